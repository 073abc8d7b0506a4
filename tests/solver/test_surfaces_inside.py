"""Limits may leave a part of a surface that no line followed on it crosses: it is met all the same."""

from __future__ import annotations

import numpy as np
import pytest

from pieper import DH, Arm, Status

QUARTER = np.pi / 2
#: Five joints that hold a round pose in two degrees of freedom, and two pairs of axes in one line each.
ARMS = {
    "RRRPR": (
        [
            (-0.2, 0, 0.25605, QUARTER),
            (0.4678, -QUARTER, 0, -1.50798),
            (0, -QUARTER, 0.50196, QUARTER),
            (0.3, QUARTER, 0.77734, QUARTER),
            (0.3, 0, 0, 0),
        ],
        [-QUARTER, -QUARTER, 0, 0.50128627, QUARTER / 2],
    ),
    "RRRRRR": (
        [
            (0.1, QUARTER, 0.3, 0),
            (0.4, 0.7, 0.1, 0),
            (0, 0, 0.1, 0),
            (0.2, QUARTER, 0, 0),
            (0, 0, 0.2, 0),
            (0.1, 0.4, 0.1, 0),
        ],
        [0.3, -0.8, 2.1, -1.2, 0.4, 1.9],
    ),
}


@pytest.mark.parametrize("types", ARMS)
@pytest.mark.parametrize("width", [0.01, 0.1, 0.3])
def test_a_posture_inside_narrow_limits_is_not_said_to_be_outside(types, width):
    rows, posture = ARMS[types]
    q = np.array(posture)
    limits = [(value - 0.8 * width, value + width) for value in posture]
    limits[3] = (posture[3], posture[3] + width)
    arm = Arm.from_dh([DH(*row) for row in rows], convention="standard", joint_types=types, limits=limits)
    T = arm.fk(q)
    sols, many = arm.ik(T), arm.ik_many(T[None])
    assert sols.status in (Status.SINGULAR, Status.REDUNDANT) and many.status[0] == sols.status
    assert any(motion.inside for motion in sols.self_motions)
    assert np.abs(sols.nearest(q) - q).max() < 1e-9
