"""Routes of arms with fewer than six joints: found or refused with proof, as their own formulas say."""

import numpy as np
import pytest
from scipy.optimize import least_squares

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


def own_route(arm, path, axis, held, q):
    """Joints that follow the tool's point from q, with the turn held at zero where it is, by least squares alone."""
    x, out = q, []
    for T in path:

        def miss(y, T=T, near=x):
            F = arm.fk(y)
            D = T[:3, :3].T @ F[:3, :3] @ pieper.Freedom(axis=axis).to_z[:3, :3]
            D = pieper.Freedom(axis=axis).to_z[:3, :3].T @ D
            turn = [100 * np.arctan2(-D[0, 1], D[0, 0])] if held else []
            return np.concatenate([100 * (F[:3, 3] - T[:3, 3]), turn, 1e-3 * (y - near)])

        for _ in range(4):
            x = least_squares(miss, x, xtol=1e-15, ftol=1e-15, gtol=1e-15).x
        out.append(x)
    out = np.array(out)
    F, e = arm.fk(out), "xyz".index(axis)
    off = np.abs(F[:, :3, 3] - path[:, :3, 3]).max()
    tilt = np.arccos(np.clip((F[:, :3, e] * path[:, :3, e]).sum(1), -1, 1)).max()
    turned = max((abs(miss(y, T, y)[3]) / 100 for y, T in zip(out, path, strict=True)), default=0.0) if held else 0.0
    return off < 1e-9 and turned < 1e-9, tilt, out


LEANING = ["robotis-openmanipulator-x", "interbotix-pincherx-100", "interbotix-pincherx-150", "interbotix-viperx-300"]


@pytest.mark.parametrize("turn", ["free", (0.0, 0.0), (-0.2, 0.1)])
@pytest.mark.parametrize("axis", ["x", "y", "z"])
@pytest.mark.parametrize("name", LEANING)
def test_a_short_arm_that_leans_as_its_joints_decide_has_the_route_that_following_its_point_finds(name, axis, turn):
    arm = pieper.load(name)
    limits = np.clip(arm.limits, -2.5, 2.5)
    q = limits[:, 0] + (limits[:, 1] - limits[:, 0]) * np.array([0.55, 0.6, 0.4, 0.6, 0.6])[: arm.n]
    path = pieper.line(arm.fk(q), arm.fk(q + 0.05), 12)
    holds, tilt, own = own_route(arm, path, axis, turn == (0.0, 0.0), q)
    inside = ((own > arm.limits[:, 0]) & (own < arm.limits[:, 1])).all()
    if not (holds and inside and tilt < 0.09):
        pytest.skip("following the tool's point leaves the cone")
    route = arm.route(path, free=pieper.Freedom(axis=axis, cone=0.1, turn=turn))
    assert route.found and route.tilt.max() <= 0.1 and route.slope < np.inf
    assert route.cost <= np.sum(np.diff(own, axis=0) ** 2) * (1 + 1e-3)
    # what the route says of turn and tilt is what its joints do: R = path Rx(a) Ry(b) Rz(turn), z the axis meant
    z = pieper.Freedom(axis=axis).to_z[:3, :3]
    D = z.T @ np.swapaxes(path[:, :3, :3], 1, 2) @ arm.fk(route.q)[:, :3, :3] @ z
    assert np.abs(arm.fk(route.q)[:, :3, 3] - path[:, :3, 3]).max() < 1e-9
    off = np.arctan2(-D[:, 0, 1], D[:, 0, 0]) - route.turn
    assert np.abs(off - 2 * np.pi * np.round(off / (2 * np.pi))).max() < 1e-7
    assert np.abs(np.arccos(np.clip(D[:, 2, 2], -1, 1)) - route.tilt).max() < 1e-6
