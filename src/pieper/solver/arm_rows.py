"""Rows of any arm and task, through the six-joint chain they became: solved, polished, cut to the arm's own joints."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array, Bools, Indices
from pieper.kinematics.newton import missed, newton
from pieper.kinematics.pose import checked_pose
from pieper.solver.kernel_rows import Solved, kernel_rows, without_repeats
from pieper.solver.plan.plan import Plan
from pieper.solver.plan.six_joints import Reduction
from pieper.solver.refilled import all_by_count
from pieper.solver.rows import Flag, Rows
from pieper.solver.snap_count import counted
from pieper.tolerances import CLOSES


def arm_rows(plan: Plan, T: Array, values: Array, threads: int) -> Rows:
    """Solve poses T (N, 4, 4) with redundant coordinates at values (N, k)."""
    reduction = plan.reduction
    if plan.immediate and reduction.full.n == plan.n:
        q6, valid, inside, flags = plan.solver.many(np.ascontiguousarray(reduction.moved_pose(T, values)), threads)
        rounded = np.flatnonzero(flags & int(Flag.ROUNDED))
        if len(rounded):
            # the arm's own pose is made a rotation, not the pose moved along the held joint's link
            straight = reduction.moved_pose(checked_pose(T[rounded], batch=True), values[rounded])
            q6, valid, inside, flags = q6.copy(), valid.copy(), inside.copy(), flags.copy()
            for into, again in zip(
                (q6, valid, inside, flags), plan.solver.many(np.ascontiguousarray(straight), threads), strict=True
            ):
                into[rounded] = again
            flags[rounded] |= np.uint8(Flag.ROUNDED)
        return Rows(_with_locked(reduction, q6, valid, values), valid, inside, flags)
    found = full_rows(plan, T, values, threads)
    q, valid = found.q[..., : plan.n], found.valid
    if reduction.full.n > plan.n:
        valid = without_repeats(reduction.full, q, valid)
    if q.shape[1] > plan.max_solutions:
        q, valid = _packed(q, valid, plan.max_solutions)
    flags = found.flags if reduction.locked or not reduction.fill else all_by_count(plan, q, valid, found.flags)
    q, inside = plan.chain.joints.inside_limits(np.where(valid[..., None], q, 0.0), plan.limits)
    return Rows(q, valid, inside & valid, flags)


def full_rows(plan: Plan, T: Array, values: Array, threads: int) -> Solved:
    """Solve poses T (N, 4, 4) with redundant coordinates at values (N, k), the task's virtual joints included."""
    found = kernel_rows(plan, T, values, threads)
    if not (plan.reduction.fill or plan.snapped):
        return found
    polished = _polished(plan, found, T, values)
    return counted(plan, T, values, polished, found.valid.sum(1)) if plan.snapped else polished


def _with_locked(reduction: Reduction, q6: Array, valid: Bools, values: Array) -> Array:
    """Return rows (N, M, n): the six solved joints with those locked at the ends beside them, zero where not valid."""
    if not reduction.locked or reduction.at_ends is None:
        return q6
    first = reduction.at_ends[0]
    q = np.empty((*q6.shape[:2], reduction.full.n))
    q[..., first : first + 6] = q6
    for k, joint in enumerate(reduction.locked):
        np.multiply(valid, values[:, k, None], out=q[..., joint])
    return q


def _polished(plan: Plan, found: Solved, T: Array, values: Array) -> Solved:
    """Newton on the arm as it is, the locked joints held; what does not close is no solution."""
    pose, slot = np.nonzero(found.valid)
    if not len(pose):
        return found
    exact, keep = found.q.copy(), np.zeros_like(found.valid)
    locked, kept = list(plan.reduction.locked), plan.reduction.kept
    for group in _by_value(values[pose]) if locked else [np.arange(len(pose))]:
        at = pose[group], slot[group]
        held = plan.exact.with_locked(values[at[0][0]]) if locked else plan.exact.full
        done = newton(held, found.q[at][:, kept], T[at[0]], steps=20 if plan.snapped else 6)
        whole = exact[at]
        whole[:, kept] = done
        exact[at] = whole
        keep[at] = missed(held, done, T[at[0]]) < CLOSES
    full = plan.reduction.full
    q = full.joints.wrapped(exact)
    return Solved(q, without_repeats(full, q, keep), found.flags)


def _by_value(values: Array) -> list[Indices]:
    _, which = np.unique(values, axis=0, return_inverse=True)
    return [np.flatnonzero(which.reshape(-1) == i) for i in range(which.max() + 1)]


def _packed(q: Array, valid: Bools, most: int) -> tuple[Array, Bools]:
    """Move valid rows to the front, order kept, and cut to `most`."""
    order = np.argsort(~valid, axis=1, kind="stable")[:, :most]
    return np.take_along_axis(q, order[..., None], 1), np.take_along_axis(valid, order, 1)
