"""A pose farther away than the links laid end to end is out of reach for certain, whatever an elimination says."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle.arms.numbered import random_arm, turned
from pieper import Status

#: Joints and number of an arm whose elimination was certain of nothing there, and of some that were.
ARMS = [(7, 717069), (6, 18), (5, 14), (3, 6), (3, 11)]


def at_a_distance(arm: pieper.Arm, rng: np.random.Generator, reaches: float, count: int) -> np.ndarray:
    """Return poses (count, 4, 4) so many times as far from the first axis's frame as the links are long together."""
    links = arm.chain.links
    T = np.array([turned(rng, 1.0) for _ in range(count)])
    way = rng.standard_normal((count, 3))
    way /= np.linalg.norm(way, axis=1, keepdims=True)
    T[:, :3, 3] = links[0][:3, 3] + reaches * np.linalg.norm(links[1:, :3, 3], axis=1).sum() * way
    return T


@pytest.mark.parametrize(("joints", "number"), ARMS)
def test_what_no_links_reach_is_out_of_reach_for_certain(joints, number):
    arm, _ = random_arm(number, joints)
    T = at_a_distance(arm, np.random.default_rng(3), 1.001, 12)
    T[6:] = at_a_distance(arm, np.random.default_rng(4), 400.0, 6)
    many = arm.ik_many(T, threads=1)
    assert (many.status == Status.OUT_OF_REACH).all()
    assert [arm.ik(pose).status for pose in T[::4]] == [Status.OUT_OF_REACH] * 3


def test_a_redundant_arm_is_asked_at_a_value_as_well():
    arm, _ = random_arm(717069, 7)
    T = at_a_distance(arm, np.random.default_rng(3), 400.0, 4)
    assert (arm.ik_many(T, redundancy=[0.3]).status == Status.OUT_OF_REACH).all()
    assert arm.ik(T[0], redundancy=[0.3]).status == Status.OUT_OF_REACH
