"""Short arms, partial tasks and spare joints: rows, their order and status are the same in any order of the poses."""

from __future__ import annotations

import numpy as np
import pytest

import pieper

CASES = [
    ("adept-cobra-600", None),
    ("three-r", None),
    ("robotis-openmanipulator-x", "position"),
    ("ufactory-xarm5", None),
    ("ur5e", "position+axis"),
    ("denso-vp6242", "position"),
    ("franka-panda", None),
]


@pytest.mark.parametrize(("name", "task"), CASES)
def test_the_order_of_poses_changes_nothing(name, task):
    arm, rng, count = pieper.load(name), np.random.default_rng(4), 14
    q = rng.uniform(-1, 1, (count, arm.n)) * np.where(arm.chain.prismatic, 0.1, 2.5)
    q[::2] = rng.choice(np.deg2rad([0, 0, 90, -90, 45, 180]), (len(q[::2]), arm.n))
    T = arm.fk(np.clip(q, arm.limits[:, 0], arm.limits[:, 1]))
    T[::5, :3, 3] += 0.3 * rng.standard_normal((len(T[::5]), 3))
    chosen = {} if task is None else {"task": task}
    whole = arm.ik_many(T, threads=1, **chosen)
    for order in (rng.permutation(count), np.arange(count)[::-1], rng.permutation(count)[:5]):
        other = arm.ik_many(T[order], threads=1, **chosen)
        for k, i in enumerate(order):
            rows, again = whole.q[i][whole.valid[i]], other.q[k][other.valid[k]]
            assert whole.status[i] == other.status[k] and whole.flag[i] == other.flag[k]
            assert rows.shape == again.shape and np.abs(rows - again).max(initial=0.0) < 1e-9
            assert np.array_equal(whole.in_limits[i][whole.valid[i]], other.in_limits[k][other.valid[k]])
