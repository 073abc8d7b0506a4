"""The rows of the six-joint chain that is solved, for poses and locked values, as its kernel gives them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper.errors import PlanError
from pieper.kinematics.arrays import Array, Bits, Bools, Indices
from pieper.kinematics.chain import Chain
from pieper.kinematics.newton import missed, newton
from pieper.solver.plan.plan import Plan
from pieper.solver.refilled import refilled_rows
from pieper.solver.rows import Flag
from pieper.tolerances import BESIDE_UNSOLVED, CLOSES, FILLED_STARTS, PULLED_RANK, SAME_ROW


@dataclass(frozen=True, eq=False, slots=True)
class Solved:
    """Rows before limits, the task's virtual joints included.

    Args:
        q: (N, M, joints of the arm and the task), rad or m.
        valid: (N, M).
        flags: (N,) bits of `Flag`.
    """

    q: Array
    valid: Bools
    flags: Bits


def kernel_rows(plan: Plan, T: Array, values: Array, threads: int) -> Solved:
    """Solve as `full_rows`, but leave rows as the kernel gives them: of the nominal arm where geometry was snapped."""
    reduction = plan.reduction
    if reduction.at_ends is not None:
        q6, valid, _, flags = plan.solver.many(np.ascontiguousarray(reduction.moved_pose(T, values)), threads)
    else:
        q6, valid, flags = _per_value(plan, T, values, threads)
    if reduction.fill:
        unit = np.array([plan.chain.length if p else 1.0 for _, p in reduction.fill])
        # a pose of the arm as described is none of the nominal arm: it misses by about as much as was snapped
        zero = max(FILLED_STARTS, 10 * plan.drift)
        valid = valid & (np.abs(q6[..., reduction.filled] / unit) < zero).all(-1)
        q6, valid, flags = refilled_rows(plan, T, values, q6[..., reduction.real], valid, flags)
    full = np.zeros((*q6.shape[:2], reduction.full.n))
    full[..., reduction.kept] = q6
    if reduction.locked:
        full[..., list(reduction.locked)] = values[:, None, :]
    return Solved(full, valid, flags)


def _per_value(plan: Plan, T: Array, values: Array, threads: int) -> tuple[Array, Bools, Bits]:
    distinct, which = np.unique(values, axis=0, return_inverse=True)
    if len(distinct) == 1:
        return _at_value(plan, T, distinct[0], threads)
    parts: list[tuple[Indices, Array, Bools, Bits]] = []
    most = 0
    for i, value in enumerate(distinct):
        rows = np.flatnonzero(which.reshape(-1) == i)
        q, valid, flags = _at_value(plan, T[rows], value, threads)
        parts.append((rows, q, valid, flags))
        most = max(most, q.shape[1])
    out = np.zeros((len(T), most, 6))
    ok = np.zeros((len(T), most), bool)
    bits = np.zeros(len(T), np.uint8)
    for rows, q, valid, flags in parts:
        out[rows, : q.shape[1]], ok[rows, : q.shape[1]], bits[rows] = q, valid, flags
    return out, ok, bits


def _at_value(plan: Plan, T: Array, value: Array, threads: int) -> tuple[Array, Bools, Bits]:
    poses = np.ascontiguousarray(T)
    try:
        q, valid, _, flags = plan.solvers.at(tuple(value)).many(poses, threads)
    except PlanError:
        return _beside_special(plan, poses, value, threads)
    return q, valid, flags


def _beside_special(plan: Plan, T: Array, value: Array, threads: int) -> tuple[Array, Bools, Bits]:
    """Solve where two axes come to coincide, for one: from rows a little beside that value, brought onto it.

    What is left of the arm there loses a freedom. A pose in general has no solution at that value then, and one that
    was made there has a continuous set, of which some points are given. Where nothing beside has a solver either (an
    arm that is nearly one with more joints to spare) there are no rows at this value, and nothing is certain of it.
    """
    six = plan.reduction.six(value)
    for step in BESIDE_UNSOLVED:
        beside = value + step * np.where(plan.reduction.full.prismatic[list(plan.reduction.locked)], six.length, 1.0)
        try:
            q, valid, _, flags = plan.solvers.at(tuple(beside)).many(T, threads)
        except PlanError:
            continue
        pose, slot = np.nonzero(valid)
        q, valid = q.copy(), np.zeros_like(valid)
        moved = newton(six, q[pose, slot], T[pose], steps=20, cutoff=PULLED_RANK)
        q[pose, slot] = six.joints.wrapped(moved)
        valid[pose, slot] = missed(six, moved, T[pose]) < CLOSES
        return q, without_repeats(six, q, valid), flags
    return np.zeros((len(T), 1, 6)), np.zeros((len(T), 1), bool), np.full(len(T), int(Flag.UNCERTAIN), np.uint8)


def without_repeats(chain: Chain, q: Array, valid: Bools) -> Bools:
    """Return valid (N, M) without rows that repeat an earlier valid one of their pose, angles around the circle."""
    return chain.joints.first(q.shape[-1]).without_repeats(q, valid, SAME_ROW)
