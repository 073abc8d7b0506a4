"""What entries of a claim may be: digits in quotes, two numbers in order; which numbers of a formula are decimals."""

import pytest

from pieper.algebra.parser import parse
from pieper.judge import keys
from pieper.judge.lengths import RATIOS, decimals


@pytest.mark.parametrize("digits", ["0.5370", " -12 ", "1e-3", "\u22120.25", "0", 7, -1.5])
def test_a_printed_number_may_be_a_number_or_its_digits(digits):
    assert keys.printed(digits) == ""


@pytest.mark.parametrize(
    "digits", ["inf", "nan", "1_000", "1e300", "0." + "1" * 1000, "1e-320", "one", "", True, [1.0]]
)
def test_what_is_no_printed_number_is_told(digits):
    assert keys.printed(digits)


@pytest.mark.parametrize("ends", [[0, 1], [-1.5, -1.25], [0.0, 1e-9]])
def test_two_numbers_in_order_are_an_interval(ends):
    assert keys.interval(ends) == ""


@pytest.mark.parametrize("ends", [[1, 1], [2.0, -2.0], [1], [0, 1, 2], ["a", 1], 3.0])
def test_two_equal_numbers_or_others_are_none(ends):
    assert keys.interval(ends)


def test_decimals_are_numbers_with_a_point_outside_of_exponents():
    found = decimals(parse("0.25 c1 + 3 s1 - (px - 1.5)^2 + 2e-3", ["px"]))
    assert sorted(node.written for node in found) == ["0.25", "1.5", "2e-3"]
    assert not decimals(parse("2 c1 + px^2", ["px"]))


def test_each_ratio_of_lengths_is_written_as_it_is():
    for ratio, words in RATIOS:
        sign, size = -1.0 if words.startswith("-") else 1.0, words.strip("- ")
        assert ratio == sign * {"": 1.0, "2": 2.0, "1/2": 0.5}[size]
    assert len({ratio for ratio, _ in RATIOS}) == len(RATIOS)
