"""Printed solutions to their last digit, lengths that are named and zero, circular entries of matrices."""

from __future__ import annotations

import pytest

import pieper
from pieper.judge.verdict import HOLDS, PARTLY, WRONG

PUMA = """[arm]
convention = "modified"
length_unit = "m"
columns = ["a", "alpha", "d", "theta"]
rows = [[0, 0, 0, "q1"], [0, "-90 deg", 0, "q2"], ["a2", 0, "d3", "q3"], ["a3", "-90 deg", "d4", "q4"],
        [0, "90 deg", 0, "q5"], [0, "-90 deg", 0, "q6"]]
values = { a2 = 0.4318, a3 = 0.0203, d3 = 0.1244, d4 = 0.4318 }
"""
THREE = """[arm]
convention = "standard"
length_unit = "m"
columns = ["theta", "d", "a", "alpha"]
rows = [["q1", "l1", "e1", "90 deg"], ["q2", "e2", "l2", 0], ["q3", 0, "l3", 0]]
values = { l1 = 0.35, l2 = 0.4, l3 = 0.3, e1 = 0, e2 = 0 }
"""


def verdict(head: str, claim: str):
    return pieper.check(f"{head}\n[[claim]]\nid = 'x'\n{claim}\n").verdicts[0]


@pytest.mark.parametrize("joint", range(6))
@pytest.mark.parametrize("off", [4, -6, 1.2])
def test_a_joint_off_by_more_than_its_last_digit_is_no_solution(joint, off):
    q = [10, 20, 30, 40, 50, 60]
    printed = [str(round(v + off) if k == joint else v) for k, v in enumerate(q)]
    exact = [v if abs(off) > 1.5 or k != joint else v + (off - 1) + 0.6 for k, v in enumerate(q)]
    said = verdict(PUMA, f'kind = "solutions"\nq_deg = {exact}\nsolutions_deg = [{printed}]')
    assert said.status == (WRONG if abs(off) > 1.5 else HOLDS), said


def test_rounded_and_cut_off_joints_close():
    joints = '["10.2 deg", "19.7 deg", "30.4 deg", "40.9 deg", "49.8 deg", "60.4 deg"]'
    said = verdict(PUMA, f'kind = "solutions"\nq = {joints}\nsolutions_deg = [[10, 20, 30, 40, 50, 60]]')
    assert said.status == HOLDS


def test_the_turn_is_held_to_the_digits_of_the_matrix():
    arm = pieper.load("unimation-puma-560")
    q = [10, 20, 30, 40, 50, 60]
    table = pieper.check(PUMA + '\n[[claim]]\nkind = "count"\ncount = 8\n')
    assert table.verdicts and arm.n == 6
    for off, status in ((0.02, WRONG), (0.0, HOLDS)):
        near = [v + (off if k == 4 else 0) for k, v in enumerate(q)]
        printed = [f"{v:.3f}" for v in near]
        said = verdict(PUMA, f'kind = "solutions"\nq_deg = {q}\nsolutions_deg = [{printed}]')
        assert said.status == status


@pytest.mark.parametrize("text", ["c1 (l2 c2 + l3 c23) - e2 s1", "c1 (l2 c2 + l3 c23)", "l1 e1 + c1 (l2 c2 + l3 c23)"])
def test_a_length_that_is_named_and_zero_is_a_length(text):
    said = verdict(THREE, f'kind = "entry"\nof = "Px"\nis = "{text}"')
    assert said.status == PARTLY and "only because" in said.sentence and "e2 = 0" in said.sentence
    assert verdict(THREE, 'kind = "entry"\nof = "Px"\nis = "c1 (e1 + l2 c2 + l3 c23) + e2 s1"').status == HOLDS


@pytest.mark.parametrize(
    ("joint", "text"),
    [
        (1, "atan2(R01[2,1], R01[1,1])"),
        (2, "atan2(R02[3,1], R02[3,2])"),
        (3, "atan2(R23[2,1], R23[1,1])"),
        (2, "atan2(P12[2], P12[1])"),
    ],
)
def test_a_joint_taken_from_its_own_matrix_is_circular(joint, text):
    said = verdict(THREE, f'kind = "joint"\njoint = {joint}\nis = "{text}"')
    assert said.status == WRONG and "circular" in said.sentence


def test_entries_of_matrices_may_stand_in_matrices_of_ones_own():
    head = '[arm]\nrobot = "denso-vp6242"\n[matrices]\nM = [["R06[1,1]", "-s1"], ["s1", "c1"]]\n'
    assert verdict(head, 'kind = "equation"\nis = "M[1,1] = nx"').status == HOLDS
