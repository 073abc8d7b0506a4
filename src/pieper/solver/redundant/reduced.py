"""Solve arms and tasks that are not six joints themselves, through the six-joint chain they were reduced to."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.newton import newton, pose_difference
from pieper.solver.plan.nominal import distinct_rows, nominal_rows
from pieper.solver.plan.plan import Plan
from pieper.solver.plan.six_joints import Reduction
from pieper.solver.plan.snapcheck import counted
from pieper.solver.results import TURN, inside_limits

#: What must remain after polishing (per length; rad).
CLOSES = 1e-9


def solve_reduced(
    plan: Plan, T: np.ndarray, values: np.ndarray, threads: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Solve poses T (N, 4, 4) with redundant coordinates at values (N, k).

    Returns:
        q (N, M, n), valid (N, M), in_limits (N, M), flag (N,), as the native solver's `many`.
    """
    reduction = plan.reduction
    if plan.immediate and reduction.full.n == plan.n:
        poses = np.ascontiguousarray(reduction.moved_pose(T, values))
        q6, valid, inside, flag = plan.solver.many(poses, threads)
        return _with_locked(reduction, q6, valid, values), valid, inside, flag
    full, valid, flag = full_rows(plan, T, values, threads)
    q = full[..., : plan.n]
    if reduction.full.n > plan.n:
        valid = distinct_rows(reduction.full, q, valid)
    most = plan.max_solutions
    if q.shape[1] > most:
        q, valid = _packed(q, valid, most)
    q = np.where(valid[..., None], q, 0.0)
    q, inside = inside_limits(q, plan.limits, plan.prismatic)
    return q, valid, inside & valid, flag


def full_rows(plan: Plan, T: np.ndarray, values: np.ndarray, threads: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Solve poses T (N, 4, 4) with redundant coordinates at values (N, k), the task's virtual joints included.

    Returns:
        q (N, M, joints of the arm and the task), valid (N, M), flag (N,).
    """
    full, valid, flag = nominal_rows(plan, T, values, threads)
    if not (plan.reduction.fill or plan.snapped):
        return full, valid, flag
    nominal = valid
    full, valid = _polished(plan, full, valid, T, values)
    if plan.snapped:
        return counted(plan, T, values, full, valid, nominal.sum(1), flag)
    return full, valid, flag


def _with_locked(reduction: Reduction, q6: np.ndarray, valid: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Return rows (N, M, n): the six solved joints with those locked at the ends beside them, zero where not valid."""
    if not reduction.locked:
        return q6
    first = reduction.at_ends[0]
    q = np.empty((*q6.shape[:2], reduction.full.n))
    q[..., first : first + 6] = q6
    for k, joint in enumerate(reduction.locked):
        np.multiply(valid, values[:, k, None], out=q[..., joint])
    return q


def _polished(plan: Plan, full: np.ndarray, valid: np.ndarray, T: np.ndarray, values: np.ndarray):
    """Newton on the arm as it is, the locked joints held; what does not close is no solution."""
    rows = np.argwhere(valid)
    if not len(rows):
        return full, valid
    exact = full.copy()
    keep = np.zeros_like(valid)
    chain = plan.exact.full
    locked = list(plan.reduction.locked)
    for group in _by_value(values[rows[:, 0]]) if locked else [slice(None)]:
        member = rows[group]
        held = chain
        for joint, value in sorted(zip(locked, values[member[0, 0]] if locked else (), strict=True), reverse=True):
            held = held.locked(joint, float(value))
        start = full[member[:, 0], member[:, 1]][:, plan.reduction.kept]
        poses = T[member[:, 0]]
        done = newton(held, start, poses, steps=20 if plan.snapped else 6)
        good = np.linalg.norm(pose_difference(held, done, poses), axis=-1) < CLOSES
        target = exact[member[:, 0], member[:, 1]]
        target[:, plan.reduction.kept] = done
        exact[member[:, 0], member[:, 1]] = target
        keep[member[:, 0], member[:, 1]] = good
    wrapped = np.where(plan.reduction.full.prismatic, exact, np.pi - (np.pi - exact) % TURN)
    return wrapped, distinct_rows(plan.reduction.full, wrapped, keep)


def _by_value(values: np.ndarray) -> list[np.ndarray]:
    _, which = np.unique(values, axis=0, return_inverse=True)
    return [np.flatnonzero(which.reshape(-1) == i) for i in range(which.max() + 1)]


def _packed(q: np.ndarray, valid: np.ndarray, most: int):
    """Move valid rows to the front, order kept, and cut to `most`."""
    order = np.argsort(~valid, axis=1, kind="stable")[:, :most]
    return np.take_along_axis(q, order[..., None], 1), np.take_along_axis(valid, order, 1)
