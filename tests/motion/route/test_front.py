"""What is followed with proof along a path: nothing that moves inside the limits is ever lost on the way."""

import re

import numpy as np
import pytest

import pieper
from oracle.turns import random_ring, reaches, ring
from pieper.motion.route.front import Ended, everything_at, follow, modulo_turns

FREE = pieper.Freedom()


def covers(front, world, x):
    """Whether a joint vector (m,) is one that a point of the front stands for."""
    gap = world.chain.joints.difference(front.q, x) / world.chain.joints.unit
    return bool((np.linalg.norm(gap, axis=1) <= front.within).any())


@pytest.mark.parametrize("fine", [1.0, 0.3])
def test_a_route_never_leaves_the_front(irb, seam, found, fine):
    world = found.setting
    limits = modulo_turns(world)
    for last in (1, 2):
        x = np.append(found.q[last], -found.turn[last])
        front = follow(world, limits, everything_at(world, limits, 0.0), (0.0, found.s[last]), fine, 2_000_000)
        assert front.ended is Ended.ARRIVED
        assert covers(front, world, x)


def test_a_front_begins_with_all_rows_inside_the_limits(irb, seam, found):
    world = found.setting
    limits = modulo_turns(world)
    front = follow(world, limits, everything_at(world, limits, 0.0), (0.0, 0.0), 0.3, 1_000_000)
    turns = np.random.default_rng(2).uniform(-np.pi, np.pi, 60)
    many = irb.ik_many(FREE.turned(seam[0], turns))
    k, row = np.nonzero(many.in_limits)
    assert len(k) > 25
    for i, j in zip(k, row, strict=True):
        assert covers(front, world, np.append(many.q[i, j], -turns[i]))


def test_a_front_of_one_posture_keeps_what_it_can_turn_to(irb, seam, found):
    world = found.setting
    start = np.append(found.q[0], -found.turn[0])
    front = follow(world, world.limits, start[None], (0.0, 0.0), 0.3, 1_000_000)
    every = follow(world, world.limits, everything_at(world, world.limits, 0.0), (0.0, 0.0), 0.3, 1_000_000)
    assert covers(front, world, start)
    assert 0 < len(front.q) < len(every.q)


def test_without_limits_nothing_ends(irb, seam, found):
    world = found.setting
    none = np.full((world.m, 2), [-np.inf, np.inf])
    seeds = everything_at(world, modulo_turns(world), 0.0)
    front = follow(world, none, seeds, (0.0, 0.01), 1.0, 1_000_000)
    assert front.ended is Ended.ARRIVED
    assert follow(world, none, seeds, (0.0, 1.0), 1.0, 20_000).ended is Ended.TIRED


def test_a_tool_that_is_held_is_refused_with_proof_too(irb):
    path = ring(30, (1.1, 0.0, 0.6), 0.3, 0.2)
    held = irb.with_limits({"joint_1": (-0.1, 0.1)}).route(path)
    assert held.verdict is pieper.Verdict.IMPOSSIBLE


def test_another_end_than_the_one_that_is_reached_is_refused(irb, seam, found):
    # the first joint can be at the start's value only where the tool is on the other side
    short = seam[:3]
    here = irb.route(short, free=FREE)
    other = irb.ik(FREE.turned(short[-1], here.turn[-1]))
    for q in other.q:
        to = irb.route(short, free=FREE, start=here.q[0], end=q)
        assert to.verdict is not pieper.Verdict.UNCERTAIN or "ruled out" in to.reason
        if to.verdict is pieper.Verdict.IMPOSSIBLE:
            # every pose can be reached, only not in that posture
            assert re.search("the posture that it is to (begin|end) with is not reached", to.reason)
    with_limits = irb.with_limits({"joint_1": (-0.1, 0.1)}).route(seam, free=FREE)
    assert "to end with" not in with_limits.reason


@pytest.mark.slow
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_what_is_refused_is_not_reached_by_many_turns(irb, seed):
    rng = np.random.default_rng(seed)
    reach, unknown = irb.chain.length, 0
    for _ in range(6):
        path = random_ring(rng, 20, reach, out=(0.2, 0.65), around=2.5, up=(0, 0.55), wide=(0.03, 0.17))
        route = irb.route(path, free=FREE)
        unknown += route.verdict is pieper.Verdict.UNCERTAIN
        if route.verdict is pieper.Verdict.IMPOSSIBLE:
            assert reaches(irb, path, 90) < len(path) - 1
    assert unknown <= 1


@pytest.mark.parametrize("free", [None, FREE])
def test_an_end_that_is_out_of_reach_is_told_where_it_is(irb, free):
    out, inside = (pieper.pose(x, y, 0.9, rpy=(180, 0, 0), degrees=True) for x, y in ((2.5, 0.0), (0.9, 0.2)))
    first = irb.route(pieper.line(out, inside, 20), free=free)
    assert first.verdict is pieper.Verdict.IMPOSSIBLE
    assert first.blocked.s == (0.0, 0.0) and first.blocked.begun == 0.0
    assert "no motion begins at the first pose" in first.reason
    assert first.blocked.why.startswith("At the first point of the path the pose is out of reach")
    last = irb.route(pieper.line(inside, out, 20), free=free)
    assert last.verdict is pieper.Verdict.IMPOSSIBLE
    low, high = last.blocked.s
    # with a spherical wrist the tool is reached where its wrist is; the place is told to a station of a hundred
    count = 401 if free is None else 101
    at = np.linspace(0, 1, count)
    path = pieper.line(inside, out, count)
    can = np.array([len(irb.ik(T, task="position+axis" if free else None).q) > 0 for T in path])
    ends = at[np.argmin(can)]
    assert low <= ends <= high + 1 / (count - 1) and high - low < 0.011


def test_a_first_pose_that_limits_forbid_is_told_there(irb):
    path = ring(30, (1.1, 0.0, 0.6), 0.3, 0.2)
    here = irb.ik(path[0]).q[0, 0]
    refused = irb.with_limits({"joint_1": (here + 0.4, here + 0.5)}).route(path)
    assert refused.verdict is pieper.Verdict.IMPOSSIBLE
    assert refused.blocked.s == (0.0, 0.0)
    assert "no motion begins at the first pose" in refused.reason
    assert "joint_1" in {c.joint for c in refused.blocked.closed}


@pytest.mark.parametrize("seed", [1, 2, pytest.param(4, marks=pytest.mark.slow)])
def test_a_route_stays_in_the_front_of_a_box_that_only_just_holds_it(irb, seed):
    """What is let go at the limits is told by the curve's tangent: nothing that moves along them may be lost."""
    rng = np.random.default_rng(seed)
    looked = 0
    while not looked:
        path = random_ring(rng, 16, 1.5, out=(0.3, 0.8), around=2.5, up=(0.0, 0.7), wide=(0.03, 0.2))
        route = irb.route(path, free=FREE)
        if not route.found:
            continue
        near = np.radians(0.01)
        box = {
            name: (max(low - near, a), min(high + near, b))
            for name, low, high, (a, b) in zip(
                irb.joint_names, route.q.min(0), route.q.max(0), irb.limits.tolist(), strict=True
            )
        }
        world = irb.with_limits(box).route(path, free=FREE).setting
        for begin, last in ((0.0, 0.3), (0.5, 0.8)):
            k = int(last * (len(path) - 1))
            x = np.append(route.q[k], -route.turn[k])
            for fine in (1.0, 0.4):
                seeds = everything_at(world, world.limits, begin)
                front = follow(world, world.limits, seeds, (begin, route.s[k]), fine, 150_000)
                assert front.ended in (Ended.ARRIVED, Ended.TIRED)
                if front.ended is Ended.ARRIVED:
                    assert covers(front, world, x)
                    looked += 1
