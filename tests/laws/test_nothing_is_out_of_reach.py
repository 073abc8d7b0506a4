"""A pose that a joint vector made is never told out of reach, on singularities of any kind or at any distance."""

from __future__ import annotations

import numpy as np
import pytest

from oracle.arms.known import free
from pieper import Arm
from pieper.solver.rows import Flag
from pieper.solver.singular.overlooked import overlooked

ARMS = ["stanford-arm", "denso-vp6242", "unimation-puma-560", "universal-robots-ur5e"]


def strata(arm: Arm, rng: np.random.Generator, count: int) -> np.ndarray:
    """Return joint vectors with one joint or two at a value where axes line up, or 1e-16 to 1e-2 beside it."""
    q = rng.uniform(-3, 3, (count, 6))
    for _ in range(2):
        at = np.flatnonzero(rng.uniform(size=count) < 0.5)
        joint = rng.integers(0, 6, len(at))
        base = np.where(arm.plan.prismatic[joint], 0.0, rng.choice([0.0, np.pi / 2, np.pi], len(at)))
        q[at, joint] = base + np.where(rng.uniform(size=len(at)) < 0.3, 0.0, 10 ** rng.uniform(-16, -2, len(at)))
    return q


@pytest.mark.parametrize("name", ARMS)
def test_a_pose_that_was_made_has_rows_or_is_looked_at(name):
    arm, rng = free(name), np.random.default_rng(31)
    T = arm.fk(strata(arm, rng, 20_000))
    _, valid, _, flags = arm.plan.solver.many(T, 1)
    _noticed(arm, T[~valid.any(1) & ((flags & Flag.DEGENERATE) == 0)])


def _noticed(arm: Arm, T: np.ndarray) -> None:
    assert not len(T) or overlooked(arm.plan, T).all()


@pytest.mark.parametrize("size", [0.0, 1e-14, 1e-12, 1e-10, 1e-9, -1e-9, 1e-8, 1e-6])
def test_a_slide_so_near_zero_that_its_square_is_rounding_is_found(size):
    arm, rng = free("stanford-arm"), np.random.default_rng(17)
    q = rng.uniform(-2.5, 2.5, (3000, 6))
    q[:, 2] = size
    T = arm.fk(q)
    _, valid, _, flags = arm.plan.solver.many(T, 1)
    assert valid.any(1).mean() > 0.98
    _noticed(arm, T[~valid.any(1) & ((flags & Flag.DEGENERATE) == 0)])
