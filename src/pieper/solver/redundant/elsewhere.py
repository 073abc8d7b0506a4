"""Rows at another value of the spare coordinates, where the one that nobody chose has nothing inside the limits."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from pieper.errors import PlanError
from pieper.kinematics.arrays import Array, Indices
from pieper.solver.arm_rows import arm_rows
from pieper.solver.plan.holding import locked_at
from pieper.solver.plan.plan import Plan
from pieper.solver.redundant.anywhere import INSIDE, anywhere, spare_values
from pieper.solver.redundant.choice import Choice
from pieper.solver.rows import Flag, Rows
from pieper.tolerances import CHOSEN_POINT


def choose_elsewhere(plan: Plan, T: Array, rows: Rows, threads: int) -> tuple[Rows, Indices]:
    """Choose another value for each pose without a row inside the limits.

    Args:
        plan: A plan with redundancy.
        T: (N, 4, 4) poses.
        rows: Rows of all of them at a value that nobody chose.
        threads: For the kernels.

    Returns:
        Rows with those of the chosen values in their places, and (N,) whether a pose has no solution at all, solutions
        outside the limits alone, or some inside (as `Anywhere.kind`).
    """
    kind = np.full(len(T), INSIDE)
    left = np.flatnonzero(~rows.inside.any(1))
    if not len(left):
        return rows, kind
    found = anywhere(plan, T[left], threads)
    some = rows.valid[left].any(1)
    kind[left] = np.maximum(found.kind, some)
    # solutions at the value that nobody chose are as good as others outside the limits
    moved = (found.kind == INSIDE) | ((found.kind > 0) & ~some)
    if plan.nearly_free:
        rows = replace(rows, flags=rows.flags.copy())
        rows.flags[left[kind[left] == 0]] |= np.uint8(int(Flag.UNCERTAIN))
    if not moved.any():
        return rows, kind
    at, points = left[moved], found.q[moved]
    return _with_those(rows, at, _rows_through(plan, T[at], points, threads)), kind


def others_elsewhere(asked: Choice, T: Array, rows: Rows, threads: int) -> Rows:
    """Choose other values of the coordinates that nobody named, where those named were given.

    Args:
        asked: What was asked for, of some of the coordinates by name.
        T: (N, 4, 4) poses.
        rows: Rows of all of them, what was not named at its default.
        threads: For the kernels.

    Returns:
        Rows with those of the chosen values in their places, of poses without a row inside the limits.
    """
    left = np.flatnonzero(~rows.inside.any(1))
    joints = tuple(asked.plan.reduction.locked[i] for i in asked.named)
    values = asked.values[:, list(asked.named)]
    for value in np.unique(values[left], axis=0):
        at = left[(values[left] == value).all(1)]
        try:
            plan = locked_at(asked.plan, tuple(value.tolist()), joints)
        except PlanError:
            continue  # what is left is no arm: its rows stand as they are
        found = anywhere(plan, T[at], threads)
        moved = (found.kind == INSIDE) | ((found.kind > 0) & ~rows.valid[at].any(1))
        if moved.any():
            points = np.insert(found.q[moved], np.array(joints) - np.arange(len(joints)), value, axis=1)
            rows = _with_those(rows, at[moved], _rows_through(asked.plan, T[at[moved]], points, threads))
    return rows


def _with_those(rows: Rows, at: Indices, there: Rows) -> Rows:
    """Return rows of all poses with those of some of them (k,) in their places."""
    if len(at) == len(rows.q):
        return _widened(there, rows.q.shape[1])
    rows = _widened(rows, there.q.shape[1])
    q, valid, inside = rows.q.copy(), rows.valid.copy(), rows.inside.copy()
    q[at], valid[at], inside[at] = 0.0, False, False
    most = there.q.shape[1]
    q[at, :most], valid[at, :most], inside[at, :most] = there.q, there.valid, there.inside
    flags = rows.flags.copy()
    flags[at] = there.flags
    return Rows(q, valid, inside, flags)


def _rows_through(plan: Plan, T: Array, points: Array, threads: int) -> Rows:
    """Return all rows of poses at the spare values of points (N, n) of theirs, these points among them."""
    values = spare_values(plan, points)
    most = plan.max_solutions
    try:
        rows = arm_rows(plan, T, values, threads)
    except PlanError:  # at one of the values two axes coincide: that pose keeps its point alone
        rows = _one_by_one(plan, T, values)
    rows = _widened(rows, most)
    own, within = plan.chain.joints.inside_limits(points[:, : plan.n], plan.limits)
    gap = plan.chain.joints.difference(rows.q, own[:, None])
    met = ((np.abs(gap).max(-1) < CHOSEN_POINT) & rows.valid & (rows.inside | ~within[:, None])).any(1)
    q, valid, inside = rows.q.copy(), rows.valid.copy(), rows.inside.copy()
    for i in np.flatnonzero(~met):
        near = np.abs(gap[i]).max(-1) < CHOSEN_POINT
        slot = int(np.argmax(near & valid[i])) if (near & valid[i]).any() else int(np.argmin(valid[i]))
        if valid[i].all() and not near.any():
            slot = most - 1
        q[i, slot], valid[i, slot], inside[i, slot] = own[i], True, within[i]
    return Rows(q, valid, inside, rows.flags)


def _one_by_one(plan: Plan, T: Array, values: Array) -> Rows:
    most = plan.max_solutions
    valid = np.zeros((len(T), most), bool)
    out = Rows(np.zeros((len(T), most, plan.n)), valid, valid.copy(), np.zeros(len(T), np.uint8))
    for i in range(len(T)):
        try:
            rows = arm_rows(plan, T[i : i + 1], values[i : i + 1], 1)
        except PlanError:
            continue
        count = min(most, rows.q.shape[1])
        out.q[i, :count], out.valid[i, :count] = rows.q[0, :count], rows.valid[0, :count]
        out.inside[i, :count], out.flags[i] = rows.inside[0, :count], rows.flags[0]
    return out


def _widened(rows: Rows, most: int) -> Rows:
    """Return rows with at least so many slots a pose."""
    more = most - rows.q.shape[1]
    if more <= 0:
        return rows
    pad = ((0, 0), (0, more))
    return Rows(np.pad(rows.q, (*pad, (0, 0))), np.pad(rows.valid, pad), np.pad(rows.inside, pad), rows.flags)
