"""Round postures of round arms, the ones people type first: the posture that made a pose is among its answers."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi

import numpy as np
import pytest

import pieper
from pieper import DH, Arm, Status

H, K = pi / 2, pi / 4

#: Arms and postures whose poses were once OUT_OF_REACH "by 0 mm", or SOLVED without the posture.
LOST: dict[str, tuple[str, str, list[DH], list[float]]] = {
    "RRRR, a regular posture": (
        "standard",
        "RRRR",
        [DH(0.1, pi), DH(0.25, -H, 0.1, pi), DH(0, -H, 0.4), DH(0.1, 0, 0.2, H)],
        [0] * 4,
    ),
    "RRRR, another": (
        "standard",
        "RRRR",
        [DH(0.1, pi, 0.1, pi), DH(0.1, pi, 0.2), DH(0.3, -H), DH(0.25, pi, 0, pi)],
        [pi, -H, H, -H],
    ),
    "RRPRR": (
        "modified",
        "RRPRR",
        [DH(-0.2, K, 0.1), DH(0.25, -H, 0.2), DH(0.1, H), DH(0, H), DH(0, -H)],
        [0] * 5,
    ),
    "RRP, a slide at its fold": ("standard", "RRP", [DH(0.1, -H, 0, pi), DH(-0.2, H, -0.15), DH(0, -H)], [-H, -H, 0]),
    "RRRPRP, slides along one line": (
        "modified",
        "RRRPRP",
        [
            *(DH(0.1, -H, 0.2, pi), DH(0.25, 0, -0.15), DH(0.1, H, -0.15)),
            *(DH(0.25, K, 0.2), DH(0.3, -H, 0.4, pi), DH(0, H, 0.1)),
        ],
        [pi, -H, 0, -0.1, 0, -0.1],
    ),
    "PRRR": ("standard", "PRRR", [DH(0.3, -H), DH(0.3, H, 0.4), DH(0.25, H), DH(0, pi, 0.4, H)], [0] * 4),
    "PRRR, others": (
        "modified",
        "PRRR",
        [DH(0.1, -H, -0.15), DH(0.3, H, 0.4, H), DH(0.25, pi, 0, H), DH(-0.2, H, 0.4)],
        [0.1, -H, pi, pi],
    ),
    "RPPRR": (
        "modified",
        "RPPRR",
        [DH(0.1, pi, 0.4), DH(0.1, -H, 0.4), DH(0, -H, 0, H), DH(0.3, H, 0.4, H), DH(0, -H, 0.1, pi)],
        [H, -0.1, 0.2, -H, -H],
    ),
    "PRPRP": (
        "modified",
        "PRPRP",
        [DH(-0.2, 0, 0.2), DH(0.3, -H, -0.15), DH(0, 0, 0, pi), DH(0.25, K, 0, pi), DH(0, K, 0, H)],
        [0, pi, 0.1, 0, 0.2],
    ),
    "PRRRPR, beside a self-motion": (
        "modified",
        "PRRRPR",
        [
            *(DH(-0.2, pi), DH(0, K, 0.4), DH(0.3, H, -0.15, pi)),
            *(DH(0.1, pi, 0.1, H), DH(0, -H, 0, H), DH(-0.2, -H, 0.1)),
        ],
        [-0.1, H, H, H, 0.2, -H],
    ),
    "RRPRP, on a self-motion": (
        "standard",
        "RRPRP",
        [DH(0, K), DH(0.1, pi, 0.2, H), DH(0, 0, 0.2, H), DH(0, K, 0, pi), DH(0.25, 0, 0.1, H)],
        [0] * 5,
    ),
}

#: Twists of half a turn as they are typed: axes are parallel, or one line, but for the sine of pi.
TYPED: dict[str, tuple[str, str, list[DH]]] = {
    "RP": ("standard", "RP", [DH(0, pi, 0.4), DH(0.1, 0, 0.1)]),
    "PP": ("standard", "PP", [DH(0, pi, 0.4), DH(0.1, 0, 0.1)]),
    "PR": ("modified", "PR", [DH(0.1, K, 0.4), DH(0, pi, 0.1)]),
    "PR standard": ("standard", "PR", [DH(0, pi, 0.4), DH(0.1, 0, 0.1)]),
    "RR": ("standard", "RR", [DH(0, pi, 0.4), DH(0.1, 0, 0.1)]),
    "PRP": ("standard", "PRP", [DH(0, pi), DH(0, pi, -0.15, H), DH(0, -H, 0.1, H)]),
    "RRRP": ("modified", "RRRP", [DH(0, -H, 0.4, pi), DH(0, pi, 0.4, H), DH(0, pi), DH(0, -H)]),
    "RRRPR": ("modified", "RRRPR", [DH(0.25, pi, 0.2, H), *(DH(0, pi, d) for d in (0.4, 0.4, 0.2)), DH(0, 0, -0.15)]),
}


def is_told(arm: Arm, q: np.ndarray) -> bool:
    """Whether a posture is a row of its pose or on a self-motion, and `ik_many` has the rows of `ik`."""
    T = arm.fk(q)
    sols, many = arm.ik(T), arm.ik_many(T[None], threads=1)
    rows = many.q[0][many.valid[0]]
    assert many.status[0] == sols.status and len(rows) == len(sols.all_q)
    assert np.abs(rows - sols.all_q).max(initial=0.0) < 1e-9
    near = arm.chain.joints.apart(sols.all_q, q).min(initial=np.inf) < 5e-4
    return near or any(motion.contains(q, 1e-4) for motion in sols.self_motions)


@pytest.mark.parametrize("name", LOST)
def test_a_posture_that_was_once_lost_is_told(name):
    convention, types, rows, q = LOST[name]
    assert is_told(Arm.from_dh(rows, convention=convention, joint_types=types), np.array(q, float))


@pytest.mark.parametrize("name", TYPED)
def test_a_twist_of_pi_is_half_a_turn(name):
    convention, types, rows = TYPED[name]
    arm = Arm.from_dh(rows, convention=convention, joint_types=types)
    q = np.array([0.2, 0.3, 0.1, 0.25, -0.3][: arm.n])
    sols = arm.ik(T := arm.fk(q))
    assert sols.status in (Status.SOLVED, Status.REDUNDANT)
    assert np.abs(arm.fk(sols.q) - T).max() < 1e-12
    assert arm.plan.redundancy or len(sols) <= arm.plan.count.most


def drawn(rng: np.random.Generator) -> Arm:
    """Return an arm of three to five joints with round numbers."""
    n = int(rng.integers(3, 6))
    rows = [
        DH(
            float(rng.choice([0, 0, 0.1, 0.25, 0.3, -0.2])),
            float(rng.choice([0, H, -H, pi, K])),
            float(rng.choice([0, 0, 0.1, 0.2, 0.4, -0.15])),
            float(rng.choice([0, 0, H, pi])),
        )
        for _ in range(n)
    ]
    types = "".join(rng.choice(list("RRRP"), n))
    return Arm.from_dh(rows, convention=str(rng.choice(["standard", "modified"])), joint_types=types)


def drawn_without_spare(rng: np.random.Generator, count: int) -> Iterator[Arm]:
    """Yield so many drawn arms that have a plan and no joint to spare."""
    while count:
        arm = drawn(rng)
        try:
            spare = arm.plan.redundancy
        except pieper.PlanError:
            continue
        if not spare:
            count -= 1
            yield arm


def test_drawn_round_arms_tell_all_but_one_in_fifty_of_their_round_postures():
    rng, lost = np.random.default_rng(3), []
    for arm in drawn_without_spare(rng, 25):
        for k in range(4):
            q = np.where(arm.chain.prismatic, rng.choice([0, 0.1, -0.1, 0.2], arm.n), H * rng.integers(-2, 3, arm.n))
            q = q if k else np.zeros(arm.n)
            if not is_told(arm, q) and arm.ik(arm.fk(q)).status != Status.UNCERTAIN:
                lost.append((arm.description.rows, arm.joint_types, arm.description.convention, q.tolist()))
    assert len(lost) <= 2, lost


def test_no_pose_that_a_round_arm_takes_is_out_of_reach():
    rng = np.random.default_rng(11)
    for arm in drawn_without_spare(rng, 20):
        slide = rng.choice([0, 0.1, -0.1, 0.2], (24, arm.n))
        q = np.where(arm.chain.prismatic, slide, K * rng.integers(-4, 5, (24, arm.n)))
        q[12:] += 10.0 ** rng.uniform(-12, -2, (12, 1)) * rng.standard_normal((12, arm.n))
        status = arm.ik_many(arm.fk(q), threads=1).status
        assert not np.any(status == Status.OUT_OF_REACH), (arm.description.rows, q[status == Status.OUT_OF_REACH])


def test_poses_that_a_short_arm_cannot_take_are_not_looked_at_with_care(monkeypatch):
    """Filled up, it takes nearly all of them with virtual joints far from zero, and so it does poses beside."""
    from pieper.solver.singular import careful

    looked: list[np.ndarray] = []
    every = careful.every_solution
    monkeypatch.setattr(careful, "every_solution", lambda plan, T, rows: looked.append(T) or every(plan, T, rows))
    arm = Arm.from_dh([DH(0, H, 0.3), DH(0.3), DH(0.3), DH(0.1, H)], convention="standard")
    rng = np.random.default_rng(0)
    poses = np.stack([pieper.pose(*x[:3], rpy=x[3:]) for x in rng.uniform(-0.6, 0.6, (200, 6))])
    assert np.all(arm.ik_many(poses, threads=1).status == Status.OUT_OF_REACH)
    assert all(arm.ik(T).status == Status.OUT_OF_REACH for T in poses[:20])
    assert not looked


@pytest.mark.parametrize("name", ["dfrobot-rob0036"])
def test_a_hair_beside_a_round_posture_no_row_of_a_short_arm_is_lost(name):
    """The virtual joint is nearly free there: rounding moves it by more than what counts as zero."""
    arm, rng = pieper.load(name), np.random.default_rng(0)
    for size in (5.9e-10, 1e-8, 1e-7, 1e-6):
        q = rng.uniform(-1.5, 1.5, (150, 5))
        q[:, 4] = rng.choice([0, H, np.pi], 150) + size * rng.choice([-1, 1], 150)
        many = arm.ik_many(arm.fk(q), threads=1)
        away = [
            arm.chain.joints.apart(rows[ok], p).min(initial=9)
            for rows, ok, p in zip(many.q, many.valid, q, strict=True)
        ]
        assert max(away) < 1e-6


def test_a_pose_rounded_to_nine_digits_is_not_looked_at_with_care_where_the_posture_is_regular(monkeypatch):
    """Its own row misses it by the rounding, and nothing merges so near: there is no other to look for."""
    from pieper.solver.singular import careful

    looked: list[np.ndarray] = []
    every = careful.every_solution
    monkeypatch.setattr(careful, "every_solution", lambda plan, T, rows: looked.append(T) or every(plan, T, rows))
    arm, rng = pieper.load("dfrobot-rob0036"), np.random.default_rng(0)
    q = rng.uniform(-1.5, 1.5, (400, 5))
    s = np.linalg.svd(arm.jacobian(q), compute_uv=False)
    q = q[s[:, -1] > 0.02 * s[:, 0]]
    status = arm.ik_many(np.round(arm.fk(q), 9), threads=1).status
    assert np.isin(status, [Status.SOLVED, Status.OUT_OF_REACH]).all() and np.any(status == Status.OUT_OF_REACH)
    assert len(looked) <= len(q) // 50
