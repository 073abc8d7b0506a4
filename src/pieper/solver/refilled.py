"""Short arms where the six joints they were filled up to are special: other fillings, and the arm's own count."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array, Bits, Bools, Indices
from pieper.kinematics.joints import JointSpace
from pieper.kinematics.newton import singular_values
from pieper.solver.plan.plan import Plan
from pieper.solver.rows import Flag
from pieper.tolerances import CLEARLY_REGULAR, FILLED_STARTS, SAME_ROW

_DOUBT = np.uint8(int(Flag.DEGENERATE | Flag.UNCERTAIN))
#: What a filling says that gives no rows, and does not say that poses beside have none.
_EDGE = np.uint8(int(Flag.EDGE))
#: What it says where it gives none at all.
_NONE = np.uint8(int(Flag.OUT_OF_REACH | Flag.EDGE))


def refilled_rows(
    plan: Plan, T: Array, values: Array, q: Array, valid: Bools, flags: Bits
) -> tuple[Array, Bools, Bits]:
    """Return rows of poses T (N, 4, 4) with what other fillings say where the first is singular or in doubt.

    All that the arm has at a pose is among the solutions of each filling, with the virtual joints at zero: one filling
    that is certain there tells them all, and where it finds nothing singular there is nothing singular.

    Args:
        plan: Of an arm that is filled up.
        T: (N, 4, 4).
        values: (N, l) of its locked joints.
        q: (N, M, k) the first filling's rows, locked and virtual joints cut off.
        valid: (N, M).
        flags: (N,) bits of `Flag`.
    """
    doubted = np.flatnonzero(flags & _DOUBT)
    if not len(doubted):
        return q, valid, flags
    q, valid, flags = q.copy(), valid.copy(), flags.copy()
    distinct, which = np.unique(values[doubted], axis=0, return_inverse=True)
    for k, value in enumerate(distinct):
        _refilled(plan, T, value, doubted[which.reshape(-1) == k], q, valid, flags)
    return q, valid, flags


def _refilled(plan: Plan, T: Array, value: Array, doubted: Indices, q: Array, valid: Bools, flags: Bits) -> None:
    """Put into rows and flags what other fillings say of doubted poses with the locked joints at value (l,)."""
    full, kept = plan.reduction.full, plan.reduction.kept
    joints = JointSpace(full.prismatic[kept], full.length) if plan.reduction.locked else full.joints
    doubt = flags & _DOUBT
    for solver, real in plan.refilled_at(value):
        q6, there, _, said = solver.many(np.ascontiguousarray(T[doubted]), 1)
        virtual = np.setdiff1d(np.arange(6), real)
        there &= np.all(np.abs(q6[..., virtual]) < FILLED_STARTS * solver.chain.joints.unit[virtual], axis=-1)
        said = (said & _DOUBT) | ((said & _EDGE) > 0).astype(np.uint8) * np.uint8(int(Flag.DEGENERATE))
        for k in np.flatnonzero(said < doubt[doubted]):
            i = doubted[k]
            rows = np.concatenate([q[i][valid[i]], q6[k][there[k]][:, real]])
            rows = rows[joints.distinct(rows, SAME_ROW)][: q.shape[1]]
            q[i], valid[i] = 0.0, False
            q[i, : len(rows)], valid[i, : len(rows)] = rows, True
            was = flags[i] & ~(_DOUBT | _NONE) if len(rows) else flags[i] & ~_DOUBT
            flags[i], doubt[i] = said[k] | was, said[k]
        doubted = doubted[doubt[doubted] > 0]
        if not len(doubted):
            break


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
