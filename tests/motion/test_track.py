"""Following paths: the right branch, no silent jump, every stop with its cause."""

import numpy as np
import pytest

import pieper
from pieper.errors import InputError
from pieper.motion.follow import follow

DENSO = pieper.load("denso-vp6242")
FREE = pieper.Arm.from_dh(DENSO.description.rows, convention="standard", name="denso-without-limits")

UP = np.eye(3)
FORWARD = np.array([[0.0, 0, 1], [0, 1, 0], [-1, 0, 0]])
SIDEWAYS = np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])
DOWN = np.diag([1.0, -1.0, -1.0])
FIRST, LAST = (0.35, 0.0, 0.4), (0.2, 0.1, 0.5)

# The one branch inside the limits at points 1, 13, 25, 38, 50, deg (recomputed independently at 50 digits)
BRANCH_UP = {
    0: (0, 51.492738, -150.638208, 0, 99.145470, 0),
    12: (4.470057, 63.014941, -161.719835, 0, 98.704894, -4.470057),
    24: (10.044159, 72.108669, -167.712547, 0, 95.603878, -10.044159),
    37: (17.690890, 79.538259, -169.810548, 0, 90.272289, -17.690890),
    49: (26.565051, 83.867278, -167.963671, 0, 84.096393, -26.565051),
}
BRANCH_FORWARD = {
    0: (0, 70.285829, -159.654676, 0, -0.631153, 0),
    12: (5.748663, 78.413645, -163.200967, -47.934613, -7.754215, 47.672711),
    24: (13.341459, 84.194048, -162.785509, -50.169490, -17.486630, 48.830838),
    37: (24.364649, 87.248708, -157.763710, -53.626995, -30.821478, 49.381409),
    49: (37.568592, 86.021348, -147.755182, -58.381942, -45.724495, 48.592033),
}


def at(R, p):
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, p
    return T


def line(R, first=FIRST, last=LAST, n=50):
    return pieper.line(at(R, first), at(R, last), n)


def unbroken(track):
    """Every point put back, and no step that the path does not ask for."""
    assert track.residual.max() < 1e-12
    return np.abs(np.diff(track.followed, axis=0)).max()


@pytest.mark.parametrize(("R", "expected"), [(UP, BRANCH_UP), (FORWARD, BRANCH_FORWARD)], ids=["up", "forward"])
def test_the_line_of_the_study_is_followed_by_the_one_branch_inside_the_limits(R, expected):
    track = DENSO.follow(line(R), start=np.radians(expected[0]))
    assert track.complete
    for k, q in expected.items():
        assert np.degrees(track.followed[k]) == pytest.approx(q, abs=2e-6)
    assert sum(b.complete for b in track.branches) == 1
    unbroken(track)


def test_all_eight_branches_pass_when_there_are_no_limits():
    track = FREE.follow(line(UP), start=np.zeros(6))
    assert [b.points for b in track.branches] == [50] * 8
    assert np.degrees(track.followed[0]) == pytest.approx((0, 9.2235, -68.6694, 0, 59.4459, 0), abs=1e-4)
    assert np.degrees(track.followed[-1]) == pytest.approx((26.5651, 23.6397, -51.344, 0, 27.7043, -26.5651), abs=1e-4)
    assert unbroken(track) < np.radians(2)


@pytest.mark.parametrize(("R", "count"), [(UP, 50), (FORWARD, 50), (SIDEWAYS, 35), (DOWN, 0)])
def test_the_tool_orientation_decides_how_many_points_can_be_reached(R, count):
    track = FREE.follow(line(R), start=np.zeros(6))
    assert track.reachable.sum() == count
    assert track.complete == (count == 50)


def test_a_fast_swing_near_the_wrist_singularity_is_a_remark_and_not_a_stop():
    track = DENSO.follow(line(FORWARD), start=np.radians(BRANCH_FORWARD[0]))
    remark = next(e for e in track.events if e.joint == "joint_4")
    assert not remark.stop
    assert np.degrees(remark.excess) == pytest.approx(24.3, abs=0.1)


def test_out_of_reach_is_found_between_the_points_and_the_branches_that_meet_there_are_named():
    track = FREE.follow(line(SIDEWAYS, LAST, FIRST), start=np.zeros(6))
    assert track.points == 35
    assert track.stop.cause == "out of reach"
    assert track.stop.s == pytest.approx(1 - 0.304405, abs=2e-6)
    assert track.stop.joint == "joint_3"
    # position comes first: the arm gets there, turned another way
    assert "0.69 deg are missing" in track.stop.detail
    for branch in track.branches:
        assert track.branches[branch.meets].meets == branch.index


def test_a_first_pose_without_solution_is_a_stop_at_zero():
    track = FREE.follow(line(DOWN), start=np.zeros(6))
    assert track.followed.shape == (0, 6)
    assert (track.stop.s, track.stop.cause) == (0.0, "out of reach")
    assert not track.branches


def test_printed_limits_taken_literally_forbid_the_first_pose_and_the_joint_is_named():
    limits = DENSO.limits.copy()
    limits[2] = np.radians([20, 160])
    literal = pieper.Arm.from_dh(DENSO.description.rows, convention="standard", limits=limits)
    track = literal.follow(line(UP), start=np.zeros(6))
    assert (track.points, track.stop.cause, track.stop.joint) == (0, "limit", "joint_3")
    assert [b.unlimited_points for b in track.branches] == [50] * 8


def test_whole_turns_stay_continuous_and_the_limit_says_that_another_turn_would_do():
    limits = [(-np.pi, np.pi)] * 5 + [(-2 * np.pi, 2 * np.pi)]
    arm = pieper.Arm.from_dh(DENSO.description.rows, convention="standard", limits=limits)
    turns = np.linspace(0, 4 * np.pi, 200)
    path = np.array(
        [at(np.array([[np.cos(t), -np.sin(t), 0], [np.sin(t), np.cos(t), 0], [0, 0, 1]]), FIRST) for t in turns]
    )
    track = arm.follow(path, start=np.zeros(6))
    assert (track.stop.cause, track.stop.joint) == ("limit", "joint_6")
    assert track.stop.s == pytest.approx(0.5, abs=1e-4)
    assert "1 turn lower" in track.stop.detail
    again = arm.follow(path, start=np.array([0, 0, 0, 0, 0, -2 * np.pi]))
    assert again.complete
    assert again.q[:, 5] == pytest.approx(turns - 2 * np.pi, abs=1e-9)


@pytest.mark.parametrize("n", [50, 51])
def test_the_wrist_may_pass_exactly_over_the_first_axis_without_turning_it(n):
    track = FREE.follow(line(UP, (-0.1, 0, 0.45), (0.1, 0, 0.45), n), start=np.zeros(6))
    assert track.complete
    assert track.largest_step[0] < 1e-6
    assert any(e.cause == "singularity" and not e.stop for e in track.events)


@pytest.mark.parametrize("offset", [1e-2, 1e-4, 1e-6])
def test_beside_the_first_axis_it_must_turn_however_near_it_passes(offset):
    track = FREE.follow(line(UP, (-0.1, offset, 0.45), (0.1, offset, 0.45)), start=np.zeros(6))
    assert track.complete
    assert abs(track.followed[-1, 0] - track.followed[0, 0]) == pytest.approx(
        np.pi - 2 * np.arctan2(offset, 0.1), abs=1e-6
    )


def test_a_corner_on_the_wrist_singularity_stops_only_the_branches_that_would_jump():
    q = np.array([0.3, 0.8, -2.2, 0.4, 0, 0.2])
    before, corner = FREE.fk(q - [0, 0, 0, 0, 0.5, 0]), FREE.fk(q)
    after = FREE.fk(np.array([0.3, 0.8, -2.2, 1.6, 0.5, -1.0]))
    path = np.concatenate([pieper.line(before, corner, 11), pieper.line(corner, after, 11)[1:]])
    track = FREE.follow(path, start=q - [0, 0, 0, 0, 0.5, 0])
    assert (track.points, track.stop.cause) == (11, "singularity")
    assert track.stop.s == pytest.approx(0.5)
    assert sum(b.complete for b in track.branches) == 6


def test_a_path_that_begins_singular_is_left_by_every_branch_without_a_jump():
    q = np.array([0.3, 0.8, -2.2, 0.4, 0, 0.2])
    end = FREE.fk(np.array([0.3, 0.8, -2.2, 1.6, 0.5, -1.0]))
    track = FREE.follow(pieper.line(FREE.fk(q), end, 11), start=q)
    assert track.complete
    assert len(track.branches) == 8
    assert unbroken(track) < 0.3


def test_forth_and_back_is_the_same_curve():
    rng = np.random.default_rng(5)
    for _ in range(4):
        q0 = rng.uniform(-1.5, 1.5, 6)
        q1 = q0 + rng.uniform(-0.4, 0.4, 6)
        path = pieper.line(FREE.fk(q0), FREE.fk(q1), 25)
        forth = FREE.follow(path, start=q0)
        if not forth.complete:
            continue
        back = FREE.follow(path[::-1], start=forth.q[-1])
        assert back.complete
        assert back.q[::-1] == pytest.approx(forth.q, abs=1e-6)


def test_finer_points_lie_on_the_same_curve():
    coarse = DENSO.follow(line(FORWARD, n=8), start=np.radians(BRANCH_FORWARD[0]))
    fine = DENSO.follow(line(FORWARD, n=71), start=np.radians(BRANCH_FORWARD[0]))
    assert coarse.q == pytest.approx(fine.q[::10], abs=1e-9)


def test_one_pose_and_a_rest_are_paths_too():
    T = at(UP, FIRST)
    assert DENSO.follow(T[None], start=np.zeros(6)).complete
    rest = DENSO.follow(np.repeat(T[None], 5, 0), start=np.zeros(6))
    assert rest.complete
    assert np.abs(rest.largest_step).max() == 0.0


@pytest.mark.parametrize(
    ("path", "start", "noun"),
    [
        (np.eye(4), np.zeros(6), "path"),
        (np.full((3, 4, 4), np.nan), np.zeros(6), "finite"),
        (np.zeros((0, 4, 4)), np.zeros(6), "empty"),
        (np.tile(np.diag([2.0, 1, 1, 1]), (2, 1, 1)), np.zeros(6), "rotation"),
        (line(UP), np.zeros(5), "start"),
        (line(UP), np.full(6, np.nan), "start"),
        (line(UP), "home", "start"),
    ],
)
def test_what_is_not_a_path_or_a_start_is_refused_by_name(path, start, noun):
    with pytest.raises(InputError, match=noun):
        follow(DENSO, path, start=start)


def test_a_track_explains_itself():
    text = FREE.follow(line(SIDEWAYS, LAST, FIRST), start=np.zeros(6)).explain()
    assert "35 of 50" in text
    assert "out of reach" in text


def test_a_track_has_one_row_a_point_and_says_which_were_reached():
    arm = pieper.load("denso-vp6242")
    path = pieper.line(pieper.pose(0.35, 0, 0.4), pieper.pose(0.2, 0.1, 0.9), n=10)
    track = arm.follow(path, start="line-start")
    assert not track.complete and 0 < track.points < 10
    assert track.q.shape == (10, 6) and track.reached.shape == track.s.shape == (10,)
    assert not track.reached[track.points :].any() and np.isfinite(track.q).all()
    # a point that was not reached holds the last posture that was
    assert (track.q[track.points :] == track.followed[-1]).all()
    assert np.abs(arm.fk(track.followed) - path[: track.points]).max() < 1e-9
