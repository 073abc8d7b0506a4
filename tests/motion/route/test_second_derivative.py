"""The second derivative with which a route is made smooth, against differences of the first."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from pieper.motion.route.setting import setting
from pieper.motion.route.smooth import Shape, _bend, _slope


@pytest.mark.parametrize("turn_step", [None, 0.5])
@pytest.mark.parametrize("margin", [0.01, 0.3])
def test_the_blocks_are_the_differences_of_the_slope(turn_step, margin):
    """Nothing pulls a pose here and every coordinate is free: the cost's own second derivative is left, exactly."""
    arm = pieper.load("abb-irb2400")
    free, N = pieper.Freedom(turn=(-2.0, 2.0)), 6
    T = np.broadcast_to(arm.fk(np.array([0.1, 0.2, -0.1, 0.3, 0.5, 0.2])), (N, 4, 4))
    world = setting(*arm._plans_of(free), free, T, np.linspace(0.0, 1.0, N))
    rng = np.random.default_rng(3)
    x = np.cumsum(rng.uniform(-0.2, 0.2, (N, world.m)), 0)
    step = None if turn_step is None else np.full(N - 1, turn_step)
    shape = Shape(world, T, np.ones(N - 1), 2, np.ones(N), step)
    Z = np.broadcast_to(np.eye(world.m), (N, world.m, world.m))
    blocks, beside = _bend(shape, x, Z, np.zeros_like(x), 0.7, margin)
    v, h = rng.standard_normal(x.shape), 1e-6
    found = np.einsum("kab,kb->ka", blocks, v)
    found[:-1] += np.einsum("kab,kb->ka", beside, v[1:])
    found[1:] += np.einsum("kab,ka->kb", beside, v[:-1])
    wanted = (_slope(shape, x + h * v, 0.7, margin)[0] - _slope(shape, x - h * v, 0.7, margin)[0]) / (2 * h)
    assert np.abs(found - wanted).max() < 1e-5 * np.abs(wanted).max()
