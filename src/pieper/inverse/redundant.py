"""Redundant arms: whole families of solutions over the redundant coordinate."""

from __future__ import annotations

import numpy as np

from pieper.inverse.plan import Plan
from pieper.inverse.reduced import full_rows
from pieper.inverse.reduction import sample_joints
from pieper.inverse.refine import newton, pose_difference
from pieper.inverse.selfmotion import MOST_STEPS, Family, trace
from pieper.inverse.solutions import TURN
from pieper.inverse.sweep import span, sweep

#: Starts from which the pose is approached freely, besides the sweep, and the steps of each.
STARTS, STEPS = 192, 40
#: Draws of several redundant coordinates where the given values have no solution, and the most families traced.
DRAWS, MOST_FAMILIES = 60, 24
#: Where several coordinates are redundant the solutions form a surface: lines followed on it, and how far.
MOST_LINES, LINE_STEPS = 8, 60
#: A seed this near to a traced curve is on it; between this and `DOUBTFUL` it is slid onto the curve to see.
ON_POLYLINE, DOUBTFUL = 5e-3, 5e-2
#: What a seed may miss the pose by (per length; rad).
HOLDS = 1e-9


def families_of(plan: Plan, T: np.ndarray, values: np.ndarray) -> tuple[Family, ...]:
    """Trace every family of a pose of a redundant arm.

    A sweep over the first redundant coordinate (the others stay) meets every curve that reaches over more than a
    slice's width. A curve that lies between two slices is small in that coordinate; it is met by free approach: the
    distance to the pose is minimised over all joints from many starts, and a curve that shrinks to a point, and is
    gone beyond that, is where that distance has a minimum whose surroundings lead to it. Each point not on a traced
    curve starts a new one.

    Args:
        plan: A plan with redundancy.
        T: (4, 4).
        values: (k,) the redundant coordinates asked for.
    """
    full = plan.reduction.full
    spare = len(plan.redundancy)
    seeds = _seeds(plan, T, values)
    families: list[Family] = []
    # a surface has no list of curves: one line through each solution shows the way, and `dimension` says the rest
    most, steps = (MOST_FAMILIES, MOST_STEPS) if spare == 1 else (MOST_LINES, LINE_STEPS)
    while len(seeds) and len(families) < most:
        family = trace(full, seeds[0], T, plan.full_limits, plan.full_names, shown=plan.n, most_steps=steps)
        families.append(family)
        seeds = seeds[1:][~_on(family, seeds[1:])]
    return tuple(families)


def _seeds(plan: Plan, T: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Return points (m, n) of the pose, the task's virtual joints included, on every family."""
    full = plan.reduction.full
    swept = sweep(plan, T, 0, values)
    found = swept.q[swept.valid]
    if not len(found) and len(values) > 1:
        low, high = np.array([span(plan, joint) for joint in plan.reduction.locked]).T
        drawn = np.random.default_rng(8).uniform(low, high, (DRAWS, len(values)))
        rows, valid, _ = full_rows(plan, np.tile(T, (DRAWS, 1, 1)), drawn, 1)
        found = rows[valid]
    free = newton(full, sample_joints(full, STARTS, seed=7), T, steps=STEPS, cutoff=1e-3)
    free = np.where(full.prismatic, free, (free + np.pi) % TURN - np.pi)
    seeds = np.concatenate([found.reshape(-1, full.n), free])
    return seeds[np.linalg.norm(pose_difference(full, seeds, T), axis=-1) < HOLDS]


def _on(family: Family, seeds: np.ndarray) -> np.ndarray:
    """Return which of the seeds (m, n) lie on a traced curve."""
    away = np.array([family.distance(seed) for seed in seeds])
    on = away < ON_POLYLINE
    for i in np.flatnonzero(~on & (away < DOUBTFUL)):
        on[i] = family.contains(seeds[i], 1e-5)
    return on
