"""Arms a rounding away from a special arrangement are solved like any other, not left uncertain at every pose."""

from __future__ import annotations

import numpy as np
import pytest

from oracle.joints import turns_apart
from pieper import DH, Arm, Status

RIGHT = np.pi / 2


@pytest.mark.parametrize("off", [3e-12, 3.7e-10, 1e-7, 1e-6])
def test_a_wrist_that_misses_its_point_by_next_to_nothing_is_solved_completely(off):
    rows = [(0.13, RIGHT, 0), (0, -RIGHT, -0.2), (0, RIGHT, off), (0, RIGHT, -0.41), (0, RIGHT, -0.0114), (0, 0, -0.31)]
    arm = Arm.from_dh([DH(a, alpha, d) for a, alpha, d in rows], convention="standard", joint_types="PRRRRR")
    q = np.random.default_rng(0).uniform(-1, 1, (100, 6))
    T = arm.fk(q)
    many = arm.ik_many(T, threads=1)
    assert (many.status == Status.SOLVED).mean() > 0.94
    gap = turns_apart(many.q, q[:, None]).max(-1)
    assert (np.where(many.valid, gap, 9.0).min(1) < 1e-6).all()
    rows = many.q[many.valid]
    assert np.abs(arm.fk(rows) - T[np.nonzero(many.valid)[0]]).max() < 1e-9
    far = T[:1].copy()
    far[0, 2, 3] += 50.0
    far[0, 0, 3] += 50.0
    assert arm.ik_many(far).status[0] == Status.OUT_OF_REACH
    assert "Made special to be solved" in arm.plan.explain()
