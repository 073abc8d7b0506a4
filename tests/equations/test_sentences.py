"""Every sentence of a derivation is checked by a machine: a few arms always, all and random ones in the slow tests."""

from __future__ import annotations

import pytest

import pieper
from tests.equations.sentences import false_sentences, random_arm

QUICK = ["denso-vp6242", "universal-robots-ur5e", "adept-cobra-600", "stanford-arm"]
OTHERS = [name for name in sorted(pieper.catalog()) if name not in QUICK]
#: Joints -> how many random arms: every kind of table, slides anywhere; docs/symbolic.md says how many were tried.
RANDOM = {3: 40, 4: 40, 5: 24, 6: 90, 7: 4}


@pytest.mark.parametrize("name", QUICK)
def test_a_derivation_says_nothing_false(name):
    assert false_sentences(pieper.load(name)) == []


@pytest.mark.slow
@pytest.mark.parametrize("first", range(0, len(OTHERS), 20))
def test_no_derivation_of_the_catalogue_says_anything_false(first):
    bad = {name: false_sentences(pieper.load(name)) for name in OTHERS[first : first + 20]}
    assert {name: said for name, said in bad.items() if said} == {}


def test_a_derivation_of_a_coupled_offset_wrist_says_nothing_false():
    assert false_sentences(pieper.load("fanuc-crx-10ia-controller")) == []


@pytest.mark.slow
@pytest.mark.parametrize("joints", RANDOM)
def test_no_derivation_of_a_random_arm_says_anything_false(joints):
    arms = {number: random_arm(number, joints)[0] for number in range(RANDOM[joints])}
    bad = {number: false_sentences(arm) for number, arm in arms.items()}
    assert {number: said for number, said in bad.items() if said} == {}


def test_an_order_of_steps_that_needs_a_later_angle_is_left_for_another():
    arm, _ = random_arm(81)
    assert false_sentences(arm) == []
