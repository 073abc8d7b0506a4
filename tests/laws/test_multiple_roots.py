"""Roots of multiplicity two to five: the multiplicity that is told is the true one, and the row is where the root is.

The oracle turns joints in fifty digits: with one of them moved by d and the others best placed, a root of multiplicity
m misses its pose by about d^m.
"""

from __future__ import annotations

from math import log2, pi

import mpmath
import numpy as np
import pytest

import pieper
from pieper import DH, Arm, Status
from pieper.kinematics.newton import null_space, singular_values

H, K = pi / 2, pi / 4

#: Arms, postures at which branches meet, how many.
MEET: dict[str, tuple[str, str, list[DH], list[float], int]] = {
    "RRRRRR, four": (
        *("standard", "RRRRRR"),
        [DH(-0.2, H, 0.1), DH(0.3, H, 0.1), DH(0.25), DH(-0.2, -H), DH(-0.2, pi, 0, pi), DH(0.25, 0, 0, H)],
        *([H, -H, H, -H, pi, -H], 4),
    ),
    "RRRRRR, five": (
        *("standard", "RRRRRR"),
        [DH(-0.2, H, 0.1), DH(0.3, H, 0.1), DH(0.25), DH(-0.2, -H), DH(-0.2, pi, 0, pi), DH(0.25, 0, 0, H)],
        *([pi, 0, -H, H, pi, H], 5),
    ),
    "RRRRRR, four beside two double ones": (
        *("standard", "RRRRRR"),
        [
            *(DH(0.1, pi, 0, H), DH(-0.2, H, 0, pi), DH(0, -H, -0.15, H)),
            *(DH(-0.2, -H), DH(-0.2, 0, -0.15, H), DH(0, H, 0.4, pi)),
        ],
        *([pi, H, H, pi, 0, H], 4),
    ),
    "RRRRRR, three": (
        *("standard", "RRRRRR"),
        [
            *(DH(0, -H, 0.2, pi), DH(-0.2), DH(0.25, -H, -0.15)),
            *(DH(0.1, 0, -0.15, pi), DH(0, H, -0.15, pi), DH(0.1, K, 0, pi)),
        ],
        *([pi, H, H, pi, pi, 0], 3),
    ),
    "RRRPRR, four": (
        *("standard", "RRRPRR"),
        [DH(0, H, 0.2), DH(-0.2, pi, 0.1), DH(0.1, pi, 0.4), DH(0, pi), DH(-0.2, K, -0.15), DH(0.1, H, 0.1)],
        *([0] * 6, 4),
    ),
}


def arm_of(name: str) -> tuple[Arm, np.ndarray, int]:
    convention, types, rows, q, branches = MEET[name]
    return Arm.from_dh(rows, convention=convention, joint_types=types), np.array(q, float), branches


def order_of(arm: Arm, q: np.ndarray) -> int:
    """Return the multiplicity of the root at q, a posture of multiples of a quarter turn, in fifty digits."""
    mpmath.mp.dps = 50
    chain, n = arm.chain, arm.n

    def exact(x: float) -> mpmath.mpf:
        quarters = round(x / H)
        return quarters * mpmath.pi / 2 if abs(x - quarters * H) < 1e-12 else mpmath.mpf(x)

    def link(row: DH) -> mpmath.matrix:
        ca, sa = mpmath.cos(exact(row.alpha)), mpmath.sin(exact(row.alpha))
        return mpmath.matrix([[1, 0, 0, row.a], [0, ca, -sa, 0], [0, sa, ca, 0], [0, 0, 0, 1]])

    def turned(angle: mpmath.mpf, way: mpmath.mpf) -> mpmath.matrix:
        c, s = mpmath.cos(angle), mpmath.sin(angle)
        return mpmath.matrix([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, way], [0, 0, 0, 1]])

    rows, sign = arm.description.rows, [1] * n

    def end(x: list[mpmath.mpf]) -> mpmath.matrix:
        T = mpmath.eye(4)
        for i, row in enumerate(rows):
            slide = arm.joint_types[i] == "P"
            angle, way = exact(row.theta), mpmath.mpf(row.d)
            motion = turned(angle + (0 if slide else sign[i] * x[i]), way + (x[i] if slide else 0))
            T = T * motion * link(row) if arm.description.convention == "standard" else T * link(row) * motion
        return T

    start = [exact(v) for v in q]
    goal = end(start)

    def error(x: list[mpmath.mpf]) -> mpmath.matrix:
        now = end(x)
        R = goal[:3, :3] * now[:3, :3].T
        turn = [(R[2, 1] - R[1, 2]) / 2, (R[0, 2] - R[2, 0]) / 2, (R[1, 0] - R[0, 1]) / 2]
        return mpmath.matrix([*(goal[i, 3] - now[i, 3] for i in range(3)), *turn])

    free = null_space(chain, q)[1][n - 1]
    lead = int(np.argmax(np.abs(free)))
    others = [i for i in range(n) if i != lead]

    def least(d: mpmath.mpf) -> mpmath.mpf:
        x = list(start)
        x[lead] += d
        for _ in range(8):
            e, step = error(x), mpmath.mpf(10) ** -25
            J = mpmath.matrix(6, n - 1)
            for column, i in enumerate(others):
                moved = list(x)
                moved[i] += step
                J[:, column] = (e - error(moved)) / step
            move = mpmath.lu_solve(J.T * J, J.T * e)
            for column, i in enumerate(others):
                x[i] += move[column]
            if mpmath.norm(move) < mpmath.mpf(10) ** -30:
                break
        return mpmath.norm(error(x))

    d = mpmath.mpf(1) / 1024
    return round(log2(least(d) / least(d / 2)))


def apart(arm: Arm, rows: np.ndarray, q: np.ndarray) -> np.ndarray:
    return arm.chain.joints.apart(rows, q)


@pytest.mark.parametrize("name", MEET)
def test_the_multiplicity_told_is_the_true_one_and_the_row_is_the_root(name):
    arm, q, branches = arm_of(name)
    assert order_of(arm, q) == branches
    sols, many = arm.ik(T := arm.fk(q)), arm.ik_many(arm.fk(q)[None], threads=1)
    away = apart(arm, sols.all_q, q)
    assert away.min() < 1e-11 and sols.multiplicity[away.argmin()] == branches
    assert np.count_nonzero(away < 1e-2) == 1 and np.abs(sols.direction[away.argmin()]).max() > 0
    assert arm.n < 6 or sols.multiplicity.sum() % 2 == (1 if branches == 1 else 0)
    assert np.abs(many.q[0][many.valid[0]] - sols.all_q).max() < 1e-12
    assert np.abs(arm.fk(sols.all_q) - T).max() < 1e-13
    assert f"1 of them of {branches} branches" in sols.why


@pytest.mark.parametrize("room", [1e-3, 1e-6, 1e-10])
@pytest.mark.parametrize("name", MEET)
def test_limits_about_a_root_hold_it_however_close(name, room):
    arm, q, _ = arm_of(name)
    sols = arm.with_limits({n: (v - room, v + room) for n, v in zip(arm.joint_names, q, strict=True)}).ik(arm.fk(q))
    assert sols.status == Status.SOLVED and apart(arm, sols.q, q).min() < 1e-11


@pytest.mark.parametrize("room", [1e-8, 4e-10])
def test_a_double_root_with_the_turn_that_a_task_leaves_open_is_inside_limits_about_it(room):
    rows = [DH(0.25, K, 0, H), DH(-0.2, -H, 0.2), DH(0.3, H, 0.2), DH(0, -H), DH(0, K, 0.1)]
    arm = Arm.from_dh(rows, convention="standard", joint_types="PRRRP")
    sols = arm.with_limits({n: (-room, room) for n in arm.joint_names}).ik(arm.fk(np.zeros(5)))
    assert sols.status == Status.SOLVED and np.abs(sols.q).max() < 1e-12 and sols.multiplicity.max() == 2


@pytest.mark.parametrize("room", [1e-4, 1e-6, 1e-10])
def test_the_zero_posture_of_an_arm_of_the_catalogue_is_inside_limits_about_it(room):
    arm = pieper.load("motoman-ea1400n")
    near = arm.with_limits({n: (-room, room) for n in arm.joint_names})
    sols = near.ik(arm.fk(np.zeros(6)))
    assert sols.status == Status.SOLVED and np.abs(sols.q).max() < 1e-12 and sols.multiplicity.max() == 3
    assert near.ik_many(arm.fk(np.zeros(6))[None], threads=1).status[0] == Status.SOLVED


def drawn(rng: np.random.Generator) -> Arm:
    """Return an arm of six joints with round numbers, one of which may slide."""
    rows = [
        DH(
            float(rng.choice([0, 0.1, 0.25, 0.3, -0.2])),
            float(rng.choice([0, H, -H, pi, H])),
            float(rng.choice([0, 0.1, 0.2, 0.4, -0.15])),
        )
        for _ in range(6)
    ]
    return Arm.from_dh(rows, convention="standard", joint_types=str(rng.choice(["RRRRRR", "RRRRRR", "RRPRRR"])))


def test_drawn_arms_tell_the_multiplicity_of_their_round_postures():
    rng, orders = np.random.default_rng(5), []
    while len(orders) < 8:
        arm = drawn(rng)
        try:
            if not arm.plan.family or arm.plan.redundancy:
                continue
        except pieper.PlanError:
            continue
        q = np.where(arm.chain.prismatic, 0.1, H * rng.integers(-1, 3, (40, 6)))
        s = singular_values(arm.chain, q)
        for posture in q[(s[:, 5] < 1e-13) & (s[:, 4] > 1e-2)][:2]:
            sols = arm.ik(arm.fk(posture))
            if sols.self_motions or sols.status != Status.SOLVED:
                continue
            away = apart(arm, sols.all_q, posture)
            order = order_of(arm, posture)
            orders.append(order)
            assert away.min() < 1e-9, (arm.description.rows, posture.tolist(), away.min())
            assert sols.multiplicity[away.argmin()] == order, (
                arm.description.rows,
                posture.tolist(),
                sols.multiplicity,
            )
    assert max(orders) > 2
