"""The careful look for any plan without spare joints: short arms and partial tasks through their virtual joints."""

from __future__ import annotations

import numpy as np

from pieper.solver.families import named
from pieper.solver.plan.plan import Plan
from pieper.solver.results import TURN
from pieper.solver.singular.examine import Examined, examine
from pieper.solver.singular.selfmotion import Family


def near_rows(plan: Plan, poses: np.ndarray) -> np.ndarray:
    """Return the joint vectors (m, k) of all solutions of poses (N, 4, 4), the task's virtual joints included.

    Virtual joints that must come out as zero may have any value: on a singularity of the six-joint chain they are free.
    """
    return plan.solver.all_rows(poses)[:, : 6 - len(plan.reduction.fill)]


def every_solution(plan: Plan, T: np.ndarray, rows: np.ndarray) -> Examined:
    """Return all there is at a pose, of the arm's own joints.

    Args:
        plan: A plan without spare joints.
        T: (4, 4).
        rows: (k, n) solutions already known.
    """
    full = plan.exact.full
    # closed forms lose nothing next to a self-motion: only what an elimination gives is searched for more
    hiding = named(plan.family).eliminating
    if full.n == plan.n:
        return examine(full, T, rows, lambda poses: near_rows(plan, poses), plan.limits, plan.names, hiding=hiding)
    # values of the virtual joints are not known of given rows: all are solved for again
    found = examine(
        full,
        T,
        near_rows(plan, T[None]),
        lambda poses: near_rows(plan, poses),
        plan.full_limits,
        plan.full_names,
        shown=plan.n,
        hiding=hiding,
    )
    return _own(plan, found)


def _own(plan: Plan, found: Examined) -> Examined:
    """Cut the virtual joints off: families that move only those are points, and points that differ in them are one."""
    moving = [i for i, family in enumerate(found.families) if family.free]
    families: tuple[Family, ...] = tuple(found.families[i] for i in moving)
    index = np.array([moving.index(i) if i in moving else -1 for i in found.family], int)
    keep: list[int] = []
    for i in range(len(found.q)):
        gap = found.q[keep, : plan.n] - found.q[i, : plan.n]
        gap = np.where(plan.prismatic, gap / plan.chain.length, (gap + np.pi) % TURN - np.pi)
        if not np.any(np.abs(gap).max(-1, initial=0.0) < 1e-6):
            keep.append(i)
    return Examined(
        found.q[keep, : plan.n], index[keep], found.multiplicity[keep], found.direction[keep, : plan.n], families
    )
