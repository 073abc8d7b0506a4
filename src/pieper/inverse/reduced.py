"""Solve arms and tasks that are not six joints themselves, through the six-joint chain they were reduced to."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from pieper.inverse.families import choose
from pieper.inverse.native import SixJointSolver
from pieper.inverse.plan import Plan
from pieper.inverse.reduction import Reduction
from pieper.inverse.refine import newton, pose_difference
from pieper.inverse.snapcheck import counted
from pieper.inverse.solutions import TURN, inside_limits
from pieper.kinematics.chain import Chain
from pieper.kinematics.geometry import look
from pieper.tolerances import GEOMETRY_EXACT, SAME_SOLUTION

#: A filled joint that comes out below this was meant to be zero: the pose is one the arm can reach (rad; per length).
FILLED_ZERO = 1e-6
#: What must remain after polishing (per length; rad).
CLOSES = 1e-9

_UNLIMITED = np.tile([-np.inf, np.inf], (6, 1))


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


def nominal_rows(
    plan: Plan, T: np.ndarray, values: np.ndarray, threads: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Solve as `full_rows`, but leave rows as the kernel gives them: of the nominal arm where geometry was snapped."""
    reduction = plan.reduction
    if reduction.at_ends is not None:
        q6, valid, _, flag = plan.solver.many(np.ascontiguousarray(reduction.moved_pose(T, values)), threads)
    else:
        q6, valid, flag = _per_value(plan, T, values, threads)
    full = np.zeros((*q6.shape[:2], reduction.full.n))
    real = 6 - len(reduction.fill)
    if reduction.fill:
        unit = np.array([plan.chain.length if p else 1.0 for _, p in reduction.fill])
        # a pose of the arm as described is none of the nominal arm: it misses by about as much as was snapped
        zero = max(FILLED_ZERO, 10 * plan.drift)
        valid = valid & (np.abs(q6[..., real:] / unit) < zero).all(-1)
    full[..., reduction.kept] = q6[..., :real]
    if reduction.locked:
        full[..., list(reduction.locked)] = values[:, None, :]
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


def _per_value(plan: Plan, T: np.ndarray, values: np.ndarray, threads: int):
    distinct, which = np.unique(values, axis=0, return_inverse=True)
    if len(distinct) == 1:
        q, valid, _, flag = solver_at(plan, tuple(distinct[0])).many(np.ascontiguousarray(T), threads)
        return q, valid, flag
    parts = []
    most = 0
    for i, value in enumerate(distinct):
        rows = np.flatnonzero(which.reshape(-1) == i)
        q, valid, _, flag = solver_at(plan, tuple(value)).many(np.ascontiguousarray(T[rows]), threads)
        parts.append((rows, q, valid, flag))
        most = max(most, q.shape[1])
    out = np.zeros((len(T), most, 6))
    ok = np.zeros((len(T), most), bool)
    bits = np.zeros(len(T), np.uint8)
    for rows, q, valid, flag in parts:
        out[rows, : q.shape[1]], ok[rows, : q.shape[1]], bits[rows] = q, valid, flag
    return out, ok, bits


@lru_cache(maxsize=512)
def solver_at(plan: Plan, values: tuple[float, ...]) -> SixJointSolver:
    """Return the native solver with the locked joints at values; made once a value."""
    six = plan.reduction.six(np.array(values))
    _, spec = choose(six, look(six, GEOMETRY_EXACT))
    return SixJointSolver(six, spec, _UNLIMITED)


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


def distinct_rows(chain: Chain, q: np.ndarray, valid: np.ndarray) -> np.ndarray:
    """Return valid (N, M) without rows that repeat an earlier valid one of their pose, angles around the circle."""
    prismatic = chain.prismatic[: q.shape[-1]]
    first = valid.copy()
    for b in range(1, q.shape[1]):
        gap = q[:, b : b + 1] - q[:, :b]
        gap = np.where(prismatic, gap / chain.length, (gap + np.pi) % TURN - np.pi)
        first[:, b] &= ~((np.abs(gap) < SAME_SOLUTION * 10).all(-1) & first[:, :b]).any(1)
    return first


def _packed(q: np.ndarray, valid: np.ndarray, most: int):
    """Move valid rows to the front, order kept, and cut to `most`."""
    order = np.argsort(~valid, axis=1, kind="stable")[:, :most]
    return np.take_along_axis(q, order[..., None], 1), np.take_along_axis(valid, order, 1)
