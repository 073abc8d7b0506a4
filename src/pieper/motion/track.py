"""What following a path gave: the branch that was followed, every stop with its cause, how far other branches go."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from pieper.document.columns import Column, Tabular, Units
from pieper.kinematics.arrays import Array, Bools
from pieper.motion.stops import Event
from pieper.solver.plan.plan import Plan
from pieper.tolerances import WORTH_SAYING
from pieper.words_by_number import plural

NO_CURE = (
    "No cure was found: not another start, nor the tool turned or tilted, nor the path shifted by up to 300 mm lets it "
    "pass."
)


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


@dataclass(frozen=True, eq=False)
class OffLine:
    """How far the tool leaves the line while the joints move straight from point to point.

    Attributes:
        metres: Largest distance of the tool from the straight piece between its two points, m.
        radians: Largest turn away from the piece's rotation, rad.
        point: The point (0-based) after which the distance is largest.
    """

    metres: float
    radians: float
    point: int


@dataclass(frozen=True, eq=False)
class Cure:
    """A change with which a path is followed to its end; it was followed to say so.

    Attributes:
        kind: "start", "tool turned", "tool tilted" or "path shifted".
        words: What to do, a sentence.
        amount: How much: the largest joint difference of the start (rad; lengths), the turn (rad) or the shift (m).
        start: (n,) where to start.
        path: (N, 4, 4) the path with the change.
        track: The whole track.
    """

    kind: str
    words: str
    amount: float
    start: Array
    path: Array
    track: Track = field(repr=False)


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
        off_line: How far the tool leaves the line while the joints move straight from point to point.
        seek: Finds what lets a track that stops pass; None where nobody looks.
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
    off_line: OffLine = OffLine(0.0, 0.0, 0)
    seek: Callable[[Track], tuple[Cure, ...]] | None = field(default=None, repr=False)

    @cached_property
    def cures(self) -> tuple[Cure, ...]:
        """What lets the path pass where the track stops, each followed to its end; worked out when first asked for."""
        return () if self.seek is None else self.seek(self)

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

    def explain(self, *, cures: bool = True) -> str:
        """Return what happened as a few sentences.

        Args:
            cures: Whether to say what would let the path pass, which may have to be worked out first.
        """
        n, N = self.points, len(self.path)
        text = [f"All {N} points were reached." if self.complete else f"{n} of {N} points were reached."]
        text += [str(event) for event in self.events]
        passing = [b for b in self.branches if b.complete and b.index != self.chosen]
        if not self.complete and passing:
            names = "; ".join(f"branch {b.index + 1} ({b.label})" for b in passing)
            text.append(f"Started elsewhere it would have passed: {names}.")
        elif not self.complete and self.branches:
            text.append("No other branch of the first pose reaches the end either.")
        if cures and not self.complete and self.seek is not None:
            text += [f"Cure: {cure.words}" for cure in self.cures] or [NO_CURE]
        off = self.off_line
        if off.metres > WORTH_SAYING:
            where = f"between points {off.point + 1} and {off.point + 2}"
            turned = f" and turns it by up to {np.degrees(off.radians):.2g} deg" if off.radians > WORTH_SAYING else ""
            text.append(
                f"Straight motion of the joints from point to point leads the tool up to {off.metres * 1e3:.2g} mm off "
                f"the line{turned}, most {where}."
            )
        return "\n".join(text)

    def __repr__(self) -> str:
        end = "complete" if self.complete else f"stops at s = {self.stop.s:.4g}: {self.stop.cause}" if self.stop else ""
        return f"<Track: {self.points} of {plural(len(self.path), 'point')} reached, {end}>"
