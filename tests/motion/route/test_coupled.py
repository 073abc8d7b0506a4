"""Routes and arcs of arms whose joints are coupled: in the joints' own numbers, within the joints' own limits."""

from dataclasses import replace

import numpy as np
import pytest

import pieper
from oracle.turns import reaches
from pieper.errors import PlanError
from pieper.kinematics.pose import rotation_z

FREE = pieper.Freedom()
PLAIN = pieper.load("fanuc-lr-mate-200id")
PLAIN = PLAIN.with_tool(pieper.pose(0.05, 0.02, 0.1, rpy=(0, 0.6, 0)))
START = np.array([0.2, 0.3, -0.5, 0.3, -0.8, 0.3])


def coupled(C, **limits):
    arm = pieper.Arm(replace(PLAIN.description, coupling=C, name="coupled"))
    return arm.with_limits(limits) if limits else arm


def level(row=2, column=1, by=1.0):
    C = np.eye(6)
    C[row, column] = by
    return C


def seam(points=20, move=(0.05, 0.15, -0.1)):
    T = PLAIN.fk(START)
    U = T.copy()
    U[:3, 3] += move
    return pieper.line(T, U, points)


@pytest.mark.parametrize("C", [level(), level(2, 1, -1.0), level(5, 4) @ level()])
def test_a_route_of_coupled_joints_is_the_cheapest_in_their_own_numbers(C):
    arm, path = coupled(C), seam()
    route = arm.route(path, free=FREE)
    assert route.verdict is pieper.Verdict.FOUND
    assert np.abs(arm.fk(route.q) - FREE.turned(path, route.turn)).max() < 1e-9
    assert (route.q >= arm.limits[:, 0] - 1e-9).all() and (route.q <= arm.limits[:, 1] + 1e-9).all()
    assert route.bound <= route.cost
    # the axes' own cheapest route is one of these joints too, and costs no less in their numbers
    other = np.linalg.solve(C, PLAIN.route(path, free=FREE).q.T).T
    assert route.cost <= np.sum(np.diff(other, axis=0) ** 2) * (1 + 1e-9)
    motion = pieper.time_law(route, pieper.Limits(1.0, 4.0))
    steps = np.abs(np.diff(motion.q[:-1], axis=0)) * 500.0
    assert motion.margin <= 1 and steps.max() <= 1.0 + 1e-9


@pytest.mark.parametrize("low, high", [(-1.2, -0.55), (-0.9, -0.6), (-0.75, -0.72), (-2.0, -0.85)])
def test_a_limit_of_a_coupled_joint_decides_as_a_search_over_turns_does(low, high):
    arm = coupled(level(), joint_3=(low, high))
    route = arm.route(seam(8), free=FREE)
    dense = seam(40)
    got = reaches(arm, dense, 360) == len(dense) - 1
    assert route.verdict is not pieper.Verdict.UNCERTAIN
    assert route.found == got


def test_arcs_end_where_a_coupled_joint_meets_its_limit():
    arm = coupled(level(), joint_3=(-1.05, -0.85))
    T = seam()[3]
    arcs = arm.arcs(T)
    assert any(end.joint == "joint_3" for arc in arcs for end in arc.ends)
    turn = (np.arange(720) + 0.37) * 2 * np.pi / 720
    many = arm.ik_many(T @ rotation_z(turn))
    # whole turns aside, as many rows as arcs at each turn
    open_ = np.zeros(len(turn), int)
    seen = {}
    for arc in arcs:
        for k in range(-2, 3):
            inside = (turn + 2 * np.pi * k >= arc.lo) & (turn + 2 * np.pi * k <= arc.hi)
            q = [np.interp(t, arc.turn, arc.q[:, 1]) for t in turn[inside] + 2 * np.pi * k]
            for i, value in zip(np.flatnonzero(inside), q, strict=True):
                seen.setdefault(i, set()).add((arc.branch, round(float(value), 2)))
    for i, rows in seen.items():
        open_[i] = len(rows)
    assert ((open_ > 0) == many.in_limits.any(1)).all()


@pytest.mark.parametrize("turn", ["free", (-0.2, 0.2), (0.0, 0.0)])
def test_the_tool_of_coupled_joints_may_tilt(turn):
    arm, path, free = coupled(level()), seam(8), pieper.Freedom(turn=turn, cone=0.1)
    route = arm.route(path, free=free)
    assert route.verdict is pieper.Verdict.FOUND
    T = arm.fk(route.q)
    assert np.abs(T[:, :3, 3] - path[:, :3, 3]).max() < 1e-9
    assert np.arccos(np.clip(np.sum(T[:, :3, 2] * path[:, :3, 2], axis=1), -1, 1)).max() < 0.1 + 1e-9
    assert (route.q >= arm.limits[:, 0] - 1e-9).all() and (route.q <= arm.limits[:, 1] + 1e-9).all()
    # to tilt is allowed, not asked for: no dearer than upright
    assert route.cost <= arm.route(path, free=pieper.Freedom(turn=turn)).cost * (1 + 1e-9)
    # without limits the axes' own cheapest route is one of these joints too
    wide = {joint: (-20.0, 20.0) for joint in arm.joint_names}
    other = np.linalg.solve(level(), PLAIN.with_limits(wide).route(path, free=free).q.T).T
    best = arm.with_limits(wide).route(path, free=free).cost
    assert best <= np.sum(np.diff(other, axis=0) ** 2) * (1 + 1e-9)


def test_joints_coupled_in_parts_of_turns_are_told():
    with pytest.raises(PlanError, match="parts of turns"):
        coupled(level(2, 1, 0.5)).route(seam(), free=FREE)


def test_the_controllers_numbers_of_a_fanuc_have_routes():
    arm = pieper.load("fanuc-lr-mate-200id-controller").with_tool(pieper.pose(0.05, 0.02, 0.1, rpy=(0, 0.6, 0)))
    T = arm.fk([0.2, 0.3, -0.5, 0.3, -0.8, 0.3])
    U = T.copy()
    U[:3, 3] += [0.05, 0.15, -0.1]
    route = arm.route(pieper.line(T, U, 20), free=FREE)
    assert route.found and arm.arcs(T)
