"""Short arms' claims are about positions where a page means positions, and every verdict says what was asked for."""

from __future__ import annotations

import pytest

import pieper
from tests.judge.planted.short_arms import two_links
from tests.judge.test_zero_lengths import table

TWO = two_links(0.4, 0.3)
ELBOW = table(()).replace('"e1"', "0").replace('"e2"', "0").replace(", e1 = 0.12, e2 = 0.21", "")
LAW = "+-acos((px^2 + py^2 - a1^2 - a2^2)/(2 a1 a2))"
METHOD = """kind = "procedure"
steps = [
  { joint = 1, is = ["atan2(py, px)", "atan2(py, px) + pi"] },
  { joint = 3, is = "+-acos((px^2 + py^2 + (pz - l1)^2 - l2^2 - l3^2)/(2 l2 l3))" },
  { joint = 2, is = "atan2(pz - l1, c1 px + s1 py) - atan2(l3 s3, l2 + l3 c3)" },
]
"""


def verdict(arm: str, claim: str):
    (found,) = pieper.check(f"{arm}\n[[claim]]\n{claim}\n").verdicts
    return found


@pytest.mark.parametrize(
    ("arm", "count", "task", "status", "words"),
    [
        (TWO, 2, "", "holds", ("positions", "orientation", 'task = "position"')),
        (TWO, 2, "position", "holds", ("40 of 40 random positions",)),
        (TWO, 2, "pose", "wrong", ("never 2",)),
        (TWO, 1, "", "holds", ("random poses",)),
        (TWO, 3, "", "wrong", ("never 3",)),
        (ELBOW, 4, "", "holds", ("positions", "orientation")),
        (ELBOW, 1, "", "holds", ("random poses",)),
        (ELBOW, 8, "", "wrong", ("never 8",)),
    ],
)
def test_counts_say_of_what(arm, count, task, status, words):
    more = f'task = "{task}"' if task else ""
    found = verdict(arm, f'kind = "count"\ncount = {count}\n{more}')
    assert found.status == status and all(word in found.sentence for word in words), found.sentence
    if status == "wrong" and not task:
        assert "positions" in dict(found.details)


def test_both_signs_of_a_formula_of_positions_are_solutions_of_a_position():
    found = verdict(TWO, f'kind = "joint"\njoint = 2\nis = "{LAW}"')
    assert found.holds and "solutions of a position" in found.sentence
    assert 'task = "position"' in dict(found.details)["both signs"]
    assert verdict(TWO, f'kind = "joint"\njoint = 2\ntask = "position"\nis = "{LAW}"').holds
    assert verdict(TWO, f'kind = "joint"\njoint = 2\ntask = "pose"\nis = "{LAW}"').partly
    # what uses the orientation is about the pose
    turned = "+-acos(nx c1 + ny s1)"
    assert verdict(TWO, f'kind = "joint"\njoint = 2\nis = "{turned}"').partly


@pytest.mark.parametrize("task", ["", "position", "pose"])
def test_a_textbook_s_method_finds_every_solution_of_what_is_asked(task):
    more = f'task = "{task}"' if task else ""
    found = verdict(ELBOW, METHOD + more)
    number = "all 4 solutions of a position" if task == "position" else "the one solution of a pose"
    assert found.holds and number in found.sentence
    assert not verdict(ELBOW, METHOD.replace("l2 + l3 c3", "l2 - l3 c3") + more).holds


def test_half_of_a_method_says_what_it_misses():
    half = METHOD.replace('["atan2(py, px)", "atan2(py, px) + pi"]', '"atan2(py, px)"')
    found = verdict(ELBOW, half + 'task = "position"')
    assert found.partly and "Finds 2 solutions of a position, there are 4" in found.sentence
    assert "1 to 1" not in verdict(ELBOW, half).sentence


def test_what_is_all_of_a_pose_is_not_all_of_a_position():
    rows = 'kind = "solutions"\nq_deg = [20, 35, -60]\nsolutions_deg = [[20, 35, -60]]\ncomplete = true\n'
    assert verdict(ELBOW, rows).holds
    found = verdict(ELBOW, rows + 'task = "position"')
    assert found.partly and "there are 4" in found.sentence


@pytest.mark.parametrize(
    ("formula", "status", "words"),
    [
        ("theta2 = 0", "holds", "where theta2 = 180 deg"),
        ("theta2 = pi", "holds", "where theta2 = 0 deg"),
        ("theta2 = -pi", "holds", "where theta2 = 0 deg"),
        ("theta2 = 0 or theta2 = pi", "holds", ""),
        ("s2 = 0", "holds", ""),
        ("tan(theta2/2) = 0", "holds", "where theta2 = 180 deg"),
        ("theta2 = pi/2", "wrong", ""),
    ],
)
def test_singular_places_that_are_left_out_are_told_by_name(formula, status, words):
    found = verdict(TWO, f'kind = "singular"\nis = "{formula}"')
    assert found.status == status
    assert (words and words in found.sentence) or ("elsewhere" not in found.sentence and not words)


@pytest.mark.parametrize(
    ("formula", "whole"), [("s3 = 0", False), ("s3 = 0 or l2 c2 + l3 c23 = 0", True), ("theta3 = 0", False)]
)
def test_singular_places_of_an_elbow(formula, whole):
    found = verdict(ELBOW, f'kind = "singular"\nis = "{formula}"')
    assert found.holds and ("elsewhere" in found.sentence) != whole
