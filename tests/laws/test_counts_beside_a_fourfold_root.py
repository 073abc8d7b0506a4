"""Law: where two directions are free at once four branches meet; moved a little they are as many, none told twice."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from oracle.arms.known import free

#: Multiples of 90 degrees at which four of twelve branches of an Indy7 meet (it was UNCERTAIN at each).
POSTURES = ((0, 2, 0, 0, 1, 1), (-1, 0, 0, 0, -1, 2), (2, 2, 0, 2, -1, 1))


@pytest.mark.parametrize("posture", POSTURES)
def test_as_many_branches_are_counted_at_the_root_and_beside_it(posture: tuple[int, ...]):
    arm, q = free("neuromeka-indy7"), np.array(posture) * pi / 2
    way = np.random.default_rng(1).normal(size=6)
    for step in (0.0, 1e-12, 1e-9, 1e-7, 1e-6, 1e-5, 1e-4):
        at = q + step * way
        sols = arm.ik(arm.fk(at))
        assert sols.status.name == "SOLVED" and sols.multiplicity.sum() == 12, step
        assert np.abs(sols.nearest(at) - at).max() < 1e-6
