"""Whether a snapped arm has as many solutions as its nominal one at a pose; where that is in doubt, the arm itself."""

from __future__ import annotations

import numpy as np

from pieper.errors import PlanError
from pieper.kinematics.arrays import Array, Bools, Indices
from pieper.kinematics.newton import singular_values
from pieper.kinematics.pose import stepped
from pieper.solver.kernel_rows import Solved, kernel_rows, without_repeats
from pieper.solver.plan.plan import Plan
from pieper.solver.rows import Flag
from pieper.tolerances import FILLED_STARTS, NO_MORE_THAN_TYPED, PAIRED

#: How far from the pose the nominal arm's count is looked at, in multiples of how far the two arms differ: a double
#: cross of twelve poses so far away encloses the ball that the difference may lead to.
MARGIN = 3.0
#: Poses whose surroundings are looked at in one go: it bounds the memory.
CHUNK = 4096


def in_doubt(plan: Plan, T: Array, values: Array, count: Indices) -> Bools:
    """Return (N,) bool: poses T (N, 4, 4) near which the nominal arm has another count of solutions than count (N,)."""
    size = MARGIN * plan.drift
    twists = np.concatenate([size * np.eye(6), -size * np.eye(6)])
    doubt = np.zeros(len(T), bool)
    for first in range(0, len(T), CHUNK):
        part = slice(first, first + CHUNK)
        beside = np.concatenate([stepped(T[part], np.tile(w, (len(T[part]), 1)), plan.chain.length) for w in twists])
        values_beside = np.tile(values[part], (len(twists), 1))
        counts = kernel_rows(plan, beside, values_beside, 1).valid.sum(1).reshape(len(twists), -1)
        doubt[part] = (counts != count[part]).any(0)
    return doubt


def _nearly_singular(plan: Plan, q: Array, valid: Bools) -> Bools:
    """Return (N,) bool: poses with a row among q (N, M, n) so nearly singular that the two arms' rows need not pair.

    Newton's method leads one arm's row to one row of the other where its first step, the drift over sigma, is short
    beside sigma: else one of them may have a curve, or none, where the other has a few.
    """
    out = np.zeros(len(q), bool)
    pose, slot = np.nonzero(valid)
    s = singular_values(plan.exact.full, q[pose, slot])
    out[pose[s[:, -1] ** 2 < PAIRED * plan.drift * s[:, 0] ** 2]] = True
    return out


def exact_rows(plan: Plan, T: Array, values: Array) -> tuple[Array, bool]:
    """Return the rows (m, n) of one pose (4, 4) of the arm as described, and whether they are certainly all."""
    reduction = plan.exact
    # one kernel serves all values of joints locked at the ends
    try:
        solver = plan.exact_solvers.at(() if reduction.at_ends is not None else tuple(values))
    except PlanError:
        return np.zeros((0, reduction.full.n)), False
    pose = reduction.moved_pose(T[None], values[None])
    q6, valid, _, flags = solver.many(np.ascontiguousarray(pose), 1)
    q6 = q6[0][valid[0]]
    if reduction.fill:
        unit = np.array([plan.chain.length if p else 1.0 for _, p in reduction.fill])
        q6 = q6[(np.abs(q6[:, reduction.filled] / unit) < FILLED_STARTS).all(-1)]
    rows = np.zeros((len(q6), reduction.full.n))
    rows[:, reduction.kept] = q6[:, reduction.real]
    rows[:, list(reduction.locked)] = values
    return rows, not int(flags[0]) & Flag.UNCERTAIN


def counted(plan: Plan, T: Array, values: Array, polished: Solved, nominal: Indices) -> Solved:
    """Compare the refined rows with the nominal arm's and, where the counts may differ, with the arm's own.

    Args:
        plan: A snapped plan.
        T: (N, 4, 4).
        values: (N, k) of the locked joints.
        polished: Rows refined on the arm as described.
        nominal: (N,) number of the nominal arm's solutions.

    Returns:
        Rows, at least `max_solutions` a pose: where a pair of solutions lies between the nominal arm and the true one,
        those of the true one with the flags UNCERTAIN and COUNT_CHANGES.
    """
    room = max(0, plan.max_solutions - polished.q.shape[1])
    full, valid = np.pad(polished.q, ((0, 0), (0, room), (0, 0))), np.pad(polished.valid, ((0, 0), (0, room)))
    flags = polished.flags.copy()
    if plan.reduction.fill:
        # the nominal arm's rows are those that come near to filling with zero: only the refined ones can be counted
        nominal, doubt = valid.sum(1), np.ones(len(T), bool)
    else:
        doubt = (valid.sum(1) != nominal) | in_doubt(plan, T, values, nominal)
        if plan.drift > NO_MORE_THAN_TYPED:
            doubt |= nominal == 0
    doubt |= _nearly_singular(plan, full, valid)
    for i in np.flatnonzero(doubt):
        rows, certain = exact_rows(plan, T[i], values[i])
        both = np.concatenate([full[i][valid[i]], rows])
        both = both[without_repeats(plan.exact.full, both[None], np.ones((1, len(both)), bool))[0]][: full.shape[1]]
        if certain and len(both) == nominal[i] == valid[i].sum():
            continue
        full[i], valid[i] = 0.0, False
        full[i, : len(both)], valid[i, : len(both)] = both, True
        flags[i] |= Flag.UNCERTAIN | (Flag.COUNT_CHANGES if len(both) != nominal[i] else 0)
    return Solved(full, valid, flags)
