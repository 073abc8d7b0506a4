"""Every sentence of a derivation is checked by a machine: a few arms always, all and random ones when asked."""

from __future__ import annotations

import pytest

import pieper
from tests.equations.sentences import false_sentences, random_arm

QUICK = ["denso-vp6242", "universal-robots-ur5e", "adept-cobra-600", "stanford-arm"]
OTHERS = [name for name in sorted(pieper.catalog()) if name not in QUICK]
RANDOM = range(200)


@pytest.mark.parametrize("name", QUICK)
def test_a_derivation_says_nothing_false(name):
    assert false_sentences(pieper.load(name)) == []


@pytest.mark.slow
@pytest.mark.parametrize("first", range(0, len(OTHERS), 20))
def test_no_derivation_of_the_catalogue_says_anything_false(first):
    bad = {name: false_sentences(pieper.load(name)) for name in OTHERS[first : first + 20]}
    assert {name: said for name, said in bad.items() if said} == {}


@pytest.mark.slow
@pytest.mark.parametrize("first", range(0, len(RANDOM), 20))
def test_no_derivation_of_a_random_arm_says_anything_false(first):
    arms = {number: random_arm(number)[0] for number in RANDOM[first : first + 20]}
    bad = {number: false_sentences(arm) for number, arm in arms.items()}
    assert {number: said for number, said in bad.items() if said} == {}
