"""Where nothing is free a route is one branch, however near it passes a singular posture; and what routes cost."""

import numpy as np
import pytest

import pieper
from pieper.motion.route.front import Ended, follow

DH = pieper.DH
FOUND = pieper.Verdict.FOUND


def three_turns(first=(-4.0, 4.0)):
    rows = [DH(0, np.pi / 2, 0.3), DH(0.4), DH(0.3)]
    return pieper.Arm.from_dh(rows, convention="standard", limits=[first, (-4, 4), (-4, 4)])


def beside_the_axis(d):
    """A line that passes the first axis at a distance (m), and the first joint along it at s (k,)."""
    path = pieper.line(pieper.pose(-0.15, d, 0.55), pieper.pose(0.12, d, 0.5), 15)
    s = np.linspace(0, 1, len(path))
    return path, np.arctan2(d, -0.15 + 0.27 * s)


@pytest.mark.parametrize("d", [1e-2, 1e-3, 3e-4, 1e-4, 1e-5, 1e-6])
def test_a_line_beside_an_axis_swings_the_first_joint_round_it(d):
    arm = three_turns()
    path, first = beside_the_axis(d)
    route = arm.route(path)
    assert route.verdict is FOUND
    # front all along, or rear all along: the first joint is the bearing of the tool, or half a turn on
    for offset in (0.0, np.pi, -np.pi):
        if abs(route.q[0, 0] - first[0] - offset) < 1e-6:
            np.testing.assert_allclose(route.q[:, 0], first + offset, atol=1e-6)
            break
    else:
        pytest.fail("the first joint is not where the tool is")
    np.testing.assert_allclose(arm.fk(route.q)[:, :3, 3], path[:, :3, 3], atol=1e-9)


@pytest.mark.parametrize("d", [1e-2, *(pytest.param(d, marks=pytest.mark.slow) for d in (3e-4, 1e-5))])
def test_a_swing_that_limits_forbid_is_no_route(d):
    path, _ = beside_the_axis(d)
    assert three_turns((-1.0, 1.0)).route(path).verdict is not FOUND


def test_a_start_that_is_not_known_is_never_lost():
    # on the axis nothing is known of what is reached: that is no proof that there is nothing
    arm = three_turns()
    path, _ = beside_the_axis(0.0)
    world = arm.route(path).setting
    on_axis = arm.ik(pieper.pose(0, 0, 0.52)).q[0]
    seed = np.concatenate([on_axis, np.zeros(world.m - 3)])
    found = follow(world, world.limits, seed[None], (0.15 / 0.27, 1.0), 1.0, 100_000)
    assert found.ended is Ended.SINGULAR


def gantry():
    rows = [
        DH(0, -np.pi / 2, 0, 0),
        DH(0, -np.pi / 2, 0, -np.pi / 2),
        DH(0, 0, 0, 0),
        DH(0, np.pi / 2),
        DH(0, -np.pi / 2),
        DH(0, 0, 0.1),
    ]
    limits = [(0, 0.5)] * 3 + [(-2, 2), (-1.8, 1.8), (-2.5, 2.5)]
    return pieper.Arm.from_dh(rows, convention="standard", joint_types="PPPRRR", limits=limits)


@pytest.mark.parametrize(
    "free", [None, pieper.Freedom(turn=(0, 0)), pieper.Freedom(turn=(-0.01, 0.01)), pieper.Freedom()]
)
def test_slides_count_the_same_whatever_is_free(free):
    arm = gantry()
    wide = arm.limits[:, 1] - arm.limits[:, 0]
    q = arm.limits.mean(1) + 0.09 * wide
    route = arm.route(arm.fk(q + np.linspace(0, 1, 15)[:, None] * 0.05 * wide), free=free, start=q)
    unit = np.where([kind == "P" for kind in arm.joint_types], arm.chain.length, 1.0)
    assert route.cost == pytest.approx(((np.diff(route.q, axis=0) / unit) ** 2).sum(), rel=1e-9)


@pytest.mark.slow
def test_a_wider_cone_never_costs_more_and_no_alternative_costs_less():
    rows = [DH(0, np.pi / 2, 0.1), DH(-0.4), DH(-0.35), DH(0, np.pi / 2, 0.1), DH(0, -np.pi / 2, 0.1), DH(0, 0, 0.08)]
    limits = [(-7, 7)] * 3 + [(-4, 4.5), (-2, 2), (-7, 3)]
    arm = pieper.Arm.from_dh(rows, convention="standard", limits=limits)
    T = arm.fk([0.1, -1.2, 1.3, -1.0, -1.4, 0.2])
    E = T.copy()
    E[1, 3] += 0.15
    path, before = pieper.line(T, E, 30), np.inf
    for cone in (0.0, 0.01, 0.05, 0.2, 0.5):
        route = arm.route(path, free=pieper.Freedom(cone=cone))
        assert route.cost <= before * (1 + 1e-6)
        assert all(route.cost <= other.cost * (1 + 1e-6) for other in route.alternatives)
        before = route.cost


@pytest.mark.slow
def test_a_told_start_that_does_not_get_there_is_refused_with_proof():
    def deg(*pairs):
        return [tuple(np.radians(pair)) for pair in pairs]

    rows = [DH(0, np.pi / 2, 0.1), DH(-0.4), DH(-0.35), DH(0, np.pi / 2, 0.1), DH(0, -np.pi / 2, 0.1), DH(0, 0.4, 0.08)]
    limits = deg((-170, 200), (-200, 20), (-150, 150), (-350, 100), (-120, 350), (-350, 350))
    arm = pieper.Arm.from_dh(rows, convention="standard", limits=limits)
    start = [-1.8819225630896814, -3.2026363786616856, 1.9436062288968015]
    start += [0.7116131631429958, 1.6857442549287938, 2.3014497599606916]
    end = pieper.pose(0.14901694896209317, 0.03840297966156275, 0.6172537380396365)
    end[:3, :3] = [
        [-0.5579091635547881, 0.5519911024522145, -0.6197121816094834],
        [0.665431249197814, 0.7437605759443344, 0.06341496875335152],
        [0.4959219876277244, -0.37699605897746574, -0.782262969660987],
    ]
    route = arm.route(pieper.line(arm.fk(start), end, 20), free=pieper.Freedom(), start=start)
    assert route.verdict is pieper.Verdict.IMPOSSIBLE
    assert "All that is reached from the posture told for the first pose" in route.reason


def wrist():
    rows = [DH(0, np.pi / 2, 0.3), DH(0.4), DH(0, np.pi / 2), DH(0, -np.pi / 2, 0.3), DH(0, np.pi / 2), DH()]
    limits = [(0, 0.6), (0.6, 1.2), (0.2, 0.8), (-3.3, 3.3), (-2, 2), (-3.3, 3.3)]
    return pieper.Arm.from_dh(rows, convention="standard", limits=limits)


def turned_beside_the_wrist(arm, d):
    """Return a turn on the spot that passes the wrist's singular posture by an angle (rad)."""
    C, by = arm.fk([0.3, 0.9, 0.5, 0, 0, 0]), pieper.pose(0, 0, 0, rpy=(0, d, 0))
    ends = (C @ pieper.pose(0, 0, 0, rpy=(t, 0, 0)) @ by for t in (0.3, -0.3))
    return pieper.line(*ends, 25)


@pytest.mark.parametrize("d", [1e-2, 1e-3, 3e-4, 1e-4, 1e-5])
def test_a_turn_beside_a_straight_wrist_swings_it(d):
    arm = wrist()
    path = turned_beside_the_wrist(arm, d)
    route = arm.route(path)
    assert route.verdict is FOUND
    np.testing.assert_allclose(arm.fk(route.q), path, atol=1e-8)
    # R = Rz(q4) Ry(q5) Rz(q6): the wrist keeps its side, and joint 4 goes from bearing to bearing
    assert (route.q[:, 4] > 0).all() or (route.q[:, 4] < 0).all()
    assert abs(np.ptp(route.q[:, 3]) - 2 * np.arctan2(0.3, d)) < 2e-2


@pytest.mark.slow
def test_more_freedom_does_not_lose_a_route_beside_a_singular_posture():
    arm = wrist()
    path = turned_beside_the_wrist(arm, 0.01)
    route = arm.route(path, free=pieper.Freedom(axis="x", turn=(-0.2, 0.2)))
    assert route.verdict is FOUND and route.cost < arm.route(path).cost
    turned = pieper.Freedom(axis="x").turned(path, route.turn)
    np.testing.assert_allclose(arm.fk(route.q), turned, atol=1e-8)
    # the bearing of the wrist goes round the singular posture, by pi less what the turn takes off its ends
    assert np.ptp(np.unwrap(route.q[:, 3])) > 2 * np.arctan2(0.1, 0.01) - 0.05
    assert (route.q[:, 4] > 0).all() or (route.q[:, 4] < 0).all()
