"""The straight line of the Denso study: how much of it is reachable in each orientation, and all eight branches."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from tests.papers.reference_arms import read, same

LINE = read("line_of_the_denso.json")
REVOLUTE = np.zeros(6, bool)


@pytest.fixture(scope="module")
def arm():
    return pieper.load("denso-vp6242")


def path(case):
    """Return the line (50, 4, 4) with the case's orientation kept."""
    ends = np.tile(np.eye(4), (2, 1, 1))
    ends[:, :3, :3] = case["R"]
    ends[0, :3, 3], ends[1, :3, 3] = LINE["from"], LINE["to"]
    return pieper.line(*ends, n=LINE["n"])


def cases(**having):
    """Return the cases that have all keys, as pytest parameters named by their tool direction."""
    return [pytest.param(c, id=c["tool"]) for c in LINE["cases"] if all(k in c for k in having)]


def test_the_line_has_the_length_and_the_step_of_the_study():
    steps = np.linalg.norm(np.diff(path(LINE["cases"][0])[:, :3, 3], axis=0), axis=1)
    np.testing.assert_allclose(steps, LINE["step_m"], rtol=1e-12)
    assert steps.sum() == pytest.approx(LINE["length_m"], rel=1e-13)


@pytest.mark.parametrize("case", cases())
def test_as_many_points_are_reachable_as_the_geometry_says(arm, case):
    poses = path(case)
    reached = arm.ik_many(poses, threads=1).valid.any(1)
    assert reached.sum() == case["reachable"]
    assert [len(arm.ik(T).all_q) > 0 for T in poses] == reached.tolist()
    if case["interval"]:
        s = np.linspace(0, 1, LINE["n"])
        assert np.array_equal(reached, (s >= case["interval"][0]) & (s <= case["interval"][1]))


@pytest.mark.parametrize("case", cases(branches=True))
def test_all_eight_branches_are_found_along_the_line(arm, case):
    poses = path(case)
    for j, point in enumerate(LINE["branch_points"]):
        sols = arm.ik(poses[point])
        expected = np.radians([branch[j] for branch in case["branches"]])
        gap = same(sols.all_q, expected, REVOLUTE)
        assert gap.shape == (8, 8) and gap.min(0).max() < 1e-9 and gap.min(1).max() < 1e-9


def unlimited(arm):
    """Return the arm with no joint limits."""
    return pieper.Arm.from_dh(arm.description.rows, convention="standard", name="denso without limits")


@pytest.mark.parametrize("case", cases(branches=True))
@pytest.mark.parametrize("branch", range(8))
def test_each_branch_is_followed_from_end_to_end(arm, case, branch):
    expected = np.radians(case["branches"][branch])
    track = unlimited(arm).follow(path(case), start=expected[0])
    assert track.complete and track.points == LINE["n"]
    here = track.followed[LINE["branch_points"]]
    assert np.diagonal(same(here, expected, REVOLUTE)).max() < 1e-8
    assert np.abs(np.diff(track.followed, axis=0)).max() < np.radians(60)


@pytest.mark.parametrize("case", cases(nearest_to_zeros=True))
def test_nearest_to_the_zero_posture_is_the_branch_of_the_study(arm, case):
    start = unlimited(arm).ik(path(case)[0]).nearest(np.zeros(6))
    np.testing.assert_allclose(np.degrees(start), case["nearest_to_zeros"], atol=1e-9)


@pytest.mark.parametrize("case", cases(branches=True))
def test_one_branch_stays_inside_the_limits(arm, case):
    poses = path(case)
    inside = [b for b in case["branches"] if all(_allowed(arm, row) for row in b)]
    if case["tool"].startswith(("identity", "tool +x: R")):
        assert len(inside) == 1
    for branch in inside:
        for j, point in enumerate(LINE["branch_points"]):
            assert same(arm.ik(poses[point]).q, np.radians([branch[j]]), REVOLUTE).min() < 1e-9


@pytest.mark.parametrize("case", [c for c in cases() if not 0 < c.values[0]["reachable"] == LINE["n"]])
def test_a_line_out_of_reach_stops_with_an_event_not_an_answer(arm, case):
    track = unlimited(arm).follow(path(case), start=np.zeros(6))
    assert not track.complete and track.points < LINE["n"]
    assert track.events, "a stop has a cause"
    assert "reach" in str(track.events[0].cause).lower().replace("_", " ")


def _allowed(arm, row):
    q = np.radians(row)
    lower, upper = arm.limits.T
    turns = q + 2 * np.pi * np.array([-1, 0, 1])[:, None]
    return bool(((turns >= lower - 1e-12) & (turns <= upper + 1e-12)).any(0).all())
