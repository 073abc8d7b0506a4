"""Following a path: the branch nearest to the start, every stop with its cause, and how far other branches go."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from pieper.kinematics.forward import checked_joints
from pieper.motion.branches import Strand, strands
from pieper.motion.continuation import BRIDGE, Continuation
from pieper.motion.path import checked_path
from pieper.motion.stops import LIMIT, Event, geometric_stop, limit_stop, remarks
from pieper.tolerances import LIMIT_SLACK, VERIFIED

if TYPE_CHECKING:
    from pieper.arm import Arm

TURN = 2 * np.pi


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
    q: np.ndarray
    s: float
    complete: bool
    stop: Event | None
    meets: int | None
    unlimited_points: int

    @property
    def points(self) -> int:
        """How many points of the path it reaches inside the limits."""
        return len(self.q)


@dataclass(frozen=True, eq=False)
class Track:
    """What following a path gave.

    Attributes:
        path: (N, 4, 4) the poses asked for, m.
        s: (N,) path parameter of the points, 0 to 1.
        q: (k, n) joint vectors up to the end or the first stop, rad or m.
        complete: Whether all N points were reached.
        events: What happened, in order of s: at most one stop, and remarks (a fast swing, a singularity passed).
        branches: Every branch that starts at the first pose and how far it goes.
        chosen: Number of the branch that was followed, or None when there was none.
        start: (n,) the posture the arm was in.
        residual: (k, 2) how far forward kinematics misses each pose, metres and radians.
        reachable: (N,) bool, whether a pose has any solution inside the limits, on whatever branch.
        joint_names: Names of the joints.
        prismatic: (n,) bool.
    """

    path: np.ndarray
    s: np.ndarray
    q: np.ndarray
    complete: bool
    events: tuple[Event, ...]
    branches: tuple[Branch, ...]
    chosen: int | None
    start: np.ndarray
    residual: np.ndarray
    reachable: np.ndarray
    joint_names: tuple[str, ...]
    prismatic: np.ndarray

    @property
    def stop(self) -> Event | None:
        """The event that ended the track, or None when it is complete."""
        return next((event for event in self.events if event.stop), None)

    @property
    def largest_step(self) -> np.ndarray:
        """(n,) largest joint step between neighbouring points, rad or m; zeros when there is no step."""
        return np.abs(np.diff(self.q, axis=0)).max(0) if len(self.q) > 1 else np.zeros(len(self.joint_names))

    def explain(self) -> str:
        """Return what happened as a few sentences."""
        n, N = len(self.q), len(self.path)
        text = [f"All {N} points were reached." if self.complete else f"{n} of {N} points were reached."]
        text += [str(event) for event in self.events]
        passing = [b for b in self.branches if b.complete and b.index != self.chosen]
        if not self.complete and passing:
            names = "; ".join(f"branch {b.index + 1} ({b.label})" for b in passing)
            text.append(f"Started elsewhere it would have passed: {names}.")
        elif not self.complete and self.branches:
            text.append("No other branch of the first pose reaches the end either.")
        return "\n".join(text)


def follow(arm: Arm, path: np.ndarray, *, start: np.ndarray | None = None) -> Track:
    """Follow a path by the branch whose first solution is nearest to the start posture.

    Each branch is carried by continuity, not merely by nearness: steps are compared with what the Jacobian predicts and
    halved between the points when in doubt, so that a track never changes branch unnoticed. Between two given points
    the tool is taken to move on the straight line of `pieper.line`. Whole turns stay continuous, from the turn nearest
    to the start. Where the first pose is singular and has a continuum of solutions, the branches are those that
    leave it.

    Args:
        arm: The arm.
        path: (N, 4, 4) poses, m; one pose is a path too.
        start: (n,) posture the arm is in, rad or m; all joints at zero when left out.

    Returns:
        The Track. A pose that cannot be reached is never an exception: it is the stop, with its cause.

    Raises:
        InputError: The path is not a stack of poses, or start is not a joint vector.
        PlanError: The arm is beyond the solver.
    """
    path = checked_path(path)
    start = np.zeros(arm.n) if start is None else checked_joints(start, arm.n, "start")
    if start.ndim != 1:
        start = start.reshape(-1)[: arm.n] if start.size == arm.n else checked_joints(start.ravel(), arm.n, "start")
    way = Continuation(arm, path)
    found = strands(way, start)
    labels = _labels(arm, found)
    branches = tuple(_branch(way, i, found, labels[i], start) for i in range(len(found)))
    N = len(path)
    s = np.linspace(0.0, 1.0, N) if N > 1 else np.zeros(1)
    chosen = _nearest(way, branches, start)
    if chosen is None:
        q, events = np.zeros((0, arm.n)), (_no_start(way, branches, start),)
        complete = False
    else:
        branch = branches[chosen]
        q, complete = branch.q, branch.complete
        events = remarks(way, q, found[chosen].crossings)
        events = tuple(sorted((*events, *([branch.stop] if branch.stop else [])), key=lambda e: (e.s, e.stop)))
    residual = way.residuals(q)
    return Track(
        path,
        s,
        q,
        complete,
        events,
        branches,
        chosen,
        start,
        residual,
        way.reachable,
        arm.joint_names,
        ~way.revolute,
    )


def _labels(arm: Arm, found: list[Strand]) -> list[str]:
    from pieper.solver.words.labels import posture_words

    return posture_words(arm.plan, np.array([strand.q[0] for strand in found])) if found else []


def _turns(way: Continuation, q: np.ndarray, start: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the whole turns (n,) to add to a curve q (k, n) so that it begins inside the limits, nearest to the start.

    Returns:
        (n,) turns, zero for prismatic joints, and (n,) whether the joint then begins inside its limits.
    """
    lower, upper = way.arm.limits[:, 0], way.arm.limits[:, 1]
    first = q[0]
    lowest = np.ceil((lower - LIMIT_SLACK - first) / TURN)
    highest = np.floor((upper + LIMIT_SLACK - first) / TURN)
    possible = lowest <= highest
    wanted = np.round((start - first) / TURN)
    turns = np.where(possible, np.clip(wanted, lowest, np.maximum(lowest, highest)), wanted)
    turns = np.where(way.revolute, turns, 0.0)
    moved = first + TURN * turns
    return turns, (moved >= lower - LIMIT_SLACK) & (moved <= upper + LIMIT_SLACK)


def _branch(way: Continuation, index: int, found: list[Strand], label: str, start: np.ndarray) -> Branch:
    strand, N = found[index], len(way.path)
    free = np.array(strand.q)
    turns, _ = _turns(way, free, start)
    free = free + TURN * turns
    outside = (free < way.arm.limits[:, 0] - LIMIT_SLACK) | (free > way.arm.limits[:, 1] + LIMIT_SLACK)
    wrong = (way.residuals(free) > VERIFIED * np.array([way.length, 1.0])).any(1)
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
        if abs(candidate.end - strand.end) < 1e-3 and np.abs(way.wrapped(candidate.at - strand.at)).max() < 5e-2:
            return other
    return None


def _nearest(way: Continuation, branches: tuple[Branch, ...], start: np.ndarray) -> int | None:
    best, distance = None, np.inf
    for branch in branches:
        if branch.points:
            d = float(np.linalg.norm((branch.q[0] - start) * way.scale))
            if d < distance - 1e-9:
                best, distance = branch.index, d
    return best


def _no_start(way: Continuation, branches: tuple[Branch, ...], start: np.ndarray) -> Event:
    """Return why not even the first pose is reached."""
    if not branches:
        return Event(0.0, None, "out of reach", True, f"The first pose has no solution. {way.why(0.0)}")
    nearest = min(branches, key=lambda b: b.stop.excess if b.stop else np.inf)
    return Event(
        0.0, nearest.stop.joint, LIMIT, True, f"The first pose has no solution inside the limits: {nearest.stop.detail}"
    )


__all__ = ["BRIDGE", "Branch", "Event", "Track", "follow"]
