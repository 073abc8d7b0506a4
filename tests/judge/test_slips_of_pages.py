"""Slips that pages make, told by their names: a branch of an arcsine, a quadrant, a symbol that stands twice."""

from __future__ import annotations

import pytest

import pieper
from oracle.arms.claim_headers import elbow, puma
from pieper.judge.verdict import HOLDS

LINKS = elbow(0.4, 0.3, 0.25)
PUMA = (
    puma(0.4318, 0.15, 0.0203, 0.4)
    + """[symbols]
K = "(px^2 + py^2 + pz^2 - a2^2 - a3^2 - d3^2 - d4^2)/(2 a2)"
"""
)
TURNED = "(px^2 + py^2 + (pz-d1)^2 - a2^2 - a3^2)/(2 a2 a3)"


def verdict(arm: str, claim: str):
    """The verdict on one claim."""
    (found,) = pieper.check(f"{arm}[[claim]]\n{claim}\n").verdicts
    return found


@pytest.mark.parametrize(
    ("arm", "joint", "formula"),
    [
        (LINKS, "theta2 + theta3", "asin(r31)"),
        (PUMA, "theta3", "atan2(a3, d4) - asin(K/sqrt(a3^2 + d4^2))"),
    ],
    ids=["a sum of joints", "a term of Craig's Puma"],
)
def test_the_second_branch_of_an_arcsine(arm, joint, formula):
    """It is pi less the first; the reading that is printed holds."""
    found = verdict(arm, f'kind = "joint"\nfor = "{joint}"\nis = "{formula}"')
    told = dict(found.details)
    assert found.slip == "branch" and "second branch, pi - asin" in told["the slip"], found
    reading = told["nearest right reading"].partition(" = ")[2]
    assert verdict(arm, f'kind = "joint"\nfor = "{joint}"\nis = "{reading}"').status == HOLDS


def test_a_lost_quadrant_is_told_by_its_own_name():
    """An entry that is zero for the arm, az here, makes no angle that could have been lost."""
    told = dict(verdict(LINKS, 'kind = "joint"\njoint = 1\nis = "atan(py/px)"').details)
    assert "az" not in told["nearest right reading"] and "half a turn" in told["the slip"], told
    assert verdict(LINKS, 'kind = "joint"\njoint = 1\nis = "atan2(r13, -r23)"').status == HOLDS


@pytest.mark.parametrize(
    ("printed", "slip"),
    [
        (TURNED.replace("(pz-d1)^2", "(pz)^2"), "d1 lost after pz"),
        (TURNED.replace(" - a3^2", ""), "a3^2 lost"),
        (TURNED.replace("(2 a2 a3)", "(a2 a3)"), "2 lost from a2 a3"),
    ],
)
def test_what_a_symbol_lacks_that_stands_twice_is_one_slip(printed, slip):
    """D stands twice in the formula for the elbow: what it lacks is lost once."""
    for formula in ("atan2(+-sqrt(1-D^2), D)", "+-atan2(sqrt(1-D^2), D)"):
        found = verdict(LINKS, f'kind = "joint"\njoint = 3\nis = "{formula}"\nwhere = {{ D = "{printed}" }}')
        assert slip in dict(found.details)["the slip"], found
        assert found.slip != "two slips"
    good = verdict(LINKS, f'kind = "joint"\njoint = 3\nis = "atan2(+-sqrt(1-D^2), D)"\nwhere = {{ D = "{TURNED}" }}')
    assert good.status == HOLDS


@pytest.mark.parametrize(
    "claim",
    [
        'kind = "entry"\nof = "pz"\nis = "Z c1^2 + Z s1^2"',
        'kind = "equation"\nis = "(Z c1)^2 + (Z s1)^2 = pz^2"',
        'kind = "equation"\nis = "c1 Z + s1 Z = (c1 + s1) pz"',
    ],
)
def test_so_it_is_in_an_equation_and_in_an_entry(claim):
    """Z is the arm's height and stands twice."""
    found = verdict(LINKS, f'{claim}\nwhere = {{ Z = "d1 + a2 s2" }}')
    assert "lost after d1 + a2 s2" in dict(found.details)["the slip"], found
