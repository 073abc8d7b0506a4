"""From a plan and poses to results: checked, solved to rows, looked at with care where marked, and handed back."""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from pieper import arguments
from pieper.errors import InputError
from pieper.kinematics.arrays import Array, ArrayLike, Bits, Bools, Slots
from pieper.kinematics.pose import PoseLike, as_pose, checked_pose, is_exact
from pieper.solver.afar import goes_far, one_from_afar, rows_from_afar
from pieper.solver.batch import SolutionBatch
from pieper.solver.batches import (
    BLOCK,
    LARGE_BLOCK,
    Near,
    Progress,
    after,
    arrays_of,
    finished,
    joined,
    marking,
    near_what,
    straightened,
    tell,
    without_refused,
)
from pieper.solver.beyond import DOUBTS, beyond, refuse_too_far, too_far, without_denied, without_doubt
from pieper.solver.plan.plan import Plan
from pieper.solver.redundant.at_values import rows_at_choice
from pieper.solver.redundant.choice import Choice, Redundancy, choice, nothing_chosen
from pieper.solver.results import Solutions, Status, Words
from pieper.solver.rows import Flag, Rows, any_row
from pieper.solver.words.closest import closest_to
from pieper.solver.words.labels import labels_beside, posture_words
from pieper.solver.words.table import table
from pieper.solver.words.why import why

# what looks with care, or along spare joints, is imported when it is needed: most calls never do
WORDS = Words(why, table, posture_words, labels_beside, closest_to)
# plain numbers: an IntFlag takes a microsecond to be combined with one
_DEGENERATE, _UNCERTAIN, _OUT_OF_REACH = int(Flag.DEGENERATE), int(Flag.UNCERTAIN), int(Flag.OUT_OF_REACH)
_ROUNDED, _EDGE = int(Flag.ROUNDED), int(Flag.EDGE)
_DOUBTFUL = _DEGENERATE | _UNCERTAIN
_SLOTS = np.arange(256)
#: Status codes of a pose without rows, with rows outside the limits alone, and with one inside.
_PLAIN = np.array([Status.OUT_OF_REACH, Status.OUTSIDE_LIMITS, Status.SOLVED], np.uint8)
#: Poses without rows that are asked for their neighbours in one call of the kernel: it bounds memory alone.
LOOKED_AT_ONCE = 4096
_SPARE = np.array([Status.OUT_OF_REACH, Status.OUTSIDE_LIMITS, Status.REDUNDANT], np.uint8)


def ik(plan: Plan, T: PoseLike, redundancy: Redundancy = None) -> Solutions:
    """Return every solution of one pose; see `Arm.ik`."""
    if plan.uncoupled is not None:
        from pieper.solver.coupled import solutions_of

        return solutions_of(plan, WORDS, ik(plan.uncoupled, T, redundancy))
    if not plan.direct or redundancy is not None:
        return _ik_through(plan, T, redundancy)
    pose: Any = T
    try:
        q, slots, inside, flag = plan.solver.one(pose)  # looks at its pose itself
    except (TypeError, ValueError):
        # lists, integers, poses that are none: the checked route says what is wrong, or makes it right
        pose = checked_pose(T)
        q, slots, inside, flag = plan.solver.one(pose)
    if not len(q) or (plan.slides and too_far(pose)):
        pose = checked_pose(pose)  # the kernel refuses no place, however far
    if (flag & (_DOUBTFUL | _EDGE) or not len(q)) and (far := one_from_afar(plan, np.asarray(pose, float), ik)):
        return far[0]
    if flag & (_DOUBTFUL | _EDGE):
        found = _read(plan, pose, q, flag & ~_EDGE)  # of no rows inside, it is false as a sequence
        return _careful(plan, checked_pose(pose), q, slots, inside, flag) if found is None else found
    return Solutions(plan, WORDS, pose, q, slots, inside, flag)


def ik_many(
    plan: Plan,
    Ts: PoseLike,
    threads: int | None = None,
    redundancy: Redundancy = None,
    *,
    near: ArrayLike | str | None = None,
    start: ArrayLike | None = None,
    weights: ArrayLike | None = None,
    invalid: str = "raise",
    out: SolutionBatch | None = None,
    progress: Progress | None = None,
) -> SolutionBatch:
    """Return every solution of N poses; see `Arm.ik_many`."""
    threads = _threads(threads)
    poses, refused = without_refused(Ts) if marking(invalid) else (_plain(Ts), None)
    near_by = near_what(plan, near, start, weights, len(poses))
    arguments.told(progress)
    told = None if progress is None else partial(tell, progress, len(poses))
    solve = partial(_solved, plan, threads=threads, redundancy=redundancy, near=near_by, out=out, told=told)
    try:
        found = solve(poses)
    except InputError:
        # the checked road's words for what is no pose; or it is one, but for rounding
        found = solve(_checked(poses))
    if told is not None:
        told(len(poses))
    return finished(found, near_by, refused)


def _solved(
    plan: Plan,
    poses: Array,
    *,
    threads: int,
    redundancy: Redundancy,
    near: Near | None,
    out: SolutionBatch | None,
    told: Callable[[int], None] | None,
) -> SolutionBatch:
    if plan.uncoupled is not None:
        found = _many_coupled(plan, ik_many(plan.uncoupled, poses, threads, redundancy), poses)
        return joined(plan, [found], out, near)
    asked = choice(plan, redundancy, len(poses))
    if plan.direct:
        whole = arrays_of(plan, out, len(poses), plan.max_solutions, near)
        size = max(len(poses), 1) if told is None else LARGE_BLOCK
        for first in range(0, len(poses), size):
            at = slice(first, first + size)
            by = None if near is None else near.part(at)
            _into(plan, poses[at], threads, whole.part(at), by, None if told is None else partial(after, told, first))
        return whole
    if isinstance(out, SolutionBatch):
        arrays_of(plan, out, len(poses), out.q.shape[-2], near)  # what is wrong with it is said before the work
    poses, rounded = straightened(poses)
    parts: list[SolutionBatch] = []
    for first in range(0, max(len(poses), 1), BLOCK):
        at = slice(first, first + BLOCK)
        parts.append(_through(plan, poses[at], rounded[at], asked.part(at), threads))
        if told is not None:
            told(min(first + BLOCK, len(poses)))
    return joined(plan, parts, out, near)


def _into(
    plan: Plan,
    poses: Array,
    threads: int,
    into: SolutionBatch,
    near: Near | None,
    told: Callable[[int], None] | None,
) -> None:
    """Solve poses of an arm that is its own six-joint chain; rows are chosen while the kernel has them at hand."""
    rows, outcome, chosen = into.found, np.empty(len(poses), np.uint8), None if near is None else into.chosen
    by = (
        (None,) * 4
        if near is None or chosen is None or near.to is None
        else (near.select, near.to, chosen.q, chosen.found)
    )
    plan.solver.into(poses, threads, rows.q, rows.valid, rows.inside, rows.flags, outcome, *by, told)
    np.take(_PLAIN, outcome, out=into.status, mode="clip")
    unclear = np.flatnonzero(rows.flags | (outcome == 0))
    if not goes_far(plan):
        unclear = without_denied(poses, rows.flags, unclear)
    if not len(unclear):
        return
    if len(unclear) < len(poses):
        # by themselves: for one among many the arrays of all would be gone through again and again
        part, some = rows.part(unclear), np.ascontiguousarray(poses[unclear])
        refuse_too_far(poses, unclear[~any_row(part.valid)])
        into.status[unclear] = _looked_at(plan, some, part)
        rows.put(unclear, part)
    else:
        refuse_too_far(poses, unclear[~any_row(rows.valid)])
        into.status[:] = _looked_at(plan, poses, rows)
    if near is not None and chosen is not None:
        near.choose_again(rows, unclear, chosen)


def _through(plan: Plan, poses: Array, rounded: Bools, asked: Choice, threads: int) -> SolutionBatch:
    """Solve poses of an arm or a task that became a six-joint chain, some of which were rounded."""
    rows, of_rounded = rows_at_choice(plan, poses, asked, threads, _alone), np.uint8(_ROUNDED) * rounded
    rows.flags[:] |= of_rounded
    if plan.redundancy:
        without_doubt(plan, poses, rows)
        rows, status = _spare(plan, poses, rows, asked, threads)
        rows.flags[:] = (rows.flags & np.uint8(255 ^ (_EDGE | _DEGENERATE))) | of_rounded
        status[(rows.flags & _UNCERTAIN) > 0] = np.uint8(Status.UNCERTAIN)
    else:
        refuse_too_far(poses, np.flatnonzero(~any_row(rows.valid)))
        status = _looked_at(plan, poses, rows)
    return SolutionBatch(plan, rows, status)


def _many_coupled(plan: Plan, found: SolutionBatch, poses: Array) -> SolutionBatch:
    from pieper.solver.coupled import batch_of

    batch = batch_of(plan, found)
    if plan.chain.linked:
        # what the linkage holds of the axes' self-motions, and of merged roots, is looked at pose by pose
        for i in np.flatnonzero((batch.status == Status.SINGULAR) | ((batch.found.flags & _DEGENERATE) > 0)):
            one = ik(plan, poses[i])
            batch.found.put_one(int(i), one.all_q, one.in_limits, one.flag)
            batch.status[i] = one.status
        return batch
    for i in np.flatnonzero((batch.status == Status.SINGULAR) & ~any_row(batch.in_limits)):
        batch.status[i] = ik(plan, poses[i]).status
    return batch


# ---------------------------------------------------------------------------------------------- check


def _plain(Ts: PoseLike) -> Array:
    """Return poses (N, 4, 4) as they were given where they are an array of that shape: unchecked then."""
    given = Ts
    if isinstance(given, np.ndarray):
        poses = np.ascontiguousarray(arguments.numbers(given, "Ts", "(N, 4, 4)"))
        if poses.ndim == 3 and poses.shape[1:] == (4, 4):
            return poses
    return _checked(Ts)


def _checked(Ts: PoseLike) -> Array:
    poses = checked_pose(Ts, "Ts", batch=True)
    if poses.ndim != 3:
        hint = " For a single pose write Ts[None], or ask ik." if poses.ndim == 2 else ""
        raise InputError(f"Ts must have shape (N, 4, 4), got {poses.shape}.{hint}", given=poses.shape)
    return np.ascontiguousarray(poses)


def _threads(threads: Any) -> int:
    return os.cpu_count() or 1 if threads is None else arguments.whole(threads, "threads (None for all cores)", 1)


# ---------------------------------------------------------------------------------------------- rows


def _alone(plan: Plan, poses: Array, threads: int) -> Rows:
    """Return the rows of an arm without spare coordinates, looked at with care."""
    return ik_many(plan, poses, threads).found


# ---------------------------------------------------------------------------------------------- careful look


def _read(plan: Plan, pose: Array, q: Array, flag: int) -> Solutions | None:
    """Return all there is at a pose where that can be read off the axes of its rows."""
    read = plan.solver.read(pose, q, flag)
    if read is None or (read.self_motions and not (plan.spec.closed_form or read.inside.any())):
        return None  # a curve that was followed may pass the limits between its points
    from pieper.solver.singular.read_off import crowded, examined

    if not read.self_motions and crowded(plan, pose, read.q):
        return None
    T = checked_pose(pose) if read.flag & _ROUNDED else pose
    found = examined(plan, T, read)
    return Solutions(plan, WORDS, T, read.q, _SLOTS[: len(read.q)], read.inside, read.flag, found, found.motions)


def _careful(plan: Plan, T: Array, q: Array, slots: Slots, inside: Bools, flag: int) -> Solutions:
    """Look again at a pose that has no rows, or was marked: self-motions, merged roots, what a kernel overlooked."""
    from pieper.solver.singular.careful import sure_beside
    from pieper.solver.singular.overlooked import overlooked

    if not len(q) and beyond(plan, T[None])[0]:
        return Solutions(plan, WORDS, T, q, slots, inside, flag & ~DOUBTS)
    if not flag & _DEGENERATE:
        doubted = bool(flag & _UNCERTAIN) and bool(sure_beside(plan, T[None])[0])
        if not doubted and (len(q) or not overlooked(plan, T[None])[0]):
            return Solutions(plan, WORDS, T, q, slots, inside, flag & ~_EDGE)
    return _with_care(plan, T, q, flag)


def _with_care(plan: Plan, T: Array, q: Array, flag: int) -> Solutions:
    """Return all there is at a pose that may be singular, of which rows q (m, n) are known."""
    from pieper.solver.singular.careful import all_there, clear, every_solution, settled, with_arms_beside

    flag, q = flag & ~_EDGE, with_arms_beside(plan, T, q)
    if flag & _DOUBTFUL and all_there(plan, T, q, flag):
        q, inside = plan.chain.joints.inside_limits(q, plan.limits)
        return Solutions(plan, WORDS, T, q, np.arange(len(q)), inside, flag & ~_DOUBTFUL)
    found = None if clear(plan, q) else every_solution(plan, T, q)
    q, inside = plan.chain.joints.inside_limits(q if found is None else found.q, plan.limits)
    if found is None:
        return Solutions(plan, WORDS, T, q, np.arange(len(q)), inside, flag)
    if len(q):
        flag &= ~_OUT_OF_REACH
    flag = settled(plan, T, found, flag)
    return Solutions(plan, WORDS, T, q, np.arange(len(q)), inside, flag, found, found.self_motions)


def _looked_at(plan: Plan, poses: Array, rows: Rows) -> Bits:
    """Take the doubt off what is beyond reach, look with care at every pose that needs it, and return all statuses."""
    without_doubt(plan, poses, rows)
    status = _look(plan, poses, rows)
    status[(rows.flags & _UNCERTAIN) > 0] = np.uint8(Status.UNCERTAIN)
    return status


def _look(plan: Plan, poses: Array, rows: Rows) -> Bits:
    """Look with care at every pose that needs it, put what is found into this call's rows, and return all statuses."""
    some = any_row(rows.valid)
    status = _PLAIN[some.astype(np.uint8) + any_row(rows.inside)]
    if some.all() and not rows.flags.any():
        return status
    from pieper.solver.singular.careful import sure_beside
    from pieper.solver.singular.overlooked import overlooked
    from pieper.solver.singular.read_off import crowded

    near = rows_from_afar(plan, poses, rows, status, ik_many)
    marked = near & ((rows.flags & _DEGENERATE) > 0)
    # a kernel that gives no rows says whether poses beside have none; of a chain within another that says nothing
    edge = near & ((rows.flags & _EDGE) > 0 if plan.direct else ~some)
    rows.flags[:] = rows.flags & np.uint8(255 ^ _EDGE)
    doubted = near & ((rows.flags & _DOUBTFUL) == _UNCERTAIN)
    for ask, which in ((sure_beside, doubted), (overlooked, edge)):
        index = np.flatnonzero(which & ~marked)
        for first in range(0, len(index), LOOKED_AT_ONCE):
            part = index[first : first + LOOKED_AT_ONCE]
            marked[part] = ask(plan, _checked(poses[part]))
    index = np.flatnonzero(marked)
    if plan.direct:
        read = plan.solver.read_into(poses, index, rows)
        if not plan.spec.closed_form:
            read[(read == 2) & ~any_row(rows.inside[index])] = 0  # as in `_read`
            read[read == 1] = [not crowded(plan, poses[i], rows.of(i)[0]) for i in index[read == 1].tolist()]
        seen, curve = index[read > 0], index[read == 2]
        status[seen] = _PLAIN[1 + any_row(rows.inside[seen])]
        status[curve[any_row(rows.inside[curve])]] = np.uint8(Status.SINGULAR)
        index = index[read == 0]
    for i in index.tolist():
        # the same road as `ik`, so that both start from the same digits
        q, _, _, flag = plan.solver.one(poses[i]) if plan.direct else rows.of(i)
        found = _with_care(plan, checked_pose(poses[i]), q, int(flag) | (int(rows.flags[i]) & _ROUNDED))
        rows.put_one(i, found.all_q, found.in_limits, found.flag)
        status[i] = found.status
    return status


# ---------------------------------------------------------------------------------------------- spare coordinates


def _ik_through(plan: Plan, given: PoseLike, redundancy: Redundancy) -> Solutions:
    """Solve a pose that the arm itself is no six-joint chain for."""
    from pieper.solver.redundant.elsewhere import choose_elsewhere
    from pieper.solver.redundant.self_motions import self_motions_of

    if plan.direct and nothing_chosen(redundancy):
        return ik(plan, given)
    T = checked_pose(given)
    asked = choice(plan, redundancy, 1)
    rows = rows_at_choice(plan, T[None], asked, 1, _alone)
    without_doubt(plan, T[None], rows)
    q, slots, inside, flag = rows.of(0)
    if not is_exact(given) and not np.array_equal(T, np.asarray(as_pose(given), float)):
        flag |= _ROUNDED
    if (flag & _DOUBTFUL or not len(q)) and (far := one_from_afar(plan, T, ik)):
        return far[0]
    if not plan.redundancy:
        return _careful(plan, T, q, slots, inside, int(flag))
    some = True
    if asked.free and not np.count_nonzero(inside):
        rows, (some,) = choose_elsewhere(plan, T[None], rows, 1)
        q, slots, inside, there = rows.of(0)
        flag = there | (flag & _ROUNDED)
    motions = partial(self_motions_of, plan, T, plan.defaults, ik, q) if some else ()
    if asked.free and np.count_nonzero(inside):
        flag &= ~_UNCERTAIN  # of rows at a value that nobody chose nobody was told that they are all
    return Solutions(asked.plan, WORDS, T, q, slots, inside, flag & ~(_DEGENERATE | _EDGE), None, motions, asked.names)


def _spare(plan: Plan, poses: Array, rows: Rows, asked: Choice, threads: int) -> tuple[Rows, Bits]:
    """Choose another value of the spare coordinates where nobody chose, and return statuses.

    Of poses without rows at a value that was asked for it is said whether other values have some; poses that follow
    each other and are equal, as in a sweep over the values, are looked at once.
    """
    from pieper.solver.redundant.anywhere import anywhere
    from pieper.solver.redundant.elsewhere import choose_elsewhere

    if asked.free:
        none = np.flatnonzero(~any_row(rows.inside))
        if len(none):
            rows, _ = choose_elsewhere(plan, _checked(poses), rows, threads)
        # of rows at a value that nobody chose nobody was told that they are all
        rows.flags[any_row(rows.inside)] &= np.uint8(255 ^ _UNCERTAIN)
        return rows, _SPARE[any_row(rows.valid).astype(np.uint8) + any_row(rows.inside)]
    some, within = any_row(rows.valid), any_row(rows.inside)
    status = _SPARE[some.astype(np.uint8) + within]
    none = ~some & ((rows.flags & _UNCERTAIN) == 0)
    if none.any():
        run = np.concatenate([[0], np.cumsum((poses[1:] != poses[:-1]).any((1, 2)))])
        first, of = np.unique(run[none], return_inverse=True)
        starts = np.searchsorted(run, first)
        status[none] = _SPARE[anywhere(plan, _checked(poses[starts]), threads).kind[of]]
    return rows, status
