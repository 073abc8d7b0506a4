"""A posture whose joints stand on their limits, however many, is inside: alike in one pose and in many."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle.arms.known import free
from oracle.arms.strata import three_parallel, wrist_at
from oracle.joints import on_singular
from pieper import Arm, Status

ARMS = {
    "denso": lambda: free("denso-vp6242"),
    "puma": lambda: free("unimation-puma-560"),
    "stanford": lambda: free("stanford-arm"),
    "wrist inside, PRP": lambda: wrist_at(1, "PRRRPR", 5),
    "wrist at the base": lambda: wrist_at(0, "RRRRRR", 5),
    "three parallel": lambda: free("universal-robots-ur5e"),
    "three parallel, aubo": lambda: free("aubo-i5"),
    "three parallel, skew": lambda: three_parallel(3),
}
ROUND = np.deg2rad([0, 0, 180, 90, -90, 30, -120])
#: Where a double root is known to the root of rounding (rad), and sigma_min below which a pose has one.
BLUR, SINGULAR = 3e-3, 1e-7


def posture(arm: Arm, rng: np.random.Generator, kind: str) -> np.ndarray:
    """Return a joint vector (6,): on a singularity of any kind, wrist in line, two joints round, or all of them."""
    slides = arm.chain.prismatic
    q = np.where(slides, rng.uniform(-0.5, 0.5, 6) * arm.chain.length, rng.uniform(-3, 3, 6))
    if kind == "singular":
        return next(on_singular(rng, arm.chain, 99))
    if kind == "wrist":
        q[4] = rng.choice([0.0, np.pi])
        return q
    which = rng.choice(6, 2, replace=False) if kind == "two" else np.arange(6)
    q[which] = np.where(slides, q, rng.choice(ROUND, 6))[which]
    return q


def limited(arm: Arm, q: np.ndarray, rng: np.random.Generator, how: str) -> Arm:
    """Return the arm with limits about q (6,): one to six joints stand at one, of no width, or a turn and more wide."""
    lower, upper = q - rng.uniform(0.05, 1.5, 6), q + rng.uniform(0.05, 1.5, 6)
    for j in rng.choice(6, rng.integers(1, 7), replace=False):
        what = rng.choice(["stop", "turns", "point"]) if how == "mixed" else how
        at_lower = rng.random() < 0.5
        if what == "point":
            lower[j] = upper[j] = q[j]
        elif what == "turns" and not arm.chain.prismatic[j]:
            wide = rng.choice([2 * np.pi, 2 * np.pi + 0.3, 4 * np.pi])
            lower[j], upper[j] = (q[j], q[j] + wide) if at_lower else (q[j] - wide, q[j])
        elif at_lower:
            lower[j] = q[j]
        else:
            upper[j] = q[j]
    return arm.with_limits({name: (a, b) for name, a, b in zip(arm.joint_names, lower, upper, strict=True)})


def check(arm: Arm, q: np.ndarray) -> None:
    T = arm.fk(q)
    one, many = arm.ik(T), arm.ik_many(T[None], threads=1, near=q)
    said = f"{one.status.name}, {Status(many.status[0]).name} at {q.tolist()} in {arm.limits.tolist()}"
    assert one.status in (Status.SOLVED, Status.SINGULAR) and many.status[0] == one.status, said
    rows = many.q[0][many.valid[0]]
    assert len(rows) == len(one.all_q) and many.in_limits[0].sum() == len(one.q) > 0, said
    assert arm.chain.joints.apart(rows, one.all_q).max() < 1e-9, said
    sigma = np.linalg.svd(arm.jacobian(q), compute_uv=False)[-1]
    told = 1e-6 if one.self_motions else BLUR if sigma < SINGULAR else 1e-6 + 1e-13 / sigma
    assert np.abs(one.nearest(q) - q).max() < told, said
    assert np.abs(arm.fk(one.q) - T).max() < 1e-11, said
    for motion in one.self_motions:
        for low, high in motion.inside:
            for u in (low, (low + high) / 2, high):
                there = motion.at(u)
                moved, ok = arm.chain.joints.inside_limits(there, arm.limits)
                assert ok, f"{said}: {there - q} at {u}, {moved}"
                assert np.abs(arm.fk(there) - T).max() < 1e-11


@pytest.mark.parametrize("kind", ["singular", "wrist", "two", "round"])
@pytest.mark.parametrize("name", ARMS)
def test_a_posture_on_its_limits_is_inside(name, kind):
    arm, rng = ARMS[name](), np.random.default_rng(6)
    for how in ("stop", "turns", "point", "mixed") * 2:
        q = posture(arm, rng, kind)
        check(limited(arm, q, rng, how), q)


@pytest.mark.parametrize("name", ["universal-robots-ur5e", "denso-vp6242", "stanford-arm"])
def test_a_wrist_in_line_with_half_its_joints_on_a_limit_is_singular(name):
    arm, rng = free(name), np.random.default_rng(5)
    for _ in range(40):
        q = posture(arm, rng, "wrist")
        wide = np.where(rng.random((6, 2)) < 0.5, 0.0, 0.2)
        wide[wide.sum(1) == 0, 1] = 0.2
        short = arm.with_limits({m: (v - a, v + b) for m, v, (a, b) in zip(arm.joint_names, q, wide, strict=True)})
        check(short, q)
        assert short.ik(arm.fk(q)).status == Status.SINGULAR


def test_a_joint_turned_back_at_its_very_limit_is_inside():
    """The limits of a linkage's joints are where each of them turns back: the curve only touches them."""
    arm, rng = free("universal-robots-ur5e"), np.random.default_rng(9)
    for _ in range(8):
        q = posture(arm, rng, "wrist")
        motion = arm.ik(arm.fk(q)).self_motions[0]
        for joint in motion.free:
            column = motion.samples[:, joint]
            for end in (np.argmin(column), np.argmax(column)):
                if not 0 < end < len(column) - 1 or np.ptp(column) > 6:
                    continue
                # the end between samples, by golden section
                low, high = motion.u[end - 1], motion.u[end + 1]
                sense = 1.0 if column[end] < column.mean() else -1.0
                for _ in range(60):
                    a, b = high - 0.618 * (high - low), low + 0.618 * (high - low)
                    low, high = (low, b) if sense * motion.at(a)[joint] < sense * motion.at(b)[joint] else (a, high)
                there = motion.at((low + high) / 2)
                stop = there[joint]
                limits = (stop - 1.0, stop) if sense > 0 else (stop, stop + 1.0)
                check(arm.with_limits({arm.joint_names[joint]: limits}), there)


def test_a_row_at_half_a_turn_is_told_as_plus_half_a_turn():
    for name in ("denso-vp6242", "unimation-puma-560", "stanford-arm"):
        arm = free(name)
        for q in np.deg2rad([[90, -90, 0, 30, 30, 0], [90, -90, 0, 30, 30, 180], [20, 30, 40, 0, 50, 0]]):
            q[2] += 0.4 * arm.chain.prismatic[2]
            many = arm.ik_many(np.repeat(arm.fk(q)[None], 9, 0), threads=1)
            assert np.all(many.q[many.valid] > -np.pi) and np.all(arm.ik(arm.fk(q)).all_q > -np.pi)


def test_the_posture_at_which_a_linkage_meets_three_stops_at_once():
    arm = pieper.load("ur5e")
    q = np.deg2rad([-45, 90, 60, 105, -180, -180])
    wide = np.array([[0.5, 0.0], [0.0, 0.5], [0.0, 0.5], [0.001, 0.0], [0.001, 0.5], [0.05, 0.5]])
    check(arm.with_limits({n: (v - a, v + b) for n, v, (a, b) in zip(arm.joint_names, q, wide, strict=True)}), q)
