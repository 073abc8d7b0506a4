"""From a path to a track: every branch carried, its limits looked at between the points too, the nearest one chosen."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from pieper.kinematics.arrays import Array, ArrayLike, Bools
from pieper.kinematics.forward import checked_joints
from pieper.kinematics.joints import TURN, inside
from pieper.kinematics.pose import PoseLike
from pieper.motion.between_points import off_line, outside_between
from pieper.motion.branches import Strand, strands
from pieper.motion.continuation import Continuation
from pieper.motion.path import checked_path
from pieper.motion.stops import LIMIT, Event, geometric_stop, limit_stop, limit_stop_between, placed, remarks
from pieper.motion.track import Branch, Cure, Track
from pieper.solver.plan.plan import Plan
from pieper.solver.words.labels import posture_words
from pieper.tolerances import NEARER_BY, STRANDS_END, STRANDS_MEET, VERIFIED


def followed(
    plan: Plan,
    path: PoseLike,
    *,
    start: ArrayLike | None = None,
    seek: Callable[[Track], tuple[Cure, ...]] | None = None,
) -> Track:
    """Return the track of a path, see `pieper.motion.follow`.

    Args:
        plan: How the arm is solved.
        path: (N, 4, 4) poses, m.
        start: (n,) posture the arm is in, rad or m; zeros when left out.
        seek: Finds what lets a track that stops pass, when it is asked for; None where nobody looks.

    Raises:
        InputError: The path is not a stack of poses, or start is not a joint vector.
    """
    poses = checked_path(path)
    now = np.zeros(plan.n) if start is None else checked_joints(start, plan.n, "start")
    if now.ndim != 1:
        now = now.reshape(-1)[: plan.n] if now.size == plan.n else checked_joints(now.ravel(), plan.n, "start")
    way = Continuation(plan, poses)
    found = strands(way, now)
    labels = posture_words(plan, np.array([strand.q[0] for strand in found]))
    branches = tuple(_branch(way, i, found, labels[i], now) for i in range(len(found)))
    N = len(poses)
    s = np.linspace(0.0, 1.0, N) if N > 1 else np.zeros(1)
    chosen = _nearest(way, branches, now)
    if chosen is None:
        q, events = np.zeros((0, plan.n)), (placed(way, _no_start(way, branches)),)
        complete = False
    else:
        branch = branches[chosen]
        q, complete = branch.q, branch.complete
        events = remarks(way, q, found[chosen].crossings)
        events = tuple(placed(way, event) for event in events)
        every = [*events, branch.stop] if branch.stop else list(events)
        events = tuple(sorted(every, key=lambda e: (e.s, e.stop)))
    residual = way.residuals(q)
    standing = np.repeat((q[-1] if len(q) else now)[None], N - len(q), axis=0)
    return Track(
        poses,
        s,
        np.concatenate([q, standing]),
        np.arange(N) < len(q),
        complete,
        events,
        branches,
        chosen,
        now,
        residual,
        way.reachable,
        plan.names,
        plan.prismatic,
        plan,
        off_line(way, q),
        seek,
    )


def passing(plan: Plan, path: Array, start: Array, *, nearest: bool = False) -> Array | None:
    """Return the first posture (n,) of the branch nearest to a start that passes a path (N, 4, 4); None for none.

    Cheaper than a track: why the others stop is not worked out. With `nearest` only the branch counts that begins
    nearest to the start of all.
    """
    way = Continuation(plan, path)
    best, least = None, np.inf
    curves = [_wound(way, np.array(strand.q), start) for strand in strands(way, start)]
    if nearest and curves:
        curves = [min(curves, key=lambda free: float(np.linalg.norm((free[0] - start) / way.unit)))]
    for free in curves:
        if len(free) < len(path) or not inside(free, plan.limits).all() or _wrong(way, free).any():
            continue
        away = float(np.linalg.norm((free[0] - start) / way.unit))
        if away < least and outside_between(way, free) is None:
            best, least = free[0], away
    return best


def _wound(way: Continuation, free: Array, start: Array) -> Array:
    """Return a curve (k, n) that begins inside the limits, by whole turns as near to the start as they allow."""
    return free + TURN * way.chain.joints.turns(free[0], start, way.plan.limits)


def _wrong(way: Continuation, q: Array) -> Bools:
    """Return which points of a curve (k, n) miss their pose."""
    return np.asarray(np.any(way.residuals(q) > VERIFIED * np.array([way.chain.length, 1.0]), axis=1), bool)


def _branch(way: Continuation, index: int, found: list[Strand], label: str, start: Array) -> Branch:
    strand, N = found[index], len(way.path)
    free = _wound(way, np.array(strand.q), start)
    outside = ~inside(free, way.plan.limits)
    sampled = len(free) if not outside.any() else int(np.argmax(outside.any(1)))
    crossed = outside_between(way, free[:sampled])
    wrong = _wrong(way, free)
    last = len(free)
    if wrong.any():
        last = int(np.argmax(wrong))
    meets, stop = None, None
    if crossed is not None and crossed[0] < last:
        last, at = crossed[0] + 1, crossed[1]
        stop = limit_stop_between(way, free, last, at)
    elif outside[:last].any():
        last = int(np.argmax(outside.any(1)))
        stop = limit_stop(way, free, last)
    elif last < N:
        meets = _partner(way, index, found)
        stop = geometric_stop(way, strand, free, meets)
    stop = None if stop is None else placed(way, stop)
    s = 1.0 if stop is None else stop.s
    return Branch(index, label, free[:last], s, last == N, stop, meets, len(free))


def _partner(way: Continuation, index: int, found: list[Strand]) -> int | None:
    """Return the branch that ends at the same place with the same joints, or None."""
    strand = found[index]
    for other, candidate in enumerate(found):
        if other == index or candidate.end is None or strand.end is None:
            continue
        gap = float(np.abs(way.gap(candidate.at, strand.at)).max())
        if abs(candidate.end - strand.end) < STRANDS_END and gap < STRANDS_MEET:
            return other
    return None


def _nearest(way: Continuation, branches: tuple[Branch, ...], start: Array) -> int | None:
    best, distance = None, np.inf
    for branch in branches:
        if branch.points:
            d = float(np.linalg.norm((branch.q[0] - start) / way.unit))
            if d < distance - NEARER_BY:
                best, distance = branch.index, d
    return best


def _no_start(way: Continuation, branches: tuple[Branch, ...]) -> Event:
    """Return why not even the first pose is reached."""
    if not branches:
        return Event(0.0, None, "out of reach", True, f"The first pose has no solution. {way.why(0.0)}")
    stops = [branch.stop for branch in branches if branch.stop is not None]
    least = min(stops, key=lambda stop: stop.excess)
    return Event(0.0, least.joint, LIMIT, True, f"The first pose has no solution inside the limits: {least.detail}")
