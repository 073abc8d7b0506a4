"""Where a self-motion turns back, passes a posture, or is nearest many turns away; what two held values each give."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle.joints import turns_apart
from pieper.solver.counted import most_met
from pieper.solver.singular.at_limits import _touching
from pieper.solver.singular.merged_roots import merged_root
from pieper.solver.singular.trace import trace
from pieper.tolerances import CONTAINS

SPARE = "kuka-lbr-iiwa-14-r820"
Q = np.array([0.3, 0.6, -0.4, -1.2, 0.5, 0.9, -0.2])
TURN = 2 * np.pi


def motions():
    arm = pieper.load(SPARE)
    return arm, arm.ik(arm.fk(Q)).self_motions


def test_a_joint_touches_a_limit_at_the_end_of_its_way_and_nowhere_else():
    _, found = motions()
    touched = 0
    for motion in found:
        for joint in motion.free:
            values = motion.samples[:, joint]
            inner = np.arange(1, len(values) - 1)
            for i in inner[(np.diff(values)[:-1] > 0) != (np.diff(values)[1:] > 0)]:
                side = 1.0 if values[i] > values[i - 1] else -1.0
                points = _touching(motion, joint, float(values[i]))
                assert len(points)
                grid = np.linspace(motion.u[i - 1], motion.u[i + 1], 401)
                way = side * np.unwrap([motion.point(u)[joint] for u in grid])
                nearest = points[np.argmin(np.abs(points[:, joint] - values[i]))]
                # no point of a fine grid goes farther, and one comes as far but for the grid's coarseness
                assert abs(side * nearest[joint] - way.max()) < 1e-5 * max(1.0, np.ptp(way))
                touched += 1
    assert touched > 5


def test_the_curve_passes_each_of_its_points_and_none_beside_them():
    arm, found = motions()
    for motion in found:
        for u in np.linspace(0.013, 0.987, 29):
            point = motion.point(float(u))
            assert motion._passes(point, CONTAINS)
            beside = point + 1e-3 * np.sign(np.sin(np.arange(1, 8) + 40 * u))
            assert not motion._passes(beside, CONTAINS) or motion.distance(beside) < 1e-6
    assert len(found) and arm.n == 7


@pytest.mark.parametrize("now", [(17.0, -16.0), (-19.0, 19.0), (6.5, 18.5), (-18.0, -18.0), (0.4, 19.5)])
def test_of_axes_in_one_line_the_nearest_point_is_found_however_many_turns_away(now):
    arm = pieper.load("denso-vp6242")
    arm = arm.with_limits(dict.fromkeys(arm.joint_names, (-20.0, 20.0)))
    q = np.array([0.3, 0.4, 1.2, 0.5, 0.0, -0.7])
    motion = next(m for m in arm.ik(arm.fk(q)).self_motions if set(m.free) == {3, 5})
    here = motion.representative.copy()
    here[[3, 5]] = now
    nearest = motion.nearest(here)
    assert motion.contains(nearest) and (np.abs(nearest[[3, 5]]) <= 20 + 1e-9).all()
    # by brute force: every whole turn of the last joint, and a fine grid along the line
    line = motion.representative
    sense = 1.0 if motion.contains(line + 0.3 * np.array([0, 0, 0, 1, 0, -1])) else -1.0
    x = np.linspace(-20, 20, 40001)
    best = np.inf
    for k in range(-12, 13):
        y = sense * (line[3] + sense * line[5] - x) + TURN * k
        inside = np.abs(y) <= 20
        if inside.any():
            best = min(best, np.hypot(x[inside] - now[0], y[inside] - now[1]).min())
    assert np.hypot(nearest[3] - now[0], nearest[5] - now[1]) <= best + 1e-9


@pytest.mark.parametrize("values", [(0.3, 0.9), (0.9, 0.3), (0.3, 0.3)])
def test_two_poses_at_two_held_values_each_have_the_rows_of_their_own(values):
    # held in the middle of the chain: each value has a kernel of its own
    arm = pieper.load(SPARE)
    q = np.tile(Q, (2, 1))
    q[:, 2] = values
    T = arm.fk(q)
    batch = arm.ik_many(T, redundancy={"joint_3": np.array(values)})
    for k in range(2):
        rows = batch.found.q[k][batch.found.valid[k]]
        one = arm.ik(T[k], redundancy={"joint_3": values[k]}).all_q
        assert len(rows) == len(one) > 0
        assert (turns_apart(rows[:, None], one[None]).max(-1).min(1) < 1e-9).all()
        assert (turns_apart(rows, q[k]).max(-1) < 1e-8).any()
        assert (np.abs(rows[:, 2] - values[k]) < 1e-9).all()


@pytest.mark.parametrize("coupling", [None, [[1, 0, 0], [0.5, 1, 0], [0, 0, 1]], [[1, 0, 0], [0, 2, 0], [0, -1, 3]]])
def test_branches_that_merge_are_counted_and_placed_by_the_joints_own_numbers(coupling):
    rows = [pieper.DH(a=a, alpha=0, d=0, theta=0) for a in (1.0, 0.7, 0.3)]
    arm = pieper.Arm.from_dh(rows, convention="standard", coupling=coupling)
    # stretched at the elbow, and off that by a double root's blur
    stretched = np.linalg.solve(arm.coupling, [0.4, 0.0, 0.3])
    blur = np.linalg.solve(arm.coupling, [1e-8, -2.5e-8, 1.5e-8])
    placed, branches = merged_root(arm.chain, stretched + blur, arm.fk(stretched))
    assert branches == 2
    assert np.abs(arm.coupling @ placed - [0.4, 0.0, 0.3]).max() < 1e-11


def test_solutions_are_counted_where_a_virtual_joint_is_the_first_that_is_held():
    plan = pieper.load("abb-gofa-crb15000-5-95").plan_for("position")
    assert plan.n in plan.reduction.locked
    assert 0 < most_met(plan, 100) <= plan.max_solutions


@pytest.mark.parametrize(
    "name", ["denso-vp6242", SPARE, "franka-panda", "adept-cobra-600", "dfrobot-rob0036-as-printed"]
)
def test_the_rank_of_a_plan_is_how_many_things_the_arm_can_do_at_once(name):
    arm = pieper.load(name)
    J = arm.jacobian(np.random.default_rng(9).uniform(-1, 1, (20, arm.n)))
    assert arm.plan_for("pose").rank == np.linalg.matrix_rank(J, tol=1e-9).max()


def test_a_surface_contains_what_holds_the_pose_far_from_every_line_on_it():
    """Axes 1 and 2 are one line, 5 and 6 another: two sums are held, and a surface of postures with them."""
    rows = [(0, 0, 0), (0.4, 0, 0), (0.3, 0, 0), (0.2, np.pi / 2, 0), (0, 0, 0.1), (0.1, 0.5, 0.2)]
    arm = pieper.Arm.from_dh([pieper.DH(*row, 0) for row in rows], convention="standard")
    q = np.array([0.3, 0.4, 0.7, 0.5, -0.2, 0.1])
    motion = next(m for m in arm.ik(arm.fk(q)).self_motions if m.dimension > 1)
    assert motion.contains(q)
    for a, b in ((0.9, -0.7), (-1.1, 0.4), (0.3, 1.2)):
        there = q + [a, -a, 0, 0, b, -b]
        assert np.abs(arm.fk(there) - arm.fk(q)).max() < 1e-12
        assert motion.contains(there) and not motion.contains(there + [0, 0, 0.1, 0, 0, 0])


def test_what_lies_on_a_surface_is_walked_to_where_sliding_along_it_does_not_arrive(monkeypatch):
    rows = [(0, 0, 0), (0.4, 0, 0), (0.3, 0, 0), (0.2, np.pi / 2, 0), (0, 0, 0.1), (0.1, 0.5, 0.2)]
    arm = pieper.Arm.from_dh([pieper.DH(*row, 0) for row in rows], convention="standard")
    q, along = np.array([0.3, 0.4, 0.7, 0.5, -0.2, 0.1]), np.array([1.0, -1.0, 0, 0, 0, 0]) / np.sqrt(2)
    motion = trace(arm.chain, q, arm.fk(q), np.tile([-np.inf, np.inf], (6, 1)), arm.joint_names, along)
    assert motion.dimension == 2
    monkeypatch.setattr(type(motion), "_slid", lambda self, point, *_: point)
    there = q + [0.9, -0.9, 0, 0, -0.7, 0.7]
    assert motion.contains(there) and not motion.contains(there + [0, 0, 0.1, 0, 0, 0])


def test_halving_finds_the_point_at_which_a_joint_has_a_value():
    arm, found = motions()
    T = arm.fk(Q)
    for motion in found:
        joint = motion.free[int(np.argmax(np.ptp(motion.samples[:, list(motion.free)], axis=0)))]
        step = np.abs(np.diff(motion.samples[:, joint]))
        for i in np.argsort(step)[-5:]:
            a, b = motion.samples[i, joint], motion.samples[i + 1, joint]
            for part in (0.1, 0.77):
                point = motion._halved(int(i), joint, float(a + part * (b - a)))
                assert point[joint] == a + part * (b - a)
                assert np.abs(arm.fk(point) - T).max() < 1e-9
