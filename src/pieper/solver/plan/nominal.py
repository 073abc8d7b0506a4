"""The rows of the six-joint chain that is solved, for poses and locked values, as its kernel gives them."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from pieper.kinematics.chain import Chain
from pieper.kinematics.geometry import look
from pieper.solver.families import choose
from pieper.solver.native import SixJointSolver, without_far_ends
from pieper.solver.plan.plan import Plan
from pieper.solver.results import TURN
from pieper.tolerances import GEOMETRY_EXACT, SAME_SOLUTION

#: A filled joint that comes out below this was meant to be zero: the pose is one the arm can reach (rad; per length).
FILLED_ZERO = 1e-6
#: Six joints without limits, (6, 2).
UNLIMITED = np.tile([-np.inf, np.inf], (6, 1))


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
    return solver_of(plan.reduction.six(np.array(values)))


def solver_of(chain: Chain) -> SixJointSolver:
    """Return the native solver of a six-joint chain without limits; raises PlanError where no family takes it."""
    six, ends = without_far_ends(chain)
    _, spec = choose(six, look(six, GEOMETRY_EXACT))
    return SixJointSolver(six, spec, UNLIMITED, ends)


def distinct_rows(chain: Chain, q: np.ndarray, valid: np.ndarray) -> np.ndarray:
    """Return valid (N, M) without rows that repeat an earlier valid one of their pose, angles around the circle."""
    prismatic = chain.prismatic[: q.shape[-1]]
    first = valid.copy()
    for b in range(1, q.shape[1]):
        gap = q[:, b : b + 1] - q[:, :b]
        gap = np.where(prismatic, gap / chain.length, (gap + np.pi) % TURN - np.pi)
        first[:, b] &= ~((np.abs(gap) < SAME_SOLUTION * 10).all(-1) & first[:, :b]).any(1)
    return first
