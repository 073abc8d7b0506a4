"""A formula for a joint that finds it in a matrix made of that joint is circular, by whatever name the matrix goes."""

from __future__ import annotations

import pytest

import pieper
from tests.judge.test_zero_lengths import table

LINKS = table(())
SIX = '[arm]\nrobot = "denso-vp6242"\n'
UR = '[arm]\nrobot = "universal-robots-ur5e"\n'


def joint(arm: str, of: int | str, formula: str, more: str = ""):
    """The verdict on a formula for a joint, or for a sum of joints."""
    what = f"joint = {of}" if isinstance(of, int) else f'for = "{of}"'
    (found,) = pieper.check(f'{arm}\n[[claim]]\nkind = "joint"\n{what}\nis = "{formula}"\n{more}\n').verdicts
    return found


@pytest.mark.parametrize(("arm", "joints"), [(LINKS, 3), (SIX, 6)])
def test_the_matrix_of_one_joint_is_known_when_the_joint_is(arm, joints):
    for j in range(1, joints + 1):
        for name in (f"A{j}", f"Q{j}", f"R{j - 1}{j}", f"T{j - 1}{j}", f"R{j}{j - 1}^-1", f"R{j}{j - 1}^T"):
            found = joint(arm, j, f"atan2(({name})[2,1], ({name})[1,1])")
            assert found.wrong and "circular" in found.sentence, (j, name, found.sentence)
        found = joint(arm, j, "atan2(ny, nx)", f'frame = "T{j - 1}{j}"')
        assert found.wrong and "circular" in found.sentence, j


@pytest.mark.parametrize(
    ("arm", "of", "formula"),
    [
        (LINKS, 2, "atan2(R02[3,1], R02[3,2])"),
        (LINKS, 2, "atan2(P12[2], P12[1])"),
        (LINKS, 1, "atan2(q, c1)"),
        (LINKS, "theta2 + theta3", "atan2(M[2,1], M[1,1])"),
        (SIX, 3, "atan2(R03[2,1], R03[1,1])"),
        (SIX, 6, "atan2(R56[2,1], R56[1,1])"),
    ],
)
def test_hidden_joints_are_found(arm, of, formula):
    if "M[" in formula:
        arm += '\n[matrices]\nM = [["cos(theta2 + theta3)", 0], ["sin(theta2 + theta3)", 0]]\n'
    found = joint(arm, of, formula, 'where = { q = "A1[2,1]" }' if "q" in formula else "")
    assert found.wrong and "circular" in found.sentence


@pytest.mark.parametrize(
    ("arm", "of", "formula"),
    [
        (LINKS, 3, "atan2((R02^T R03)[2,1], (R02^T R03)[1,1])"),
        (LINKS, 3, "atan2(R13[2,1], R13[1,1]) - theta2"),
        (LINKS, "theta2 + theta3", "atan2(R13[2,1], R13[1,1])"),
        (SIX, 5, "+-acos(R36[3,3])"),
        (SIX, 5, "+-acos((Rz(pi) R36)[3,3])"),
        (SIX, 5, "+-acos(R03[1,3] ax + R03[2,3] ay + R03[3,3] az)"),
        (SIX, 5, "+-acos(dot(R03[:,3], R06[:,3]))"),
        (SIX, 6, "atan2((R05^T R06)[2,1], (R05^T R06)[1,1])"),
        (SIX, 1, "atan2(P05[2], P05[1]) + pi/2 -+ pi/2"),
        (UR, 3, "+-acos((P14[1]^2 + P14[2]^2 - a2^2 - a3^2)/(2 a2 a3))"),
    ],
)
def test_what_is_left_of_the_pose_is_no_circle(arm, of, formula):
    assert "circular" not in joint(arm, of, formula).sentence


@pytest.mark.parametrize("of", [1, 2, 3])
def test_what_a_joint_does_not_move_may_stand_in_its_formula(of):
    """The length of P12 is one of the arm."""
    assert "circular" not in joint(LINKS, of, f"atan2(py norm(P{of - 1}{of}), px norm(P{of - 1}{of}))").sentence


def test_both_sides_of_an_arm_reach_a_pose_whose_wrist_centre_is_known_without_the_last_joint():
    formula = 'is = ["atan2(P05[2], P05[1])", "atan2(P05[2], P05[1]) + pi"]'
    (found,) = pieper.check(f'{SIX}\n[[claim]]\nkind = "joint"\njoint = 1\n{formula}\n').verdicts
    assert found.holds and "two branches" in found.sentence
