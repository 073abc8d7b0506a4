"""Five-joint arms whose last axis crosses the plane of the three parallel ones: every row must close."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pieper


@pytest.mark.xfail(strict=True, reason="half of the rows miss the pose")
def test_every_row_of_a_waist_shoulder_elbow_wrist_twist_arm_closes():
    arm = pieper.load(Path(__file__).with_name("widowx-250.toml"))
    q = np.random.default_rng(5).uniform(-1.5, 1.5, (12, 5))
    T = arm.fk(q)
    for pose in T:
        rows = arm.ik(pose).all_q
        assert len(rows) and np.abs(arm.fk(rows) - pose).max() < 1e-8
