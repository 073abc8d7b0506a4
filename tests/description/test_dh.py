"""Describing an arm in Python: what is accepted, what is refused, and in which words."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pieper.description.dh import DH
from pieper.description.said import describe
from pieper.errors import InputError, PieperWarning

ROWS = [DH(a=0.3), DH(alpha=math.pi / 2, d=0.1), DH(theta=1.0)]


def test_everything_but_rows_and_convention_has_a_plain_default():
    arm = describe(ROWS, convention="standard")
    assert arm.n == 3 and arm.joint_types == "RRR" and arm.joint_names == ("joint_1", "joint_2", "joint_3")
    assert np.isinf(arm.limits).all() and (arm.sign == 1).all() and (arm.offset == 0).all()
    assert np.array_equal(arm.base, np.eye(4)) and np.array_equal(arm.tool, np.eye(4))


def test_a_row_may_be_four_numbers_in_the_order_of_the_columns():
    assert describe([(1, 0.5, 2, 3)], convention="modified").rows == (DH(a=1, alpha=0.5, d=2, theta=3),)


def test_arrays_of_a_description_cannot_be_changed():
    with pytest.raises(ValueError, match="read-only"):
        describe(ROWS, convention="standard").limits[0] = 0


def test_limits_may_be_missing_one_sided_and_wider_than_a_turn():
    arm = describe(ROWS, convention="standard", limits=[None, (None, 1), (-7, 7)])
    assert arm.limits.tolist() == [[-math.inf, math.inf], [-math.inf, 1.0], [-7.0, 7.0]]


@pytest.mark.parametrize(
    ("said", "message"),
    [
        ({"convention": "dh"}, "'standard'.*'modified'"),
        ({"joint_types": "RRX"}, "3 letters"),
        ({"joint_types": "RR"}, "3 letters"),
        ({"limits": [(1, -1), None, None]}, "joint_1 are swapped"),
        ({"limits": [(math.nan, 1), None, None]}, "joint_1 contain NaN"),
        ({"limits": [None, None]}, "2 entries for 3 joints"),
        ({"limits": [1, 2, 3]}, "joint_1 must be"),
        ({"joint_names": ["a", "b", "a"]}, "'a' is used twice"),
        ({"joint_names": ["a"]}, "1 name for 3 joints"),
        ({"sign": [1, 1, 0]}, r"sign must be \+1 or -1"),
        ({"offset": [0, math.nan, 0]}, "offset must be 3 finite"),
        ({"postures": {"home": [0, 0]}}, "posture 'home' must be 3"),
        ({"base": np.eye(3)}, "base must have shape"),
        ({"tool": np.diag([1, 1, -1, 1])}, "left-handed"),
        ({"tool": np.diag([2, 2, 2, 1])}, "not a rotation"),
        ({"base": np.full((4, 4), np.nan)}, "base must be finite"),
    ],
)
def test_what_is_impossible_is_refused(said, message):
    with pytest.raises(InputError, match=message):
        describe(ROWS, **{"convention": "standard"} | said)


@pytest.mark.parametrize("rows", [[], [DH()] * 61])
def test_an_arm_has_one_to_sixty_joints(rows):
    with pytest.raises(InputError, match="1 to 60 joints"):
        describe(rows, convention="standard")


@pytest.mark.parametrize("row", [(1, 2, 3), "abcd", None, 4])
def test_a_row_that_is_no_row_is_named_by_its_number(row):
    with pytest.raises(InputError, match="row 2|DH"):
        describe([DH(), row], convention="standard")


@pytest.mark.parametrize("value", [math.nan, math.inf, "x", None])
def test_a_column_must_be_a_finite_number(value):
    with pytest.raises(InputError, match="DH alpha must be"):
        DH(alpha=value)


@pytest.mark.parametrize("said", [{"alpha": 90}, {"theta": -180}])
def test_degrees_in_a_table_get_a_warning(said):
    with pytest.warns(PieperWarning, match="looks like degrees"):
        describe([DH(**said)], convention="standard")


def test_degrees_in_limits_get_a_warning():
    with pytest.warns(PieperWarning, match="looks like degrees"):
        describe([DH()], convention="standard", limits=[(-170, 170)])


def test_metres_of_a_slide_get_no_warning(recwarn):
    describe([DH()], convention="standard", joint_types="P", limits=[(-170, 170)])
    assert not recwarn
