"""Limits while a pose is solved: the same as counted afterwards, whatever the limits."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from pieper.tolerances import LIMIT_SLACK

PI = np.pi


def limits_of(rng):
    """Some within a turn, some around a place far away, some without an end."""
    middle, half = rng.uniform(-3 * PI, 3 * PI, 6), rng.uniform(0.2, 2.5 * PI, 6)
    limits = np.stack([middle - half, middle + half], axis=1)
    limits[rng.random(6) < 0.15, 0] = -np.inf
    limits[rng.random(6) < 0.15, 1] = np.inf
    within = rng.random(6) < 0.3
    limits[within] = np.sort(rng.uniform(-PI, PI, (int(within.sum()), 2)), axis=1)
    return limits


@pytest.mark.parametrize("name", ["denso-vp6242", "ur5e", "stanford", "motoman-ea1400n", "fanuc-crx-10ia"])
def test_rows_inside_are_those_that_some_whole_turn_brings_inside(name):
    arm, rng = pieper.load(name), np.random.default_rng(8)
    plan = arm.plan
    slides = plan.chain.prismatic
    T = arm.fk(rng.uniform(-PI, PI, (70, 6)) * np.where(slides, plan.chain.length / PI, 1))
    free = np.tile([-np.inf, np.inf], (6, 1))
    plain = plan.solver.spec.solver(free, slides).many(np.ascontiguousarray(T), 1)
    inside = outside = 0
    for _ in range(40):
        limits = limits_of(rng)
        q, valid, in_limits, flag = plan.solver.spec.solver(limits, slides).many(np.ascontiguousarray(T), 1)
        assert np.array_equal(valid, plain[1]) and np.array_equal(flag, plain[3])
        low, high = limits[:, 0] - LIMIT_SLACK, limits[:, 1] + LIMIT_SLACK
        turns = np.arange(-4, 5)[:, None, None, None] * 2 * PI * ~slides
        turned = plain[0] + turns
        fits = ((turned >= low) & (turned <= high)).any(0)
        assert np.array_equal(in_limits, fits.all(-1) & valid)
        assert not q[~valid].any()
        rows, first = q[valid], plain[0][valid]
        gap = (rows - first)[:, ~slides] / (2 * PI)
        np.testing.assert_allclose(gap, np.round(gap), atol=1e-12)
        assert ((rows >= low) & (rows <= high))[in_limits[valid]].all()
        inside, outside = inside + int(in_limits.sum()), outside + int((valid & ~in_limits).sum())
    assert inside > 100 and outside > 100
