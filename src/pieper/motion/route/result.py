"""What a search for a route gave: the route with its verdict, where it is blocked, and other ways there are."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.motion.route.freedom import Freedom, Verdict
from pieper.motion.route.setting import Setting
from pieper.motion.route.turn_map import TurnMap, turn_map
from pieper.solver.plan.plan import Plan
from pieper.solver.words.labels import posture_words


@dataclass(frozen=True)
class Closed:
    """What closes one branch at a place: a joint that would have to leave its limits, and by how much there.

    Attributes:
        branch: Posture label.
        joint: Name of the joint.
        side: "lower" or "upper".
        limit: The limit, rad or m.
        excess: By how much it is passed at the best turn of that branch, rad or m.
    """

    branch: str
    joint: str
    side: str
    limit: float
    excess: float


@dataclass(frozen=True)
class Relaxation:
    """The smallest change of its kind that was found to let a route through.

    Attributes:
        kind: "limit" (a joint's, wider), "cone" (the tool's axis may tilt) or "shift" (the path moved).
        amount: How much, rad or m.
        what: The joint, or the direction of a shift in the base frame, in words.
        opens: What was found with it, in a sentence.
    """

    kind: str
    amount: float
    what: str
    opens: str

    def __str__(self) -> str:
        return self.opens


@dataclass(frozen=True)
class Blocked:
    """Where no route goes on.

    Attributes:
        s: (first, last) between which every passage closes, 0 to 1.
        closed: What closes each branch there; empty where the pose is out of reach.
        why: A sentence.
        begun: Where on the path everything inside the limits was known; followed from there, it comes to nothing: from
            behind `s` it was followed backwards.
        others: Seeks the smallest changes that let a route through.
    """

    s: tuple[float, float]
    closed: tuple[Closed, ...]
    why: str
    begun: float
    others: Callable[[], tuple[Relaxation, ...]] = field(default=tuple, repr=False, compare=False)

    @cached_property
    def relaxations(self) -> tuple[Relaxation, ...]:
        """The smallest change of each kind that lets a route through, sought when first asked for, in seconds."""
        return self.others()


@dataclass(frozen=True, eq=False)
class Alternative:
    """Another route: its joint vectors (N, n), the posture label it begins with, and its cost."""

    branch: str
    q: Array = field(repr=False)
    turn: Array = field(repr=False)
    cost: float


@dataclass(frozen=True, eq=False)
class Route:
    """What a search for a route gave.

    Attributes:
        path: (N, 4, 4) the poses asked for, m.
        s: (N,) path parameter of the points, 0 to 1.
        q: (N, n) joint vectors, whole turns continuous, rad or m; (0, n) where no route was found.
        turn: (N,) turn of the tool about its free axis, rad, continuous; fk(q) is the pose tilted, then turned by it.
        tilt: (N,) by how much the axis is tilted, rad.
        verdict: FOUND, IMPOSSIBLE or UNCERTAIN.
        blocked: Where no route goes on, or None.
        cost: Motion: the sum over steps and joints of squared differences (rad^2, slides per length of the arm). Time:
            the sum over steps of the largest joint difference, which is the time at one radian a second.
        bound: No route along these points costs less than this.
        slope: The largest slope of the cost along what the poses leave free, where no limit is in the way.
        reason: Why the verdict is what it is.
        free: What was free.
        setting: What was solved.
        plan: How the arm is solved.
    """

    path: Array
    s: Array
    q: Array
    turn: Array
    tilt: Array
    verdict: Verdict
    blocked: Blocked | None
    cost: float
    bound: float
    slope: float
    reason: str
    free: Freedom
    plan: Plan = field(repr=False)
    setting: Setting = field(repr=False)
    others: Callable[[], tuple[Alternative, ...]] = field(default=tuple, repr=False)

    @property
    def found(self) -> bool:
        """Whether there is a route."""
        return self.verdict is Verdict.FOUND

    @property
    def joint_names(self) -> tuple[str, ...]:
        """Names of the joints."""
        return self.plan.names

    @cached_property
    def alternatives(self) -> tuple[Alternative, ...]:
        """Other routes, one a posture label of the first point, cheapest first; sought when first asked for."""
        return self.others()

    @cached_property
    def labels(self) -> tuple[str, ...]:
        """(N,) posture label of each point; empty where no route was found."""
        return tuple(posture_words(self.plan, self.q)) if len(self.q) else ()

    @cached_property
    def map(self) -> TurnMap:
        """Where along the path which turn is open, branch by branch, whether a route was found or not.

        Raises:
            InputError: The turn was not free, or the arm's own joints decide it.
        """
        return turn_map(self.setting)

    @property
    def largest_step(self) -> Array:
        """(n,) largest joint step between neighbouring points, rad or m; zeros where there is none."""
        return np.abs(np.diff(self.q, axis=0)).max(0) if len(self.q) > 1 else np.zeros(self.plan.n)

    def explain(self) -> str:
        """Return what was found, in a few sentences; relaxations are told once they were asked for."""
        lines = [self.reason]
        if self.found:
            lines.append(f"Cost {self.cost:.6g}; no route along these points costs less than {self.bound:.3g}.")
            if self.setting.turns and (self.free.turns or self.setting.curves is self.plan):
                low, high = np.degrees(self.turn.min()), np.degrees(self.turn.max())
                lines.append(f"The tool turns between {low:z.2f} and {high:z.2f} deg about its {self.free.axis} axis.")
            if self.setting.tilts:
                lines.append(f"Its axis is tilted by up to {np.degrees(self.tilt.max()):z.2f} deg.")
        if self.blocked is not None:
            lines.append(self.blocked.why)
            for closed in self.blocked.closed:
                lines.append(f"  {closed.branch}: {_closed(self.plan, closed)}")
            if "relaxations" in self.blocked.__dict__:
                found = [f"  {relaxation}" for relaxation in self.blocked.relaxations]
                lines += found or ["  No wider limit, no move of the path and no cone that was tried lets one through."]
        return "\n".join(lines)

    def __repr__(self) -> str:
        return f"<Route of {self.plan.name}, {len(self.path)} points: {self.verdict.name}>"


def _closed(plan: Plan, closed: Closed) -> str:
    sliding = closed.joint in plan.names and plan.prismatic[plan.names.index(closed.joint)]
    unit, scale = ("mm", 1e3) if sliding else ("deg", 180 / np.pi)
    limit, excess = closed.limit * scale, closed.excess * scale
    word = f"{closed.joint} would pass its {closed.side} limit of {limit:.6g} {unit}"
    return f"{word} by {excess:.3g} {unit} at the best of the turns looked at"
