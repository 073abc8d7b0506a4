"""What the careful look follows at a singular posture: every direction that may be free, and where it leads."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle.joints import scaled
from pieper.solver.singular import examine
from pieper.tolerances import NEARLY_SINGULAR

#: A posture with two free directions: the arm is stretched, its wrist in one line.
STRETCHED = np.array([-np.pi / 2, -np.pi / 2, 0, 0.3, 0, 0.2])


def curves_at(arm, q, **said):
    return examine._Curves(arm.chain, arm.fk(q), arm.limits, arm.joint_names, arm.n, hiding=True, **said)


@pytest.mark.parametrize("turned", [0.0, 0.7, 2.0])
def test_where_two_directions_are_free_each_mixture_of_them_is_near_one_that_is_tried(turned):
    chain, q = pieper.load("kuka-kr6-r900-2").chain, STRETCHED + [turned, 0, 0, 0.3 * turned, 0, 0]
    J = scaled(chain, q)
    values, directions = np.linalg.svd(J)[1:]
    assert values[-2] < 1e-9
    tried = np.array(examine._directions(chain, q))
    assert np.abs(np.linalg.norm(tried, axis=1) - 1).max() < 1e-12
    assert np.linalg.norm(tried @ J.T, axis=1).max() < NEARLY_SINGULAR * values[0]
    for angle in np.linspace(0, np.pi, 50):
        mixture = np.cos(angle) * directions[-2] + np.sin(angle) * directions[-1]
        assert np.abs(tried @ mixture).max() > np.cos(np.pi / (2 * examine.FAN)) - 1e-9


def test_a_posture_on_a_surface_is_known_to_lie_on_it_when_no_further_line_is_followed():
    arm = pieper.load("kuka-kr6-r900-2")
    full = curves_at(arm, STRETCHED, lines=examine.MOST_LINES)
    assert examine._grow(full, STRETCHED) and not full.closed
    regular = STRETCHED + [0, 0, 0.7, 0, 0.9, 0]
    curves = curves_at(arm, regular)
    assert not examine._grow(curves, regular) and not curves.closed
