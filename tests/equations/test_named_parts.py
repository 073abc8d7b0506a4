"""Lines of a page are no wider than the page, broken ones say the same, and other letters are only other letters."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from pieper.algebra.arithmetics import NumpyField
from pieper.algebra.expression import Expr
from pieper.document.blocks import Document, Equation, Equations
from pieper.equations.named_parts import WIDE, broken_lines

ARMS = ["neuromeka-indyrp2", "motoman-hc10", "denso-vp6242", "fanuc-m-20ia-10l", "ur5e", "kuka-lbr-iiwa-14-r820"]


def _lines(page: Document) -> list[Equation]:
    rows = [
        list(b.rows) if isinstance(b, Equations) else [b] for b in page.blocks if isinstance(b, (Equation, Equations))
    ]
    return [row for block in rows for row in block]


def _random_6r(seed: int) -> pieper.Arm:
    rng = np.random.default_rng(seed)
    rows = [
        pieper.DH(a=rng.uniform(0.05, 0.4), alpha=rng.uniform(-2, 2), d=rng.uniform(0.05, 0.4), theta=0)
        for _ in range(6)
    ]
    return pieper.Arm.from_dh(rows, convention="standard", joint_types="RRRRRR", name=f"random-{seed}")


@pytest.mark.parametrize("name", [*ARMS, "random"])
def test_no_formula_is_wider_than_a_page(name):
    arm = _random_6r(3) if name == "random" else pieper.load(name)
    pages = [arm.symbolic.fk().page, arm.symbolic.singularities().page]
    pages += [arm.symbolic.ik().page] if name != "random" else []
    for page in pages:
        for row in _lines(page):
            if isinstance(row.sides[-1], Expr):
                assert len(" = ".join(side.text() for side in row.sides)) <= WIDE, row.sides[-1].text()[:200]


@pytest.mark.parametrize("name", ["neuromeka-indyrp2", "motoman-hc10"])
def test_a_broken_formula_is_the_formula(name):
    arm = pieper.load(name)
    forward = arm.symbolic.fk()
    whole = forward.pose.entry_equations
    page = broken_lines(Document("", blocks=[whole]))
    q = np.random.default_rng(1).uniform(-3, 3, (arm.n, 5))
    values = dict(forward.table.values(q, NumpyField))
    for row in _lines(page):
        values[row.sides[0]] = row.sides[-1].evaluate(values, NumpyField)
    for row in whole.rows:
        right = row.sides[-1].evaluate(forward.table.values(q, NumpyField), NumpyField)
        assert np.allclose(values[row.sides[0]], right, atol=1e-12)


def test_other_letters_are_only_other_letters():
    arm = pieper.load("denso-vp6242")
    plain, other = arm.symbolic.ik().text(), arm.symbolic.ik(letters="r").text()
    letters = {f"{c}_{x}": f"r{i}{j}" for j, c in enumerate("noa", 1) for i, x in enumerate("xyz", 1)}
    for old, new in letters.items():
        plain = plain.replace(old, new)
    assert (
        plain.replace("the columns n, o, a and p", "the entries r11 to r33 of its rotation and the position p") == other
    )
    assert "r33 = " in arm.symbolic.fk(letters="r").text() and "a_z" not in arm.symbolic.fk(letters="r").text()
    assert "r_{33}" in arm.symbolic.ik(letters="r").latex()
    with pytest.raises(pieper.InputError, match="noap, r"):
        arm.symbolic.ik(letters="craig")


def test_a_page_in_the_other_letters_is_judged_as_well():
    page = pieper.load("denso-vp6242").symbolic.ik(letters="r").text()
    file, read, _ = pieper.guess_claims(page, "denso-vp6242", "page")
    verdicts = pieper.check(file).verdicts
    assert read > 10 and [v.id for v in verdicts if not v.holds] == []
