"""Two axes in one line, or two slides along one, wherever in the arm: the posture that made a pose is on its set."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from pieper import DH, Arm, Status

QUARTER = np.pi / 2


def with_pair(rng: np.random.Generator, first: int, kind: str) -> Arm:
    """Return six joints, mostly of round numbers, of which `first` (0-based) and the next share a line or direction."""
    pick = [[0, 0, 0.1, 0.2, 0.3], [QUARTER, -QUARTER, 0, 0.7], [0, 0, 0.1, 0.25], [0, 0, QUARTER, -QUARTER]]
    rows, types = [[rng.choice(column) for column in pick] for _ in range(6)], list("RRRRRR")
    rows[first][:2] = [0, rng.choice([0, np.pi])]
    if kind == "slides":
        types[first : first + 2] = "PP"
    if kind == "slide along":
        types[first + 1] = "P"
    return Arm.from_dh([DH(*row) for row in rows], convention="standard", joint_types="".join(types))


@pytest.mark.parametrize("first", range(5))
@pytest.mark.parametrize("kind", ["coaxial", "slides", "slide along"])
def test_the_posture_that_made_the_pose_is_on_a_self_motion_or_a_row(kind, first):
    rng = np.random.default_rng(2 + first)
    for _ in range(3):
        arm = with_pair(rng, first, kind)
        try:
            spare = arm.plan.redundancy
        except pieper.PlanError:
            continue
        q = np.where(arm.chain.prismatic, 0.2, 1.0) * rng.uniform(-2.5, 2.5, 6)
        sols = arm.ik(arm.fk(q))
        row = len(sols.all_q) and arm.chain.joints.apart(sols.all_q, q).min() < 1e-6
        held = any(motion.contains(q) for motion in sols.self_motions)
        assert held or row, (
            f"{sols.status.name}, spare {spare}: {arm.description.rows}, {arm.joint_types}, {q.tolist()}"
        )
        assert sols.status == Status.REDUNDANT if spare else sols.status in (Status.SOLVED, Status.SINGULAR)


def test_a_surface_contains_its_postures_and_no_others():
    """Axes 3 and 4 in one line, 5 and 6 too: two turns are free at once, and a self-motion is a surface."""
    rows = [(0.1, QUARTER, 0.3), (0.4, 0.7, 0.1), (0, 0, 0.1), (0.2, QUARTER, 0), (0, 0, 0.2), (0.1, 0.4, 0.1)]
    arm = Arm.from_dh([DH(a, alpha, d) for a, alpha, d in rows], convention="standard")
    rng = np.random.default_rng(3)
    q = rng.uniform(-2, 2, 6)
    motions = arm.ik(arm.fk(q)).self_motions
    assert motions and all(motion.dimension == 2 for motion in motions)
    for _ in range(10):
        a, b = rng.uniform(-3, 3, 2)
        there = q + np.array([0, 0, a, -a, b, -b])
        assert any(motion.contains(there) for motion in motions)
        assert not any(motion.contains(there + 1e-3 * np.eye(6)[1]) for motion in motions)
