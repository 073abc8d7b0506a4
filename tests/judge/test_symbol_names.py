"""A claims file's own symbols: any order, none by itself, and none that means something else in every formula."""

from __future__ import annotations

import itertools

import pytest

import pieper
from pieper.errors import InputError
from tests.judge.planted.short_arms import two_links

ARM = two_links(0.4, 0.3)
RIGHT = '[[claim]]\nid = "x"\nkind = "entry"\nof = "Px"\nis = "a1 c1 + a2 c12"\n'


def refused(symbols: str, where: str = "") -> str:
    with pytest.raises(InputError) as caught:
        pieper.check(f"{ARM}\n[symbols]\n{symbols}\n{RIGHT}{where}")
    return str(caught.value)


@pytest.mark.parametrize("size", [1, 2, 3, 5])
def test_symbols_that_are_defined_by_themselves_are_called_so(size):
    names = [f"K{k}" for k in range(size)]
    lines = [f'{a} = "{b} + 1"' for a, b in zip(names, names[1:] + names[:1], strict=True)]
    for order in itertools.islice(itertools.permutations(lines), 12):
        said = refused("\n".join([*order, 'L = "2"']))
        assert "[symbols]" in said and "defined by itself" in said and all(name in said for name in names)


def test_symbols_stand_in_any_order():
    lines = ['K = "L + M"', 'L = "2 M"', 'M = "a1"']
    for order in itertools.permutations(lines):
        claim = '[[claim]]\nkind = "equation"\nis = "K = 3 a1"\n'
        assert pieper.check(f"{ARM}\n[symbols]\n{chr(10).join(order)}\n{claim}").ok


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ('theta1 = "theta2"', "a joint's angle"),
        ('q2 = "1"', "a joint's angle"),
        ('theta12 = "theta1"', "a joint's angle"),
        ('c1 = "s1"', "the cosine of joints, and s1 is another thing"),
        ('s12 = "s1 c2 - c1 s2"', "the sine of joints"),
        ('atan2 = "3"', "a function"),
        ('deg = "1"', "a number or a unit"),
        ('px = "1"', "a letter of this arm"),
        ('a1 = "1"', "a letter of this arm"),
    ],
)
def test_names_that_mean_something_are_refused(line, words):
    said = refused(line)
    assert "already means something" in said and words in said


@pytest.mark.parametrize("line", ['c1 = "cos(theta1)"', 's2 = "-sqrt(1 - cos(theta2)^2)"', 'c = "2"', 'c7 = "2"'])
def test_a_page_s_own_sine_is_taken_where_it_is_that_but_for_its_branch(line):
    assert pieper.check(
        f"{ARM}\n[symbols]\n{line}\n{RIGHT.replace('a1 c1 + a2 c12', 'a1 cos(q1) + a2 cos(q1 + q2)')}"
    ).ok


def test_a_claim_s_own_definition_may_use_what_the_file_has_under_its_name():
    text = f'{ARM}\n[symbols]\nK = "a1"\n[[claim]]\nkind = "equation"\nis = "K = 2 a1"\nwhere = {{ K = "2 K" }}\n'
    assert pieper.check(text).ok
    assert "defined by itself" in refused('Q = "1"', 'where = { K = "K + 1" }\n')
