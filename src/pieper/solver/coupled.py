"""Coupled joints: what the chain was solved to, said in the joints' own numbers, limits applied to those."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array, Bools
from pieper.solver.batch import SolutionBatch
from pieper.solver.plan.plan import Plan
from pieper.solver.results import Solutions, Status, Words
from pieper.solver.rows import Rows
from pieper.solver.singular.examined import Examined
from pieper.solver.singular.self_motion import SelfMotion
from pieper.solver.singular.traced_motion import TracedMotion


def solutions_of(plan: Plan, words: Words, found: Solutions) -> Solutions:
    """Return the solutions of a coupled arm from those of its chain, which had no limits."""
    if plan.chain.linked:
        from pieper.solver import linked

        return linked.solutions_of(plan, words, found)
    q, inside = in_joints(plan, found.all_q)
    motions = tuple(_motion(plan, motion) for motion in found.self_motions)
    unit = plan.chain.joints.unit
    direction = plan.chain.numbers(found.direction * unit) / unit
    size = np.linalg.norm(direction, axis=1, keepdims=True)
    examined = Examined(q, found.in_self_motion, found.multiplicity, direction / np.where(size > 0, size, 1.0), motions)
    return Solutions(plan, words, found.T, q, found.slots, inside, found.flag, examined, motions)


def batch_of(plan: Plan, found: SolutionBatch) -> SolutionBatch:
    """Return the same of many poses; a pose of which only a self-motion may lie inside keeps its status."""
    if plan.chain.linked:
        from pieper.solver import linked

        return linked.batch_of(plan, found)
    rows = rows_of(plan, found.found)
    status = found.status.copy()
    status[(status == Status.SOLVED) & ~rows.inside.any(1)] = Status.OUTSIDE_LIMITS
    return SolutionBatch(plan, rows, status)


def rows_of(plan: Plan, rows: Rows) -> Rows:
    """Return rows of the chain's values as rows of the joints' numbers."""
    if plan.chain.linked:
        from pieper.solver import linked

        return linked.rows_of(plan, rows)
    q, inside = in_joints(plan, rows.q)
    return Rows(np.where(rows.valid[..., None], q, 0.0), rows.valid, inside & rows.valid, rows.flags)


def in_joints(plan: Plan, values: Array) -> tuple[Array, Bools]:
    """Return joint vectors (..., n) at chain values (..., n), angles as results have them, and which are inside."""
    joints = plan.chain.joints
    return joints.inside_limits(joints.wrapped(plan.chain.numbers(values)), plan.limits)


def _motion(plan: Plan, motion: SelfMotion) -> SelfMotion:
    chain = plan.reduction.full
    free = np.tile([-np.inf, np.inf], (chain.n - plan.n, 1))
    limits, points = np.vstack([plan.limits, free]), chain.numbers(motion.samples)
    return TracedMotion(chain, motion.T, points, motion.closed, motion.dimension, limits, motion.names, motion.shown)
