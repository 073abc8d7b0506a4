"""A determinant's sign as a whole is free: one slip in it is one slip, whichever sign the page has."""

from __future__ import annotations

import re

import numpy as np
import pytest

import pieper
from oracle.arms.claim_headers import elbow
from pieper.judge.verdict import HOLDS, WRONG

LENGTHS = {"d1": 0.4, "a2": 0.3, "a3": 0.25}
HEAD = (
    elbow(**LENGTHS)
    + """[[claim]]
kind = "determinant"
rows = [1, 2, 3]
"""
)
RIGHT = "a2 a3 s3 (a2 c2 + a3 c23)"
SLIPS = {
    "a2 a3 s3 (a2 c2 + a3 s23)": "s23 for c23",
    "a2 a3 c3 (a2 c2 + a3 c23)": "c3 for s3",
    "a2 a3 s3 (a2 c2 + a3 c2)": "c2 for c23",
    "a2 a3 s3 (a2 c2 + a2 c23)": "a2 for a3",
    "a2 s3 (a2 c2 + a3 c23)": "a3 lost",
    "a2 a3 s3 (a2 c2 - a3 c23)": "the sign of -a3 c23",
    "2 a2 a3 s3 (a2 c2 + a3 c23)": "2 too many",
}


def determinant(formula: str):
    """The verdict on a formula."""
    (found,) = pieper.check(f'{HEAD}is = "{formula}"\n').verdicts
    return found


def value(formula: str, joints: str) -> float:
    """A formula at joints in degrees, by Python itself."""
    t1, t2, t3 = (np.radians(float(v)) for v in joints.split(","))
    names = {f + n: w(t) for n, t in (("2", t2), ("3", t3), ("23", t2 + t3)) for f, w in (("s", np.sin), ("c", np.cos))}
    text = re.sub(r"(?<=[\w)]) (?=[\w(])", "*", formula)
    return eval(text, {}, {**names, **LENGTHS})


@pytest.mark.parametrize("sign", ["", "-"])
@pytest.mark.parametrize("printed", SLIPS)
def test_one_slip_is_told_as_one(printed, sign):
    """With either sign of the whole the same slip is named, and the right value has the sign of the formula's."""
    found = determinant(sign + printed)
    told = dict(found.details)
    assert found.status == WRONG and found.slip != "two slips", found
    assert SLIPS[printed] in told["the slip"], told["the slip"]
    said = re.search(r"joints \((.*)\) deg: the formula gives (\S+), right is (\S+)", told["counter-example"])
    assert said
    joints, given, right = said.groups()
    assert np.isclose(value(sign + printed, joints), float(given), rtol=1e-4)
    assert np.isclose(value(sign + RIGHT, joints), float(right), rtol=1e-4), "of the other sign"


def test_both_signs_hold():
    """The right one and its negative."""
    assert determinant(RIGHT).status == determinant("-" + RIGHT).status == HOLDS


def test_rounded_numbers_hold_with_either_sign():
    """0.333 for 1/3 is right to its digits, whatever the sign of the whole."""
    for sign in ("", "-"):
        text = HEAD.replace("a2 = 0.3,", "a2 = 0.33333,")
        (found,) = pieper.check(f'{text}is = "{sign}0.333 a3 s3 (0.333 c2 + a3 c23)"\n').verdicts
        assert found.status == HOLDS, found
