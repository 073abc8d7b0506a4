"""The derivatives with which a route is made smooth, each against differences of what it is the derivative of."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from pieper.motion.route.setting import setting
from pieper.motion.route.smooth import Shape, _bend, _slope, _value

N = 6


def route(turn_step, power=2):
    """A shape, and coordinates (N, m) that hold nothing: what is asked here are derivatives."""
    arm, free = pieper.load("abb-irb2400"), pieper.Freedom(turn=(-2.0, 2.0))
    T = np.broadcast_to(arm.fk(np.array([0.1, 0.2, -0.1, 0.3, 0.5, 0.2])), (N, 4, 4))
    world = setting(*arm._plans_of(free), free, T, np.linspace(0.0, 1.0, N))
    x = np.cumsum(np.random.default_rng(3).uniform(-0.2, 0.2, (N, world.m)), 0)
    step = None if turn_step is None else np.full(N - 1, turn_step)
    return Shape(world, T, np.linspace(0.5, 2.0, N - 1), power, np.ones(N), step), x


@pytest.mark.parametrize("turn_step", [None, 0.5])
@pytest.mark.parametrize("margin", [0.01, 0.3])
@pytest.mark.parametrize("power", [2, 8])
def test_the_slope_is_the_difference_of_the_cost(turn_step, margin, power):
    shape, x = route(turn_step, power)
    slope, _ = _slope(shape, x, 0.7, margin)
    h = 1e-6
    for v in np.random.default_rng(5).standard_normal((8, *x.shape)):
        wanted = (_value(shape, x + h * v, 0.7, margin) - _value(shape, x - h * v, 0.7, margin)) / (2 * h)
        assert (slope * v).sum() == pytest.approx(wanted, rel=1e-5, abs=1e-7)


@pytest.mark.parametrize("turn_step", [None, 0.5])
@pytest.mark.parametrize("margin", [0.01, 0.3])
def test_the_blocks_are_the_differences_of_the_slope(turn_step, margin):
    """Nothing pulls a pose here and every coordinate is free: the cost's own second derivative is left, exactly."""
    shape, x = route(turn_step)
    Z = np.broadcast_to(np.eye(x.shape[1]), (N, x.shape[1], x.shape[1]))
    blocks, beside = _bend(shape, x, Z, np.zeros_like(x), np.zeros(N), 0.7, margin)
    v, h = np.random.default_rng(4).standard_normal(x.shape), 1e-6
    found = np.einsum("kab,kb->ka", blocks, v)
    found[:-1] += np.einsum("kab,kb->ka", beside, v[1:])
    found[1:] += np.einsum("kab,ka->kb", beside, v[:-1])
    wanted = (_slope(shape, x + h * v, 0.7, margin)[0] - _slope(shape, x - h * v, 0.7, margin)[0]) / (2 * h)
    assert np.abs(found - wanted).max() < 1e-5 * np.abs(wanted).max()
