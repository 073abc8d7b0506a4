"""Another order of steps where no equation holds a degenerate step's joint alone; five joints by their task."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

import pieper
from pieper import DH
from pieper.algebra.determinant import one_circle
from pieper.algebra.exact import decimal_text, rational
from pieper.algebra.expression import Sym, Trig, angle_symbol
from pieper.algebra.harmonic import Poly

FOUR = [DH(0, -pi / 2, 0.11), DH(0.26, -pi / 2, 0, pi / 2), DH(0.49, pi), DH(0, pi, 0.48)]
SLIDE = [DH(0.22, pi / 2, 0.46), DH(0.1, pi / 2, 0.29), DH(0.1, pi / 2, 0.1), DH(0.42, pi), DH(0.12, pi, 0.27)]
UR_LIKE = [
    DH(0, pi / 2, 0.46),
    DH(0, -pi / 2),
    DH(0.33),
    DH(0.19, 0, 0.42),
    DH(0.38, pi / 2, 0, pi / 2),
    DH(0, pi / 2, 0),
]
BUILDS = {"four turns": (FOUR, "standard", "RRRR", pi / 2), "a slide": (SLIDE, "modified", "RRPRR", 0.0)}
FIVE = ["so-101", "interbotix-viperx-300", "interbotix-pincherx-150"]


@pytest.mark.parametrize("name", BUILDS)
def test_every_solution_is_given_where_axes_beside_the_degenerate_one_are_parallel(name):
    rows, convention, types, at = BUILDS[name]
    arm = pieper.Arm.from_dh(rows, convention=convention, joint_types=types)
    ik = arm.symbolic.ik()
    assert "Another order of steps decides it there." in ik.text()
    assert "no single one" not in ik.text()
    for q in np.random.default_rng(5).uniform(-1.5, 1.5, (12, arm.n)):
        q[1] = at
        T = arm.fk(q)
        mine = ik.evaluate(T[None])[:, 0]
        mine = mine[np.isfinite(mine).all(axis=1)]
        assert np.abs(arm.fk(mine) - T).max() < 1e-7
        turning = [kind == "R" for kind in types]
        for row in arm.ik(T).all_q:
            gap = np.where(turning, np.angle(np.exp(1j * (mine - row))), mine - row)
            assert np.abs(gap).max(axis=1).min() < 1e-6


def test_a_detour_is_worked_through_and_leads_back():
    rows, convention, types, at = BUILDS["four turns"]
    arm = pieper.Arm.from_dh(rows, convention=convention, joint_types=types)
    worked = arm.symbolic.ik().worked(arm.fk([-0.5519, at, -pi / 2, 0.9362]))
    assert "another order of steps decides" in worked.text()
    assert worked.reached[worked.branch]


def test_a_joint_that_is_free_within_a_narrow_range_is_free():
    text = pieper.Arm.from_dh(UR_LIKE, convention="modified").symbolic.ik().text()
    assert "It degenerates where s5 = 0: then theta6 is free." in text
    assert "at others not" not in text


@pytest.mark.parametrize("name", FIVE)
def test_five_joints_are_derived_for_what_their_solver_takes(name):
    ik = pieper.load(name).symbolic.ik()
    assert ik.task == "position+axis"
    assert ik.closed
    held = ik.check(40)
    assert held.holds
    assert held.valid == held.real
    assert held.digits_worst is not None and held.digits_worst < 1e-45


def test_a_square_is_a_product_with_itself():
    rng = np.random.default_rng(3)
    symbols = [Sym("a", "1"), Sym("d", "2"), Sym("salpha", "1", 2), Sym("calpha", "1", 2)]
    functions = [Trig(kind, angle, 1) for kind in "cs" for angle in (((1, 1),), ((1, 1), (2, 1)), ((1, 2),))]
    for _ in range(30):
        poly = Poly()
        for _ in range(5):
            term = Poly.number(int(rng.integers(-3, 4)))
            for atom in rng.choice(len(symbols), 2):
                term = term * Poly.symbol(symbols[atom])
            poly = poly + term * Poly.symbol(functions[rng.integers(len(functions))])
        assert poly**2 == poly * poly
        values = dict(zip([*symbols[:2], angle_symbol(1), angle_symbol(2)], rng.uniform(-1, 1, 4), strict=True))
        values |= {symbols[2]: np.sin(0.7), symbols[3]: np.cos(0.7)}
        assert one_circle(poly**2).evaluate(values) == pytest.approx(poly.evaluate(values) ** 2, abs=1e-12)


def test_an_angle_that_is_no_fraction_is_written_as_a_decimal():
    assert decimal_text(rational(1.3748434905578666)) == "1.3748434905578666"
    assert decimal_text(rational(-0.5)) == "-0.5"
    assert decimal_text(rational(1.0)) == "1"
