"""From a plan and poses to results: checked, solved to rows, looked at with care where marked, and handed back."""

from __future__ import annotations

import os
from collections.abc import Mapping
from functools import partial

import numpy as np

from pieper.errors import InputError
from pieper.kinematics.arrays import Array, Bits, Bools
from pieper.kinematics.pose import PoseLike, as_pose, checked_pose
from pieper.solver.arm_rows import arm_rows
from pieper.solver.coupled import batch_of, solutions_of
from pieper.solver.plan.plan import Plan
from pieper.solver.redundant.at_arm_angle import rows_at_arm_angle
from pieper.solver.redundant.choice import ARM_ANGLE, Choice, Redundancy, choice
from pieper.solver.redundant.self_motions import self_motions_of
from pieper.solver.redundant.sweep import best_slice
from pieper.solver.results import SolutionBatch, Solutions, Status, Words
from pieper.solver.rows import Flag, Rows
from pieper.solver.singular.careful import clear, every_solution, overlooked
from pieper.solver.words.closest import closest_to
from pieper.solver.words.labels import labels_beside, posture_words
from pieper.solver.words.why import why
from pieper.tolerances import MOST_CAREFUL, MOST_TRACED

WORDS = Words(why, posture_words, labels_beside, closest_to)
# plain numbers: an IntFlag takes a microsecond to be combined with one
_DEGENERATE, _UNCERTAIN, _OUT_OF_REACH = int(Flag.DEGENERATE), int(Flag.UNCERTAIN), int(Flag.OUT_OF_REACH)
_ROUNDED = int(Flag.ROUNDED)
#: Status codes of a pose without rows, with rows outside the limits alone, and with one inside.
_PLAIN = np.array([Status.OUT_OF_REACH, Status.OUTSIDE_LIMITS, Status.SOLVED], np.uint8)
#: Poses without rows that are asked for their neighbours in one call of the kernel: it bounds memory alone.
LOOKED_AT_ONCE = 4096
_SPARE = np.array([Status.OUT_OF_REACH, Status.OUTSIDE_LIMITS, Status.REDUNDANT], np.uint8)


def ik(plan: Plan, T: PoseLike, redundancy: Redundancy = None) -> Solutions:
    """Return every solution of one pose; see `Arm.ik`."""
    if plan.uncoupled is not None:
        return solutions_of(plan, WORDS, ik(plan.uncoupled, T, redundancy))
    if not plan.direct or redundancy is not None:
        return _ik_through(plan, T, redundancy)
    try:
        q, slots, inside, flag = plan.solver.one(T)  # looks at its pose itself
    except (TypeError, ValueError):
        # lists, integers, poses that are none: the checked route says what is wrong, or makes it right
        T = checked_pose(T)
        q, slots, inside, flag = plan.solver.one(T)
    if flag & _DEGENERATE or not len(q):
        return _careful(plan, checked_pose(T), q, slots, inside, flag)
    return Solutions(plan, WORDS, T, q, slots, inside, flag)


def ik_many(plan: Plan, Ts: PoseLike, threads: int | None = None, redundancy: Redundancy = None) -> SolutionBatch:
    """Return every solution of N poses; see `Arm.ik_many`."""
    if plan.uncoupled is not None:
        return _many_coupled(plan, ik_many(plan.uncoupled, Ts, threads, redundancy), Ts)
    threads, poses, asked = _threads(threads), _plain(plan, Ts, redundancy), None
    try:
        asked = choice(plan, redundancy, len(poses))
        rows = _rows(plan, poses, asked, threads)
    except ValueError:
        if asked is None:
            raise
        poses = _checked(poses)
        rows = _rows(plan, poses, asked, threads)
    if plan.redundancy:
        _choose_elsewhere(plan, poses, rows, asked)
        status = _status_of_spare(plan, poses, rows, asked)
    else:
        status = _look(plan, poses, rows)
    status[(rows.flags & _UNCERTAIN) > 0] = np.uint8(Status.UNCERTAIN)
    return SolutionBatch(plan, rows, status)


def _many_coupled(plan: Plan, found: SolutionBatch, Ts: PoseLike) -> SolutionBatch:
    batch = batch_of(plan, found)
    for i in np.flatnonzero((batch.status == Status.SINGULAR) & ~_any(batch.in_limits)):
        batch.status[i] = ik(plan, _checked(Ts)[i]).status
    return batch


# ---------------------------------------------------------------------------------------------- check


def _plain(plan: Plan, Ts: PoseLike, redundancy: Redundancy) -> Array:
    """Return poses (N, 4, 4) as the solver takes them, unchecked where it looks at them itself."""
    by_value = not (isinstance(redundancy, Mapping) and ARM_ANGLE in redundancy)
    if isinstance(Ts, np.ndarray) and (plan.direct or (plan.immediate and by_value)):
        poses = np.ascontiguousarray(Ts, dtype=np.float64)
        if poses.ndim == 3 and poses.shape[1:] == (4, 4):
            return poses
    return _checked(Ts)


def _checked(Ts: PoseLike) -> Array:
    poses = checked_pose(Ts, "Ts", batch=True)
    if poses.ndim != 3:
        raise InputError(f"Ts must have shape (N, 4, 4), got {poses.shape}.", given=poses.shape)
    return np.ascontiguousarray(poses)


def _threads(threads: int | None) -> int:
    if threads is None:
        return os.cpu_count() or 1
    if not isinstance(threads, (int, np.integer)) or threads < 1:
        raise InputError(
            f"threads must be a whole number of at least 1, or None for all cores, got {threads!r}.", given=threads
        )
    return int(threads)


# ---------------------------------------------------------------------------------------------- rows


def _rows(plan: Plan, poses: Array, asked: Choice, threads: int) -> Rows:
    if plan.direct:
        return Rows(*plan.solver.many(poses, threads))
    if asked.angle is not None and asked.angles is not None:
        return rows_at_arm_angle(plan, asked.angle, poses, asked.angles)
    return arm_rows(plan, poses, asked.values, threads)


def _any(rows: Bools) -> Bools:
    """Return rows.any(1) of bools (N, M), eight at a time where that is possible: this runs once a pose."""
    if rows.shape[1] != 8 or not rows.flags.c_contiguous:
        return rows.any(1)
    return rows.view(np.uint64)[:, 0] != 0


# ---------------------------------------------------------------------------------------------- careful look


def _careful(plan: Plan, T: Array, q: Array, slots: Array, inside: Bools, flag: int) -> Solutions:
    """Look again at a pose that has no rows, or was marked: self-motions, merged roots, what a kernel overlooked."""
    if not flag & _DEGENERATE and (len(q) or not overlooked(plan, T[None])[0]):
        return Solutions(plan, WORDS, T, q, slots, inside, flag)
    return _with_care(plan, T, q, flag)


def _with_care(plan: Plan, T: Array, q: Array, flag: int) -> Solutions:
    """Return all there is at a pose that may be singular, of which rows q (m, n) are known."""
    found = None if clear(plan, q) else every_solution(plan, T, q)
    q, inside = plan.chain.joints.inside_limits(q if found is None else found.q, plan.limits)
    if found is None:
        return Solutions(plan, WORDS, T, q, np.arange(len(q)), inside, flag)
    if len(q):
        flag &= ~_OUT_OF_REACH
    return Solutions(plan, WORDS, T, q, np.arange(len(q)), inside, flag, found, found.self_motions)


def _look(plan: Plan, poses: Array, rows: Rows) -> Bits:
    """Look with care at every pose that needs it, put what is found into this call's rows, and return all statuses."""
    some = _any(rows.valid)
    status = _PLAIN[some.astype(np.uint8) + _any(rows.inside)]
    if some.all() and not rows.flags.any():
        return status
    marked = (rows.flags & _DEGENERATE) > 0
    none = np.flatnonzero(~some & ~marked)
    for first in range(0, len(none), LOOKED_AT_ONCE):
        part = none[first : first + LOOKED_AT_ONCE]
        marked[part] = overlooked(plan, poses[part])
    for i in np.flatnonzero(marked):
        # the same road as `ik`, so that both start from the same digits
        T = checked_pose(poses[i])
        q, _, _, flag = plan.solver.one(T) if plan.direct else rows.of(i)
        found = _with_care(plan, T, q, int(flag) | (int(rows.flags[i]) & _ROUNDED))
        _put(found, rows, i)
        status[i] = found.status
    return status


def _put(found: Solutions, rows: Rows, i: int) -> None:
    """Write one pose's Solutions into this call's rows."""
    count = min(len(found.all_q), rows.q.shape[1])
    rows.q[i], rows.valid[i], rows.inside[i], rows.flags[i] = 0.0, False, False, found.flag
    rows.q[i, :count], rows.valid[i, :count], rows.inside[i, :count] = (
        found.all_q[:count],
        True,
        found.in_limits[:count],
    )


# ---------------------------------------------------------------------------------------------- spare coordinates


def _ik_through(plan: Plan, given: PoseLike, redundancy: Redundancy) -> Solutions:
    """Solve a pose that the arm itself is no six-joint chain for."""
    T = checked_pose(given)
    asked = choice(plan, redundancy, 1)
    q, slots, inside, flag = _rows(plan, T[None], asked, 1).of(0)
    if not np.array_equal(T, np.asarray(as_pose(given), float)):
        flag |= Flag.ROUNDED
    if not plan.redundancy:
        return _careful(plan, T, q, slots, inside, int(flag))
    motions = partial(self_motions_of, plan, T, asked.values[0])
    if asked.free and not inside.any():
        # nobody chose the spare coordinate: any value will do that has an answer
        others, ok, there = best_slice(plan, T)
        if there.any() or (ok.any() and not len(q)):
            q, slots, inside = others[ok], np.flatnonzero(ok), there[ok]
        elif (len(plan.redundancy) > 1 or not ok.any()) and (motions := motions()):
            q = np.array([motion.representative for motion in motions])
            q, inside = plan.chain.joints.inside_limits(q, plan.limits)
            slots = np.arange(len(q))
    return Solutions(plan, WORDS, T, q, slots, inside, int(flag) & ~_DEGENERATE, self_motions=motions)


def _choose_elsewhere(plan: Plan, poses: Array, rows: Rows, asked: Choice) -> None:
    """Choose another value of the spare coordinate where its default, which nobody chose, gives nothing inside."""
    if not asked.free:
        return
    traced, several = 0, len(plan.redundancy) > 1
    for i in np.flatnonzero(~_any(rows.inside))[:MOST_CAREFUL]:
        q, ok, within = best_slice(plan, checked_pose(poses[i]))
        if within.any() or (ok.any() and not rows.valid[i].any()):
            rows.q[i], rows.valid[i], rows.inside[i] = q, ok, within
        elif (several or not ok.any()) and traced < MOST_TRACED:
            traced += 1
            _put(_ik_through(plan, poses[i], None), rows, i)


def _status_of_spare(plan: Plan, poses: Array, rows: Rows, asked: Choice) -> Bits:
    """Return statuses; of poses without rows at the value that was asked for, whether other values have some.

    Poses that follow each other and are equal, as in a sweep over the values, are looked at once.
    """
    some, inside = _any(rows.valid), _any(rows.inside)
    status = _SPARE[some.astype(np.uint8) + inside]
    none = ~some & ((rows.flags & _UNCERTAIN) == 0)
    if asked.free or not none.any():
        return status
    run = np.concatenate([[0], np.cumsum((poses[1:] != poses[:-1]).any((1, 2)))])
    within, anywhere = np.bincount(run, weights=inside) > 0, np.bincount(run, weights=some) > 0
    for k in np.unique(run[none & ~within[run]])[:MOST_CAREFUL]:
        _, found, there = best_slice(plan, checked_pose(poses[np.argmax(run == k)]))
        within[k], anywhere[k] = there.any(), anywhere[k] or found.any()
    status[none] = _SPARE[anywhere.astype(np.uint8) + within][run[none]]
    return status
