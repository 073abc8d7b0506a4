"""Pairs of equations in two joints: their coefficients are read off three values of a joint."""

import numpy as np
import pytest

from pieper.solver.families import pairs


@pytest.mark.parametrize("slides", [False, True])
def test_coefficients_are_those_of_cosine_and_sine_or_of_a_slide_and_its_square(slides):
    rng = np.random.default_rng(4)
    constant, coefficients = rng.uniform(-1, 1, 2), rng.uniform(-1, 1, (2, 2))

    def side(x: float) -> np.ndarray:
        return constant + coefficients @ ([x, x * x] if slides else [np.cos(x), np.sin(x)])

    assert np.abs(pairs._terms(side, slides) - coefficients).max() < 1e-15
