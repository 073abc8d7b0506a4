"""Where a step degenerates only what leads back to the pose is a solution; what a worked example then says."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

import pieper
from pieper import DH
from tests.equations.sentences import false_sentences


def built(rows, **more):
    return pieper.Arm.from_dh(rows, **{"convention": "standard", **more})


FIVE = built([DH(0, pi / 2, 0.3), DH(0.4), DH(0.3), DH(0, pi / 2, 0, pi / 2), DH(0, 0, 0.1)])
RRPR = built([DH(0.1, pi / 2, 0.2), DH(0.2, pi / 2), DH(d=0.1), DH(0.1)], joint_types="RRPR")
PRPR = built([DH(0, pi / 2, 0.2), DH(0.2, pi / 2), DH(0, pi / 2, 0.1), DH(0.1, 0, 0.1)], joint_types="PRPR")
SEVEN = built(
    [DH(0, -pi / 2, 0.34), DH(0, pi / 2), DH(0, pi / 2, 0.4), DH(0, -pi / 2), DH(0, -pi / 2, 0.4), DH(0, pi / 2)]
    + [DH(d=0.126)]
)
THREE = built([DH(0, pi / 2, 0.35), DH(0.4), DH(0.3)])
CASES = {
    "five axes, tool straight down": (FIVE, np.radians([40, 30, -60, -60, 20])),
    "a turn about the base's axis": (RRPR, [pi / 2, 0, 0.0883, pi]),
    "a slide": (PRPR, [-0.0069, -pi / 2, -0.0135, pi / 2]),
    "seven axes, stretched": (SEVEN, [0.2825, pi / 2, 1.9096, 0, -2.2662, -1.267, pi / 2]),
    "three axes, straight up": (THREE, [0.3, pi / 2, 0]),
}


@pytest.mark.parametrize("name", CASES)
def test_every_row_that_is_given_leads_to_the_pose(name):
    arm, q = CASES[name]
    T, ik = arm.fk(q), arm.symbolic.ik()
    rows = ik.evaluate(T[None])[:, 0]
    rows = rows[np.isfinite(rows).all(1)]
    given = ["noap".index(c) for c in ik.form.given]
    assert np.abs(arm.fk(rows) - T)[:, :3, given].max(initial=0.0) < 1e-5


@pytest.mark.parametrize("name", CASES)
def test_a_worked_example_ends_at_the_pose_that_it_began_with(name):
    arm, q = CASES[name]
    T = arm.fk(q)
    try:
        worked = arm.symbolic.ik().worked(T)
    except pieper.InputError as error:
        assert name == "a slide" and "cannot be worked through" in str(error)
        return
    text = worked.text()
    given = ["noap".index(c) for c in worked.form.given]
    assert np.abs(arm.fk(worked.q) - T)[:3, given].max() < 1e-6
    assert "nan" not in text and "again, to" in text
    for step in worked.form.steps:  # every line ends with what the joint is taken as
        joint = step.angle[0][0]
        if len(step.angle) == 1 and joint not in worked.form.table.prismatic:
            assert f"{np.degrees(worked.values[step.symbol]) + 0.0:.5f}".replace("-0.00000", "0.00000") in text


def test_a_pose_that_the_arm_cannot_take_is_not_given_again():
    T = FIVE.fk([0.3, 0.4, 0.5, 0.6, 0.7]) @ pieper.pose(0, 0, 0, rpy=(0.3, 0, 0))
    text = FIVE.symbolic.ik().worked(T).text()
    assert "do not give the pose" in text and "missed by 0.3" in text


def test_the_page_says_what_tells_the_signs_apart():
    text = RRPR.symbolic.ik().text()
    assert "Not every combination of the signs has a solution there: keep those that also satisfy" in text


@pytest.mark.parametrize(
    "rows",
    [
        [DH(1, -pi / 2), DH(2, pi / 2, 1), DH(1.5)],
        [DH(1, -pi / 2), DH(2, pi / 2, 1), DH(1.5, 0, 0.3)],
        [DH(0.2, -pi / 2, 0.4), DH(0.5, pi / 2), DH(0.3)],
    ],
)
def test_three_general_axes_have_their_quartic_for_positions(rows):
    arm = built(rows)
    ik = arm.symbolic.ik()
    assert ik.task == arm.plan.task == "position" and any(s.kind == "quartic" for s in ik.steps)
    assert false_sentences(arm, 20) == []


def test_only_joints_that_no_pose_fixes_are_chosen():
    arm = built([DH(0, -pi / 2), DH(0, pi), DH(0, pi), DH(0, pi)], joint_types="PRRR")
    ik, q = arm.symbolic.ik(), [0.4816, 2.6185, 0.1825, -1.3449]
    assert "theta2 and theta3 are chosen freely" in ik.text()
    assert ik.evaluate(arm.fk(q)[None])[0, 0, 0] == pytest.approx(0.4816)


def test_every_sign_of_a_page_is_said_on_it():
    arm = built(
        [DH(0, pi / 2, 0.28), DH(0.31, 0, 0.21), DH(0.22, -pi / 2), DH(0.28, pi, 0, pi / 2)],
        convention="modified",
        joint_types="RRRP",
    )
    ik = arm.symbolic.ik()
    assert all(f"sigma{k}" not in ik.text() for k in range(len(ik.form.sigmas) + 1, 9))


def test_three_parallel_axes_in_the_middle_have_their_polynomial():
    from oracle.arms.numbered import random_arm

    found = random_arm(33)[0].symbolic.ik().check(6)
    assert found.holds and found.poses == 6


def test_singular_places_that_cannot_be_are_not_said_to_be():
    text = RRPR.symbolic.singularities().text()
    assert "which cannot be with the lengths of this arm" in text
    q = np.random.default_rng(1).uniform(-pi, pi, (400, 4))
    q[:, 1] = 0
    assert np.linalg.svd(RRPR.jacobian(q), compute_uv=False)[:, -1].min() > 1e-3


def test_one_joint_and_repeated_joints_have_a_page():
    one = built([DH(d=0.05)], convention="modified")
    assert "keeps its rank in every posture" in one.symbolic.singularities().text()
    same = built([DH(0, pi, 0.22), DH(0, pi), DH(0, pi, 0.16)], joint_types="RPR")
    assert "never has full rank" in same.symbolic.singularities().text()
