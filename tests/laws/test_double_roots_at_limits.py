"""A double root is known to the root of rounding: one that blurs over a stop is a solution at the stop."""

from __future__ import annotations

import numpy as np
import pytest

from oracle import equations, machine
from oracle.arms.known import free
from oracle.arms.strata import three_parallel, wrist_at
from oracle.joints import on_singular
from pieper import Arm

ARMS = {
    "wrist": lambda: free("unimation-puma-560"),
    "wrist with a slide": lambda: free("stanford-arm"),
    "wrist inside, PRP": lambda: wrist_at(1, "PRRRPR", 5),
    "three parallel": lambda: free("universal-robots-ur5e"),
    "three parallel, skew": lambda: three_parallel(3),
    "offset wrist": lambda: free("motoman-hc10"),
    "general": lambda: free("kinova-gen3-6dof"),
}


def limited(arm: Arm, joint: int, lower: float, upper: float) -> Arm:
    limits = dict.fromkeys(arm.joint_names, (-7.0, 7.0))
    return arm.with_limits({**limits, arm.joint_names[joint]: (lower, upper)})


@pytest.mark.parametrize("kind", ARMS)
def test_a_double_root_on_a_limit_is_inside_in_one_pose_and_in_many(kind):
    arm, rng, tried = ARMS[kind](), np.random.default_rng(3), 0
    m, count = machine(arm), 1 if kind in ("offset wrist", "general") else 3  # a look takes them longest
    for q in on_singular(rng, arm.chain, 200):
        T = arm.fk(q)
        if arm.ik(T).self_motions:
            continue
        for joint in np.flatnonzero(~arm.chain.prismatic)[rng.integers(0, 2) :: 2]:
            for lower, upper in ((q[joint], q[joint] + 1.0), (q[joint] - 1.0, q[joint])):
                short = limited(arm, int(joint), lower, upper)
                many = short.ik_many(T[None], threads=1)
                for rows in (short.ik(T).q, many.q[0][many.in_limits[0]]):
                    gap = short.chain.joints.apart(rows, q)
                    assert len(rows) and gap.min() < 1e-3, f"joint {joint + 1} at {q.tolist()}"
                    left = equations(m, m.inner(rows[gap.argmin()][None]), m.pose(T))[0]
                    assert np.abs(left).max() < 2e-14
        tried += 1
        if tried == count:
            break
    assert tried == count


def test_a_double_root_clearly_outside_stays_outside():
    arm = free("universal-robots-ur5e")
    q = np.array([0.3, -1.1, 0.0, 0.7, 0.9, 0.2])  # the elbow straight
    short = limited(arm, 2, 1e-5, 1.0)
    assert not len(short.ik(arm.fk(q)).q) or short.chain.joints.apart(short.ik(arm.fk(q)).q, q).min() > 1e-3


@pytest.mark.parametrize("name", ["motoman-hc10", "fanuc-crx-10ia", "universal-robots-ur5e", "unimation-puma-560"])
def test_a_double_root_at_limits_a_turn_apart_is_there_both_ways_round(name):
    arm, rng, tried = free(name), np.random.default_rng(5), 0
    arm = arm.with_limits(dict.fromkeys(arm.joint_names, (-np.pi, np.pi)))
    for _ in range(40):
        q = np.deg2rad(rng.choice([-180, -90, -60, 0, 30, 60, 90, 135, 180], 6))
        sols = arm.ik(arm.fk(q))
        if sols.self_motions or not len(sols):
            continue
        many = arm.ik_many(arm.fk(q)[None], threads=1, near=q)
        for near in (sols.nearest(q), many.nearest[0]):
            assert np.abs(near - q).max() < 1e-5, f"{np.rad2deg(q)}: {near}"
        tried += 1
    assert tried > 10
