"""Every sentence of a derivation is checked by a machine: a few arms always, all and random ones in the slow tests."""

from __future__ import annotations

import pytest

import pieper
from tests.equations.sentences import false_sentences, random_arm

QUICK = ["denso-vp6242", "universal-robots-ur5e", "adept-cobra-600", "stanford-arm", "so-101"]
OTHERS = [name for name in sorted(pieper.catalog()) if name not in QUICK]
#: Joints, first and last number of random arms of every kind, slides anywhere; docs/symbolic.md says what was tried.
RANDOM = [(3, 0, 14), (3, 15, 40), (4, 0, 40), (5, 0, 24), (6, 0, 30), (6, 30, 60), (6, 60, 90), (7, 0, 4)]


def by_axes(arm):
    """The arm, of a palletizer its axes: what a linkage holds of them is not written as formulas."""
    return arm.uncoupled() if arm.description.linked else arm


@pytest.mark.parametrize("name", QUICK)
def test_a_derivation_says_nothing_false(name):
    assert false_sentences(pieper.load(name)) == []


@pytest.mark.slow
@pytest.mark.parametrize("first", range(0, len(OTHERS), 20))
def test_no_derivation_of_the_catalogue_says_anything_false(first):
    bad = {name: false_sentences(by_axes(pieper.load(name))) for name in OTHERS[first : first + 20]}
    assert {name: said for name, said in bad.items() if said} == {}


def test_a_derivation_of_a_coupled_offset_wrist_says_nothing_false():
    assert false_sentences(pieper.load("fanuc-crx-10ia-controller")) == []


@pytest.mark.slow
@pytest.mark.parametrize(("joints", "first", "last"), RANDOM)
def test_no_derivation_of_a_random_arm_says_anything_false(joints, first, last):
    arms = {number: random_arm(number, joints)[0] for number in range(first, last)}
    bad = {number: false_sentences(arm) for number, arm in arms.items()}
    assert {number: said for number, said in bad.items() if said} == {}


@pytest.mark.parametrize("number", [110, 146, 332])
def test_a_point_on_the_first_axis_of_a_long_arm_is_held_all_the_way_round(number):
    assert false_sentences(random_arm(number, 3)[0]) == []


@pytest.mark.parametrize("number", [14, 284])
def test_a_point_on_the_first_axis_of_an_arm_over_decades_is_given_back(number):
    """Two roots of the quartic meet beside two others: their middle keeps six digits, the slope's root eleven."""
    assert false_sentences(random_arm(number, 3)[0]) == []


def test_a_slide_that_is_free_beside_two_parallel_turns_moves():
    """RRPRRP: 60 steps along it, each put back onto the pose by Newton's method, hold the pose to 3e-16."""
    assert false_sentences(random_arm(2005, 6)[0]) == []


@pytest.mark.parametrize(("number", "joints"), [(68, 5), (128, 5), (86, 5)])
def test_an_arm_over_decades_says_nothing_false(number, joints):
    """Signs of earlier steps stand in what decides a degenerate case; turns are not compared by the arm's metres."""
    assert false_sentences(random_arm(number, joints)[0]) == []


def test_what_comes_near_nothing_and_stays_above_it_is_impossible():
    """(a2 + a3 c3)^2 + (d3 salpha2 - a3 calpha2 s3)^2 is 2.5e-4 of its usual size at 0.75, nowhere less."""
    arm, _ = random_arm(1008, 4)
    assert arm.symbolic.ik().form.cases[2].kind == "impossible"
    assert false_sentences(arm) == []


def test_what_vanishes_twice_over_at_a_posture_is_found():
    """0.5 + 0.5 c4 is nothing at theta4 = 180 deg only, and hardly changes beside it."""
    arm, _ = random_arm(2095, 5)
    assert len(arm.symbolic.ik().form.cases[3].postures)
    assert false_sentences(arm) == []


def test_the_square_of_a_small_length_is_not_nothing():
    """2 a1 ((a2 + a3 c3)^2 + d3^2) with d3 = 8 mm and a3 = 351 m comes within 5e-7 of nothing, no nearer."""
    form = random_arm(110, 3)[0].symbolic.ik().form
    assert [case.kind for case in form.cases.values()] == ["impossible", "free"]


#: Joints, and numbers of arms whose lengths lie over six decades (every sixth of the random ones).
DECADES = [(3, range(80, 482, 6)), (4, range(44, 284, 6)), (5, range(26, 206, 6))]
ON_FIRST_AXIS = {(3, 110), (3, 146), (3, 284), (3, 332)}  # see the tests above


@pytest.mark.slow
@pytest.mark.parametrize(("joints", "numbers"), DECADES)
def test_no_derivation_of_an_arm_over_decades_says_anything_false(joints, numbers):
    arms = {number: random_arm(number, joints)[0] for number in numbers if (joints, number) not in ON_FIRST_AXIS}
    bad = {number: false_sentences(arm) for number, arm in arms.items()}
    assert {number: said for number, said in bad.items() if said} == {}


def test_an_order_of_steps_that_needs_a_later_angle_is_left_for_another():
    arm, _ = random_arm(81)
    assert false_sentences(arm) == []
