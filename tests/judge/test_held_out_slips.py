"""The judge before slips that were planted by code that shares nothing with it; the full counts are measured apart."""

import collections

from tests.judge.held_out.arms import ARMS
from tests.judge.held_out.measure import forms, formulas, numbers
from tests.judge.held_out.oracle import facts, shares


def test_the_right_formulas_are_right_by_the_oracle_of_their_own():
    assert len(ARMS) == 20
    for arm in ARMS:
        for kind, of, tree in facts(arm):
            assert shares(kind, of, tree, arm, 3, 3) == 1, (arm.name, kind, of)


def test_no_planted_slip_is_called_right_and_most_are_explained_by_it():
    got = collections.Counter(what for what, _, _ in formulas(5, 60))
    assert not got["called right"] and got["planted"] >= 55, got


def test_no_wrong_number_is_called_right_and_most_are_explained():
    got = collections.Counter(what for what, _, _ in numbers(5, 60))
    assert not got["called right"] and got["planted"] >= 55, got


def test_right_formulas_in_unusual_forms_hold():
    got = collections.Counter(what for what, _, _ in forms(5, 60))
    assert got["holds"] >= 59 and not got["wrong"], got
