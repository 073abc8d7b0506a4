"""Law of arms with several joints to spare of which some are held by name: of the others any value will do."""

from __future__ import annotations

from dataclasses import replace
from math import pi
from typing import Any

import numpy as np
import pytest

import pieper
from oracle.arms.numbered import random_arm
from pieper import DH, Arm, Status


def rail() -> Arm:
    """An iiwa 7 on a rail of two metres."""
    rows = [DH(alpha=-pi / 2), DH(d=0.34, alpha=-pi / 2), DH(alpha=pi / 2), DH(d=0.4, alpha=pi / 2), DH(alpha=-pi / 2)]
    rows += [DH(d=0.4, alpha=-pi / 2), DH(alpha=pi / 2), DH(d=0.126)]
    limits = [(-1.0, 1.0), *((-x, x) for x in np.radians([170, 120, 170, 120, 170, 120, 175]))]
    return Arm.from_dh(rows, convention="standard", joint_types="PRRRRRRR", limits=limits)


def told_alike(arm: Arm, q: np.ndarray, held: list[int], task: str | None) -> None:
    """Hold joints at what made a pose: rows inside the limits with these values, alone and in a batch."""
    how: dict[str, Any] = {"redundancy": {arm.joint_names[j]: q[j] for j in held}}
    how |= {} if task is None else {"task": task}
    T = arm.fk(q)
    sols, one = arm.ik(T, **how), arm.ik_many(T[None], **how)[0]
    assert sols.status == one.status == Status.REDUNDANT and len(sols.q) == len(one.q) > 0, (held, q)
    assert np.abs(sols.q[:, held] - q[held]).max() < 1e-9
    now = arm.fk(sols.q)
    assert np.abs(now[:, :3, 3] - T[:3, 3]).max() < 1e-8
    if task is None:
        assert np.abs(now - T).max() < 1e-8


@pytest.mark.parametrize("held", [[0], [3], [1], [7]])
def test_an_arm_on_a_rail(held: list[int]):
    arm, rng = rail(), np.random.default_rng(held[0])
    for _ in range(8):
        told_alike(arm, rng.uniform(*arm.limits.T), held, None)


@pytest.mark.parametrize("held", [[1], [1, 2], [0]])
def test_a_place_alone_with_some_joints_held(held: list[int]):
    arm, rng = pieper.load("denso-vp6242"), np.random.default_rng(2)
    for _ in range(4):
        told_alike(arm, rng.uniform(*arm.limits.T), held, "position")


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::pieper.PieperWarning")
@pytest.mark.parametrize("joints", [8, 9])
def test_random_arms_with_some_joints_held(joints: int):
    rng, tried = np.random.default_rng(joints), 0
    for number in range(500, 540):
        arm = random_arm(number, joints)[0]
        if "P" in arm.joint_types:
            continue
        half = rng.uniform(0.8, 2.5, joints)
        arm = Arm(replace(arm.description, limits=np.c_[-half, half]))
        free = [j for j in range(joints) if arm.joint_names[j] in arm.plan.choices]
        if arm.plan.task != "pose" or len(arm.plan.redundancy) < 2 or not free:
            continue
        tried += 1
        told_alike(arm, rng.uniform(-half, half), [int(rng.choice(free))], None)
    assert tried > 5


def test_what_is_denied_names_what_was_chosen():
    arm = rail()
    q = np.array([-0.95, 0.3, 0.4, 0.2, -0.9, 0.4, 0.3, 0.1])
    sols = arm.ik(arm.fk(q), redundancy={"joint_1": 0.95})
    assert sols.status == Status.REDUNDANT and not len(sols.q)
    assert "the chosen joint_1; other values" in sols.why
