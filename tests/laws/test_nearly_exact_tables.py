"""Tables off by a little more than rounding: at round singular postures the posture that made a pose is told."""

from __future__ import annotations

import numpy as np
import pytest

from oracle.arms.known import free
from oracle.joints import turns_apart
from pieper import DH, Arm, Status
from pieper.solver.singular import near_curve

#: What of the pose may be missed between two joint vectors that rounding does not tell apart (per length; rad).
ALONG, BESIDE = 1.2e-15, 3e-15
NAMES = ["universal-robots-ur5e", "denso-vp6242", "aubo-i5", "unimation-puma-560"]


def off_by(name: str, size: float, seed: int) -> Arm:
    """Return an arm of the catalogue with every length and twist off by up to so much (m; rad)."""
    given, rng = free(name).description, np.random.default_rng(seed)
    errors = size * rng.uniform(-1, 1, (6, 3))
    rows = [
        DH(a=row.a + e[0], alpha=row.alpha + e[1], d=row.d + e[2], theta=row.theta)
        for row, e in zip(given.rows, errors, strict=True)
    ]
    return Arm.from_dh(rows, convention=given.convention, limits=[(-np.pi, np.pi)] * 6)


def told(arm: Arm, q: np.ndarray) -> bool:
    """Whether q (6,) is a row of its pose, as well as the pose tells, or on a self-motion."""
    T = arm.fk(q)
    sols = arm.ik(T)
    if any(motion.contains(q, 1e-5) for motion in sols.self_motions):
        return True
    apart = turns_apart(sols.all_q, q).max(1)
    sigma = np.linalg.svd(arm.jacobian(q), compute_uv=False)[-1]
    if apart.min(initial=np.inf) < (1e-6 + 1e-14 / sigma if sigma > 3e-14 else 1e-6):
        return True
    near = sols.all_q[apart.argmin()]
    chord = near + np.linspace(0.1, 0.9, 9)[:, None] * arm.chain.joints.way(q, near)
    between = near_curve.onto(arm.chain, chord, T, 4)
    return bool(apart.min() < 0.3 and np.abs(between.miss).max() < ALONG and between.rest.max() < BESIDE)


@pytest.mark.parametrize("size", [1e-13, 3e-13])
@pytest.mark.parametrize("name", NAMES)
def test_the_posture_of_a_table_off_by_rounding_is_told(name, size):
    rng = np.random.default_rng(77)
    for seed in range(3):
        arm = off_by(name, size, seed)
        for _ in range(8):
            q = rng.choice(np.deg2rad(np.arange(-180, 181, 30)), 6)
            q[4] = rng.choice([0.0, np.pi])
            assert told(arm, q), f"{np.rad2deg(q).round().tolist()}, seed {seed}: {arm.ik(arm.fk(q)).status.name}"


@pytest.mark.parametrize("size", [1e-12, 1e-10, 1e-8, 1e-6])
@pytest.mark.parametrize("name", NAMES[:2])
def test_the_special_arm_vouches_for_one_that_is_off_by_little(name, size):
    """No elimination is far from singular beside a straight wrist: the closed form of the special arm counts there."""
    arm, rng, count = off_by(name, size, 0), np.random.default_rng(5), 25
    q = rng.uniform(-np.pi, np.pi, (count, 6))
    q[:, 4] = rng.choice([-1, 1], count) * 10 ** rng.uniform(-7, 0, count)
    many, sigma = arm.ik_many(arm.fk(q), threads=1), np.linalg.svd(arm.jacobian(q), compute_uv=False)[:, -1]
    gap = np.where(many.valid, arm.chain.joints.apart(many.q, q[:, None]), np.inf).min(1)
    assert (many.status == Status.SOLVED).all()
    assert (gap < 1e-6 + 1e-14 / sigma).all()


def test_an_arm_that_is_special_asks_no_other():
    assert free("denso-vp6242").plan.nearly is None
    other = off_by("denso-vp6242", 1e-9, 1).plan
    assert other.family == "general" and other.nearly is not None and other.nearly.family == "spherical_wrist"


def test_more_branches_than_six_joints_can_have_are_not_believed():
    """Where two curves cross on the arm that this one nearly is, roots are as flat as if eight branches merged."""
    H = np.pi / 2
    rows = [DH(0, H, 0.16), DH(-0.4), DH(-0.4, 4.563972617513937e-09), DH(0, H, 0.13), DH(0, -H, 0.1), DH(0, 0, 0.1)]
    arm = Arm.from_dh(rows, convention="standard")
    T = arm.fk([0, H, np.pi, -H, 0, 0])
    sols = arm.ik(T)
    assert sols.status == Status.UNCERTAIN or sols.multiplicity.sum() <= 16
    assert arm.ik_many(T[None]).status[0] == sols.status
