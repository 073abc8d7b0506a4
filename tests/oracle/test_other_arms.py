"""Shorter arms, partial tasks and redundant arms, judged by the oracle."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle import blur, equations, gap, judge, locked, machine, search
from oracle.arms.known import free
from oracle.joints import random_joints
from pieper import DH, Arm

QUARTER = np.pi / 2

SHORT = {
    "one revolute": ("R", [(0.3, 0.4, 0.1, 0.2)]),
    "one slide": ("P", [(0.3, 0.4, 0.1, 0.2)]),
    "two links in a plane": ("RR", [(0.4, 0, 0, 0), (0.3, 0, 0, 0)]),
    "two general joints": ("RR", [(0.4, 0.7, 0.1, 0), (0.3, 0.2, 0.2, 0.1)]),
    "revolute and slide": ("RP", [(0.0, -1.53, 0.0, 1.0), (0.0, -QUARTER, -0.55, -1.65)]),
    "three general joints": ("RRR", [(0.4, 0.7, 0.1, 0), (0.3, 0.2, 0.2, 0.1), (0.2, 1.1, -0.1, 0.3)]),
    "three of the third paper": ("RRR", [(0, QUARTER, 0, 0), (0, QUARTER, -0.5, 0), (0.8, 0, 0, 0)]),
    "gantry": ("PPP", [(0, QUARTER, 0.1, QUARTER), (0, QUARTER, 0.2, QUARTER), (0.1, 0, 0.3, 0)]),
    "cylindrical": ("RPP", [(0, 0, 0.2, 0), (0, -QUARTER, 0, 0), (0, 0, 0.1, 0)]),
    "scara": ("RRPR", [(0.4, 0, 0.3, 0), (0.3, np.pi, 0, 0), (0, 0, 0.1, 0), (0, 0, 0.05, 0)]),
    "four general joints": (
        "RRRR",
        [(0.4, 0.7, 0.1, 0), (0.3, 0.2, 0.2, 0.1), (0.2, 1.1, -0.1, 0.3), (0.1, 0.5, 0.2, 0)],
    ),
    "five with a slide": (
        "RRPRR",
        [(0.4, 0.7, 0.1, 0), (0.3, 0.2, 0.2, 0.1), (0.2, 1.1, -0.1, 0.3), (0.1, 0.5, 0.2, 0), (0.1, 0.3, 0.1, 0.2)],
    ),
    "five of the second paper": (
        "RRRRR",
        [(0, QUARTER, 0.045, 0), (0.09, 0, 0, 0), (0.09, 0, 0, 0), (0, -QUARTER, 0, -QUARTER), (0, 0, 0.03, 0)],
    ),
    "five general joints": (
        "RRRRR",
        [(0.4, 0.7, 0.1, 0), (0.3, 0.2, 0.2, 0.1), (0.2, 1.1, -0.1, 0.3), (0.1, 0.5, 0.2, 0), (0.1, 0.3, 0.1, 0.2)],
    ),
}


def short(name) -> Arm:
    """Return a short arm by its name."""
    types, rows = SHORT[name]
    return Arm.from_dh([DH(*row) for row in rows], convention="standard", joint_types=types, name=name)


@pytest.mark.parametrize("task", ["pose", "position", "position+axis"])
@pytest.mark.parametrize("name", SHORT)
def test_short_arms_have_the_solutions_of_the_oracle(name, task):
    arm = short(name)
    q = random_joints(arm, np.random.default_rng(9), 1)[0]
    T = arm.fk(q)
    try:
        redundant = arm.plan_for(task).redundancy
    except pieper.PlanError as error:
        pytest.fail(f"no plan: {error}")
    sols = arm.ik(T, task=task)
    verdict = judge(arm, T, rows=sols.all_q, self_motions=sols.self_motions, task=task, starts=300, at_most=25)
    assert not verdict.wrong
    if redundant:
        assert sols.status.name == "REDUNDANT" and sols.self_motions and len(sols.all_q)
        if len(redundant) == 1:
            assert any(f.contains(q, 1e-4) for f in sols.self_motions)
    else:
        assert not verdict.missing, f"{sols.status.name}: {sols.why} {verdict.missing[:2]}"
        assert len(sols.all_q) == len(verdict.found.q)


@pytest.mark.parametrize("name", [n for n in SHORT if len(SHORT[n][0]) < 6])
def test_a_pose_beyond_a_short_arm_is_out_of_reach_by_what_the_oracle_measures(name):
    arm = short(name)
    q = random_joints(arm, np.random.default_rng(5), 1)[0]
    T = arm.fk(q)
    T[:3, 3] += [0.03, -0.02, 0.025]
    T[:3, :3] = T[:3, :3] @ np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]]) @ np.diag([1.0, -1, -1])
    sols = arm.ik(T, task="pose")
    found = search(arm, T, starts=200)
    assert len(sols.all_q) == len(found.q) == 0
    assert sols.status.name == "OUT_OF_REACH" and any(c.isdigit() for c in sols.why)


SEVEN = [
    "kuka-lbr-iiwa-14-r820",
    "franka-panda",
    "kinova-gen3-7dof",
    "ufactory-xarm7",
    "rethink-sawyer",
    "motoman-sia10d",
]


@pytest.mark.parametrize("name", SEVEN)
def test_a_redundant_arm_at_a_chosen_value_has_the_solutions_of_the_oracle(name):
    arm = free(name)
    m = machine(arm)
    joint = list(arm.joint_names).index(arm.plan.redundancy[0])
    q = np.array([0.4, -0.7, 0.5, 1.1, -0.6, 0.9, 0.3])
    T = arm.fk(q)
    sols = arm.ik(T, redundancy=q[joint])
    rest = locked(m, joint, m.inner(q)[joint])
    found = search(None, T, m=rest, starts=500)
    rows = rest.inner(np.delete(sols.all_q, joint, 1))
    assert len(rows) == len(found.q)
    for other, sigma in zip(found.q, found.sigma, strict=True):
        assert gap(rest, rows, rest.inner(other)).min() < blur(1e-5, sigma)
    assert np.abs(sols.all_q[:, joint] - q[joint]).max() < 1e-9
    many = arm.ik_many(T[None], redundancy=q[joint], threads=1)
    assert many.valid.sum() == len(found.q)


@pytest.mark.parametrize("name", SEVEN[:3])
def test_self_motions_of_a_redundant_arm_are_curves_of_exact_solutions_through_the_posture(name):
    arm = free(name)
    m = machine(arm)
    q = np.array([0.4, -0.7, 0.5, 1.1, -0.6, 0.9, 0.3])
    T = arm.fk(q)
    sols = arm.ik(T)
    assert sols.status.name == "REDUNDANT"
    assert any(f.contains(q, 1e-5) for f in sols.self_motions)
    for motion in sols.self_motions:
        points = np.stack([motion.at(s) for s in np.linspace(0, 1, 11)])
        left = np.linalg.norm(equations(m, m.inner(points), m.pose(T))[0], axis=1)
        assert left.max() < 1e-10


def test_dependent_joints_make_a_self_motion_with_the_sum_fixed():
    arm = pieper.load("dfrobot-rob0036-as-printed")
    q = np.radians([20.0, 30, 40, 50, 60, 10])
    sols = arm.ik(arm.fk(q))
    assert arm.plan.redundancy and any(f.contains(q, 1e-5) for f in sols.self_motions)
    for row in sols.all_q:
        assert np.abs(arm.fk(row) - arm.fk(q)).max() < 1e-10
