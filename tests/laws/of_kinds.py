"""A law of arms: what must hold of random arms of several kinds."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pieper

SEEDS = st.integers(0, 10**6)
Law = Callable[[pieper.Arm, np.random.Generator], None]


def of_kinds(kinds: Iterable[Callable[[np.random.Generator], pieper.Arm]], examples: int) -> Callable[[Law], Law]:
    """Make a test a kind of a law that takes an arm and random numbers, tried on so many arms."""

    def tested(law: Law) -> Law:
        @pytest.mark.parametrize("kind", kinds)
        @settings(max_examples=examples, deadline=None)
        @given(seed=SEEDS)
        def test(kind, seed):
            rng = np.random.default_rng(seed)
            law(kind(rng), rng)

        test.__name__ = test.__qualname__ = law.__name__
        test.__module__ = law.__module__
        return test

    return tested
