"""Within a cone: that nothing holds a pose is proved by boxes of joint values, and never where something does."""

from types import SimpleNamespace

import numpy as np
import pytest

import pieper
from pieper.motion.route.nowhere import _ruled_out, nothing_within_cone
from pieper.motion.route.setting import setting


def world(arm, T, free):
    return setting(*arm._plans_of(free), free, np.stack([T, T]), np.array([0.0, 1.0]))


def near(arm, q, room):
    """Return the arm with limits of so much about a posture."""
    return arm.with_limits({n: (v - room, v + room) for n, v in zip(arm.joint_names, q, strict=True)})


def tilted(angle, towards):
    return pieper.pose(0, 0, 0, rotvec=(angle * np.cos(towards), angle * np.sin(towards), 0.0))


def posture(arm, rng):
    low, high = np.clip(arm.limits, -2.5, 2.5).T
    return rng.uniform(low, high)


@pytest.mark.parametrize("name", ["abb-irb2400", "universal-robots-ur5e", "franka-panda"])
def test_a_posture_that_is_tilted_by_more_than_the_cone_is_ruled_out_and_by_less_is_not(name):
    arm, rng = pieper.load(name), np.random.default_rng(5)
    arm = arm.with_tool(arm.tool @ pieper.pose(0.03, 0.02, 0.2, rpy=(0, 0.6, 0)))
    for turn in ("free", (-0.1, 0.3)):
        q = posture(arm, rng)
        T = arm.fk(q) @ tilted(0.3, rng.uniform(0, 6))
        few = near(arm, q, 0.004)
        narrow, wide = (pieper.Freedom(turn=turn, cone=c) for c in (0.25, 0.35))
        assert nothing_within_cone(world(few, T, narrow), T) is not None
        assert nothing_within_cone(world(few, T, wide), T, 20_000) is None


def test_a_turn_that_is_held_is_held_within_the_cone():
    arm, rng = pieper.load("abb-irb2400"), np.random.default_rng(6)
    q = posture(arm, rng)
    T = arm.fk(q) @ pieper.pose(0, 0, 0, rpy=(0, 0, 0.8))
    few = near(arm, q, 0.004)
    for turn, held in (((0.0, 0.0), False), ((-1.0, 0.0), True), ((0.2, 0.4), False), ("free", True)):
        free = pieper.Freedom(turn=turn, cone=0.1)
        proved = nothing_within_cone(world(few, T, free), T, 50_000) is not None
        assert proved != held


@pytest.mark.parametrize("joints", [1, 2, 3])
@pytest.mark.parametrize("half", [1e-3, 0.05, 0.4])
def test_no_box_is_ruled_out_that_an_arm_reaches_the_point_from_at_its_corner(joints, half):
    """Of one joint the point is a sagitta off the tangent, which the bound must leave room for to the last part."""
    rng = np.random.default_rng(joints)
    for _ in range(20):
        rows = [pieper.DH(a=float(a)) for a in rng.uniform(0.2, 1.0, joints)]
        arm = pieper.Arm.from_dh(rows, convention="standard")
        world = SimpleNamespace(plan=SimpleNamespace(chain=arm.chain, prismatic=np.zeros(joints, bool)))
        q, h = rng.uniform(-3, 3, (1, joints)), np.full((1, joints), half)
        for side in (h, -h, h * rng.uniform(-1, 1, h.shape)):
            assert not _ruled_out(world, arm.fk(q + side)[0, :3, 3], [], q, h)[0].any()


@pytest.mark.parametrize("name", ["abb-irb2400", "universal-robots-ur5e"])
def test_what_holds_a_pose_is_never_ruled_out(name):
    rng = np.random.default_rng(7)
    arm = pieper.load(name)
    for _ in range(6):
        cone = rng.uniform(0.02, 0.4)
        q = posture(arm, rng)
        T = arm.fk(q) @ pieper.pose(0, 0, 0, rpy=(0, 0, rng.uniform(-3, 3))) @ tilted(cone * 0.999, rng.uniform(0, 6))
        few = near(arm, q, 10.0 ** rng.uniform(-3, -0.5))
        assert nothing_within_cone(world(few, T, pieper.Freedom(cone=cone)), T, 60_000) is None


@pytest.mark.parametrize("turn", [(0.0, 0.0), (-0.02, 0.3), (1.0, 3.9), (-3.0, 3.0)])
@pytest.mark.parametrize("name", ["abb-irb2400", "robotis-openmanipulator-x"])
def test_a_turn_at_the_ends_of_its_interval_is_held_and_a_little_beyond_them_is_not(name, turn):
    """The turn is the last of R_path Rx(a) Ry(b) Rz(turn), whatever the tilt is."""
    arm, rng = pieper.load(name), np.random.default_rng(9)
    low, high = turn
    for k in range(8):
        q, few = posture(arm, rng), None
        a, b = 0.2 * rng.uniform(-1, 1, 2)
        end, out = (low, -1.0) if k % 2 else (high, 1.0)
        few = near(arm, q, 10.0 ** rng.uniform(-4, -2.5))
        free = pieper.Freedom(turn=turn, cone=0.4)
        for beyond, held in ((0.0, True), (-1e-3, high > low), (0.05, high - low > np.pi)):
            own = pieper.pose(0, 0, 0, rotvec=(a, 0, 0)) @ pieper.pose(0, 0, 0, rotvec=(0, b, 0))
            T = arm.fk(q) @ np.linalg.inv(own @ pieper.pose(0, 0, 0, rotvec=(0, 0, end + out * beyond)))
            if held:
                assert nothing_within_cone(world(few, T, free), T, 20_000) is None
            elif beyond > 0:
                assert nothing_within_cone(world(few, T, free), T, 60_000) is not None


def test_an_arm_that_cannot_lean_without_turning_is_refused_where_its_turn_is_held():
    # of an arm that leans in the plane of its first joint alone only the first and the last pose of a line are held
    arm = pieper.load("robotis-openmanipulator-x")
    for k in range(4):
        rng = np.random.default_rng([k, 3])
        low, high = np.clip(arm.limits, -2.5, 2.5).T
        q = rng.uniform(low + 0.2 * (high - low), high - 0.2 * (high - low))
        path = pieper.line(arm.fk(q), arm.fk(np.clip(q + rng.uniform(-0.1, 0.1, 4), low, high)), 12)
        route = arm.route(path, free=pieper.Freedom(axis="xz"[k % 2], cone=0.1, turn=(0, 0)))
        assert route.verdict is pieper.Verdict.IMPOSSIBLE and "boxes of joint values" in route.reason
        # by the arm's own angles: the point tells the first joint, and no pitch at all leaves the turn at zero
        at = path[int(round(route.blocked.begun * 11))]
        pan = np.arctan2(at[1, 3], at[0, 3])
        z = pieper.Freedom(axis=route.free.axis).to_z[:3, :3]
        turns = []
        for pitch in np.linspace(-np.pi, np.pi, 20_001):
            R = pieper.pose(0, 0, 0, rotvec=(0, 0, pan)) @ pieper.pose(0, 0, 0, rotvec=(0, pitch, 0))
            D = z.T @ at[:3, :3].T @ R[:3, :3] @ z
            if D[2, 2] > np.cos(0.11):
                turns.append(np.arctan2(-D[0, 1], D[0, 0]))
        assert len(turns) > 100 and (np.all(np.array(turns) > 0) or np.all(np.array(turns) < 0))


def test_a_route_within_a_cone_is_refused_with_proof_and_with_more_room_is_found():
    arm = pieper.load("abb-irb2400")
    arm = arm.with_tool(arm.tool @ pieper.pose(0.05, 0.02, 0.35, rpy=(0, 0.6, 0)))
    ends = (pieper.pose(0.9, y, 0.9, rpy=(180, 0, 0), degrees=True) for y in (-0.3, 0.3))
    path, free = pieper.line(*ends, 30), pieper.Freedom(turn=(0, 0), cone=0.2)
    assert arm.route(path, free=free).verdict is pieper.Verdict.FOUND
    narrow = arm.with_limits({"joint_1": (-0.9, 0.05)})
    refused = narrow.route(path, free=free)
    assert refused.verdict is pieper.Verdict.IMPOSSIBLE and "boxes of joint values" in refused.reason
    at = refused.blocked.begun
    T = path[0].copy()
    T[:3, 3] += at * (path[-1] - path[0])[:3, 3]
    rng = np.random.default_rng(8)
    # a search of another kind: no tilt of thousands within the cone leaves a row inside
    tilts = np.stack([T @ tilted(0.2 * np.sqrt(rng.random()), rng.uniform(0, 7)) for _ in range(4000)])
    assert not narrow.ik_many(tilts).in_limits.any()
    assert narrow.route(path, free=pieper.Freedom(cone=0.2)).verdict is pieper.Verdict.FOUND
