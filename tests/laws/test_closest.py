"""The posture that comes nearest: inside the limits, never beaten by a slow search from many starts."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import least_squares

import pieper
from oracle.arms.known import free
from pieper import DH, Arm
from pieper.kinematics.pose import pose_error

PLANAR = Arm.from_dh([DH(a=0.3), DH(a=0.2)], convention="standard", limits=[(-2, 2), (-1, 1)])
YAW_PITCH = Arm.from_dh(
    [DH(alpha=np.pi / 2, d=0.1), DH(a=0.3), DH(a=0.25)], convention="standard", limits=[(-1, 1), (-1, 2), (-2, 2)]
)
ARMS = [
    pieper.load("denso-vp6242"),
    pieper.load("universal-robots-ur5e"),
    pieper.load("stanford-arm"),
    PLANAR,
    YAW_PITCH,
]


def slow(arm: Arm, T: np.ndarray, rng: np.random.Generator) -> tuple[float, float]:
    """Return metres and radians of the best of many least-squares searches, position weighted up in stages."""
    turning = arm.plan.task != "position"
    reach = np.where(arm.plan.prismatic, arm.chain.length, np.pi)
    lower = np.where(np.isfinite(arm.limits[:, 0]), arm.limits[:, 0], -reach) - 1e-12
    upper = np.where(np.isfinite(arm.limits[:, 1]), arm.limits[:, 1], reach) + 1e-12

    def left(q, weight):
        F = arm.fk(q)
        error = pose_error(F, T)
        R = T[:3, :3] @ F[:3, :3].T
        axis = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
        turn = error[1] * axis / max(np.linalg.norm(axis), 1e-12)
        return np.concatenate([(F[:3, 3] - T[:3, 3]) / arm.chain.length, turning * weight * turn])

    found = []
    for _ in range(8):
        q = rng.uniform(lower, upper)
        for weight in (1.0, 3e-2, 1e-3):
            q = least_squares(left, q, bounds=(lower, upper), args=(weight,), max_nfev=60).x
        found.append(pose_error(arm.fk(q), T))
    metres, radians = np.array(found).T
    best = np.lexsort((radians, np.round(metres / arm.chain.length / 1e-6)))[0]
    return metres[best], radians[best] * turning


@pytest.mark.parametrize("arm", ARMS, ids=lambda arm: f"{arm.name}-{arm.n}")
def test_no_slow_search_finds_a_posture_that_is_nearer(arm):
    rng = np.random.default_rng(11)
    for _ in range(6):
        T = arm.fk(rng.uniform(-3, 3, arm.n))
        T[:3, 3] = T[:3, 3] * rng.uniform(0.1, 2.5) + rng.normal(size=3) * 0.05
        sols = arm.ik(T)
        if len(sols):
            continue
        near = sols.closest
        assert near is sols.closest
        assert (near.q >= arm.limits[:, 0] - 1e-9).all() and (near.q <= arm.limits[:, 1] + 1e-9).all()
        assert np.allclose(near.T, arm.fk(near.q))
        miss = arm.plan.residual(near.q, T)
        assert (near.metres, near.radians) == pytest.approx(tuple(miss))
        metres, radians = slow(arm, T, rng)
        alike = 3e-6 * arm.chain.length
        assert near.metres <= metres + alike
        assert near.metres < metres - alike or near.radians <= radians + 2e-3


def test_a_pose_straight_ahead_is_missed_by_what_the_arm_is_too_short():
    arm = free("denso-vp6242")
    far = arm.fk(np.array([0.3, 0.7, -0.4, 0.5, 0.6, -0.2]))
    far[:3, 3] *= 4.0
    sols = arm.ik(far)
    assert sols.status.name == "OUT_OF_REACH"
    assert f"{sols.closest.metres * 1e3:.4g} mm" in sols.why


def test_where_there_is_a_solution_it_is_the_closest():
    arm = pieper.load("denso-vp6242")
    sols = arm.ik(arm.fk(arm.limits.mean(1) + 0.1))
    assert np.array_equal(sols.closest.q, sols.q[0]) and sols.closest.metres < 1e-12


def test_weights_trade_metres_for_radians():
    arm = PLANAR
    T = arm.fk(np.array([0.3, 0.5]))
    T[:3, 3] += [0.4, 0.1, 0.0]
    lazy, exact = arm.closest(T, task="pose", weights=(1.0, 10.0)), arm.closest(T, task="pose", weights=(10.0, 1e-4))
    assert lazy.radians < exact.radians and lazy.metres > exact.metres


@pytest.mark.parametrize("weights", [(1.0,), (0.0, 0.0), (-1.0, 1.0), (np.nan, 1.0), "near"])
def test_weights_that_say_nothing_are_refused(weights):
    with pytest.raises(pieper.InputError, match="weights"):
        PLANAR.closest(PLANAR.fk([0.1, 0.2]), weights=weights)


#: Arms with limits and poses whose position was missed by a tenth of a metre though it can be met.
MET = {
    "RPRRR": (
        "modified",
        [DH(0, 1.57, -0.15), DH(0.25, 3.14, 0, 1.57), DH(0.25, 1.57, 0.1), DH(0, 0, -0.15), DH(0.25, -1.57, 0.4, 3.14)],
        [(-0.27, 1.81), (-0.52, 0.25), (-0.22, 1.64), (-2.15, -0.62), (-1.97, 0.99)],
        (0.42, 0.15, -0.4),
        (-0.38, 2.67, -0.16),
    ),
    "RRRPRR": (
        "standard",
        [
            *(DH(0, -1.57, -0.15), DH(0.25, 3.14), DH(0, 1.57, 0.1)),
            *(DH(0, -1.57, 0.4, 1.57), DH(0.3, -1.57, -0.15), DH(-0.2, -1.57, -0.15, 1.57)),
        ],
        [(-1.21, 0.51), (-3.21, -0.53), (-0.05, 2.98), (-0.3, 0.18), (-3.58, 0.36), (-1.37, 1.6)],
        (-0.14, -0.9, 0.69),
        (-0.59, 1.38, 2.29),
    ),
}


@pytest.mark.parametrize("types", MET)
def test_a_position_that_can_be_met_is_met_whatever_the_tool_s_turn_costs(types):
    convention, rows, limits, place, turn = MET[types]
    arm = Arm.from_dh(rows, convention=convention, joint_types=types, limits=limits)
    assert arm.closest(pieper.pose(*place, rotvec=turn)).metres < 2e-6
