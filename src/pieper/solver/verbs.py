"""From a plan and a pose to Solutions: the door of the inverse wing."""

from __future__ import annotations

import os
from functools import partial

import numpy as np

from pieper.errors import InputError
from pieper.kinematics.forward import checked_joints
from pieper.kinematics.newton import scaled_jacobian
from pieper.kinematics.pose import checked_pose
from pieper.solver.families import named
from pieper.solver.plan.plan import Plan
from pieper.solver.redundant.at_arm_angle import solve_at_arm_angle
from pieper.solver.redundant.reduced import solve_reduced
from pieper.solver.redundant.sweep import best_slice
from pieper.solver.results import (
    DEGENERATE,
    OUT_OF_REACH_FLAG,
    ROUNDED,
    UNCERTAIN,
    SolutionBatch,
    Solutions,
    Status,
    inside_limits,
)
from pieper.solver.singular.careful import every_solution, near_rows
from pieper.solver.singular.examine import side_steps

_CAREFUL = DEGENERATE
#: Poses on a singularity that `ik_many` looks at one by one in a call: it bounds the work of a call.
MOST_CAREFUL = 500
#: Poses of a redundant arm in a call of `ik_many` whose families are traced because no slice through them was met.
MOST_TRACED = 20
#: Smallest relative singular value at which a marked pose is not looked at further.
CLEAR = 1.5e-7
#: The name by which an arm angle is asked for.
ARM_ANGLE = "arm angle"


def ik(plan: Plan, T: object, redundancy: object = None) -> Solutions:
    """Return every solution of one pose; see `Arm.ik`."""
    if not plan.direct:
        return _ik_reduced(plan, T, redundancy)
    if redundancy is not None:
        raise InputError(f"{plan.name} has no redundant coordinate for the task {plan.task!r}.", given=redundancy)
    try:
        q, slots, inside, flag = plan.solver.one(T)
    except (TypeError, ValueError):
        # lists, integers, poses that are none: the checked route says what is wrong, or makes it right
        T = checked_pose(T)
        q, slots, inside, flag = plan.solver.one(T)
    if flag & _CAREFUL or (not len(q) and _overlooked(plan, checked_pose(T))):
        return _careful(plan, checked_pose(T), q, flag)
    return Solutions(plan, T, q, slots, inside, flag)


def ik_many(plan: Plan, Ts: object, threads: int | None = None, redundancy: object = None) -> SolutionBatch:
    """Return every solution of N poses; see `Arm.ik_many`."""
    threads = _threads(threads)
    if plan.direct and redundancy is not None:
        raise InputError(f"{plan.name} has no redundant coordinate for the task {plan.task!r}.", given=redundancy)
    # the native solver looks at its poses itself; the checked route says what is wrong, or makes it right
    plain = (plan.direct or plan.immediate) and isinstance(Ts, np.ndarray)
    poses = np.ascontiguousarray(Ts, dtype=float) if plain else _batch(Ts)
    if poses.ndim != 3 or poses.shape[1:] != (4, 4):
        poses = _batch(poses)
    angles = None if plan.direct else arm_angles(plan, redundancy, len(poses))
    if angles is not None:
        poses = _batch(poses)
        q, valid, inside, flag = solve_at_arm_angle(plan, poses, angles)
    else:
        values = None if plan.direct else redundancy_values(plan, redundancy, len(poses))
        try:
            q, valid, inside, flag = _rows(plan, poses, values, threads)
        except ValueError:
            poses = _batch(poses)
            q, valid, inside, flag = _rows(plan, poses, values, threads)
    if plan.redundancy and redundancy is None:
        _choose_elsewhere(plan, poses, q, valid, inside)
    some = _any(valid)
    best = Status.REDUNDANT if plan.redundancy else Status.SOLVED
    codes = np.array([Status.OUT_OF_REACH, Status.OUTSIDE_LIMITS, best], np.uint8)
    status = codes[some.astype(np.uint8) + _any(inside)]
    if not plan.redundancy and not (some.all() and not flag.any()):
        marked = np.flatnonzero(flag & _CAREFUL)
        none = np.flatnonzero(~some & ((flag & _CAREFUL) == 0))[:MOST_CAREFUL]
        overlooked = [i for i in none if _overlooked(plan, checked_pose(poses[i]))]
        for i in [*overlooked, *marked[:MOST_CAREFUL]]:
            found = _careful(plan, checked_pose(poses[i]), q[i][valid[i]], int(flag[i]))
            _put(found, q[i], valid[i], inside[i])
            status[i] = found.status
        # beyond that the kernel's own rows stand, one of each family, and the pose is called singular unread
        status[marked[MOST_CAREFUL:]] = np.uint8(Status.SINGULAR)
    if plan.redundancy and redundancy is not None:
        _told_apart(plan, poses, some, inside, flag, status)
    status[(flag & UNCERTAIN) > 0] = np.uint8(Status.UNCERTAIN)
    return SolutionBatch(plan, q, valid, inside, status, flag)


def _choose_elsewhere(plan: Plan, poses: np.ndarray, q: np.ndarray, valid: np.ndarray, inside: np.ndarray) -> None:
    """Choose another value of the spare coordinate where its default, which nobody chose, gives nothing inside."""
    traced, several = 0, len(plan.redundancy) > 1
    for i in np.flatnonzero(~_any(inside))[:MOST_CAREFUL]:
        rows, ok, within = best_slice(plan, checked_pose(poses[i]))
        if within.any() or (ok.any() and not valid[i].any()):
            q[i], valid[i], inside[i] = rows, ok, within
        elif (several or not ok.any()) and traced < MOST_TRACED:
            traced += 1
            _put(_ik_reduced(plan, poses[i], None), q[i], valid[i], inside[i])


def _told_apart(plan: Plan, poses, some: np.ndarray, inside: np.ndarray, flag: np.ndarray, status: np.ndarray) -> None:
    """Say of poses without rows at the value that was asked for whether other values have some.

    Poses that follow each other and are equal, as in a sweep over the values, are looked at once.
    """
    none = ~some & ((flag & UNCERTAIN) == 0)
    if not none.any():
        return
    run = np.concatenate([[0], np.cumsum((poses[1:] != poses[:-1]).any((1, 2)))])
    within = np.bincount(run, weights=_any(inside)) > 0
    missing = np.unique(run[none & ~within[run]])[:MOST_CAREFUL]
    anywhere = np.bincount(run, weights=some) > 0
    for k in missing:
        _, found, there = best_slice(plan, checked_pose(poses[np.argmax(run == k)]))
        within[k], anywhere[k] = there.any(), anywhere[k] or found.any()
    codes = np.array([Status.OUT_OF_REACH, Status.OUTSIDE_LIMITS, Status.REDUNDANT], np.uint8)
    status[none] = codes[anywhere.astype(np.uint8) + within][run[none]]


def _rows(plan: Plan, poses: np.ndarray, values: np.ndarray | None, threads: int):
    if plan.direct:
        return plan.solver.many(poses, threads)
    return solve_reduced(plan, poses, values, threads)


def _any(rows: np.ndarray) -> np.ndarray:
    """Return rows.any(1) of bools (N, M), eight at a time where that is possible: this runs once a pose."""
    if rows.shape[1] != 8 or not rows.flags.c_contiguous:
        return rows.any(1)
    return rows.view(np.uint64)[:, 0] != 0


def _put(found: Solutions, q: np.ndarray, valid: np.ndarray, inside: np.ndarray) -> None:
    """Write one pose's Solutions into its rows of a batch."""
    rows = min(len(found.all_q), len(q))
    q[:], valid[:], inside[:] = 0.0, False, False
    q[:rows], valid[:rows], inside[:rows] = found.all_q[:rows], True, found.in_limits[:rows]


def arm_angles(plan: Plan, redundancy: object, count: int) -> np.ndarray | None:
    """Return the arm angles (count,) that were asked for, rad, or None where something else was, or nothing."""
    if not isinstance(redundancy, dict) or ARM_ANGLE not in redundancy:
        return None
    if len(redundancy) > 1:
        raise InputError(f"give either the {ARM_ANGLE} or the redundant joint, not both.", given=redundancy)
    if plan.arm_angle is None:
        raise InputError(f"{plan.name} has no {ARM_ANGLE}: {plan.no_arm_angle}.", given=redundancy)
    try:
        angles = np.asarray(redundancy[ARM_ANGLE], float)
    except (TypeError, ValueError):
        angles = np.array(np.nan)
    if not np.isfinite(angles).all():
        raise InputError(f"the {ARM_ANGLE} must be a finite number, got {redundancy[ARM_ANGLE]!r}.", given=redundancy)
    if angles.shape not in ((), (1,), (count,)):
        raise InputError(
            f"the {ARM_ANGLE} must be one number, or one a pose, got shape {angles.shape}.", given=redundancy
        )
    return np.broadcast_to(angles, (count,))


def read_arm_angle(plan: Plan, q: object) -> tuple[np.ndarray, np.ndarray]:
    """Return the arm angles of joint vectors; see `Arm.arm_angle`."""
    if plan.arm_angle is None:
        raise InputError(f"{plan.name} has no {ARM_ANGLE}: {plan.no_arm_angle}.")
    return plan.arm_angle.of(checked_joints(q, plan.n))


def redundancy_values(plan: Plan, redundancy: object, count: int) -> np.ndarray:
    """Return the values (count, k) of the redundant coordinates: a number, one a coordinate, one a pose, or by name."""
    names = plan.redundancy
    if redundancy is None:
        return np.tile(plan.defaults, (count, 1))
    if not names:
        raise InputError(f"{plan.name} has no redundant coordinate for the task {plan.task!r}.", given=redundancy)
    if isinstance(redundancy, dict):
        unknown = [name for name in redundancy if name not in names]
        if unknown:
            raise InputError(
                f"{unknown[0]!r} is no redundant coordinate of this plan; they are {', '.join(plan.choices)}.",
                given=redundancy,
            )
        redundancy = [redundancy.get(name, plan.defaults[i]) for i, name in enumerate(names)]
    try:
        values = np.asarray(redundancy, float)
    except (TypeError, ValueError):
        values = np.array(np.nan)
    if not np.isfinite(values).all():
        raise InputError(f"redundancy must be finite numbers, got {redundancy!r}.", given=redundancy)
    k = len(names)
    if values.ndim == 0 and k == 1:
        values = np.full((count, 1), float(values))
    elif values.shape == (k,) and not (k == 1 and count == 1):
        values = np.tile(values, (count, 1))
    elif values.shape == (count,) and k == 1:
        values = values[:, None]
    if values.shape != (count, k):
        raise InputError(
            f"redundancy must give {k} value(s) ({', '.join(names)}), or one such row a pose, "
            f"got shape {values.shape}.",
            given=redundancy,
        )
    for j, (lower, upper) in enumerate(plan.redundancy_limits):
        outside = (values[:, j] < lower - 1e-9) | (values[:, j] > upper + 1e-9)
        if outside.any():
            raise InputError(
                f"redundancy value {values[outside, j][0]:g} of {names[j]} is outside its limits "
                f"{lower:g} to {upper:g}.",
                given=redundancy,
                joint=names[j],
            )
    return values


def _ik_reduced(plan: Plan, given: object, redundancy: object) -> Solutions:
    T = checked_pose(given)
    angles = arm_angles(plan, redundancy, 1)
    values = redundancy_values(plan, redundancy, 1) if angles is None else plan.defaults[None]
    if angles is None:
        q, valid, inside, flag = solve_reduced(plan, T[None], values, 1)
    else:
        q, valid, inside, flag = solve_at_arm_angle(plan, T[None], angles)
    rows, slots, within, bits = q[0][valid[0]], np.flatnonzero(valid[0]), inside[0][valid[0]], int(flag[0])
    if not np.array_equal(T, np.asarray(given, float)):
        bits |= ROUNDED
    if plan.redundancy:
        from pieper.solver.redundant.families_of import families_of

        families = partial(families_of, plan, T, values[0])
        if redundancy is None and not within.any():
            # nobody chose the spare coordinate: any value will do that has an answer
            others, ok, there = best_slice(plan, T)
            if there.any() or (ok.any() and not len(rows)):
                rows, slots, within = others[ok], np.flatnonzero(ok), there[ok]
            elif (len(plan.redundancy) > 1 or not ok.any()) and (families := families()):
                rows = np.array([family.representative for family in families])
                rows, within = inside_limits(rows, plan.limits, plan.prismatic)
                slots = np.arange(len(rows))
        return Solutions(plan, T, rows, slots, within, bits & ~DEGENERATE, families=families)
    if bits & _CAREFUL or (not len(rows) and _overlooked(plan, T)):
        return _careful(plan, T, rows, bits)
    return Solutions(plan, T, rows, slots, within, bits)


def _careful(plan: Plan, T: np.ndarray, candidates: np.ndarray, flag: int) -> Solutions:
    """Re-examine a pose that the kernel marked: families, merged roots, and what the kernel could not certify."""
    flag = int(flag) & ~DEGENERATE
    if _clear(plan, candidates):
        q, inside = inside_limits(candidates, plan.limits, plan.prismatic)
        return Solutions(plan, T, q, np.arange(len(q)), inside, flag)
    found = every_solution(plan, T, candidates)
    q, inside = inside_limits(found.q, plan.limits, plan.prismatic)
    if len(q):
        flag &= ~OUT_OF_REACH_FLAG
    return Solutions(
        plan,
        T,
        q,
        np.arange(len(q)),
        inside,
        flag,
        families=found.families,
        all_family=found.family,
        all_multiplicity=found.multiplicity,
        all_direction=found.direction,
    )


def _clear(plan: Plan, rows: np.ndarray) -> bool:
    """Whether all rows are far enough from singular ones that nothing merges there and no family passes.

    Closed forms mark poses generously. Twins of a root at sigma lie about 2 sigma apart, which they tell apart well
    above 1e-8; a family needs sigma to vanish. The general kernel marks poses where its elimination itself is nearly
    singular, and there clear rows say nothing about those that it may have lost; nor do they where a virtual joint that
    must be zero may be free.
    """
    six_alone = plan.task == "pose" and not plan.reduction.fill and not named(plan.family).eliminating
    if not six_alone or not len(rows) or len(rows) % 2:
        return False
    s = np.linalg.svd(scaled_jacobian(plan.chain, rows), compute_uv=False)
    return bool(np.all(s[:, -1] > CLEAR * s[:, 0]))


def _overlooked(plan: Plan, T: np.ndarray) -> bool:
    """Whether a pose without solutions has neighbours with some: it may be singular, or lie at the edge of reach."""
    return len(near_rows(plan, side_steps(plan.chain, T, (1e-9,)))) > 0


def _batch(Ts: object) -> np.ndarray:
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
