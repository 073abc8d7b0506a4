"""Redundant arms: whole families of solutions over the redundant coordinate."""

from __future__ import annotations

import numpy as np

from pieper.inverse.plan import Plan
from pieper.inverse.reduced import solve_reduced
from pieper.inverse.refine import pose_difference
from pieper.inverse.selfmotion import Family, trace

#: Values of the redundant coordinate that are tried to meet every family, and the most families that are traced.
SLICES, MOST_FAMILIES = 48, 24


def families_of(plan: Plan, T: np.ndarray, values: np.ndarray, rows: np.ndarray) -> tuple[Family, ...]:
    """Trace every family of a pose of a redundant arm.

    Slices at many values of the first redundant coordinate (the others stay) give starting points on every curve that
    reaches over more than a slice's width; each point not on a traced curve starts a new one.

    Args:
        plan: A plan with redundancy.
        T: (4, 4).
        values: (k,) the redundant coordinates asked for.
        rows: (m, n) solutions at those values.
    """
    full = plan.reduction.full
    seeds = _seeds(plan, T, values)
    families: list[Family] = []
    for q in [*_completed(plan, rows, T, values), *seeds]:
        if len(families) >= MOST_FAMILIES:
            break
        if any(family.distance(q) < 0.02 for family in families):
            continue
        if np.linalg.norm(pose_difference(full, q, T)) > 1e-9:
            continue
        families.append(trace(full, q, T, plan.full_limits, plan.full_names))
    return tuple(families)


def _seeds(plan: Plan, T: np.ndarray, values: np.ndarray) -> list[np.ndarray]:
    joint = plan.reduction.locked[0]
    lower, upper = plan.full_limits[joint]
    if plan.reduction.full.prismatic[joint]:
        reach = 2 * plan.chain.length
        grid = np.linspace(max(lower, -reach), min(upper, reach), SLICES)
    else:
        grid = np.linspace(max(lower, -np.pi), min(upper, np.pi), SLICES, endpoint=bool(upper - lower < 6.28))
    many = np.tile(values, (SLICES, 1))
    many[:, 0] = grid
    poses = np.tile(T, (SLICES, 1, 1))
    found: list[np.ndarray] = []
    q, valid, _, _ = solve_reduced(plan, poses, many, 1)
    for i in range(SLICES):
        found += _completed(plan, q[i][valid[i]], T, many[i])
    return found


def _completed(plan: Plan, rows: np.ndarray, T: np.ndarray, values: np.ndarray) -> list[np.ndarray]:
    """Return rows (m, n) with the task's virtual joints added, so that they reach the full pose."""
    full = plan.reduction.full
    if full.n == plan.n:
        return list(rows)
    from pieper.inverse.refine import newton

    out = []
    for row in rows:
        start = np.zeros(full.n)
        start[: plan.n] = row
        for joint, value in zip(plan.reduction.locked, values, strict=True):
            start[joint] = value
        virtual = newton(full.section(plan.n, full.n - 1), start[plan.n :], np.eye(4), steps=0)
        start[plan.n :] = virtual
        best = newton(full, start, T, steps=25)
        out.append(best)
    return out


__all__ = ["families_of"]
