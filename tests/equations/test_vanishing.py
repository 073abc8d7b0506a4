"""Postures at which several expressions vanish together are found whichever joints they are of, and only those."""

from __future__ import annotations

import numpy as np
import pytest

from pieper.equations.vanishing import random_postures, scale_of, vanish_together, vanishing_near


@pytest.mark.parametrize("joint", range(4))
def test_newtons_steps_go_along_each_joint(joint):
    start = random_postures(24, 4, [1], 0.5, np.random.default_rng(1))
    scale = scale_of(4, [1], 0.5)
    at = 0.2 if joint == 1 else np.sin(start[:, joint].mean())

    def values(q):
        return (q[:, joint] - at if joint == 1 else np.sin(q[:, joint]) - at)[:, None]

    found, left, nothing = vanishing_near(values, start, scale)
    assert nothing.sum() > 20 and left[nothing].max() < 1e-9
    assert np.abs(values(found[nothing])).max() < 1e-9
    others = [k for k in range(4) if k != joint]
    assert (found[:, others] == start[:, others]).all()


def test_two_that_vanish_at_different_places_do_not_vanish_together():
    def first(q):
        return np.cos(q[:, 0]) + 0.5 * np.sin(q[:, 1])

    def second(q):
        return np.sin(q[:, 0] + q[:, 1]) - 0.2

    def away(q):
        return first(q) + 0.25

    assert vanish_together([first, second], 2, [], 1.0)
    assert not vanish_together([first, away], 2, [], 1.0)
