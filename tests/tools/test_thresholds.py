"""What counts as a bare threshold, in Python and in C++."""

from __future__ import annotations

import re

import pytest

from tests.tools import house
from tests.tools.thresholds import bare


@pytest.mark.parametrize("spelled", ["1e-9", "2.5e-7", "0.0001", "3e-2", "1e300", "0.999999", "1.0000001", "1e-300"])
def test_a_threshold_is_found_in_both_languages(spelled):
    assert [found for _, found in bare(f"x = {spelled}\n", ".py")] == [spelled]
    assert [found for _, found in bare(f"const double x = {spelled};\n", ".hpp")] == [spelled]


@pytest.mark.parametrize("spelled", ["1.0", "0.5", "0.05", "2.0", "0.001", "7", "100000", "1e3"])
def test_other_numbers_are_not(spelled):
    assert not list(bare(f"x = {spelled}\n", ".py"))
    assert not list(bare(f"const double x = {spelled};\n", ".hpp"))


@pytest.mark.parametrize("suffix", [".py", ".hpp"])
def test_units_and_coefficients_are_none(suffix):
    assert not list(bare("x = y * 1e6 + z / 1e9 - 2.505075875015891e-08\n", suffix))


def test_what_stands_in_comments_and_texts_is_not_read():
    assert not list(bare('x = "1e-9"  # 1e-9\n', ".py"))
    assert not list(bare('// 1e-9\nauto x = "1e-9"; /* 1e-9\n1e-9 */\n', ".hpp"))


def test_the_line_is_told():
    assert list(bare("\n\nx = 1e-9\n", ".py")) == [(3, "1e-9")]
    assert list(bare("/* a\nb */\ndouble x = 1e-9;\n", ".cpp")) == [(3, "1e-9")]


def test_no_tolerance_has_two_names_alike_and_each_has_a_reason():
    names, told = [], False
    for path in house.files("src/pieper/tolerances/**/*.py"):
        for line in path.read_text().splitlines():
            found = re.match(r"((?:[A-Z][A-Z0-9_]*, )*[A-Z][A-Z0-9_]*) = ", line)
            if found:
                names += found[1].split(", ")
                assert told, f"{path}: {line} has no reason"
            told = line.startswith("#:") or bool(found and told)
    assert len(names) == len(set(names)) > 300
