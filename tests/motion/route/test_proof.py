"""That nothing gets through is proved from any place of the path and to either end."""

import numpy as np
import pytest

import pieper
from benchmarks.measure.route_verdicts import at, drawn, missed
from oracle.turns import flooded, ring
from pieper.kinematics.pose import rotation_z
from pieper.motion.route.front import modulo_turns
from pieper.motion.route.proof import anywhere
from pieper.motion.route.search import Task
from pieper.motion.route.windows import backwards

FREE = pieper.Freedom()


@pytest.fixture(scope="module")
def closed(irb):
    """A ring whose far side a narrow first joint does not let the arm come to."""
    arm = irb.with_limits({"joint_1": (-0.12, 0.1)})
    path = ring(25, (1.1, 0.0, 0.6), 0.3, 0.2)
    return arm, path, arm.route(path, free=FREE)


def past(arm, path, begun, end, further=0.02):
    """Whether a flood from everything inside the limits gets from one place to a little behind another."""
    there = np.clip(end + np.sign(end - begun) * further, 0, 1)
    poses = at(path, np.linspace(begun, there, 2 + int(400 * abs(there - begun))))
    return flooded(arm, poses, 720, lifted=False) == len(poses) - 1


def test_a_proof_is_found_forwards_and_backwards_and_a_flood_does_not_get_past(closed):
    arm, path, route = closed
    assert route.verdict is pieper.Verdict.IMPOSSIBLE
    task = Task(route.setting, False, (None, None), None)
    for way, poses in ((task, path), (backwards(task), path[::-1])):
        proof = anywhere(way, modulo_turns(way.setting))
        assert proof is not None
        assert not past(arm, poses, proof.along(proof.begun), proof.along(proof.s))


def test_a_seam_and_the_same_gone_backwards_have_one_verdict(closed, irb, seam):
    arm, path, _ = closed
    assert arm.route(path[::-1], free=FREE).verdict is pieper.Verdict.IMPOSSIBLE
    assert irb.route(seam[::-1], free=FREE).verdict is pieper.Verdict.FOUND


@pytest.mark.slow
@pytest.mark.parametrize(
    "name, number", [("motoman-gp7", 1), ("denso-vs060", 8), ("fanuc-lr-mate-200id", 1), ("kuka-kr16-2", 11)]
)
def test_what_closes_far_from_where_a_front_ends_is_proved(name, number):
    # another stretch of postures opens before the first front ends: from close by the two are not told apart
    arm, path = drawn(name, number)
    route = arm.route(path, free=FREE)
    assert route.verdict is pieper.Verdict.IMPOSSIBLE
    begun, (first, last) = route.blocked.begun, route.blocked.s
    back = begun > last
    assert ("followed backwards" in route.reason) == back
    assert not past(arm, path, begun, first if back else last)


def boxed(arm, q, degrees):
    """Return the arm with limits so much wider than what a route needs."""
    room = np.radians(degrees)
    both = np.clip(np.stack([q.min(0) - room, q.max(0) + room], -1), *arm.limits.T[:, :, None])
    return arm.with_limits(dict(zip(arm.joint_names, both.tolist(), strict=True)))


@pytest.mark.parametrize(
    "name, number",
    [("kuka-kr6-r900-sixx", 1), ("abb-irb2400", 2), ("fanuc-m-10ia", 1), ("universal-robots-ur5e", 4)],
)
def test_limits_a_little_inside_what_a_route_needs_are_refused_by_the_pose_that_needs_them(name, number):
    arm, path = drawn(name, number)
    q = arm.route(path, free=FREE).q
    assert boxed(arm, q, 0.01).route(path, free=FREE).found
    tight = boxed(arm, q, -0.02)
    route = tight.route(path, free=FREE)
    assert route.verdict is pieper.Verdict.IMPOSSIBLE
    place = route.blocked.s[1]
    turned = at(path, np.array([place]))[0] @ rotation_z(np.arange(20_000) * 2 * np.pi / 20_000)
    assert not tight.ik_many(turned).in_limits.any() and arm.ik_many(turned).in_limits.any()


@pytest.mark.parametrize(
    "degrees, verdict",
    [(0.2, "FOUND"), (0.01, "FOUND"), (-0.02, "IMPOSSIBLE"), (-0.05, "IMPOSSIBLE"), (-0.1, "IMPOSSIBLE")],
)
def test_a_box_about_a_route_that_swings_lets_it_through_and_one_that_is_smaller_does_not(degrees, verdict):
    # a joint swings by 39 degrees from one point to the next
    arm, path = drawn("kuka-kr6-r900-sixx", 1)
    q = arm.route(path, free=FREE).q
    assert np.abs(np.diff(q, axis=0)).max() > 0.6
    tight = boxed(arm, q, degrees)
    route = tight.route(path, free=FREE)
    assert route.verdict.name == verdict
    if verdict == "FOUND":
        assert missed(tight, route) == ""
        assert abs(route.cost - arm.route(path, free=FREE).cost) < 1e-3
    else:
        begun, (first, last) = route.blocked.begun, route.blocked.s
        assert not past(tight, path, begun, first if begun > last else last)
