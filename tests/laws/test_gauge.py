"""Laws of description: how an arm is written down changes nothing about its solutions."""

from __future__ import annotations

import numpy as np

from oracle.arms.gauge import flipped, from_chain, slid
from oracle.arms.kinds import KINDS, random_pose
from oracle.joints import random_joints, same_set
from pieper import Arm
from pieper.kinematics.chain import Chain
from tests.laws.of_kinds import of_kinds

TURN = 2 * np.pi


@of_kinds(KINDS, examples=6)
def test_table_frames_and_senses_do_not_matter(arm, rng):
    q = random_joints(arm, rng, 8)
    T = arm.fk(q)
    joint = int(rng.integers(6))
    for other, sign in (
        (from_chain(slid(arm.chain, rng)), np.ones(6)),
        (from_chain(flipped(arm.chain, joint)), _minus(joint)),
    ):
        assert np.abs(other.fk(q * sign) - T).max() < 1e-12 * (1 + np.abs(T).max()) * 10
        for pose in T:
            mine, theirs = arm.ik(pose), other.ik(pose)
            assert same_set(mine.all_q, theirs.all_q * sign, arm.chain.prismatic)


@of_kinds(KINDS, examples=6)
def test_base_tool_and_scale_do_not_matter(arm, rng):
    q = random_joints(arm, rng, 8)
    base, tool = random_pose(rng), random_pose(rng)
    links = arm.chain.links.copy()
    links[0], links[-1] = base @ links[0], links[-1] @ tool
    moved = from_chain(Chain.of(links, arm.chain.prismatic))
    big = arm.chain.links.copy()
    big[:, :3, 3] *= 1000.0
    scaled = from_chain(Chain.of(big, arm.chain.prismatic))
    unit = np.where(arm.chain.prismatic, 1000.0, 1.0)
    for pose in arm.fk(q):
        mine = arm.ik(pose)
        assert same_set(mine.all_q, moved.ik(base @ pose @ tool).all_q, arm.chain.prismatic)
        far = pose.copy()
        far[:3, 3] *= 1000.0
        assert same_set(mine.all_q, scaled.ik(far).all_q / unit, arm.chain.prismatic)


@of_kinds(KINDS, examples=6)
def test_the_reversed_arm_has_the_reversed_solutions(arm, rng):
    back = from_chain(arm.chain.reversed())
    for pose in arm.fk(random_joints(arm, rng, 8)):
        mine, theirs = arm.ik(pose), back.ik(np.linalg.inv(pose))
        assert same_set(mine.all_q, theirs.all_q[:, ::-1], arm.chain.prismatic)


def test_a_tool_is_applied_on_the_tool_side():
    rng = np.random.default_rng(4)
    rows = [
        (0.1, 1.57, 0.2, 0.0),
        (0.3, 0, 0, 0),
        (0.1, -1.57, 0, 0),
        (0, 1.57, 0.3, 0),
        (0, -1.57, 0, 0),
        (0, 0, 0.1, 0),
    ]
    bare, tool = Arm.from_dh(rows, convention="standard"), random_pose(rng)
    held = Arm.from_dh(rows, convention="standard", tool=tool)
    q = random_joints(bare, rng, 5)
    np.testing.assert_allclose(held.fk(q), bare.fk(q) @ tool, atol=1e-14)


def _minus(joint):
    sign = np.ones(6)
    sign[joint] = -1
    return sign
