"""Slides without limits make self-motions that lead away for ever: each is told once, and none for another's length."""

from __future__ import annotations

import numpy as np
import pytest

from pieper import DH, Arm

QUARTER = np.pi / 2
TYPES = "PRPRRRR"
ROWS = [
    (0.3, QUARTER, 0.4, -2.4902),
    (-0.2, -QUARTER, 0.4, QUARTER),
    (0.5, 0, 0, 0),
    (0.5, QUARTER, 0.1801, 0),
    (0.3, -QUARTER, 0.2, QUARTER),
    (0.4224, QUARTER, 0, -0.9816),
    (0.5, QUARTER, 0.4, 0),
]


@pytest.mark.parametrize("limited", [False, True])
@pytest.mark.parametrize(
    "q", [[0.1, QUARTER, 0.5, 0, -0.893, QUARTER, 0], [-0.3, 1.1, 0.2, 0, -QUARTER, 0.785, QUARTER]]
)
def test_the_posture_that_made_the_pose_is_on_one_of_the_curves_and_no_curve_is_told_in_pieces(q, limited):
    limits = [(-1, 1) if kind == "P" else (-np.pi, np.pi) for kind in TYPES] if limited else None
    arm = Arm.from_dh([DH(*row) for row in ROWS], convention="standard", joint_types=TYPES, limits=limits)
    q = np.array(q)
    motions = arm.ik(arm.fk(q)).self_motions
    assert any(motion.contains(q) for motion in motions)
    for i, motion in enumerate(motions):
        middle = motion.at(0.5)
        assert not any(other.contains(middle) for other in motions[:i])
    assert len(motions) < 16
