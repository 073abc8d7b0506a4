"""Five-joint arms whose last joint turns across the tool's axis: a row meets what the task asks for, and no more.

Position and tool axis leave the turn about that axis open, so half of such an arm's rows stand with the tool turned by
half a turn; the task `pose` asks for that turn too.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pieper

ARM = Path(__file__).with_name("widowx-250.toml")


@pytest.mark.parametrize("task", ["position+axis", "pose"])
def test_every_row_meets_its_task_and_the_posture_is_among_them(task):
    arm = pieper.load(ARM)
    assert arm.plan.task == "position+axis"
    q = np.random.default_rng(5).uniform(-1.5, 1.5, (40, 5))
    half_turned = 0
    for known, T in zip(q, arm.fk(q), strict=True):
        sols = arm.ik(T, task=task)
        off = np.abs(arm.fk(sols.all_q) - T)
        asked = off[:, :3, 2:] if task == "position+axis" else off
        assert len(sols.all_q) and asked.max() < 1e-8
        assert arm.chain.joints.apart(sols.all_q, known).min() < 1e-8
        half_turned += int((off.max((1, 2)) > 1e-3).sum())
    assert (half_turned > 0) == (task == "position+axis")
