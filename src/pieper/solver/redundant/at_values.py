"""Rows with the spare coordinates at chosen values; where these are singular, of the arm that is locked there."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

import numpy as np

from pieper.errors import PlanError
from pieper.kinematics.arrays import Array, Indices
from pieper.solver.arm_rows import arm_rows
from pieper.solver.plan.holding import locked_at
from pieper.solver.plan.plan import Plan
from pieper.solver.redundant.choice import Choice
from pieper.solver.rows import Flag, Rows, any_row

#: Solves poses (N, 4, 4) of a plan without redundancy, looks with care where that is needed, and returns all rows.
Solve: TypeAlias = Callable[[Plan, Array, int], Rows]


def rows_at_choice(plan: Plan, poses: Array, asked: Choice, threads: int, solve: Solve) -> Rows:
    """Return the rows of poses (N, 4, 4) with the coordinates that were asked for where they were asked for."""
    if asked.angle is not None and asked.angles is not None:
        from pieper.solver.redundant.at_arm_angle import rows_at_arm_angle

        return rows_at_arm_angle(plan, asked.angle, poses, asked.angles)
    rows = arm_rows(asked.plan, poses, asked.values, threads)
    short = bool(asked.plan.reduction.fill)
    if not asked.plan.reduction.locked or (asked.free and not short):
        return rows  # any value will do, or there is nothing to hold
    # a kernel says of no rows whether poses beside have none; of an arm that is filled up that says nothing
    doubtful = (rows.flags & (Flag.DEGENERATE | Flag.UNCERTAIN | Flag.EDGE)) > 0
    if short:
        doubtful |= ~rows.valid.any(1)
    rows = _again(asked.plan, poses, asked.values, rows, np.flatnonzero(doubtful), threads, solve)
    if not asked.named:
        return rows
    if not any_row(rows.inside).all():
        from pieper.solver.redundant.elsewhere import others_elsewhere

        rows = others_elsewhere(asked, poses, rows, threads)
    # of rows at a value that nobody chose nobody was told that they are all
    rows.flags[any_row(rows.inside)] &= np.uint8(255 ^ int(Flag.UNCERTAIN))
    return rows


def _again(plan: Plan, poses: Array, values: Array, rows: Rows, at: Indices, threads: int, solve: Solve) -> Rows:
    """Solve some of the poses again, the arm locked, as an arm with fewer joints; return all rows.

    That arm is looked at with care where it is singular. And a virtual joint that fills a short arm up may lie along
    what it can do at a pose: then the six joints are singular where the arm is not, and give no rows, or not all.
    """
    if not len(at):
        return rows
    found: list[tuple[Indices, Rows]] = []
    for value in np.unique(values[at], axis=0):
        same = at[(values[at] == value).all(1)]
        try:
            again = solve(locked_at(plan, tuple(value.tolist())), poses[same], threads)
        except PlanError:
            continue  # what is left is no arm: its rows stand as they are
        some = again.valid.any(1)
        found.append((same[some], again.part(np.flatnonzero(some))))
    count = max([rows.q.shape[1], *(again.q.shape[1] for _, again in found)])
    q, valid = np.zeros((len(poses), count, plan.n)), np.zeros((len(poses), count), bool)
    q[:, : rows.q.shape[1]], valid[:, : rows.q.shape[1]] = rows.q, rows.valid
    flags = rows.flags.copy()
    for same, again in found:
        whole = np.zeros((*again.q.shape[:2], plan.reduction.full.n))
        whole[..., plan.reduction.kept] = again.q
        whole[..., list(plan.reduction.locked)] = values[same][:, None]
        q[same], valid[same] = 0.0, False
        q[same, : again.q.shape[1]], valid[same, : again.q.shape[1]] = whole[..., : plan.n], again.valid
        flags[same] = again.flags
    q, inside = plan.chain.joints.inside_limits(np.where(valid[..., None], q, 0.0), plan.limits)
    return Rows(q, valid, inside & valid, flags)
