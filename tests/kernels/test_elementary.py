"""Sine, cosine and arctangent of the kernels against thirty digits and against NumPy."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest

from pieper import _kernel


def ulps(found: np.ndarray, exact: list[mpmath.mpf]) -> float:
    """Return the largest error in units in the last place of the exact value."""
    return max(
        float(abs(mpmath.mpf(float(f)) - e) / np.spacing(abs(float(e))))
        for f, e in zip(found, exact, strict=True)
        if e != 0
    )


@pytest.fixture(autouse=True)
def digits():
    with mpmath.workdps(40):
        yield


def test_sine_and_cosine_are_right_to_two_units_over_many_turns_and_next_to_their_zeros():
    rng = np.random.default_rng(0)
    multiples = np.arange(-40, 41) * (np.pi / 2)
    x = np.concatenate(
        [
            rng.uniform(-7, 7, 800),
            rng.uniform(-1e3, 1e3, 500),
            rng.uniform(-1e6, 1e6, 300),
            multiples,
            np.nextafter(multiples, 99),
            10.0 ** rng.uniform(-300, 0, 200),
            np.array([0.0, 355.0, 103993.0, 710.0, 6381956970095103 * 2.0**-40]),
        ]
    )
    found = _kernel.sincos(x)
    assert ulps(found[:, 0], [mpmath.sin(mpmath.mpf(float(v))) for v in x]) <= 2.0
    assert ulps(found[:, 1], [mpmath.cos(mpmath.mpf(float(v))) for v in x]) <= 2.0


def test_huge_arguments_fall_back_to_the_c_library_and_what_is_not_finite_gives_nan():
    x = np.array([1e7, -3.7e9, 1e22, 1.0, np.nan, np.inf, -np.inf])
    found = _kernel.sincos(x)
    np.testing.assert_allclose(found[:4, 0], np.sin(x[:4]), rtol=1e-15)
    np.testing.assert_allclose(found[:4, 1], np.cos(x[:4]), rtol=1e-15)
    assert np.isnan(found[4:]).all()


def test_arctangent_is_right_to_two_units_in_all_quadrants_and_scales():
    rng = np.random.default_rng(1)
    yx = rng.normal(size=(1200, 2)) * 10.0 ** rng.uniform(-200, 200, (1200, 1))
    steep = rng.normal(size=(400, 2)) * np.array([1.0, 1e-8])
    yx = np.concatenate([yx, steep, steep[:, ::-1]])
    exact = [mpmath.atan2(mpmath.mpf(float(y)), mpmath.mpf(float(x))) for y, x in yx]
    assert ulps(_kernel.atan2(yx), exact) <= 2.5


def test_arctangent_lies_in_minus_pi_exclusive_to_pi_and_keeps_nan():
    y_x = np.array([[0.0, 0.0], [0.0, -1.0], [-0.0, -1.0], [-1e-300, -1.0], [1.0, 0.0], [-1.0, 0.0], [-3.0, -3.0]])
    expected = [0.0, np.pi, np.pi, np.pi, np.pi / 2, -np.pi / 2, -3 * np.pi / 4]
    np.testing.assert_allclose(_kernel.atan2(y_x), expected, rtol=1e-15)
    assert np.isnan(_kernel.atan2(np.array([[np.nan, 1.0], [1.0, np.nan], [np.nan, np.nan]]))).all()


def test_the_arctangent_misses_no_angle_by_more_than_the_bound_that_verification_rests_on():
    # kAngleError in kernels/lanes/math.hpp, 8e-16 rad; where the folds at tan(pi/8), 1 and 0 meet it is largest
    rng = np.random.default_rng(2)
    angle = np.concatenate(
        [rng.uniform(-np.pi, np.pi, 6000), rng.normal(0, 1e-3, 6000) + np.pi / 8 * rng.integers(-8, 9, 6000)]
    )
    yx = np.stack([np.sin(angle), np.cos(angle)], axis=1) * (1 + rng.uniform(-1e-12, 1e-12, (12000, 1)))
    yx[::3] *= rng.uniform(1e-6, 1e3, (4000, 1))
    found = _kernel.atan2(yx)
    with mpmath.workdps(50):
        missed = max(
            float(abs(mpmath.mpf(float(f)) - mpmath.atan2(mpmath.mpf(float(y)), mpmath.mpf(float(x)))))
            for f, (y, x) in zip(found, yx, strict=True)
        )
    assert missed < 8e-16


def test_the_angle_of_a_pair_of_length_one_misses_it_by_no_more_than_the_bound_and_is_exact_at_whole_quarter_turns():
    # ANGLE_ERROR, 8e-16 rad, and 0.231 times what the length misses; sectors of the table meet where |y| - |x| is k / 4
    rng = np.random.default_rng(3)
    k = rng.integers(-4, 5, 4000) / 4
    meeting = np.pi / 4 + np.arcsin(k / np.sqrt(2)) + rng.normal(0, 1e-9, 4000)
    angle = np.concatenate(
        [rng.uniform(-np.pi, np.pi, 6000), meeting, -meeting, np.pi - meeting, rng.normal(0, 1, 2000) * 1e-8]
    )
    yx = np.stack([np.sin(angle), np.cos(angle)], axis=1)
    longer = yx.copy()
    longer[::2] *= 1 + rng.uniform(-1e-9, 1e-9, (len(longer[::2]), 1))
    for pairs in (yx, longer):
        found = _kernel.unit_angle(pairs)
        with mpmath.workdps(50):
            for f, (y, x) in zip(found, pairs, strict=True):
                y, x = mpmath.mpf(float(y)), mpmath.mpf(float(x))
                missed = abs(mpmath.mpf(float(f)) - mpmath.atan2(y, x))
                assert missed <= 8e-16 + 0.231 * abs(mpmath.sqrt(x * x + y * y) - 1)
    quarters = np.array([[0.0, 1.0], [1.0, 0.0], [-1.0, 0.0], [0.0, -1.0], [-0.0, 1.0], [1e-200, 1.0]])
    assert _kernel.unit_angle(quarters).tolist() == [0.0, np.pi / 2, -np.pi / 2, np.pi, 0.0, 1e-200]
    assert np.isnan(_kernel.unit_angle(np.array([[np.nan, 1.0], [1.0, np.nan]]))).all()
