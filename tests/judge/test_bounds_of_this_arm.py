"""Bounds that are numbers are about the arm's own lengths, and a bound that is a little too narrow does not hold.

The truth is geometry: two links of 0.3 and 0.25 reach between 0.05 and 0.55 from the shoulder, 0.4 above the ground.
"""

from __future__ import annotations

import re

import numpy as np
import pytest

import pieper
from oracle.arms.claim_headers import elbow
from pieper.judge.verdict import HOLDS, PARTLY

SYMBOLS = elbow(0.4, 0.3, 0.25)
NUMBERS = re.sub(r"values.*\n", "", SYMBOLS.replace('"d1"', "0.4").replace('"a2"', "0.3").replace('"a3"', "0.25"))
FROM_SHOULDER, FROM_GROUND = "px^2+py^2+(pz-0.4)^2", "px^2+py^2+pz^2"
TRUE = [
    (FROM_SHOULDER, 0.05**2, 0.55**2),
    (FROM_GROUND, 0.0, 0.95**2),
    ("px", -0.55, 0.55),
    ("pz", 0.4 - 0.55, 0.95),
    ("norm(P02-P01)", 0.3, 0.3001),
    ("norm(P03-P02)", 0.2499, 0.25),
    ("r11 r33", -1, 1),
]


def bounds(arm: str, formula: str, low: float, high: float, more: str = ""):
    """The verdict on bounds."""
    claim = f'[[claim]]\nkind = "bounds"\nis = "{formula}"\nbetween = [{low!r}, {high!r}]\n{more}'
    (found,) = pieper.check(arm + claim).verdicts
    return found


def place(q: list[float]) -> np.ndarray:
    """Where the tool is, by the geometry of two links."""
    t1, t2, t3 = np.radians(q)
    out, up = (0.3 * f(t2) + 0.25 * f(t2 + t3) for f in (np.cos, np.sin))
    return np.array([out * np.cos(t1), out * np.sin(t1), 0.4 + up])


@pytest.mark.parametrize("arm", [SYMBOLS, NUMBERS], ids=["symbols", "numbers"])
@pytest.mark.parametrize(("formula", "low", "high"), TRUE)
def test_the_exact_bounds_of_an_arm_hold(arm, formula, low, high):
    """Of a table with names and of one with numbers."""
    assert bounds(arm, formula, low, high).status == HOLDS


@pytest.mark.parametrize("side", ["low", "high"])
@pytest.mark.parametrize(("formula", "low", "high"), TRUE[:4])
def test_bounds_that_are_too_narrow_by_a_thousandth_do_not(formula, low, high, side):
    """The counter-example is a posture of this arm that gives what is said of it."""
    less = 1e-3 * (high - low)
    found = bounds(SYMBOLS, formula, low + less * (side == "low"), high - less * (side == "high"))
    assert found.status == PARTLY
    example = dict(found.details)["counter-example"]
    said = re.search(r"joints \((.*)\) deg: it is (\S+)", example)
    assert said
    joints, value = said.groups()
    px, py, pz = place([float(v) for v in joints.split(",")])
    right = eval(formula.replace("^", "**"), {}, {"px": px, "py": py, "pz": pz})
    assert np.isclose(right, float(value), rtol=1e-5, atol=1e-5)
    assert not low + less * (side == "low") < right < high - less * (side == "high")


def test_a_bound_without_lengths_is_told_to_hold_for_any():
    """The cosine of the elbow's angle, from the cosine law; bounds on a length are one arm's."""
    law = bounds(SYMBOLS, "(px^2+py^2+(pz-d1)^2-a2^2-a3^2)/(2 a2 a3)", -1, 1)
    assert law.status == HOLDS and "for any lengths" in law.sentence
    wide = bounds(SYMBOLS, "px", -10, 10)
    assert wide.status == HOLDS and "this arm's lengths" in wide.sentence


def test_conditions_and_held_joints_bound_the_search():
    """With the elbow held at a right angle the reach is one number; where theta2 and theta3 are small it is long."""
    reach = "px^2+py^2+(pz-d1)^2"
    right = 0.3**2 + 0.25**2
    assert bounds(SYMBOLS, reach, right - 1e-6, right + 1e-6, "at_deg = { theta3 = 90 }").status == HOLDS
    assert bounds(SYMBOLS, reach, right, 0.3025, 'when = "cos(theta3) > 0"').status == HOLDS
    assert bounds(SYMBOLS, reach, right + 1e-3, 0.3025, 'when = "cos(theta3) > 0"').status == PARTLY


def test_what_is_undefined_is_told_so():
    """A root that has no value at some postures."""
    found = bounds(SYMBOLS, "sqrt(c1 + 0.5)", 0, 2)
    assert found.status == PARTLY and "undefined" in dict(found.details)["counter-example"]
