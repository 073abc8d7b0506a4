"""The judge of whole sets finds what is planted: a row left out, given twice or moved; and it searches long enough."""

from __future__ import annotations

import numpy as np
import pytest

from oracle import compare, machine, whole_set
from oracle.arms.known import free

Q = np.array([0.4, 0.9, -0.7, 0.8, 0.7, -0.5])


@pytest.fixture(scope="module")
def searched():
    """An arm's machine, a pose, what was found there, and rows that are right."""
    arm = free("motoman-ea1400n")
    m, T = machine(arm), arm.fk(Q)
    return m, T, whole_set(m, T, library=None, rng=np.random.default_rng(0), least=200), arm.ik(T).all_q


def test_right_rows_are_right(searched):
    m, T, found, rows = searched
    verdict = compare(m, T, rows, found)
    assert not (verdict.missing or verdict.extra or verdict.unseen)
    assert found.fewest >= 8 and len(found.q) == len(rows)


def test_a_row_left_out_is_missing(searched):
    m, T, found, rows = searched
    for i in range(len(rows)):
        verdict = compare(m, T, np.delete(rows, i, 0), found)
        assert len(verdict.missing) == 1 and np.abs(np.array(verdict.missing[0][0]) - rows[i]).max() < 1e-8


def test_a_row_given_twice_is_extra(searched):
    m, T, found, rows = searched
    verdict = compare(m, T, np.vstack([rows, rows[:1] + 1e-11]), found)
    assert len(verdict.extra) == 1 and "twice" in verdict.extra[0][1] and not verdict.missing


def test_a_row_that_is_off_is_extra_and_its_solution_missing(searched):
    m, T, found, rows = searched
    moved = rows.copy()
    moved[0, 3] += 1e-5
    verdict = compare(m, T, moved, found)
    assert len(verdict.extra) == 1 and "close" in verdict.extra[0][1] and len(verdict.missing) == 1


def test_a_true_row_that_the_search_has_not_met_is_told_apart(searched):
    m, T, found, rows = searched
    few = type(found)(found.q[1:], found.hits[1:], found.sigma[1:], found.residual[1:], False)
    verdict = compare(m, T, rows, few)
    assert len(verdict.unseen) == 1 and not verdict.missing and not verdict.extra


def test_the_search_goes_on_until_the_rarest_was_met_often_enough(searched):
    m, T, found, _ = searched
    short = whole_set(m, T, library=None, rng=np.random.default_rng(0), least=10, sure=8, most=20_000)
    assert short.fewest >= 8 and len(short.q) == len(found.q)
    cut = whole_set(m, T, library=None, rng=np.random.default_rng(0), least=10, sure=8, most=10)
    assert cut.hits.sum() <= 10
