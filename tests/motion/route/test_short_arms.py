"""Routes of arms with fewer than six joints: found or refused with proof, as their own formulas say."""

import numpy as np
import pytest

import pieper
from oracle.planar import reached

LINKS = (0.4, 0.35, 0.1)
LIMITS = [(-2.0, 2.0), (-2.2, 2.2), (-1.5, 1.5)]
PLANAR = pieper.Arm.from_dh([pieper.DH(a, 0, 0, 0) for a in LINKS], convention="standard", limits=LIMITS)
FREE = pieper.Freedom()


@pytest.mark.parametrize("number", range(12))
def test_a_planar_arm_is_refused_where_no_heading_leads_on(number):
    rng = np.random.default_rng([5, number])
    ends = [PLANAR.fk(rng.uniform(*PLANAR.limits.T)) for _ in range(2)]
    if number % 3 == 0:
        ends[1][:2, 3] *= 1.1 * sum(LINKS) / np.linalg.norm(ends[1][:2, 3])
    route = PLANAR.route(pieper.line(*ends, 16), free=FREE)
    points = pieper.line(*ends, 200)[:, :2, 3]
    last = reached(points, LINKS, PLANAR.limits)
    assert route.verdict is not pieper.Verdict.UNCERTAIN
    assert route.found == (last == 199)
    if not route.found:
        # the place told is the one where the flood ends, as nearly as stations stand
        assert route.blocked.s[0] - 0.02 < last / 199 < route.blocked.s[1] + 0.01


@pytest.mark.parametrize("free", [None, FREE, pieper.Freedom(turn=(-0.5, 0.5))])
@pytest.mark.parametrize("name", ["adept-cobra-600", "doosan-p3020"])
def test_a_pose_out_of_reach_of_a_short_arm_is_told_where_it_is(name, free):
    arm = pieper.load(name)
    near = arm.fk(np.clip(np.full(arm.n, 0.3), *(0.9 * arm.limits.T)))
    far = near.copy()
    far[0, 3] += 5.0
    route = arm.route(pieper.line(near, far, 30), free=free)
    assert route.verdict is pieper.Verdict.IMPOSSIBLE
    assert "out of reach" in route.blocked.why
    assert route.blocked.s[1] < 0.3


SHORT = [
    ("interbotix-viperx-300", "z"),
    ("adept-cobra-600", "x"),
    ("adept-cobra-600", "z"),
    ("three-r", "z"),
    ("doosan-p3020", "x"),
]


@pytest.mark.parametrize("free", [FREE, pieper.Freedom(cone=0.1), pieper.Freedom(turn=(-0.1, 0.1))])
@pytest.mark.parametrize(("name", "axis"), SHORT)
def test_a_freedom_that_a_short_arm_can_use_is_no_poorer_than_none(name, axis, free):
    arm = pieper.load(name)
    limits = np.clip(arm.limits, -3, 3)
    q = limits[:, 0] + (limits[:, 1] - limits[:, 0]) * np.array([0.55, 0.6, 0.4, 0.7, 0.6])[: arm.n]
    path = pieper.line(arm.fk(q), arm.fk(q + 0.01), 10)
    held = arm.route(path)
    route = arm.route(path, free=pieper.Freedom(turn=free.turn, cone=free.cone, axis=axis))
    assert route.found, route.explain()
    assert not held.found or route.cost <= held.cost * (1 + 1e-6)
    assert np.abs(arm.fk(route.q)[:, :3, 3] - path[:, :3, 3]).max() < 1e-9
    if free.cone == 0 and arm.plan.task != "position":
        turned = pieper.Freedom(axis=axis).turned(path, route.turn)
        assert np.abs(arm.fk(route.q) - turned).max() < 1e-8


def test_where_the_joints_decide_the_turn_arcs_say_so():
    arm = pieper.load("interbotix-viperx-300")
    with pytest.raises(pieper.PlanError, match="its own joints decide the turn"):
        arm.arcs(arm.fk(np.full(5, 0.2)))


def test_the_turn_that_an_arms_own_task_leaves_is_told():
    arm = pieper.load("interbotix-viperx-300")
    path = pieper.line(arm.fk([0.1, 0.2, 0.3, 0.4, 0.5]), arm.fk([0.4, 0.4, 0.1, 0.2, 0.3]), 10)
    route = arm.route(path)
    assert np.abs(arm.fk(route.q) - pieper.Freedom().turned(path, route.turn)).max() < 1e-8
    assert np.ptp(route.turn) > 1e-3 and "The tool turns between" in route.explain()
