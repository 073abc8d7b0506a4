"""Following a path: the branch nearest to the start, every stop with its cause, and how far other branches go."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from pieper.document.columns import Column, Tabular, Units
from pieper.kinematics.arrays import Array, ArrayLike, Bools
from pieper.kinematics.forward import checked_joints
from pieper.kinematics.joints import TURN, inside
from pieper.kinematics.pose import PoseLike
from pieper.motion.branches import Strand, strands
from pieper.motion.continuation import Continuation
from pieper.motion.path import checked_path
from pieper.motion.stops import LIMIT, Event, geometric_stop, limit_stop, remarks
from pieper.solver.plan.plan import Plan
from pieper.solver.words.labels import posture_words
from pieper.tolerances import NEARER_BY, STRANDS_END, STRANDS_MEET, VERIFIED
from pieper.words_by_number import plural


@dataclass(frozen=True, eq=False)
class Branch:
    """One continuous curve of solutions that starts at the first pose.

    Attributes:
        index: Its number; branches keep the order of the plan's branches at the first pose.
        label: Posture label at the first pose.
        q: (k, n) joint vectors inside the limits, whole turns continuous and as near to the start as allowed, rad or m.
        s: Path parameter it reaches, 0 to 1.
        complete: Whether it reaches the last pose.
        stop: The event that ends it, or None.
        meets: Number of the branch it runs into where it ends, or None.
        unlimited_points: How many points it would reach if there were no limits.
    """

    index: int
    label: str
    q: Array
    s: float
    complete: bool
    stop: Event | None
    meets: int | None
    unlimited_points: int

    @property
    def points(self) -> int:
        """How many points of the path it reaches inside the limits."""
        return len(self.q)


@dataclass(frozen=True, eq=False, repr=False)
class Track(Tabular):
    """What following a path gave.

    Attributes:
        path: (N, 4, 4) the poses asked for, m.
        s: (N,) path parameter of the points, 0 to 1.
        q: (N, n) joint vectors, one a point, rad or m; where a point was not reached, the last posture that was (the
            start, where none was).
        reached: (N,) bool: which points were reached; all up to the end or the first stop.
        complete: Whether all N points were reached.
        events: What happened, in order of s: at most one stop, and remarks (a fast swing, a singularity passed).
        branches: Every branch that starts at the first pose and how far it goes.
        chosen: Number of the branch that was followed, or None when there was none.
        start: (n,) the posture the arm was in.
        residual: (k, 2) how far forward kinematics misses the poses that were reached, metres and radians.
        reachable: (N,) bool, whether a pose has any solution inside the limits, on whatever branch.
        joint_names: Names of the joints.
        prismatic: (n,) bool.
        plan: How the arm is solved.
    """

    path: Array
    s: Array
    q: Array
    reached: Bools
    complete: bool
    events: tuple[Event, ...]
    branches: tuple[Branch, ...]
    chosen: int | None
    start: Array
    residual: Array
    reachable: Bools
    joint_names: tuple[str, ...]
    prismatic: Bools
    plan: Plan = field(repr=False)

    @property
    def points(self) -> int:
        """How many points were reached."""
        return int(np.count_nonzero(self.reached))

    @property
    def followed(self) -> Array:
        """The joint vectors (k, n) of the points that were reached, rad or m."""
        return self.q[self.reached]

    def columns(self, *, degrees: bool = False, mm: bool = False) -> dict[str, Column]:
        """Return one row a point: s, joints, the pose asked for, whether it was reached."""
        units, rotation = Units(degrees, mm), self.path[:, :3, :3]
        position: dict[str, Column] = {}
        for k, axis in enumerate("xyz"):
            position |= units.metres(axis, self.path[:, k, 3])
        return {
            "point": np.arange(1, len(self.path) + 1),
            "s": self.s,
            **units.joints(self.joint_names, self.prismatic, self.q),
            "reached": self.reached,
            **position,
            **{f"r{i + 1}{j + 1}": rotation[:, i, j] for i in range(3) for j in range(3)},
        }

    @property
    def stop(self) -> Event | None:
        """The event that ended the track, or None when it is complete."""
        return next((event for event in self.events if event.stop), None)

    @property
    def largest_step(self) -> Array:
        """(n,) largest joint step between neighbouring points, rad or m; zeros when there is no step."""
        return np.abs(np.diff(self.followed, axis=0)).max(0) if self.points > 1 else np.zeros(len(self.joint_names))

    def explain(self) -> str:
        """Return what happened as a few sentences."""
        n, N = self.points, len(self.path)
        text = [f"All {N} points were reached." if self.complete else f"{n} of {N} points were reached."]
        text += [str(event) for event in self.events]
        passing = [b for b in self.branches if b.complete and b.index != self.chosen]
        if not self.complete and passing:
            names = "; ".join(f"branch {b.index + 1} ({b.label})" for b in passing)
            text.append(f"Started elsewhere it would have passed: {names}.")
        elif not self.complete and self.branches:
            text.append("No other branch of the first pose reaches the end either.")
        return "\n".join(text)

    def __repr__(self) -> str:
        end = "complete" if self.complete else f"stops at s = {self.stop.s:.4g}: {self.stop.cause}" if self.stop else ""
        return f"<Track: {self.points} of {plural(len(self.path), 'point')} reached, {end}>"


def follow(plan: Plan, path: PoseLike, *, start: ArrayLike | None = None) -> Track:
    """Follow a path by the branch whose first solution is nearest to the start posture.

    Each branch is carried by continuity, not merely by nearness: steps are compared with what the Jacobian predicts and
    halved between the points when in doubt, so that a track never changes branch unnoticed. Between two given points
    the tool is taken to move on the straight line of `pieper.line`. Whole turns stay continuous, from the turn nearest
    to the start. Where the first pose is singular and has a continuum of solutions, the branches are those that
    leave it.

    Args:
        plan: How the arm is solved.
        path: (N, 4, 4) poses, m; one pose is a path too.
        start: (n,) posture the arm is in, rad or m; all joints at zero when left out.

    Returns:
        The Track. A pose that cannot be reached is never an exception: it is the stop, with its cause.

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
        q, events = np.zeros((0, plan.n)), (_no_start(way, branches),)
        complete = False
    else:
        branch = branches[chosen]
        q, complete = branch.q, branch.complete
        events = remarks(way, q, found[chosen].crossings)
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
    )


def _branch(way: Continuation, index: int, found: list[Strand], label: str, start: Array) -> Branch:
    strand, N = found[index], len(way.path)
    free = np.array(strand.q)
    # whole turns are added so that the curve begins inside the limits, as near to the start as they allow
    free = free + TURN * way.chain.joints.turns(free[0], start, way.plan.limits)
    outside = ~inside(free, way.plan.limits)
    wrong = (way.residuals(free) > VERIFIED * np.array([way.chain.length, 1.0])).any(1)
    last = len(free)
    if wrong.any():
        last = int(np.argmax(wrong))
    meets, stop = None, None
    if outside[:last].any():
        last = int(np.argmax(outside.any(1)))
        stop = limit_stop(way, free, last)
    elif last < N:
        meets = _partner(way, index, found)
        stop = geometric_stop(way, strand, free, meets)
    s = 1.0 if stop is None else stop.s
    return Branch(index, label, free[:last], s, last == N, stop, meets, len(free))


def _partner(way: Continuation, index: int, found: list[Strand]) -> int | None:
    """Return the branch that ends at the same place with the same joints, or None."""
    strand = found[index]
    for other, candidate in enumerate(found):
        if other == index or candidate.end is None or strand.end is None:
            continue
        if (
            abs(candidate.end - strand.end) < STRANDS_END
            and np.abs(way.gap(candidate.at, strand.at)).max() < STRANDS_MEET
        ):
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
