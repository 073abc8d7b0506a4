"""Redundant arms: whole families of solutions over the redundant coordinate."""

from __future__ import annotations

import numpy as np

from pieper.inverse.plan import Plan
from pieper.inverse.reduced import solve_reduced
from pieper.inverse.refine import newton, pose_difference
from pieper.inverse.selfmotion import MOST_STEPS, Family, trace
from pieper.kinematics.chain import Chain
from pieper.kinematics.forward import fk

#: Values of the redundant coordinate that are tried to meet every family, and the most families that are traced.
SLICES, DRAWS, MOST_FAMILIES = 48, 60, 24
#: Where several coordinates are redundant the solutions form a surface: lines followed on it, and how far.
MOST_LINES, LINE_STEPS = 8, 60


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
    spare = len(plan.redundancy)
    seeds = _completed(plan, rows, T, values)
    if spare == 1 or not seeds:
        seeds += _seeds(plan, T, values)
    families: list[Family] = []
    for q in seeds:
        # a surface has no list of curves: one line through each solution shows the way, and `dimension` says the rest
        if len(families) >= (MOST_FAMILIES if spare == 1 else MOST_LINES):
            break
        if any(family.distance(q) < 0.02 for family in families):
            continue
        if np.linalg.norm(pose_difference(full, q, T)) > 1e-9:
            continue
        steps = MOST_STEPS if spare == 1 else LINE_STEPS
        families.append(trace(full, q, T, plan.full_limits, plan.full_names, shown=plan.n, most_steps=steps))
    return tuple(families)


def _seeds(plan: Plan, T: np.ndarray, values: np.ndarray) -> list[np.ndarray]:
    """Return points of the pose at many values of the redundant coordinates.

    The first coordinate is swept at the given values of the others; where that meets nothing and there are others,
    all of them are drawn at random (the same draws every time).
    """
    ranges = [_range(plan, joint) for joint in plan.reduction.locked]
    lower, upper = ranges[0]
    # a joint held inside the chain needs a kernel prepared for each value
    slices = SLICES if plan.reduction.at_ends is not None else SLICES // 4
    sweep = np.tile(values, (slices, 1))
    sweep[:, 0] = np.linspace(lower, upper, slices, endpoint=bool(upper - lower < 2 * np.pi - 1e-9))
    found = _points(plan, T, sweep)
    if not found and len(ranges) > 1:
        low, high = np.array(ranges).T
        found = _points(plan, T, np.random.default_rng(8).uniform(low, high, (DRAWS, len(ranges))))
    return found


def _range(plan: Plan, joint: int) -> tuple[float, float]:
    lower, upper = plan.full_limits[joint]
    span = 2 * plan.chain.length if plan.reduction.full.prismatic[joint] else np.pi
    return max(lower, -span), min(upper, span)


def _points(plan: Plan, T: np.ndarray, values: np.ndarray) -> list[np.ndarray]:
    q, valid, _, _ = solve_reduced(plan, np.tile(T, (len(values), 1, 1)), values, 1)
    return [row for i in range(len(values)) for row in _completed(plan, q[i][valid[i]], T, values[i])]


def _completed(plan: Plan, rows: np.ndarray, T: np.ndarray, values: np.ndarray) -> list[np.ndarray]:
    """Return rows (m, n) with the task's virtual joints added, so that they reach the full pose."""
    full = plan.reduction.full
    if full.n == plan.n:
        return list(rows)
    out = []
    for row in rows:
        start = np.zeros(full.n)
        start[: plan.n] = row
        for joint, value in zip(plan.reduction.locked, values, strict=True):
            start[joint] = value
        # the virtual joints are a wrist at the tool: solved alone, from a few starts, with the arm where it is
        wrist = Chain.of(np.concatenate([[fk(plan.chain, row)], full.links[plan.n + 1 :]]), full.prismatic[plan.n :])
        starts = np.vstack([start[plan.n :], np.random.default_rng(2).uniform(-3, 3, (5, full.n - plan.n))])
        turned = newton(wrist, starts, T, steps=30)
        best = np.argmin(np.linalg.norm(pose_difference(wrist, turned, T), axis=-1))
        start[plan.n :] = turned[best]
        out.append(start)
    return out
