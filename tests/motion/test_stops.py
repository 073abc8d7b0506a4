"""Stops an integrator can act on: the place in millimetres, what is in the way, and cures that were followed."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from pieper.motion.in_the_way import in_the_way

DENSO = pieper.load("denso-vp6242")
SIDEWAYS = np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])
FORWARD = np.array([[0.0, 0, 1], [0, 1, 0], [-1, 0, 0]])


def at(R, p):
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, p
    return T


@pytest.fixture(scope="module")
def beyond():
    path = pieper.line(at(SIDEWAYS, (0.2, 0.1, 0.5)), at(SIDEWAYS, (0.35, 0, 0.4)), 50)
    return DENSO.follow(path, start=np.zeros(6))


def test_a_stop_says_where_along_the_line_it_is_in_millimetres_and_between_which_points(beyond):
    length = np.linalg.norm([0.15, -0.1, -0.1])
    stop = beyond.stop
    assert stop.metres == pytest.approx(stop.s * length, abs=1e-12)
    assert f"{stop.metres * 1e3:.1f} mm along the path, between points 35 and 36" in str(stop)


def test_a_stop_says_what_of_the_arm_is_in_the_way_and_the_number_is_true(beyond):
    assert "the arm is stretched: the wrist centre cannot get farther from axis 2 than 433 mm" in beyond.stop.detail
    rows = DENSO.description.rows
    assert np.hypot(rows[2].a, rows[3].d) + rows[1].a == pytest.approx(0.433, abs=5e-4)


def test_every_cure_is_followed_to_its_end_when_asked_again(beyond):
    assert {cure.kind for cure in beyond.cures} == {"tool tilted", "path shifted"}
    for cure in beyond.cures:
        again = DENSO.follow(cure.path, start=cure.start)
        assert again.complete and cure.track.complete and cure.words in beyond.explain()
    shifted = next(cure for cure in beyond.cures if cure.kind == "path shifted")
    assert np.abs(shifted.path[:, :3, 3] - beyond.path[:, :3, 3]).max() == pytest.approx(shifted.amount)
    tilted = next(cure for cure in beyond.cures if cure.kind == "tool tilted")
    assert np.array_equal(tilted.path[:, :3, 3], beyond.path[:, :3, 3])


def test_a_smaller_change_of_the_same_kind_does_not_do(beyond):
    shifted = next(cure for cure in beyond.cures if cure.kind == "path shifted")
    step = (shifted.path - beyond.path)[0, :3, 3]
    less = beyond.path.copy()
    less[:, :3, 3] += step * (1 - 8e-3 / shifted.amount)
    assert not any(branch.complete for branch in DENSO.follow(less, start=np.zeros(6)).branches)


def test_another_branch_that_passes_is_a_cure_with_its_joints():
    path = pieper.line(at(np.eye(3), (0.35, 0, 0.4)), at(np.eye(3), (0.2, 0.1, 0.5)), 50)
    free = pieper.Arm.from_dh(DENSO.description.rows, convention="standard", name="free")
    passes = free.follow(path, start=np.zeros(6))
    mine = passes.q
    joint, middle, low = next(
        (j, float(mine[25, j]), low)
        for j in range(6)
        for low in (False, True)
        for other in passes.branches
        if abs(mine[-1, j] - mine[0, j]) > 0.1
        and (mine[-1, j] < mine[0, j]) == low
        and ((other.q[:, j] > mine[25, j] + 0.1).all() if low else (other.q[:, j] < mine[25, j] - 0.1).all())
    )
    limits = np.tile([-2 * np.pi, 2 * np.pi], (6, 1))
    limits[joint] = (middle, 2 * np.pi) if low else (-2 * np.pi, middle)
    arm = pieper.Arm.from_dh(DENSO.description.rows, convention="standard", limits=limits, name="narrow")
    track = arm.follow(path, start=passes.q[0])
    assert track.stop is not None and track.stop.cause == "limit"
    start = track.cures[0]
    assert start.kind == "start" and "branch" in start.words
    assert arm.follow(path, start=start.start).complete
    assert start.amount == pytest.approx(np.abs(start.start - track.start).max(), abs=1e-12)
    for cure in track.cures[1:]:  # what is changed lets the branch pass that the arm is on: no start is needed too
        assert "starting" not in cure.words
        assert arm.follow(cure.path, start=track.start).complete


def test_a_limit_that_is_passed_between_two_points_is_seen_and_stands_where_fine_points_put_it():
    arm = pieper.load("universal-robots-ur5e")
    first, last = pieper.pose(0.5, -0.3, 0.4, rpy=(np.pi, 0, 0)), pieper.pose(0.5, 0.3, 0.4, rpy=(np.pi, 0, 0))
    q = arm.ik(first).q[0]
    fine = arm.follow(pieper.line(first, last, 61), start=q)
    assert fine.complete
    peaks = fine.q.max(0) - np.maximum(fine.q[0], fine.q[-1])
    joint = int(np.argmax(peaks))
    assert peaks[joint] > 0.05
    top = float(fine.q[:, joint].max() - peaks[joint] / 2)
    narrow = arm.with_limits({arm.joint_names[joint]: (float(arm.limits[joint, 0]), top)})
    stops = [narrow.follow(pieper.line(first, last, n), start=q).stop for n in (2, 3, 61)]
    for stop in stops:
        assert (stop.cause, stop.joint) == ("limit", arm.joint_names[joint])
        assert stop.s == pytest.approx(stops[-1].s, abs=1e-5)
    assert "at the points themselves it is inside" in stops[0].detail


def test_how_far_straight_joints_leave_the_line_is_what_dense_samples_say():
    path = pieper.line(at(np.eye(3), (0.35, 0, 0.4)), at(np.eye(3), (0.2, 0.1, 0.5)), 9)
    track = DENSO.follow(path, start=np.zeros(6))
    worst = 0.0
    for k in range(8):
        a, b = path[k, :3, 3], path[k + 1, :3, 3]
        for s in np.linspace(0, 1, 101):
            p = DENSO.fk(track.q[k] + s * (track.q[k + 1] - track.q[k]))[:3, 3]
            worst = max(worst, float(np.linalg.norm(np.cross(p - a, b - a)) / np.linalg.norm(b - a)))
    assert track.off_line.metres == pytest.approx(worst, rel=0.02)
    assert f"{track.off_line.metres * 1e3:.2g} mm off the line" in track.explain()


def test_a_singularity_of_another_branch_is_no_remark():
    """Lines through a wrist singularity: a remark stands where the followed Jacobian degenerates and only there."""
    free = pieper.Arm.from_dh(DENSO.description.rows, convention="standard", name="free")
    rng, others = np.random.default_rng(4), 0
    for _ in range(3):
        q = rng.uniform(-1.5, 1.5, 6)
        q[4] = 0.0
        half = np.array([0, 0, 0, 0, 0.4, 0])
        before, middle, after = free.fk(q - half), free.fk(q), free.fk(q + half)
        path = np.concatenate([pieper.line(before, middle, 4), pieper.line(middle, after, 4)[1:]])
        for first in free.ik(before).q[::2]:
            track = free.follow(path, start=first)
            if track.points > 4:
                remarks = [e for e in track.events if "passes it without a jump" in e.detail]
                sigma = np.linalg.svd(free.jacobian(track.q[3]), compute_uv=False)
                assert bool(remarks) == (sigma[-1] < 1e-6 * sigma[0])
                others += not remarks
    assert others >= 3


def test_the_own_singularity_is_a_remark_by_name():
    path = pieper.line(at(np.eye(3), (-0.1, 0, 0.45)), at(np.eye(3), (0.1, 0, 0.45)), 11)
    free = pieper.Arm.from_dh(DENSO.description.rows, convention="standard", name="free")
    track = free.follow(path, start=np.zeros(6))
    remark = next(e for e in track.events if "passes it without a jump" in e.detail)
    assert track.complete and "the wrist centre lies on axis 1" in remark.detail


@pytest.mark.parametrize("name", ["denso-vp6242", "universal-robots-ur5e", "unimation-puma-560", "abb-irb2400"])
def test_what_is_in_the_way_is_what_the_factors_of_the_determinant_say(name):
    arm = pieper.load(name)
    for found in arm.symbolic.singularities().configurations:
        for q in found.samples[:3]:
            assert in_the_way(arm.plan, np.array(q)).name == found.kind


def test_a_scara_is_stretched_and_an_arm_without_a_name_for_it_says_which_joints_move():
    scara = pieper.load("adept-cobra-600")
    words = in_the_way(scara.plan, np.array([0.3, 0.0, 0.1, 0.2])).words
    assert words == "the arm is stretched: axis 4 cannot get farther from axis 1 than 600 mm"
    crx = pieper.load("fanuc-crx-10ia")
    q = np.array(crx.symbolic.singularities().configurations[0].samples[0])
    _, s, rows = np.linalg.svd(crx.jacobian(q))
    said = in_the_way(crx.plan, q).words
    assert s[-1] < 1e-6 and "move there without moving the tool" in said
    for j in np.flatnonzero(np.abs(rows[-1]) > 0.2):
        assert crx.joint_names[j] in said


@pytest.mark.parametrize("side", [0, 1])
def test_the_excess_is_how_far_beyond_its_limit_the_joint_would_be_at_the_next_point(side):
    q = np.array([0.3, 1.2, -2.9, 0.5, 0.8, -0.7])
    T = DENSO.fk(q)
    path = np.tile(T, (20, 1, 1))
    path[:, :3, 3] += np.linspace(0, 1, 20)[:, None] * [0.0, 0.08, 0.05]
    free = DENSO.follow(path, start=q).q
    away = free[-1] - free[0]
    joint = int(np.argmin(away) if side == 0 else np.argmax(away))
    name, limit = DENSO.joint_names[joint], float(free[0, joint] + 0.4 * away[joint])
    limits = list(DENSO.limits[joint])
    limits[side] = limit
    stop = DENSO.with_limits({name: tuple(limits)}).follow(path, start=q).stop
    beyond = free[:, joint] < limit if side == 0 else free[:, joint] > limit
    first = int(np.argmax(beyond))
    assert first > 1 and stop.cause == "limit" and stop.joint == name
    assert stop.excess == pytest.approx(abs(free[first, joint] - limit), abs=1e-6)
    assert first - 1 <= stop.point <= first
