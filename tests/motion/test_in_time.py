"""What the kernel says of a cubic curve under a profile: the samples are the formulas', the peaks those of sampling."""

from __future__ import annotations

import numpy as np
import pytest

from pieper import _kernel
from pieper.motion.curve import JointCurve
from pieper.motion.in_time import profile_of, sampled


def curve_and_profile(seed, points=12, n=5):
    rng = np.random.default_rng(seed)
    s = np.sort(rng.uniform(0, 1, points))
    s[[0, -1]] = 0.0, 1.0
    curve = JointCurve.through(s, rng.uniform(-2, 2, (points, n)))
    x = rng.uniform(0.1, 3.0, points)
    x[[0, -1]] = 0.0
    return curve, x


def joint_peaks(curve, x):
    """The largest rates and accelerations (k, n): what is used of limits that are one."""
    n = curve.q.shape[1]
    one = {"speed": np.ones(n), "acceleration": np.ones(n), "share": np.ones(len(curve.q))}
    used = _kernel.peak_ratios(s=curve.s, d1=curve.d1, d2=curve.d2, d3=curve.d3, x=x, **one)
    return used[::2].T, used[1::2].T


@pytest.mark.parametrize("seed", range(8))
def test_nothing_between_the_ends_of_a_piece_is_larger_than_its_peak(seed):
    curve, x = curve_and_profile(seed)
    rates, bends = joint_peaks(curve, x)
    u = np.diff(x) / (2 * np.diff(curve.s))
    r = np.linspace(0, 1, 4001)[:, None, None] * np.diff(curve.s)[None, :, None]
    here = np.maximum(x[:-1][None, :, None] + 2 * u[None, :, None] * r, 0.0)
    d1 = curve.d1 + r * (curve.d2 + r * curve.d3 / 2)
    speed = np.abs(d1) * np.sqrt(here)
    bend = np.abs(d1 * u[None, :, None] + (curve.d2 + r * curve.d3) * here)
    for peak, sampled_values in ((rates, speed.max(0)), (bends, bend.max(0))):
        assert (sampled_values <= peak * (1 + 1e-12)).all()
        assert (sampled_values >= peak * (1 - 1e-5)).all()


@pytest.mark.parametrize("seed", range(4))
def test_samples_in_time_are_the_curve_under_the_profile(seed):
    curve, x = curve_and_profile(seed)
    profile = profile_of(curve.s, x)
    t, q, dq, ddq, dddq, s = sampled(curve, profile, 97.0)
    at, v, a, j = profile.at(t)
    at[-1] = curve.s[-1]
    d0, d1, d2, d3 = curve.at(at)
    v, a, j = v[:, None], a[:, None], j[:, None]
    wanted = (d0, d1 * v, d2 * v**2 + d1 * a, d3 * v**3 + 3 * d2 * v * a + d1 * j)
    assert np.abs(s - at).max() <= 4 * np.finfo(float).eps
    for got, said in zip((q, dq, ddq, dddq), wanted, strict=True):
        assert np.abs(got - said).max() <= 1e-13 * max(1.0, np.abs(said).max())


def test_a_piece_without_curvature_or_motion_has_finite_peaks():
    curve = JointCurve.through(np.array([0.0, 0.5, 1.0]), np.array([[0.0, 1.0], [0.0, 1.5], [0.0, 2.0]]))
    rates, bends = joint_peaks(curve, np.array([0.0, 1.0, 0.0]))
    assert np.isfinite(rates).all() and np.isfinite(bends).all()
    assert np.abs(rates[:, 0]).max() == 0.0 and np.allclose(rates[:, 1], 1.0)
