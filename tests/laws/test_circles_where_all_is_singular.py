"""A Gen3 stretched or folded, its wrist in line: the wrist's circle and nothing else, told once, closed.

Solutions merge several times over there, and what was followed from rows known to a few digits wandered 24 rad between
"two ends", or went twice round.
"""

from __future__ import annotations

import numpy as np
import pytest

import pieper

QUARTERS = [(1, 0, 2, 2, 1, 0, 1), (-1, 0, 0, 0, -1, 2, 1), (0, 2, 2, 2, 0, 2, -1), (0, 0, 0, 0, 0, 0, 0)]


@pytest.mark.parametrize("quarters", QUARTERS)
def test_joints_5_and_7_turn_against_one_another_once_round(quarters):
    arm, q = pieper.load("kinova-gen3-7dof"), np.array(quarters) * np.pi / 2
    T = arm.fk(q)
    (motion,) = arm.ik(T).self_motions
    assert motion.closed and motion.dimension == 1 and motion.contains(q)
    points = np.array([motion.at(u) for u in np.linspace(0, 1, 61)])
    assert np.abs(arm.fk(points) - T).max() < 1e-12
    steps = np.linalg.norm(np.diff(np.unwrap(points, axis=0), axis=0), axis=1)
    assert abs(steps.sum() - 2 * np.pi * np.sqrt(2)) < 1e-6
    assert np.count_nonzero(np.ptp(np.unwrap(points, axis=0), axis=0) > 1e-6) == 2
