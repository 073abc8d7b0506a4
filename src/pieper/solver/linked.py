"""Axes that a linkage moves: of what the axes could do by themselves, the postures that the linkage holds.

The joint vectors that take a pose are the chain's solutions whose values follow from the joints' numbers. The axes that
have a joint of their own say these numbers; the others must come out as the coupling says.
"""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.joints import short_way
from pieper.kinematics.newton import missed, newton
from pieper.solver.batch import SolutionBatch
from pieper.solver.plan.plan import Plan
from pieper.solver.results import Solutions, Status, Words
from pieper.solver.rows import Flag, Rows
from pieper.solver.singular.careful import looked_at, near_rows
from pieper.solver.singular.examined import Examined
from pieper.tolerances import CLOSES, LINKAGE_STARTS, SAME_AFTER_CUT

#: Points of a self-motion of the axes from which the postures on it that the linkage holds are looked for.
MOST_STARTS = 64


def held(plan: Plan, values: Array, valid: Bools) -> tuple[Array, Bools]:
    """Return the joint vectors (..., n) of rows of the axes' values (..., axes), and which the linkage holds.

    What is nearly held is moved onto the pose by Newton's method on the arm as it is, and counts where it closes.
    """
    chain = plan.chain
    q = chain.joints.wrapped(chain.numbers(values))
    off = values - q @ np.asarray(chain.coupling).T
    off = np.where(chain.sliding, off / chain.length, short_way(off))
    ok = valid & (np.abs(off).max(-1) < LINKAGE_STARTS)
    if ok.any():
        T = chain.plain.fk(np.ascontiguousarray(values[ok]))
        moved = newton(chain, q[ok], T)
        q[ok] = chain.joints.wrapped(moved)
        ok[ok] = missed(chain, moved, T) < CLOSES
    return q, ok


def rows_of(plan: Plan, rows: Rows) -> Rows:
    """Return rows of the axes' values as rows of the joints' numbers, those that the linkage does not hold left out."""
    q, valid = held(plan, rows.q, rows.valid)
    valid = plan.chain.joints.without_repeats(q, valid, SAME_AFTER_CUT)
    q, inside = plan.chain.joints.inside_limits(q, plan.limits)
    return Rows(np.where(valid[..., None], q, 0.0), valid, inside & valid, rows.flags)


def solutions_of(plan: Plan, words: Words, found: Solutions) -> Solutions:
    """Return the solutions of the arm from those of its axes, which had no limits."""
    q, ok = held(plan, found.all_q, np.ones(len(found.all_q), bool))
    if found.self_motions or (found.multiplicity > 1).any():
        return _looked_at(plan, words, found, q[ok])
    q, slots = q[ok], found.slots[ok]
    keep = plan.chain.joints.distinct(q, SAME_AFTER_CUT)
    q, inside = plan.chain.joints.inside_limits(q[keep], plan.limits)
    return Solutions(plan, words, found.T, q, slots[keep], inside, found.flag)


def _looked_at(plan: Plan, words: Words, found: Solutions, q: Array) -> Solutions:
    """Look at a pose that is singular for the axes: what of their self-motions and merged roots the linkage holds."""
    chain, starts = plan.exact.full, [q]
    for motion in found.self_motions:
        points = motion.samples[:: max(1, len(motion.samples) // MOST_STARTS), : chain.axis_count]
        moved = newton(chain, chain.numbers(points), found.T)
        starts.append(moved[missed(chain, moved, found.T) < CLOSES])
    rows = np.concatenate(starts)
    rows = rows[chain.joints.distinct(rows, SAME_AFTER_CUT)]
    looked = looked_at(plan, found.T, rows, _beside)
    kept, inside = plan.chain.joints.inside_limits(looked.q, plan.limits)
    known = Examined(kept, looked.self_motion, looked.multiplicity, looked.direction, looked.self_motions)
    flag = found.flag & ~int(Flag.OUT_OF_REACH) if len(kept) else found.flag
    return Solutions(plan, words, found.T, kept, np.arange(len(kept)), inside, flag, known, looked.self_motions)


def _beside(plan: Plan, poses: Array) -> Array:
    """Return joint vectors (k, n) to begin at near poses (N, 4, 4), which the linkage need not hold."""
    axes = plan.uncoupled or plan
    return plan.chain.numbers(near_rows(axes, poses)[:, : plan.chain.axis_count])


def batch_of(plan: Plan, found: SolutionBatch) -> SolutionBatch:
    """Return the same of many poses; those that are singular for the axes keep that status until they are looked at."""
    rows, status = rows_of(plan, found.found), found.status.copy()
    plain = (status == Status.SOLVED) | (status == Status.OUTSIDE_LIMITS)
    some, inside = rows.valid.any(1), rows.inside.any(1)
    status[plain & ~some] = Status.OUT_OF_REACH
    status[plain & some & ~inside] = Status.OUTSIDE_LIMITS
    return SolutionBatch(plan, rows, status)
