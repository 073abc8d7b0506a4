"""Arms of one to five joints: what is SOLVED holds what the task asks for, and what holds it is found."""

from __future__ import annotations

import numpy as np
import pytest

from pieper import DH, Arm
from pieper.errors import PlanError
from pieper.kinematics.pose import rotation_about

QUARTER = np.pi / 2


def short_arm(rng: np.random.Generator, n: int) -> Arm:
    """Return a random arm of n joints: right angles, parallel axes and zero offsets often, slides now and then."""
    rows = [
        DH(
            a=float(rng.choice([0.0, 0.3, rng.uniform(0.1, 0.5)])),
            alpha=float(rng.choice([0.0, QUARTER, -QUARTER, rng.uniform(-2, 2)])),
            d=float(rng.choice([0.0, rng.uniform(-0.4, 0.4)])),
            theta=float(rng.choice([0.0, rng.uniform(-1, 1)])),
        )
        for _ in range(n)
    ]
    rows[-1] = DH(a=0.2, alpha=rows[-1].alpha, d=rows[-1].d, theta=rows[-1].theta)
    kinds = "".join(rng.choice(["R", "R", "R", "P"], n))
    return Arm.from_dh(rows, convention="standard", joint_types=kinds)


def poses(arm: Arm, rng: np.random.Generator) -> list[tuple[np.ndarray, np.ndarray]]:
    """Return poses beside postures: exactly reached, moved by a millimetre, tilted, and anywhere."""
    out = []
    for size in (0.0, 1e-3, 0.3):
        q = rng.uniform(-1.5, 1.5, arm.n) * np.where(arm.plan_for("position").prismatic, 0.3, 1.0)
        T = arm.fk(q)
        way = rng.standard_normal(6)
        T[:3, 3] += size * way[:3] * 0.3
        axis = way[3:] / np.linalg.norm(way[3:])
        T[:3, :3] = rotation_about(axis, size) @ T[:3, :3]
        out.append((q, T))
    return out


@pytest.mark.parametrize("n", [1, 2, 3, 4, 5])
@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("task", ["position", "position+axis", "pose"])
def test_what_misses_the_task_is_no_solution(n, seed, task):
    rng = np.random.default_rng(1000 * n + seed)
    arm = short_arm(rng, n)
    try:
        plan = arm.plan_for(task)
    except PlanError:
        pytest.skip("this task makes no sense for this arm, and the plan says so")
    for q, T in poses(arm, rng):
        sols, many = arm.ik(T, task=task), arm.ik_many(T[None], task=task, threads=1)
        length = plan.chain.length
        assert sols.residual[:, 0].max(initial=0.0) < 1e-8 * length and sols.residual[:, 1].max(initial=0.0) < 1e-8
        assert int(sols.status) == many.status[0] and len(sols.all_q) == many.count[0]
        reached = plan.residual(q, T).max() < 1e-12
        if reached and not plan.redundancy:
            # a row is polished to what rounding leaves of its pose: compare what it does, not the joints alone
            gap = plan.chain.joints.apart(sols.all_q, q)
            assert len(sols.all_q) and (
                gap.min() < 1e-5 or any(motion.contains(q, 1e-4) for motion in sols.self_motions)
            ), f"lost: {sols.status.name}, {sols.why}"
        if sols.status.name == "OUT_OF_REACH":
            near = sols.closest
            assert near.metres > 1e-9 or near.radians > 1e-9
            miss = plan.residual(near.q, T)
            assert near.metres == pytest.approx(miss[0]) and near.radians == pytest.approx(miss[1], abs=1e-12)
