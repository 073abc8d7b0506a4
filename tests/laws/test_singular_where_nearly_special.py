"""Law of nearly special arms, solved as the special one: where that is singular nothing of theirs is missing."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from pieper import DH, Arm, Status

LIMITS = [(-pi, pi), (-0.5, 0.5), (-0.5, 0.5), *[(-pi, pi)] * 3]


def cylindrical(off: float) -> Arm:
    """A turn, two slides and a wrist whose axes miss one point by `off` m."""
    rows = [(0, 0, 0.2), (0, -pi / 2, 0.1), (0, 0, 0.2), (off, -pi / 2), (0, pi / 2), (0, 0, 0.1)]
    return Arm.from_dh([DH(*row) for row in rows], convention="standard", joint_types="RPPRRR", limits=LIMITS)


@pytest.mark.parametrize("off", [1e-5, 1e-6, 1e-7, 1e-8, 1e-9])
def test_a_straight_wrist_that_is_none_has_all_its_solutions(off: float):
    """With the wrist's axes in one point a curve holds the pose; so nearly in one, a few postures far apart on it."""
    arm, rng = cylindrical(off), np.random.default_rng(1)
    q = rng.uniform(*arm.limits.T, (6, 6))
    q[:, 4] = 0.0
    many = arm.ik_many(arm.fk(q))
    certain = 0
    for k in range(6):
        sols = arm.ik(arm.fk(q[k]))
        assert np.abs(sols.nearest(q[k]) - q[k]).max() < 1e-4
        assert sols.status == many.status[k] and len(sols.all_q) == many.count[k]
        certain += sols.status == Status.SOLVED
    assert certain >= (6 if off > 5e-7 else 1)
