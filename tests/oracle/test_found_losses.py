"""Every arm and pose at which a solution was once lost: the joint vector that made the pose must be found again.

Cases are in found_losses.json. A case that is not cured has its reason under "open" and must fail until it is; when it
is cured, "open" becomes null. "claim" says what must hold: "found" (the joint vector is a row or on a self-motion),
"certain" (the status is not UNCERTAIN either) or "self-motions" (it lies on one of a redundant arm's).
"full rank" (no joint is to spare) asks without held values. "task" is None for the arm's default task.
"""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from oracle import equations, forward, gap, machine, polish
from oracle.arms.known import free
from oracle.joints import random_joints
from pieper import DH, Arm

CASES = json.loads(Path(__file__).with_name("found_losses.json").read_text())


def made(case) -> tuple[Arm, np.ndarray, np.ndarray]:
    """Return a case's arm, joint vector and pose; the pose by the oracle's own product."""
    rows = [DH(*row) for row in case["rows"]]
    place = {key: np.array(case[key]) for key in ("base", "tool", "sign", "offset")}
    arm = Arm.from_dh(rows, convention=case["convention"], joint_types=case["types"], name=case["name"], **place)
    m, q = machine(arm), np.array(case["q"])
    T = forward(m, m.inner(q[None]))[0][0]
    T[:3, 3] *= m.unit
    return arm, q, T


def marked(case):
    """Return a case as a parameter, a strict xfail while it is open."""
    marks = [pytest.mark.xfail(strict=True, reason=case["open"])] if case["open"] else []
    return pytest.param(case, id=case["name"], marks=marks)


@pytest.mark.parametrize("case", [marked(case) for case in CASES])
def test_a_joint_vector_that_was_once_lost_is_found_again(case):
    arm, q, T = made(case)
    m = machine(arm)
    task = case["task"]
    held = [list(arm.joint_names).index(name) for name in arm.plan_for(task).redundancy]
    if case["claim"] == "full rank":
        assert not held
    chosen = {"task": task} | ({"redundancy": q[held]} if held else {})
    one, many = arm.ik(T, **chosen), arm.ik_many(T[None], threads=1, **chosen)
    free = [j for j in range(arm.n) if j not in held]
    # rounding of the pose moves a solution by about this much
    sigma = 1.0
    if len(free) == 6:
        sigma = polish(m, m.pose(T), m.inner(q[None]), rounds=0)[2][0]
    elif (task or arm.plan.task) == "position" and len(free) == 3:
        sigma = np.linalg.svd(arm.jacobian(q)[:3] / m.unit, compute_uv=False)[-1]
    wide = 1e-6 + 1e-14 / max(sigma, 1e-300)
    on_motion = not held and any(motion.contains(q, 1e-5) for motion in one.self_motions)
    for rows in (one.all_q, many.q[0][many.valid[0]]):
        near = gap(m, m.inner(rows), m.inner(q)).min() if len(rows) else np.inf
        assert near < wide or on_motion, f"lost: {one.status.name}, {one.why}"
    if case["claim"] == "self-motions":
        assert any(motion.contains(q, 1e-5) for motion in arm.ik(T).self_motions)
    if case["claim"] == "certain":
        assert one.status.name != "UNCERTAIN", one.why


@pytest.mark.parametrize("size", [1e-9, 1e-10, 1e-11])
def test_an_arm_that_is_off_by_less_than_is_recognised_still_closes_to_rounding(size):
    arm = free("denso-vp6242")
    d = arm.description
    errors = size * np.random.default_rng(11).uniform(-1, 1, (6, 3))
    rows = [replace(r, a=r.a + e[0], d=r.d + e[1], alpha=r.alpha + e[2]) for r, e in zip(d.rows, errors, strict=True)]
    arm = Arm.from_dh(rows, convention=d.convention)
    m = machine(arm)
    for q in random_joints(arm, np.random.default_rng(1), 5):
        T = forward(m, m.inner(q[None]))[0][0]
        given = np.array(T)
        given[:3, 3] *= m.unit
        left = equations(m, m.inner(arm.ik(given).all_q), T)[0]
        assert np.abs(left).max() < 1e-12
