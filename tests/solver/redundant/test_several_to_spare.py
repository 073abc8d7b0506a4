"""Arms with several joints to spare: all that holds a pose is one self-motion, on which every such posture lies."""

from __future__ import annotations

import numpy as np
import pytest

from pieper import DH, Arm, Status
from pieper.solver.redundant import self_motions

QUARTER = np.pi / 2
#: Tables (a, alpha, d, theta) whose postures single lines on what holds the pose do not lead to.
ARMS = {
    "RRRPPRRR": [
        (0, 0, 0.4, 0),
        (0.3, np.pi, 0, 0),
        (0, -QUARTER, 0, QUARTER),
        (0.71, QUARTER, 0, 0),
        (0, -QUARTER, 0, 0),
        (0, 0.89, 0, 0),
        (0, QUARTER, 0.4, QUARTER),
        (0, QUARTER, 0.4, 0),
    ],
    "RPRPRR": [
        (0.3, -QUARTER, 0, -0.07),
        (0.5, QUARTER, 0.4, 0),
        (0, -QUARTER, 0.2, 0),
        (0, QUARTER, 0, 0),
        (0, 0, 0, -2.28),
        (0.5, QUARTER, 0, 0),
    ],
    "RRRRR": [(0.3, 0, 0.1, 0), (0.4, 0, 0, 0), (0.2, np.pi, 0, 0), (0.3, 0, 0.2, 0), (0.1, 0, 0, 0)],
}


def made(types: str) -> Arm:
    return Arm.from_dh([DH(*row) for row in ARMS[types]], convention="standard", joint_types=types)


def drawn(types: str, seed: int) -> np.ndarray:
    rng = np.random.default_rng(seed)
    return np.array([rng.uniform(-3, 3) if kind == "R" else rng.uniform(-1, 1) for kind in types])


@pytest.mark.parametrize("types", ARMS)
@pytest.mark.parametrize("seed", range(3))
def test_what_holds_the_pose_is_told_once_and_contains_the_posture_that_made_it(types, seed):
    arm, q = made(types), drawn(types, seed)
    sols = arm.ik(arm.fk(q))
    assert sols.status == Status.REDUNDANT and len(sols.self_motions) == 1
    motion = sols.self_motions[0]
    assert motion.dimension == len(arm.plan.redundancy) > 1
    assert motion.contains(q)
    assert f"with {motion.dimension} degrees of freedom" in str(motion)
    # the posture is its own nearest, as it holds the pose; one beside it that does not hold it is not contained
    assert np.abs(arm.fk(sols.nearest(q)) - arm.fk(q)).max() < 1e-9
    assert arm.chain.joints.apart(sols.nearest(q), q) < 1e-9
    J = np.linalg.svd(arm.jacobian(q))[2]
    assert not motion.contains(q + 1e-3 * J[0])


def test_a_position_with_the_tool_free_is_held_by_every_posture_that_reaches_it():
    arm = made("RRRPPRRR")
    q = drawn("RRRPPRRR", 5)
    motion = arm.ik(arm.fk(q), task="position").self_motions[0]
    turned = q + np.append(np.zeros(7), 0.4)  # the last axis passes through the tool point
    assert np.abs(arm.fk(turned)[:3, 3] - arm.fk(q)[:3, 3]).max() < 1e-12
    assert motion.contains(q) and motion.contains(turned)
    assert not motion.contains(q + np.append([0.01], np.zeros(7)))


def test_limits_are_met_by_the_line_that_is_shown_where_any_meets_them():
    arm = made("RRRPPRRR")
    q = drawn("RRRPPRRR", 1)
    narrow = arm.with_limits({name: (v - 0.4, v + 0.4) for name, v in zip(arm.joint_names, q, strict=True)})
    sols = narrow.ik(arm.fk(q))
    assert sols.status == Status.REDUNDANT and len(sols.self_motions) == 1
    point = sols.nearest(q)
    assert narrow.chain.joints.apart(point, q) < 1e-9


@pytest.mark.parametrize("seed", [0, 2, 3])
def test_points_are_drawn_of_both_values_where_none_is_held_at_the_second_as_it_is_asked(seed, monkeypatch):
    arm, q = made("RRRPPRRR"), drawn("RRRPPRRR", seed)
    swept = self_motions.sweep(arm.plan, arm.fk(q), 0, arm.plan.defaults)
    assert len(arm.plan.reduction.locked) == 2 and not swept.valid.any()
    monkeypatch.setattr(self_motions, "from_anywhere", lambda plan, T, starts: [np.zeros((0, 8))] * len(T))
    points = self_motions.met(arm.plan, arm.fk(q), arm.plan.defaults)
    assert len(points) and np.abs(arm.fk(points) - arm.fk(q)).max() < 1e-9
