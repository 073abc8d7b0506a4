"""Short arms where the six joints they were filled up to are special: other fillings, and the arm's own count."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array, Bits, Bools
from pieper.kinematics.newton import singular_values
from pieper.solver.plan.plan import Plan
from pieper.solver.rows import Flag
from pieper.tolerances import CLEARLY_REGULAR, FILLED_STARTS, SAME_ROW

_DOUBT = np.uint8(int(Flag.DEGENERATE | Flag.UNCERTAIN))
#: What a filling says that gives no rows, and does not say that poses beside have none.
_EDGE = np.uint8(int(Flag.EDGE))


def refilled_rows(plan: Plan, T: Array, q: Array, valid: Bools, flags: Bits) -> tuple[Array, Bools, Bits]:
    """Return rows of poses T (N, 4, 4) with what other fillings say where the first is singular or in doubt.

    All that the arm has at a pose is among the solutions of each filling, with the virtual joints at zero: one filling
    that is certain there tells them all, and where it finds nothing singular there is nothing singular.

    Args:
        plan: Of an arm that is filled up, none of its joints held.
        T: (N, 4, 4).
        q: (N, M, k) the first filling's rows, virtual joints cut off.
        valid: (N, M).
        flags: (N,) bits of `Flag`.
    """
    doubt = flags & _DOUBT
    doubted = np.flatnonzero(doubt)
    if not len(doubted) or not plan.refilled:
        return q, valid, flags
    q, valid, flags = q.copy(), valid.copy(), flags.copy()
    for solver, real in plan.refilled:
        q6, there, _, said = solver.many(np.ascontiguousarray(T[doubted]), 1)
        virtual = np.setdiff1d(np.arange(6), real)
        there &= np.all(np.abs(q6[..., virtual]) < FILLED_STARTS * solver.chain.joints.unit[virtual], axis=-1)
        said = (said & _DOUBT) | ((said & _EDGE) > 0).astype(np.uint8) * np.uint8(int(Flag.DEGENERATE))
        for k in np.flatnonzero(said < doubt[doubted]):
            i = doubted[k]
            rows = np.concatenate([q[i][valid[i]], q6[k][there[k]][:, real]])
            rows = rows[plan.reduction.full.joints.distinct(rows, SAME_ROW)][: q.shape[1]]
            q[i], valid[i] = 0.0, False
            q[i, : len(rows)], valid[i, : len(rows)] = rows, True
            flags[i], doubt[i] = said[k] | (flags[i] & ~_DOUBT), said[k]
        doubted = np.flatnonzero(doubt)
        if not len(doubted):
            break
    return q, valid, flags


def all_by_count(plan: Plan, q: Array, valid: Bools, flags: Bits) -> Bits:
    """Return flags (N,) without doubt where an arm's rows are as many as its own axes allow, and none is singular."""
    doubted = np.flatnonzero(flags & Flag.UNCERTAIN)
    if not len(doubted):
        return flags
    flags, most = flags.copy(), plan.count.most
    for i in doubted[valid[doubted].sum(1) == most]:
        s = singular_values(plan.chain, q[i][valid[i]])
        if most < plan.max_solutions and np.all(s[:, -1] > CLEARLY_REGULAR * s[:, 0]):
            flags[i] &= ~_DOUBT
    return flags
