"""Round postures of every family: SOLVED never says of some rows that they are all, wherever roots meet."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle import compare, machine, whole_set
from oracle.arms.known import free
from oracle.arms.rounded import STEPS_DEG, round_arm, round_postures
from pieper import Arm, Status

#: Postures whose poses were once told SOLVED with two of eight rows missing (deg).
LOST = [
    ("fanuc-crx-10ia", [90, 90, -165, -90, -135, 90]),
    ("fanuc-crx-10ia", [90, 90, -135, 135, -135, 135]),
    ("fanuc-crx-10ia", [120, 90, -150, -60, -150, 90]),
    ("motoman-hc10", [113.9520811, 0, 70.71346, 115.0701021, -37.2011982, 90]),
    ("kinova-gen3-lite", [135, -135, 135, 0, 90, -90]),
    ("niryo-ned2", [90, 0, 0, 0, 90, -90]),
]
FAMILIES = [
    *("denso-vp6242", "stanford-arm", "universal-robots-ur5e", "aubo-i5", "kinova-gen3-6dof"),
    *("fanuc-crx-10ia", "motoman-hc10", "motoman-ea1400n", "kinova-gen3-lite", "niryo-ned2", "neuromeka-indy12"),
]
#: A pose this far beside (rad) has its roots within so much of the round one's: a fourfold one by the fourth root.
BESIDE, NEAR = 1e-8, 3e-2


def apart(arm: Arm, rows: np.ndarray, valid: np.ndarray, q: np.ndarray) -> np.ndarray:
    """Return how far joint vectors q (N, k, n) lie from the nearest valid one of rows (N, m, n): (N, k)."""
    gap = arm.chain.joints.apart(rows[:, None], q[:, :, None])
    return np.where(valid[:, None], gap, np.inf).min(-1)


def missing(arm: Arm, q: np.ndarray) -> np.ndarray:
    """Return those of q (N, n) whose pose is SOLVED without them, or without a row that a pose close beside has."""
    many = arm.ik_many(arm.fk(q), threads=1)
    beside = arm.ik_many(arm.fk(q + BESIDE * np.random.default_rng(5).standard_normal(q.shape)), threads=1)
    own = apart(arm, many.q, many.valid, q[:, None])[:, 0] > 1e-5
    near = np.where(beside.valid, apart(arm, many.q, many.valid, beside.q), 0.0).max(1, initial=0.0) > NEAR
    return q[(many.status == Status.SOLVED) & (own | near)]


@pytest.mark.parametrize(("name", "degrees"), LOST)
def test_a_posture_that_was_once_lost_is_found_again(name, degrees):
    arm, q = free(name, placed=True), np.radians(degrees)
    sols = arm.ik(arm.fk(q))
    assert sols.status == Status.SOLVED and len(sols.all_q) >= 8
    assert arm.chain.joints.apart(sols.all_q, q).min() < 1e-6


@pytest.mark.parametrize("name", FAMILIES)
def test_no_row_is_missing_at_multiples_of_round_angles(name):
    arm = free(name, placed=True)
    for step in STEPS_DEG:
        lost = missing(arm, round_postures(arm, np.random.default_rng(step), 30, step))
        assert not len(lost), f"{step} deg: {np.degrees(lost[:2]).round(3).tolist()}"


def test_round_arms_of_every_kind_lose_no_row_at_round_postures():
    rng, solved = np.random.default_rng(11), 0
    while solved < 25:
        arm, step = round_arm(rng), int(rng.choice(STEPS_DEG))
        try:
            spare = arm.plan.redundancy
        except pieper.PlanError:
            continue
        if spare or not len(q := round_postures(arm, rng, 8, step)):
            continue
        solved += 1
        lost = missing(arm, q)
        assert not len(lost), f"{arm.plan.family}: {arm.description.rows} {arm.joint_types} at {lost[:1].tolist()}"


@pytest.mark.slow
@pytest.mark.parametrize("name", ["fanuc-crx-10ia", "universal-robots-ur5e", "kinova-gen3-6dof", "stanford-arm"])
def test_whole_sets_at_round_postures_are_those_of_the_search(name):
    arm = free(name)
    for q in round_postures(arm, np.random.default_rng(3), 3, 45):
        sols, m = arm.ik(arm.fk(q)), machine(arm)
        found = whole_set(m, arm.fk(q), library=None, rng=np.random.default_rng(1))
        compared = compare(m, arm.fk(q), sols.all_q, found)
        assert sols.self_motions or not compared.missing, f"{np.degrees(q)}: {compared.missing[:1]}"


@pytest.mark.parametrize("name", ["universal-robots-ur5e", "aubo-i5", "dobot-cr5"])
def test_a_linkage_stretched_to_its_end_has_its_rows(name):
    """Elbow and wrist in line: joint 6, free beside the plane, has one place left, and rounding blurs it."""
    arm, rng = free(name, placed=True), np.random.default_rng(2)
    quarter = np.pi / 2
    q = rng.uniform(-np.pi, np.pi, (300, 6))
    q[:, 2] = rng.choice([0.0, np.pi], 300)
    q[:, 3], q[:, 4] = rng.choice([0.0, quarter, -quarter, np.pi], 300), rng.choice([0.0, np.pi], 300)
    status = arm.ik_many(arm.fk(q), threads=1).status
    assert np.isin(status, [Status.SOLVED, Status.SINGULAR]).all(), np.unique(status)


@pytest.mark.parametrize("name", ["universal-robots-ur5e", "aubo-i5"])
def test_nothing_is_lost_where_elbow_and_wrist_are_all_but_straight_at_once(name):
    arm, rng, count = free(name, placed=True), np.random.default_rng(1), 40
    q = rng.uniform(-np.pi, np.pi, (count, 6))
    for joint in (2, 4):
        q[:, joint] = rng.choice([0.0, np.pi], count) * (joint == 4)
        q[:, joint] += rng.choice([-1, 1], count) * 10 ** rng.uniform(-13, -5, count)
    many = arm.ik_many(T := arm.fk(q), threads=1)
    told = 1e-6 + 1e-14 / np.maximum(np.linalg.svd(arm.jacobian(q), compute_uv=False)[:, -1], 1e-300)
    for i in np.flatnonzero(apart(arm, many.q, many.valid, q[:, None])[:, 0] > told):
        motions = arm.ik(T[i]).self_motions
        assert any(motion.contains(q[i], told[i]) for motion in motions), f"{q[i].tolist()}, {Status(many.status[i])}"
