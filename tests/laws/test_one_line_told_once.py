"""A wrist in line at a posture where the elbow and the shoulder are singular too: one line, closed, told once.

More than one direction is free to first order there, and what else is free leads nowhere: rows are known to half the
digits, and curves that were followed from them came round beside the line and were told beside it.
"""

from __future__ import annotations

import numpy as np
import pytest

import pieper

#: Joints 2 and 3 in quarters of a turn, of arms whose zero posture is all of that, or another one.
POSTURES = [
    ("staubli-tx60", 0, 0),
    ("staubli-tx2-60l", 0, 0),
    ("doosan-a0912", 0, 0),
    ("doosan-m0609", 0, 0),
    ("doosan-m1013", 0, 0),
    ("doosan-m1013", 2, 0),
    ("doosan-m1509", 2, 0),
    ("jaka-minicobo", 0, 0),
    ("doosan-h2017", 0, 0),
    ("doosan-m0617", 0, 0),
]


@pytest.mark.parametrize(("name", "second", "third"), POSTURES)
def test_joints_4_and_6_turn_against_one_another_and_nothing_else_moves(name, second, third):
    arm = pieper.load(name)
    q = np.array([0, second, third, 0, 0, 0]) * np.pi / 2
    assert np.linalg.svd(arm.jacobian(q))[1][4] < 1e-9  # two directions and more are free to first order
    T = arm.fk(q)
    sols = arm.ik(T)
    assert sols.status == pieper.Status.SINGULAR
    near = [motion for motion in sols.self_motions if motion.contains(q, 1e-6)]
    assert len(near) == 1 and near[0].dimension == 1 and "all the way round" in str(near[0])
    points = np.unwrap([near[0].at(u) for u in np.linspace(0, 1, 41)], axis=0)
    assert np.abs(np.ptp(points, axis=0) - [0, 0, 0, 2 * np.pi, 0, 2 * np.pi]).max() < 1e-6
    assert np.abs(arm.fk(points) - T).max() < 1e-9
    for other in sols.self_motions:
        if other is not near[0]:
            assert not all(near[0].contains(other.at(u), 1e-6) for u in np.linspace(0.1, 0.9, 9))
    many = arm.ik_many(T[None])
    assert many.status[0] == sols.status and many.count[0] == len(sols.all_q)
