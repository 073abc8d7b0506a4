"""Seed 004's T03 and T06 of the Fanuc R-2000iC/165F: what is right, and the cause of what is not."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from pieper import DH, Arm
from tests.papers.reference_arms import read

SETS = read("poses_of_the_r2000ic.json")


@pytest.fixture(scope="module")
def arm():
    return pieper.load("fanuc-r2000ic-165f")


@pytest.mark.parametrize("k", range(3))
def test_the_third_frame_is_the_one_of_the_report_with_its_misprints_put_right(arm, k):
    third = arm.frames(np.radians(SETS["thetas"][k]))[3]
    np.testing.assert_allclose(third[:3, :3], SETS["T03_rotation"][k], atol=6e-5)
    np.testing.assert_allclose(third[:3, 3], SETS["T03_position"][k], atol=6e-5)


@pytest.mark.parametrize("k", range(3))
def test_the_tool_is_where_the_table_puts_it(arm, k):
    T = arm.fk(np.radians(SETS["thetas"][k]))
    np.testing.assert_allclose(T[:3, :3], SETS["T06_rotation"][k], atol=6e-5)
    np.testing.assert_allclose(T[:3, 3], SETS["T06_position"][k], atol=1e-11)


@pytest.mark.parametrize("k", range(3))
def test_the_printed_positions_have_the_flange_in_the_wrong_column(arm, k):
    rows = list(arm.description.rows)
    last = rows[5]
    slipped = Arm.from_dh([*rows[:5], DH(last.d, last.alpha, 0.0, last.theta)], convention="standard")
    T = slipped.fk(np.radians(SETS["thetas"][k]))
    np.testing.assert_allclose(T[:3, 3], SETS["T06_position_as_printed"][k], atol=1.1e-4)


@pytest.mark.parametrize("k", range(3))
def test_each_set_is_singular_with_its_posture_in_a_self_motion_and_six_isolated_solutions(arm, k):
    q = np.radians(SETS["thetas"][k])
    sols = arm.ik(arm.fk(q))
    assert sols.status.name == "SINGULAR"
    assert [f.contains(q, 1e-6) for f in sols.self_motions].count(True) == 1
    unlimited = Arm.from_dh(arm.description.rows, convention="standard").ik(arm.fk(q))
    assert list(unlimited.in_self_motion).count(-1) == 6
