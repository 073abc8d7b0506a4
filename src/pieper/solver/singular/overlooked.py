"""Which poses without solutions have some all the same, or poses beside them do: singular ones, the edge of reach."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.newton import at_least_as_strong, newton_and_miss, singular_values
from pieper.solver.plan.plan import Plan
from pieper.solver.rows import Flag
from pieper.solver.singular.examine import SLOW_STEPS, side_steps
from pieper.tolerances import ALONG_FIRST_AXIS, CAREFUL_ASIDE, CLOSES, NEARLY_ZERO, PLAIN_MISS


def overlooked(plan: Plan, poses: Array) -> Bools:
    """Return which poses (N, 4, 4) without solutions have neighbours with some (N,).

    They may be singular, or lie at the edge of reach. Of an arm that is filled up nearly every pose has some, with
    virtual joints far from zero: those count that have them nearly there, or where the solver marks what it gives, of
    the poses themselves too, and however it is filled up.
    """
    aside = side_steps(plan.chain, poses, (CAREFUL_ASIDE,))
    found = _on_first_axis(plan, poses)
    if not plan.refilled:
        valid = plan.solver.many(np.ascontiguousarray(aside.reshape(-1, 4, 4)), 1)[1]
        return found | np.any(valid.reshape(len(poses), -1), axis=1)
    every = np.ascontiguousarray(np.concatenate([poses[:, None], aside], 1).reshape(-1, 4, 4))
    for solver, real in ((plan.solver, plan.reduction.real), *plan.refilled):
        q, valid, _, flags = solver.many(every, 1)
        virtual = np.setdiff1d(np.arange(6), real)
        off = np.abs(q[..., virtual] / solver.chain.joints.unit[virtual]).max(-1)
        marked = (flags & (Flag.DEGENERATE | Flag.UNCERTAIN)) > 0
        leads = valid & ((off < NEARLY_ZERO) | marked[:, None])
        plain = leads & ~marked[:, None]
        pose = np.nonzero(plain)[0] // (1 + aside.shape[1])
        leads[plain] = _merge(plan, q[plain][:, real], poses[pose], off[plain] + CAREFUL_ASIDE)
        found |= np.any(leads.reshape(len(poses), -1), axis=1)
    return found


def _merge(plan: Plan, q: Array, T: Array, off: Array) -> Bools:
    """Return which postures q (k, n) are so near to where two merge that their poses T (k, 4, 4) may have them (k,).

    Farther away a posture that misses the pose by so little has no solution near it but its own, and that has been
    looked for. They miss it by no more than `off` (k,); by less, where they are moved onto it.
    """
    full = plan.exact.full
    out = off > PLAIN_MISS * at_least_as_strong(full, q) ** 2
    some = np.flatnonzero(out)
    if not len(some):
        return out
    moved, left = newton_and_miss(full, q[some], T[some], steps=SLOW_STEPS)
    s = singular_values(full, moved)
    out[some] = (left < CLOSES) | (left > PLAIN_MISS * (s[:, -1] / s[:, 0]) ** 2)
    return out


def _on_first_axis(plan: Plan, poses: Array) -> Bools:
    """Return which positions of poses (N, 4, 4) lie on the axis of a first joint that turns (N,).

    That joint may stand anywhere there. Where the arm reaches one height on the axis alone it reaches a cone's outside
    around it, which may be so flat that no pose beside has a solution.
    """
    chain = plan.exact.full
    if plan.task != "position" or chain.prismatic[0]:
        return np.zeros(len(poses), bool)
    point, axis = chain.points[0], chain.axes[0]
    away = poses[:, :3, 3] - point
    across = np.linalg.norm(np.cross(away, axis), axis=1)
    return across <= ALONG_FIRST_AXIS * (np.linalg.norm(away, axis=1) + np.linalg.norm(point))
