"""Arms with joints to spare have a plan for every task, and it solves the poses they are made of."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

import pieper
from pieper import DH, Arm
from pieper.solver.plan import classify

H = pi / 2
SLIDES_AT_THE_END = Arm.from_dh(
    [
        DH(0.25, H, 0, H),
        DH(0, H, 0, 0),
        DH(0.3, H, -0.15, H),
        DH(-0.2, -H, 0, H),
        DH(-0.2, pi / 4, 0.4, H),
        DH(0.1, -H, 0, 0),
        DH(0, -H, 0.2, H),
    ],
    convention="standard",
    joint_types="RRPRRPP",
)


def drawn(seed: int) -> Arm:
    """Return a round arm of seven to nine joints, every fourth a slide."""
    rng = np.random.default_rng(seed)
    n = int(rng.integers(7, 10))
    lengths, turns = [0, 0, 0.1, 0.25, -0.2, 0.3, -0.15, 0.4], [0, H, -H, pi / 4, pi]
    rows = [DH(*(float(rng.choice(some)) for some in (lengths, turns, lengths, [0, 0, H, pi]))) for _ in range(n)]
    kinds = "".join(rng.choice(list("RRRP"), n))
    return Arm.from_dh(rows, convention=str(rng.choice(["standard", "modified"])), joint_types=kinds)


@pytest.mark.parametrize("task", ["pose", "position", "position+axis"])
@pytest.mark.parametrize(
    "arm", [SLIDES_AT_THE_END, *(drawn(seed) for seed in range(6))], ids=lambda arm: arm.joint_types
)
def test_every_task_of_an_arm_with_joints_to_spare_has_a_plan(arm: Arm, task: str):
    q = np.where(arm.plan.prismatic, 0.2, 0.7) * np.sin(np.arange(1, arm.n + 1))
    sols = arm.ik(arm.fk(q), task=task)
    assert sols.status.name == "REDUNDANT" and len(sols.q)
    assert sols.residual.max() < 1e-9


@pytest.mark.parametrize("task", ["pose", "position"])
def test_an_arm_without_solver_is_told_by_its_own_joints_and_its_task(task: str, monkeypatch: pytest.MonkeyPatch):
    def refuse(*_: object) -> None:
        raise pieper.PlanError("These depend. Lock a joint, or ask for a partial task.", reason="These depend.")

    monkeypatch.setattr(classify, "choose", refuse)
    with pytest.raises(pieper.PlanError) as told:
        SLIDES_AT_THE_END.with_limits({}).plan_for(task)
    said = str(told.value)
    assert "7 joints of its own" in said and "These depend. Lock a joint" in said and "partial task" not in said
    assert ("3 joints for what the task 'position' leaves free, 4 of them held" in said) == (task == "position")
    assert f"'{task}' or" not in said and f"or '{task}'" not in said
