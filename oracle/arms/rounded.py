"""Arms and postures of round numbers, as people type them: there several roots of a polynomial meet in one."""

from __future__ import annotations

from typing import Any

import numpy as np

from oracle.arms.kinds import random_pose
from pieper import DH, Arm

TWISTS_DEG = (0, 90, -90, 90, -90, 90, -90, 45, 30, 60, 180)
LENGTHS = (0.0, 0.0, 0.0, 0.1, 0.15, 0.2, 0.25, 0.3, 0.5)
STEPS_DEG = (90, 45, 30, 15, 1)


def round_arm(rng: np.random.Generator) -> Arm:
    """Return six joints, at most two of them slides, with round twists, lengths and zeros; base and tool at random."""
    types = np.array(list("RRRRRR"))
    types[rng.choice(6, rng.choice([0, 0, 0, 1, 2]), replace=False)] = "P"
    twists, zeros = np.radians(rng.choice(TWISTS_DEG, 6)), np.radians(rng.choice([0, 90, -90, 180], 6))
    rows = [DH(*row) for row in zip(rng.choice(LENGTHS, 6), twists, rng.choice(LENGTHS, 6), zeros, strict=True)]
    place: dict[str, Any] = (
        {"tool": random_pose(rng, 0.3), "base": random_pose(rng, 0.3)} if rng.uniform() < 0.3 else {}
    )
    convention = str(rng.choice(["standard", "modified"]))
    return Arm.from_dh(rows, convention=convention, joint_types="".join(types), name="round", **place)


def round_postures(arm: Arm, rng: np.random.Generator, count: int, step_deg: float) -> np.ndarray:
    """Return up to `count` regular joint vectors (k, n) of multiples of a step, slides of round lengths (m)."""
    half = round(180 / step_deg)
    q = np.radians(rng.integers(-half + 1, half + 1, (3 * count, arm.n)) * float(step_deg))
    slides = arm.chain.prismatic
    q[:, slides] = rng.choice(LENGTHS, (len(q), int(slides.sum())))
    smallest = np.linalg.svd(arm.jacobian(q), compute_uv=False)[:, -1]
    return q[smallest > 1e-3][:count]
