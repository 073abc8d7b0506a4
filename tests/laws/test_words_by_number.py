"""What is written of one thing is in the singular: arms of one joint, one pose, one claim, one missing number."""

from __future__ import annotations

import re
from math import pi

import numpy as np
import pytest

import pieper

#: A one, and a plural: "1 solutions", "1 entries"; "0.1 degrees" is none, and "1 of 8 solutions" has its own count.
ONE_OF_MANY = re.compile(r"(?<![\d.,])1 (?!is\b|holds\b)[a-z]+[^s\W]s\b")


def single() -> pieper.Arm:
    """Return an arm of one joint."""
    return pieper.Arm.from_dh([pieper.DH(a=0.3, alpha=0, d=0.1)], convention="standard", limits=[(-1.0, 1.0)])


def texts() -> list[str]:
    """Return what is said of an arm of one joint, and of poses and claims one at a time."""
    arm = single()
    inside, outside = arm.ik(arm.fk([0.5])), arm.ik(arm.fk([2.0]))
    claims = """
title = "one claim"
[arms.a]
convention = "standard"
length_unit = "m"
columns = ["theta", "d", "a", "alpha"]
rows = [["q1", 0.1, 0.3, 0]]
[[claim]]
id = "c"
arm = "a"
kind = "pose"
q_deg = [0]
position = ["0.3", "0", "0.1"]
"""
    out = [repr(arm), arm.plan.explain(), inside.why, outside.why, str(outside), repr(arm.ik_many(arm.fk([[0.5]])))]
    out.append(pieper.check(claims).text())
    return out


@pytest.mark.parametrize("refused", [{"joint_names": ["a", "b"]}, {"limits": [(-pi, pi)] * 2}, {"coupling": np.eye(2)}])
def test_a_refusal_counts_by_number(refused):
    with pytest.raises(pieper.InputError) as error:
        pieper.Arm.from_dh([pieper.DH(a=0.3, alpha=0, d=0)], convention="standard", **refused)
    assert not ONE_OF_MANY.search(str(error.value)), error.value


def test_nothing_says_one_of_many():
    for text in texts():
        assert not ONE_OF_MANY.search(text), text


def test_the_rule_finds_what_it_is_for():
    assert ONE_OF_MANY.search("it has 1 joints") and ONE_OF_MANY.search("1 claims: 1 hold")
    assert not ONE_OF_MANY.search("1 joint; 21 poses, 0.1 degrees, at most 1 solution")
