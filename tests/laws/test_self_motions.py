"""Self-motions in closed form: they hold the pose, their intervals are exact, and no batch changes an answer."""

from __future__ import annotations

import numpy as np
import pytest

from oracle.arms.known import free
from pieper import DH, Arm
from pieper.kinematics.newton import missed
from pieper.solver.singular.trace import trace
from pieper.solver.singular.traced_motion import TracedMotion

ARMS = ["denso-vp6242", "universal-robots-ur5e", "stanford-arm", "unimation-puma-560"]


def on_axis(arm: Arm, q: np.ndarray) -> np.ndarray:
    """Return q with joint 2 so that the wrist centre of an arm with a spherical wrist lies on axis 1, by halving."""
    values = np.linspace(-3, 3, 400)
    line = np.tile(q, (400, 1))
    line[:, 1] = values
    side = [_aside(arm, p) for p in line]
    k = int(np.argmin(np.abs(np.diff(np.sign(side)) == 0)))
    low, high = values[k], values[k + 1]
    for _ in range(80):
        q[1] = (low + high) / 2
        low, high = (q[1], high) if np.sign(_aside(arm, q)) == np.sign(side[k]) else (low, q[1])
    return q


def _aside(arm: Arm, q: np.ndarray) -> float:
    frames = arm.chain.native_axes.frames(q[None], np.eye(4))[0]
    centre, first = frames[5, :3, 3], frames[1]
    return float((centre - first[:3, 3]) @ np.cross(frames[2, :3, 2], first[:3, 2]))


def cases():
    """Yield arms with joint vectors on self-motions of two and of four joints, and limits about them."""
    rng = np.random.default_rng(5)
    for name in ARMS:
        for _ in range(3):
            q = rng.uniform(-2, 2, 6)
            q[4] = 0.0
            yield name, q
    for _ in range(3):
        yield "denso-vp6242", on_axis(free("denso-vp6242"), rng.uniform(-1.2, 1.2, 6))


@pytest.mark.parametrize(("name", "q"), list(cases()))
def test_a_self_motion_holds_the_pose_everywhere_and_is_the_one_that_is_traced(name, q):
    arm = free(name)
    T = arm.fk(q)
    sols = arm.ik(T)
    mine = [motion for motion in sols.self_motions if motion.contains(q, 1e-7)]
    assert len(mine) == 1
    motion = mine[0]
    assert not isinstance(motion, TracedMotion)
    at = np.array([motion.at(u) for u in np.linspace(0, 1, 23)])
    assert missed(arm.chain, at, T).max() < 2e-12
    traced = trace(arm.chain, q, T, arm.limits, arm.joint_names)
    assert traced.closed and traced.free == motion.free
    assert motion.distances(traced.samples).max() < 3e-2 and traced.distances(motion.samples).max() < 3e-2
    assert all(motion.contains(row, 1e-6) for row in traced.samples[::9])
    aside = q + 0.01 * motion.direction[::-1] + 0.01
    assert not motion.contains(aside, 1e-3)


@pytest.mark.parametrize(("name", "q"), list(cases()))
@pytest.mark.parametrize("width", [0.9, 0.3, 0.02])
def test_what_lies_inside_limits_is_exact_and_the_nearest_point_is_nearest(name, q, width):
    rng = np.random.default_rng(int(1e3 * abs(q[0]) + 1e3 * width))
    middle = q + rng.uniform(-width, width, 6) * 0.9
    arm = free(name).with_limits(
        {n: (m - width, m + width) for n, m in zip(free(name).joint_names, middle, strict=True)}
    )
    T = arm.fk(q)
    sols = arm.ik(T)
    assert sols.status.name == "SINGULAR"
    motion = next(m for m in sols.self_motions if m.contains(q, 1e-7))
    assert any(arm.chain.joints.inside_limits(motion.at((a + b) / 2), arm.limits)[1] for a, b in motion.inside)
    u = np.linspace(0, 1, 3001)
    points = np.array([motion.at(x) for x in u])
    inside = arm.chain.joints.inside_limits(points, arm.limits)[1]
    told = np.array([any(a - 1e-12 <= x <= b + 1e-12 for a, b in motion.inside) for x in u])
    # at an end the limit is met to rounding: a sample that stands on it may fall to either side
    clear = np.array([min((abs(x - e) for i in motion.inside for e in i), default=1.0) > 1e-6 for x in u])
    assert (inside == told)[clear].all()
    assert len(sols.q) and arm.chain.joints.inside_limits(sols.q, arm.limits)[1].all()
    for _ in range(3):
        now = rng.uniform(arm.limits[:, 0], arm.limits[:, 1])
        near = motion.nearest(now)
        dense = [motion.at(x) for a, b in motion.inside for x in np.linspace(a, b, 400)]
        wound = arm.chain.joints.unwound(np.array(dense), now, arm.limits)
        assert np.linalg.norm(near - now) <= np.linalg.norm(wound - now, axis=1).min() + 1e-9
        assert missed(arm.chain, near, T) < 2e-12
        assert arm.chain.joints.inside_limits(near, arm.limits)[1]


def strata(arm: Arm, rng: np.random.Generator, count: int) -> np.ndarray:
    """Return poses of wrist-singular joint vectors, exact and at distances of 1e-12 to 1e-2, and ordinary ones."""
    q = rng.uniform(-2.5, 2.5, (count, 6))
    q[:, 4] = np.where(rng.uniform(size=count) < 0.4, 0.0, 10 ** rng.uniform(-12, -2, count))
    q[::7, 4] = rng.uniform(-2, 2, len(q[::7]))
    T = arm.fk(q)
    T[::11, :3, 3] *= 5.0
    return T


@pytest.mark.parametrize("name", ARMS)
def test_the_order_and_the_number_of_poses_in_a_call_change_nothing(name):
    arm, rng = free(name), np.random.default_rng(8)
    T = strata(arm, rng, 60)
    one = [arm.ik(pose) for pose in T]
    whole = arm.ik_many(T, threads=1)
    order = rng.permutation(len(T))
    shuffled = arm.ik_many(T[order], threads=1)
    pieces = [arm.ik_many(T[i : i + 7], threads=1) for i in range(0, len(T), 7)]
    for i, sols in enumerate(one):
        back = int(np.flatnonzero(order == i)[0])
        for many, k in ((whole, i), (shuffled, back), (pieces[i // 7], i % 7)):
            rows = many.q[k][many.valid[k]]
            assert many.status[k] == int(sols.status) and many.flag[k] == sols.flag
            assert len(rows) == len(sols.all_q)
            assert np.abs(rows - sols.all_q).max(initial=0.0) < 1e-12 or not sols.flag & 1
            assert (many.in_limits[k][many.valid[k]] == sols.in_limits).all()


def test_the_representative_does_not_depend_on_the_solution_that_made_the_pose():
    arm = free("denso-vp6242")
    q = np.array([0.4, 0.9, -0.3, 0.8, 0.0, -0.5])
    rows = []
    for turn in np.linspace(0, 6, 7):
        moved = q + np.array([0, 0, 0, turn, 0, -turn])
        sols = arm.ik(arm.fk(moved))
        rows.append(sols.q[sols.in_self_motion >= 0][0])
    assert np.ptp(rows, axis=0).max() < 1e-9


def test_a_wrist_in_line_is_told_where_rounding_of_the_pose_turns_it():
    """The elbow is so nearly stretched that what rounding leaves open of it turns the wrist by 1e-12."""
    arm = free("unimation-puma-560")
    q = np.array([-1.22903787e-03, 1.82391572e00, 1.61278235e00, -4.19957959e-01, 0.0, 1.22819174e00])
    sols = arm.ik(arm.fk(q))
    assert sols.status.name == "SINGULAR" and any(motion.contains(q, 1e-6) for motion in sols.self_motions)


@pytest.mark.parametrize("name", ARMS)
@pytest.mark.parametrize("size", [5e-13, 1e-12, 2e-12, 1e-11, 1e-9])
def test_no_solution_is_lost_all_but_on_a_wrist_singularity(name, size):
    arm, rng = free(name), np.random.default_rng(int(1e13 * size) % 1000)
    for _ in range(6):
        q = rng.uniform(-2, 2, 6)
        q[4] = size
        sols = arm.ik(arm.fk(q))
        near = arm.chain.joints.apart(sols.all_q, q).min()
        assert near < 1e-6 + 2e-14 / size or any(motion.contains(q, 1e-6) for motion in sols.self_motions)
        assert len(sols.all_q) % 2 == 0 or sols.self_motions


def test_a_fold_on_every_point_of_a_surface_is_no_third_degree_of_freedom():
    """Axes 1 and 2 are one line, 5 and 6 another; the straight elbow between them adds a third null direction only."""
    rows = [(0, 0, 0), (0.4, 0, 0), (0.3, 0, 0), (0.2, np.pi / 2, 0), (0, 0, 0.1), (0.1, 0.5, 0.2)]
    arm = Arm.from_dh([DH(*row, 0) for row in rows], convention="standard")
    for elbow in (0.0, 0.7):
        q = np.array([0.3, 0.4, elbow, 0.5, -0.2, 0.1])
        along = np.array([1.0, -1.0, 0, 0, 0, 0]) / np.sqrt(2)
        motion = trace(arm.chain, q, arm.fk(q), np.tile([-np.inf, np.inf], (6, 1)), arm.joint_names, along)
        assert motion.dimension == 2


#: Four parallel axes, then two whose turns the pose leaves to second order: every point of what is free is a fold.
FOLDED = [
    ((0.5, 0.3, 0.3, 0.7475), (-np.pi / 2, -np.pi / 2, np.pi / 2, np.pi / 2)),
    ((0.5, 0.4, 0.3, 0.6), (0.3, 0.9, -0.5, 0.7)),
    ((0.4, 0.4, 0.4, 0.5), (-0.4, 1.2, 0.8, -0.3)),
]


@pytest.mark.parametrize(("links", "turns"), FOLDED)
def test_a_curve_of_folds_is_followed_and_told_once(links, turns):
    """24 self-motions were told, 11 of them points: which of two null directions is the curve's no tangent says."""
    twists = (np.pi, np.pi, 0.0, -np.pi / 2, -1.6286, np.pi / 2)
    rows = [DH(a, twist, d, 0) for a, twist, d in zip((*links, 0, 0), twists, (0, 0.2, 0, 0, -0.1, 0), strict=True)]
    arm = Arm.from_dh(rows, convention="standard")
    q = np.array([*turns, 0.0, -np.pi / 2])
    T = arm.fk(q)
    (motion,) = arm.ik(T).self_motions
    assert motion.closed and motion.dimension == 1 and motion.free == (0, 1, 2, 3)
    assert motion.contains(q, 1e-5)
    assert max(missed(arm.chain, arm.chain.joints.wrapped(motion.at(u)), T) for u in np.linspace(0, 1, 9)) < 1e-11
