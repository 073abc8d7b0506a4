"""The kernel's determinant and smallest singular value against LAPACK's and 40 digits, singular matrices included."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest

from pieper import _kernel

N = 16_667


def turns(rng, n):
    return np.linalg.qr(rng.normal(size=(n, 6, 6)))[0]


def with_values(rng, values):
    return turns(rng, len(values)) @ (values[:, :, None] * turns(rng, len(values)))


def spread_of(rng, **at):
    values = rng.uniform(0.1, 1, size=(N, 6))
    for place, value in at.items():
        values[:, int(place[1:]) :] = value
    return values


KINDS = {
    "any": lambda rng: rng.normal(size=(N, 6, 6)),
    "values over 16 decades": lambda rng: with_values(rng, 10 ** rng.uniform(-16, 0, size=(N, 6))),
    "one value 0": lambda rng: with_values(rng, spread_of(rng, v5=0.0)),
    "three values 0": lambda rng: with_values(rng, spread_of(rng, v3=0.0)),
    "two least values equal": lambda rng: with_values(rng, spread_of(rng, v4=0.01)),
    "whole numbers, many 0": lambda rng: rng.integers(-1, 2, size=(N, 6, 6)) * (rng.random((N, 6, 6)) < 0.4) * 1.0,
}


@pytest.mark.parametrize("kind", KINDS)
def test_a_hundred_thousand_matrices_are_measured_as_lapack_measures_them(kind):
    J = KINDS[kind](np.random.default_rng(7))
    determinant, least = _kernel.posture_measures(J, 1.0).T
    values = np.linalg.svd(J, compute_uv=False)
    largest = np.maximum(values[:, 0], np.finfo(float).tiny)
    assert (np.abs(least - values[:, -1]) / largest).max() < 2e-15
    assert (np.abs(determinant - np.linalg.det(J)) / largest**6).max() < 1e-14


def test_small_values_are_right_in_forty_digits():
    """Least values down to 1e-12 of the largest, to the rounding of the largest."""
    rng = np.random.default_rng(8)
    J = with_values(rng, 10 ** rng.uniform(-12, 0, size=(12, 6)))
    found = _kernel.posture_measures(J, 1.0)[:, 1]
    with mpmath.workdps(40):
        for one, least in zip(J, found, strict=True):
            right = mpmath.svd_r(mpmath.matrix(one.tolist()), compute_uv=False)
            assert abs(least - min(right)) < 2e-15 * max(right)


def test_lengths_are_divided_in_the_singular_value_only():
    J = np.random.default_rng(9).normal(size=(11, 6, 6))
    scaled = J.copy()
    scaled[:, :3] /= 250.0
    determinant, least = _kernel.posture_measures(J, 250.0).T
    assert determinant == pytest.approx(np.linalg.det(J), rel=1e-12)
    assert least == pytest.approx(np.linalg.svd(scaled, compute_uv=False)[:, -1], rel=1e-9)


@pytest.mark.parametrize("count", range(10))
def test_any_number_of_matrices_as_each_alone(count):
    J = np.random.default_rng(count).normal(size=(count, 6, 6))
    alone = [_kernel.posture_measures(one[None], 1.0)[0] for one in J]
    assert np.array_equal(_kernel.posture_measures(J, 1.0), np.reshape(alone, (count, 2)))


def test_matrices_of_zeros_and_of_one_long_chain_are_singular():
    chain = np.zeros((6, 6))
    chain[np.arange(5), np.arange(1, 6)] = 1.0
    assert not _kernel.posture_measures(np.stack([np.zeros((6, 6)), chain, 1e-300 * np.eye(6)]), 1.0)[:, 0].any()
    assert (_kernel.posture_measures(np.stack([np.zeros((6, 6)), chain]), 1.0) == 0).all()
