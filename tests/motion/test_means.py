"""Means over a window of time are what sums over fine steps give, cut where the motion begins and ends."""

from __future__ import annotations

import numpy as np
import pytest

from pieper.motion.jerk import mean_around


@pytest.mark.parametrize("window", [0.05, 0.3, 1.1])
def test_a_mean_around_each_time_is_that_of_many_small_steps(window):
    rng = np.random.default_rng(6)
    t = np.concatenate([[0.0], np.cumsum(rng.uniform(0.02, 0.3, 12))])
    values = rng.uniform(-2, 2, 12)
    for at, mean in zip(t, mean_around(t, values, window), strict=True):
        fine = np.linspace(max(at - window / 2, t[0]), min(at + window / 2, t[-1]), 20001)
        middle = (fine[1:] + fine[:-1]) / 2
        assert mean == pytest.approx(values[np.searchsorted(t, middle) - 1].mean(), abs=1e-3)
