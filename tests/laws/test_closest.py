"""The posture that comes nearest: inside the limits, never beaten by a slow search from many starts."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
from scipy.optimize import least_squares, minimize
from scipy.spatial.transform import Rotation

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


@pytest.mark.parametrize("weights", [(1.0, 1.0), (1.0, 0.3), (1.0, 0.1), (1.0, 0.01), (0.0, 1.0)])
@pytest.mark.parametrize("name", ["denso-vp6242", "ur5e"])
def test_weights_are_of_metres_and_of_radians(name, weights):
    """Nothing near the answer, and no minimum of a search of another kind, has less of what the words say is least."""
    arm = pieper.load(name)
    middle, half = arm.limits.mean(1), np.ptp(arm.limits, axis=1) / 2
    T = arm.fk(middle + 0.3 * half)
    T[:3, 3] = 3.0, 0.2, 0.1
    near = arm.closest(T, weights=weights)

    def missed(q):
        now = arm.fk(q)
        turn = Rotation.from_matrix(T[:3, :3].T @ now[:3, :3]).as_rotvec()
        return np.append(weights[0] * (now[:3, 3] - T[:3, 3]), weights[1] * turn)

    low, high = arm.limits.T
    own = float(np.sum(missed(near.q) ** 2))
    assert own == pytest.approx((weights[0] * near.metres) ** 2 + (weights[1] * near.radians) ** 2, abs=1e-12)
    rng = np.random.default_rng(1)
    for start in [near.q, *rng.uniform(low, high, (4, arm.n))]:
        start = np.clip(start, low + 1e-9, high - 1e-9)
        found = least_squares(missed, start, bounds=(low, high), xtol=1e-14, ftol=1e-14, gtol=1e-14, max_nfev=150)
        assert 2 * found.cost > own - 1e-8 * max(own, 1.0)


@pytest.mark.parametrize("weights", [(1.0, 1.0), (1.0, 0.2), (0.1, 1.0)])
@pytest.mark.parametrize("name", ["so-101", "ufactory-xarm5", "universal-robots-ur5e"])
def test_weights_of_a_task_that_leaves_the_roll_free(name, weights):
    """The chain that is moved then has a joint more, and another length, than the arm: a radian counts as much."""
    arm = pieper.load(name)
    T = arm.fk(np.full(arm.n, 0.3))
    T[:3, 3] += 0.3
    near = arm.closest(T, task="position+axis", weights=weights)

    def cost(q):
        now = arm.fk(q)
        turn = np.arctan2(np.linalg.norm(np.cross(now[:3, 2], T[:3, 2])), now[:3, 2] @ T[:3, 2])
        return np.sum((weights[0] * (now[:3, 3] - T[:3, 3])) ** 2) + (weights[1] * turn) ** 2

    own = cost(near.q)
    assert own == pytest.approx((weights[0] * near.metres) ** 2 + (weights[1] * near.radians) ** 2, abs=1e-12)
    low, high = arm.limits.T
    rng = np.random.default_rng(1)
    for start in [near.q, *rng.uniform(low, high, (3, arm.n))]:
        found = minimize(cost, np.clip(start, low, high), bounds=list(zip(low, high, strict=True)), tol=1e-12)
        assert found.fun > own - 1e-7 * max(own, 1.0)


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


# ---------------------------------------------------------------------------------------------- position first

#: Of three hundred, which held as well.
ARMS_TRIED = 60


def limited(rng: np.random.Generator) -> Arm:
    """Return an arm of three to seven joints of round lengths, a fifth of them slides, each with limits."""
    n = int(rng.integers(3, 8))
    turns, lengths = [0, pi / 2, -pi / 2, pi, 1.57, 3.14, 0.7, -1.1], [0, 0, 0.1, 0.25, -0.2, 0.3, -0.15, 0.4]
    rows = [
        DH(*(float(rng.choice(some)) for some in (lengths, turns, lengths, [0, pi / 2, 1.57, pi, 3.14])))
        for _ in range(n)
    ]
    kinds = "".join(rng.choice(list("RRRRP"), n))
    half = np.array([rng.uniform(0.1, 0.5) if kind == "P" else rng.uniform(0.4, 2.2) for kind in kinds])
    middle = np.array([rng.uniform(-0.2, 0.2) if kind == "P" else rng.uniform(-1.5, 1.5) for kind in kinds])
    return Arm.from_dh(
        rows,
        convention=str(rng.choice(["standard", "modified"])),
        joint_types=kinds,
        limits=np.round(np.stack([middle - half, middle + half], 1), 2).tolist(),
    )


def aimed(arm: Arm, rng: np.random.Generator) -> np.ndarray:
    """Return a pose that the arm reaches without limits, or whose place it does, or one some way off."""
    kind = rng.integers(3)
    T = arm.fk(rng.uniform(-3, 3, arm.n) * np.where(arm.plan.prismatic, 0.2, 1.0))
    if kind == 1:
        T[:3, 3] *= rng.uniform(0.2, 1.6)
    elif kind == 2:
        T[:3, 3] = arm.fk(rng.uniform(*arm.limits.T))[:3, 3]
    if kind != 1:
        T[:3, :3] = pieper.pose(rotvec=rng.uniform(-2, 2, 3))[:3, :3]
    return T


def own_place(arm: Arm, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return places (k, 3) and their slopes (k, 3, n), by products of this file's own from the DH table."""
    F, axes, points = np.tile(np.eye(4), (len(q), 1, 1)), [], []
    slides = [kind == "P" for kind in arm.joint_types]
    for j, row in enumerate(arm.description.rows):
        c, s = np.cos(row.alpha), np.sin(row.alpha)
        X = np.array([[1, 0, 0, row.a], [0, c, -s, 0], [0, s, c, 0], [0, 0, 0, 1]])
        turn = row.theta + (0.0 if slides[j] else q[:, j])
        Z = np.tile(np.eye(4), (len(q), 1, 1))
        Z[:, 0, 0] = Z[:, 1, 1] = np.cos(turn)
        Z[:, 1, 0] = np.sin(turn)
        Z[:, 0, 1], Z[:, 2, 3] = -Z[:, 1, 0], row.d + (q[:, j] if slides[j] else 0.0)
        before = F @ X if arm.description.convention == "modified" else F
        axes.append(before[:, :3, 2])
        points.append(before[:, :3, 3])
        F = before @ Z if arm.description.convention == "modified" else before @ Z @ X
    place = F[:, :3, 3]
    columns = [z if p else np.cross(z, place - o) for z, o, p in zip(axes, points, slides, strict=True)]
    return place, np.stack(columns, -1)


def by_gauss_and_newton(arm: Arm, goal: np.ndarray, rng: np.random.Generator) -> float:
    """Return the least distance that damped Gauss-Newton steps inside the limits find from sixty postures."""
    low, high = arm.limits.T
    q, damping = rng.uniform(low, high, (60, arm.n)), np.full(60, 1e-3)
    place, J = own_place(arm, q)
    left = np.linalg.norm(goal - place, axis=1)
    for _ in range(60):
        e = goal - place
        pull = np.einsum("kij,ki->kj", J, e)
        held = ((q <= low) & (pull < 0)) | ((q >= high) & (pull > 0))
        free = np.where(held[:, None], 0.0, J)
        A = np.einsum("kij,kil->kjl", free, free) + (damping[:, None, None] + 1e-14) * np.eye(arm.n)
        step = np.linalg.solve(A, np.where(held, 0.0, pull)[..., None])[..., 0]
        there = np.clip(q + step, low, high)
        new, slope = own_place(arm, there)
        size = np.linalg.norm(goal - new, axis=1)
        better = size < left
        q[better], place[better], J[better], left[better] = there[better], new[better], slope[better], size[better]
        damping = np.clip(np.where(better, damping * 0.2, damping * 6), 1e-13, 1e6)
    return float(left.min())


def test_no_search_for_the_position_alone_comes_nearer():
    for seed in range(ARMS_TRIED):
        rng = np.random.default_rng(seed)
        arm = limited(rng)
        T = aimed(arm, rng)
        near = arm.closest(T)
        assert ((near.q >= arm.limits[:, 0]) & (near.q <= arm.limits[:, 1])).all()
        reach = sum(abs(row.a) + abs(row.d) for row in arm.description.rows)
        best = by_gauss_and_newton(arm, T[:3, 3], rng)
        assert near.metres <= best + 1e-6 * reach, f"{seed}: {near.metres} where {best} was found"
        if best < 1e-13:
            assert near.metres < 1e-11 * max(reach, 0.1), seed


@pytest.mark.parametrize("status", ["OUT_OF_REACH", "OUTSIDE_LIMITS"])
def test_a_place_that_can_be_met_is_met_whatever_the_orientation_would_have(status: str):
    if status == "OUT_OF_REACH":
        arm = Arm.from_dh(
            [
                DH(0, 1.57, -0.15, 0),
                DH(0.25, 3.14, 0, 1.57),
                DH(0.25, 1.57, 0.1),
                DH(0, 0, -0.15),
                DH(0.25, -1.57, 0.4, 3.14),
            ],
            convention="modified",
            joint_types="RPRRR",
            limits=[(-0.27, 1.81), (-0.52, 0.25), (-0.22, 1.64), (-2.15, -0.62), (-1.97, 0.99)],
        )
        T = pieper.pose(0.42, 0.15, -0.4, rotvec=(-0.38, 2.67, -0.16))
    else:
        arm = Arm.from_dh(
            [
                DH(0, -1.57, -0.15),
                DH(0.25, 3.14),
                DH(0, 1.57, 0.1),
                DH(0, -1.57, 0.4, 1.57),
                DH(0.3, -1.57, -0.15),
                DH(-0.2, -1.57, -0.15, 1.57),
            ],
            convention="standard",
            joint_types="RRRPRR",
            limits=[(-1.21, 0.51), (-3.21, -0.53), (-0.05, 2.98), (-0.3, 0.18), (-3.58, 0.36), (-1.37, 1.6)],
        )
        T = pieper.pose(-0.14, -0.9, 0.69, rotvec=(-0.59, 1.38, 2.29))
    sols = arm.ik(T)
    assert sols.status.name == status
    assert sols.closest.metres < 1e-14
    assert ("the arm gets there, but not turned this way" in sols.why) == (status == "OUT_OF_REACH")


@pytest.mark.parametrize("seed", range(4))
def test_orientation_is_as_good_as_the_best_place_allows(seed: int):
    rng = np.random.default_rng(seed)
    arm = pieper.load("denso-vp6242")
    middle, half = arm.limits.mean(1), np.diff(arm.limits)[:, 0] / 2
    narrow = arm.with_limits({n: (m - h / 3, m + h / 3) for n, m, h in zip(arm.joint_names, middle, half, strict=True)})
    T = narrow.fk(rng.uniform(*narrow.limits.T))
    T[:3, :3] = pieper.pose(rotvec=rng.uniform(-2, 2, 3))[:3, :3]
    near = narrow.closest(T)

    def turned(q):
        return (3 - np.trace(narrow.fk(q)[:3, :3].T @ T[:3, :3])) / 2

    least = np.inf
    for start in [near.q, *rng.uniform(*narrow.limits.T, (6, 6))]:
        place = {"type": "eq", "fun": lambda q: (narrow.fk(q)[:3, 3] - T[:3, 3]) * 100}
        found = minimize(turned, start, method="SLSQP", bounds=narrow.limits, constraints=place)
        if np.linalg.norm(narrow.fk(found.x)[:3, 3] - T[:3, 3]) < 1e-8:
            least = min(least, float(np.arccos(1 - found.fun)))
    assert near.metres < 1e-14 and near.radians < least + 1e-4


@pytest.mark.parametrize("name", ["kuka-kr120-r3200-pa", "dobot-magician"])
@pytest.mark.parametrize("turn", [1e-9, 1e-7, 1e-6, 1e-2])
def test_where_only_the_turn_is_missed_the_turn_is_told(name: str, turn: float):
    arm = pieper.load(name)
    sols = arm.ik(arm.fk(arm.limits.mean(1)) @ pieper.pose(0, 0, 0, rpy=(turn, 0, 0)))
    assert sols.status.name == "OUT_OF_REACH" and sols.closest.radians == pytest.approx(turn, rel=1e-3)
    assert f"not turned this way; at best {np.degrees(turn):.3g} deg are missing" in sols.why


@pytest.mark.parametrize("name", ["epson-g6-651s", "adept-cobra-600"])
def test_a_pose_missed_by_a_turn_alone_is_no_further_turned_where_the_elbow_is_straight(name):
    arm, rng = pieper.load(name), np.random.default_rng(1)
    for _ in range(12):
        q = rng.uniform(-0.5, 0.5, arm.n)
        q[1], q[2] = 10 ** rng.uniform(-8, -6), arm.limits[2].mean()
        T = arm.fk(q)
        x, y = 1e-8 * rng.uniform(0.5, 1, 2)  # two joints turn about upright axes: no posture leans so
        T[:3, :3] = np.array([[1, 0, y], [0, 1, -x], [-y, x, 1]]) @ T[:3, :3]
        near = arm.ik(T).closest
        assert near.metres < 1e-11 and near.radians < 1.2 * np.hypot(x, y)
