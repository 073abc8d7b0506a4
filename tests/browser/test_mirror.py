"""What the page computes itself is the same as in Python: forward kinematics, conversion, typed numbers."""

from __future__ import annotations

import math

import numpy as np
import pytest

import pieper
from oracle.slow_forward import placed
from pieper.workbench.table import arm_from_table, table_from_arm


def random_arm(rng: np.random.Generator, convention: str) -> pieper.Arm:
    n = int(rng.integers(1, 9))
    angle = lambda: float(rng.choice([0, math.pi / 2, -math.pi / 2, math.pi, rng.uniform(-3, 3)]))  # noqa: E731
    length = lambda: float(rng.choice([0.0, rng.uniform(-1, 1)]))  # noqa: E731
    quaternion = rng.normal(size=4)
    tool = placed(quaternion, rng.normal(size=3))
    return pieper.Arm.from_dh(
        [pieper.DH(length(), angle(), length(), angle()) for _ in range(n)],
        convention=convention,
        joint_types="".join(rng.choice(["R", "R", "P"], n)),
        sign=rng.choice([-1.0, 1.0], n),
        offset=rng.uniform(-1, 1, n),
        base=placed(rng.normal(size=4), rng.normal(size=3)),
        tool=tool,
    )


@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_forward_kinematics_of_the_page_equals_the_librarys(calculator, convention):
    rng = np.random.default_rng(11)
    arms = [random_arm(rng, convention) for _ in range(60)]
    qs = [rng.uniform(-3, 3, arm.n) for arm in arms]
    asked = [[table_from_arm(arm), q.tolist()] for arm, q in zip(arms, qs, strict=True)]
    answered = calculator.page.evaluate("list => list.map(([table, q]) => workbench.forward(table, q))", asked)
    for arm, q, frames in zip(arms, qs, answered, strict=True):
        assert np.allclose(np.reshape(frames, (-1, 4, 4)), arm.frames(q), atol=1e-12)


@pytest.mark.parametrize(("one", "other"), [("standard", "modified"), ("modified", "standard")])
def test_conversion_keeps_the_motion_and_comes_back(calculator, one, other):
    rng = np.random.default_rng(12)
    arms = [random_arm(rng, one) for _ in range(40)]
    tables = [table_from_arm(arm) for arm in arms]
    converted = calculator.page.evaluate("([list, to]) => list.map((t) => workbench.convert(t, to))", [tables, other])
    back = calculator.page.evaluate("([list, to]) => list.map((t) => workbench.convert(t, to))", [converted, one])
    for arm, there, again in zip(arms, converted, back, strict=True):
        q = rng.uniform(-3, 3, (5, arm.n))
        assert there["convention"] == other
        assert np.allclose(arm_from_table(there).fk(q), arm.fk(q), atol=1e-12)
        assert np.allclose(arm_from_table(again).fk(q), arm.fk(q), atol=1e-12)


def test_converting_there_and_back_gives_the_same_rows_when_base_and_tool_are_plain(calculator):
    table = table_from_arm(pieper.load("denso-vp6242"))
    again = calculator.page.evaluate("t => workbench.convert(workbench.convert(t, 'modified'), 'standard')", table)
    keys = ("a", "alpha", "d", "theta")
    assert np.allclose([[j[k] for k in keys] for j in again["joints"]], [[j[k] for k in keys] for j in table["joints"]])


@pytest.mark.parametrize(
    "name",
    ["denso-vp6242", "motoman-ea1400n", "adept-cobra-600", "universal-robots-ur5e", "stanford-arm", "kuka-kr5-arc"],
)
def test_equations_with_the_present_numbers_add_up_to_the_pose(calculator, name):
    from pieper.workbench.equation_blocks import forward_blocks

    arm = pieper.load(name)
    q = np.random.default_rng(5).uniform(-1, 1, arm.n)
    T = arm.fk(q).ravel()
    table = table_from_arm(arm)
    checked = 0
    for block in forward_blocks(arm, "numbers"):
        if "entry" not in block:
            continue
        latex = calculator.page.evaluate(
            "([block, table, q]) => workbench.present(block, table, q)", [block, table, q.tolist()]
        )
        sum_ = latex.split(" = ", 1)[1].replace(r"\left", "").replace(r"\right", "").replace(r"\cdot", "*")
        assert set(sum_) <= set("0123456789.+-*() "), f"a symbol is left in {latex}"
        assert eval(sum_) == pytest.approx(T[block["entry"]], abs=2e-3)
        checked += 1
    assert checked == 12


@pytest.mark.parametrize(
    ("typed", "kind", "value"),
    [
        ("pi/2", "angle", math.pi / 2),
        ("-π/4", "angle", -math.pi / 4),
        ("90", "angle", math.pi / 2),
        ("90 deg", "angle", math.pi / 2),
        ("1.5rad", "angle", 1.5),
        ("2pi", "angle", 2 * math.pi),
        ("125+85", "length", 0.21),
        ("0.5 m", "length", 0.5),
        ("sqrt(2)*100", "length", 0.1 * math.sqrt(2)),
        ("2^3^2", "plain", 512),
        ("-2^2", "plain", -4),
        ("1e-3", "plain", 1e-3),
        ("(1+2)*(3-4)/-2", "plain", 1.5),
    ],
)
def test_typed_numbers_are_read(calculator, typed, kind, value):
    assert calculator.page.evaluate("([t, k]) => workbench.read(t, k).value", [typed, kind]) == pytest.approx(
        value, abs=1e-15
    )


@pytest.mark.parametrize(
    "typed",
    [
        "",
        "pi/",
        "2**",
        "alert(1)",
        "constructor",
        "__proto__",
        "1/0",
        "(1",
        "1 2",
        "0x10",
        "a" * 100,
        "1;2",
        "window.q",
    ],
)
def test_what_is_no_number_is_refused_with_a_reason(calculator, typed):
    reason = calculator.page.evaluate(
        "t => { try { workbench.read(t, 'plain'); return null; } catch (e) { return e.message; } }", typed
    )
    assert reason
