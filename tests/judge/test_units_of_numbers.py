"""A printed number is compared in the unit that is printed with it, whatever the arm's; the truth is arithmetic."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle.arms.claim_headers import elbow
from pieper.judge.keys import UNITS

METRES = {"d1": 0.4, "a2": 0.3, "a3": 0.25}
FORMULAS = {
    "a2+a3": 0.55,
    "norm(P02-P01)": 0.3,
    "sqrt(d1^2 + a2^2)": 0.5,
    "px": np.cos(np.radians(10)) * (0.3 * np.cos(np.radians(20)) + 0.25 * np.cos(np.radians(50))),
    "J[3,3]": 0.25 * np.cos(np.radians(50)),
}


def arm(unit: str) -> str:
    """A three-link arm in a unit of length."""
    return elbow(**{name: float(f"{value / UNITS[unit]:.10g}") for name, value in METRES.items()}, unit=unit)


def judged(formula: str, value: str, unit: str = "", own: str = "m"):
    """The verdict on a printed number."""
    more = f'unit = "{unit}"\n' if unit else ""
    claim = f'[[claim]]\nkind = "number"\nis = "{formula}"\nvalue = "{value}"\nq_deg = [10, 20, 30]\n{more}'
    (found,) = pieper.check(arm(own) + claim).verdicts
    return found


@pytest.mark.parametrize("own", UNITS)
@pytest.mark.parametrize("printed", UNITS)
@pytest.mark.parametrize("formula", FORMULAS)
def test_a_length_holds_in_its_own_unit_and_in_no_other(own, printed, formula):
    """The same length of the same arm, in each pair of units."""
    for unit in UNITS:
        value = f"{FORMULAS[formula] / UNITS[unit]:.6f}"
        assert judged(formula, value, printed, own).holds == (unit == printed)
    assert judged(formula, f"{FORMULAS[formula] / UNITS[own]:.6f}", "", own).holds


def test_what_is_added_to_a_length_is_in_the_units_of_the_arm():
    """A number beside the arm's lengths is one of them; numbers by themselves are in the unit that is printed."""
    assert judged("px - 0.1", f"{1000 * (FORMULAS['px'] - 0.1):.3f}", "mm").holds
    assert judged("sqrt(a2^2 + 0.16)", "500.0", "mm").holds
    assert judged("0.330 + 0.42", "0.75", "m").holds
    assert judged("330 + 420", "750", "mm").holds
    assert judged("330 + 420", "0.75", "mm").wrong


def test_a_number_in_another_unit_of_length_is_told_so():
    """The slip is the unit, with its name."""
    assert "metres for millimetres" in dict(judged("a2+a3", "0.55", "mm").details)["the slip"]
    assert "in cm" in dict(judged("a2+a3", "55", "mm").details)["the slip"]


@pytest.mark.parametrize(
    ("formula", "value", "unit"),
    [
        ("a2+a3", "31.51", "deg"),
        ("a2", "0.3", "rad"),
        ("a2", "30", "%"),
        ("a3/a2", "0.8333", "mm"),
        ("acos(a3/a2)", "0.5857", "m"),
        ("a2 a3", "0.075", "m"),
        ("c1", "0.985", "mm"),
        ("theta2", "20", "mm"),
        ("a3/a2", "0.8333", "%"),
    ],
)
def test_a_value_with_the_unit_of_something_else_is_wrong(formula, value, unit):
    """An angle is no length, a length no ratio, and an area neither."""
    assert judged(formula, value, unit).wrong


@pytest.mark.parametrize(
    ("formula", "value", "unit"),
    [
        ("acos(a3/a2)", "33.56", "deg"),
        ("acos(a3/a2)", "0.5857", "rad"),
        ("atan2(0.15, a2)", "26.57", "deg"),
        ("theta2", "20", "deg"),
        ("a3/a2", "83.33", "%"),
        ("100 (a2 - a3)/a2", "16.67", "%"),
    ],
)
def test_angles_and_ratios_keep_their_units(formula, value, unit):
    """Of the same arm in metres and in millimetres; a number beside lengths is in the arm's unit."""
    assert judged(formula, value, unit).holds
    assert "0.15" in formula or judged(formula, value, unit, "mm").holds


def test_a_slide_is_a_length():
    """A sliding joint's value and a pose's coordinates go with the arm."""
    head = """[arm]
convention = "standard"
length_unit = "m"
columns = ["theta", "d", "a", "alpha"]
rows = [["q1", 0, "a1", 0], ["0 deg", "b2 + 0.1", 0, 0]]
values = { a1 = 0.3 }
[[claim]]
kind = "number"
q_rad = [0, 0.25]
"""
    for formula, value, unit, holds in (
        ("b2", "250", "mm", True),
        ("b2", "0.25", "mm", False),
        ("pz", "350", "mm", True),
        ("b2", "14.3", "deg", False),
    ):
        (found,) = pieper.check(f'{head}is = "{formula}"\nvalue = "{value}"\nunit = "{unit}"\n').verdicts
        assert found.holds == holds, found
