"""The equations of coupled joints: in the table's angles, with what the joints' own numbers have to do with them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import pieper
from pieper import InputError

ARMS = {
    "fanuc-lr-mate-200id": [(2, 1, 1)],
    "abb-irb2400": [(2, 1, -0.4), (4, 3, 0.25)],
    "adept-cobra-600": [(2, 3, 0.003)],
}


@pytest.fixture(params=ARMS, scope="module")
def arm(request):
    plain = pieper.load(request.param)
    C = np.eye(plain.n)
    for i, j, value in ARMS[request.param]:
        C[i, j] = value
    return pieper.Arm(replace(plain.description, coupling=C))


def test_forward_jacobian_and_determinant_are_by_the_joints_own_numbers(arm):
    assert arm.symbolic.fk().check(40).worst < 1e-13
    assert arm.symbolic.jacobian().check(40).worst < 1e-13
    assert arm.symbolic.singularities().check(20).worst < 1e-9


def test_the_inverse_gives_every_solution_in_the_joints_own_numbers(arm):
    equations = arm.symbolic.ik()
    checked = equations.check(8)
    assert checked.holds and checked.worst < 1e-9
    q = np.array([0.1, 0.2, 0.05, 0.3, 0.5, 0.6][: arm.n])
    T = arm.fk(q)
    rows = equations.evaluate(T[None])[:, 0]
    assert np.nanmax(np.abs(arm.fk(rows) - T)) < 1e-12
    sols = arm.ik(T)
    for row in sols.all_q:
        apart = arm.chain.joints.apart(rows, row)
        assert np.nanmin(apart) < 1e-8


def test_the_page_says_how_the_joints_follow(arm):
    text = arm.symbolic.ik().text()
    assert "These joints are coupled" in text
    said = {"fanuc-lr-mate-200id": "q3 = -theta2", "abb-irb2400": "q5 = -0.25*theta4 + theta5"}
    assert said.get(arm.name, "q3 = ") in text
    assert any("q2 + q3" in line or "q" in line for line in arm.symbolic.fk().relations())


def test_joint_numbers_that_are_no_angles_are_refused_with_a_cure(arm):
    with pytest.raises(InputError, match='write angles="theta"'):
        arm.symbolic.fk(angles="q")
