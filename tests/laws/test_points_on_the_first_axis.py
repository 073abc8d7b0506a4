"""A point on the first axis is held all the way round, also where an arm over decades of length reaches it alone."""

from __future__ import annotations

import numpy as np
import pytest

from oracle.arms.numbered import random_arm
from oracle.joints import around
from pieper import Arm, Status


def onto_first_axis(arm: Arm, q: np.ndarray) -> np.ndarray:
    """Return the posture whose tool point lies on the first axis, to the last digits: Newton on the other joints."""
    axis, point = arm.chain.axes[0], arm.chain.points[0]
    across = np.eye(3) - np.outer(axis, axis)
    for _ in range(60):
        step = np.linalg.lstsq(across @ arm.jacobian(q)[:3, 1:], -across @ (arm.fk(q)[:3, 3] - point), rcond=1e-9)[0]
        q = q + np.concatenate([[0.0], step * min(1.0, 0.5 / max(np.abs(step).max(), 1e-300))])
    return q


# arms over six decades of length, and two that are not
@pytest.mark.parametrize("number", [14, 110, 146, 332, 284, 0, 4])
def test_a_point_on_the_first_axis_is_held_all_the_way_round(number):
    arm, _ = random_arm(number, 3)
    rng = np.random.default_rng(2)
    for start in rng.uniform(-3, 3, (40, 3)):
        q = onto_first_axis(arm, start)
        T = arm.fk(q)
        away = T[:3, 3] - arm.chain.points[0]
        size = np.linalg.norm(away) + np.linalg.norm(arm.chain.points[0])
        if np.linalg.norm(np.cross(away, arm.chain.axes[0])) < 1e-15 * size:
            break
    else:
        pytest.skip("no posture of this arm has its tool point on the first axis")
    sols = arm.ik(T)
    assert sols.status == Status.SINGULAR == arm.ik_many(T[None]).status[0], sols.why
    turned = around(q + np.array([0.7, 0.0, 0.0]))
    assert any(motion.contains(turned, 1e-5) for motion in sols.self_motions)
