"""What a time law is asked for: a joint curve on a grid, what the tool does along it, and every bound on the way."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Protocol, runtime_checkable

import numpy as np

from pieper import _kernel, arguments
from pieper.description.dh import Description
from pieper.errors import InputError
from pieper.kinematics.arrays import Array, ArrayLike
from pieper.kinematics.chain import Chain
from pieper.motion.certificate import vector_peaks
from pieper.motion.curve import JointCurve, checked_points
from pieper.motion.limits import SAY_LIMITS, JointLimits, Limits
from pieper.motion.motion import Motion, Tight
from pieper.motion.route.result import Route
from pieper.motion.tool_bounds import ToolCurve, tool_curve
from pieper.motion.track import Track
from pieper.solver.plan.plan import Plan
from pieper.tolerances import ONE_POINT_OF_PATH, SQUARES_LEAST, TINY
from pieper.words_by_number import plural

#: Points of the grid on which a profile is made, at least; a curve through few points bends more on each of its pieces,
GRID = 1000
#: which get this many where they are few,
GRID_OF_A_PIECE = 400
#: no more than this in all,
GRID_OF_FEW = 4000
#: and are few up to this many.
FEW = 100
#: Directions on a half circle in which the tool's acceleration is kept; between them it is kept by their polygon, which
#: lies within the circle and takes away up to 1 - cos(pi / 64), 0.12 percent.
DIRECTIONS = 32


@runtime_checkable
class JointPath(Protocol):
    """A joint path of an arm: points q (N, n) at s (N,) and how the arm is solved."""

    @property
    def q(self) -> Array:
        """(N, n), rad or m."""
        ...

    @property
    def s(self) -> Array:
        """(N,) from 0 to 1."""
        ...

    @property
    def plan(self) -> Plan:
        """How the arm is solved."""
        ...


@runtime_checkable
class Planned(Protocol):
    """Whatever has a plan: an arm."""

    @property
    def plan(self) -> Plan:
        """How it is solved."""
        ...


@dataclass(frozen=True, eq=False)
class TimedPath:
    """A joint curve on a grid with its bounds.

    Attributes:
        curve: The curve, one piece a cell of the grid.
        tool: What the tool does, or None where no arm is known.
        bound: Limits of the joints.
        limits: The limits as given.
        share: (k,) part of the speed limits that is used on each piece.
        tool_speed: (k,) largest speed of the tool's point on each piece, m/s; infinite where there is none.
        names: Joint names.
        plan: How the arm is solved, or None.
        easing: (k,) part of the speed, and squared of the acceleration, that is used on each piece; None for all.
    """

    curve: JointCurve
    tool: ToolCurve | None
    bound: JointLimits
    limits: Limits
    share: Array
    tool_speed: Array
    names: tuple[str, ...]
    plan: Plan | None = None
    easing: Array | None = None

    @property
    def chain(self) -> Chain:
        """The arm's chain, where there is one."""
        assert self.plan is not None
        return self.plan.chain

    @property
    def description(self) -> Description | None:
        """The arm, where there is one."""
        return None if self.plan is None else self.plan.description

    def motion(
        self,
        samples: tuple[Array, Array, Array, Array, Array, Array],
        tight: Iterable[Tight],
        margin: float,
        duration: float,
        deviation: float,
    ) -> Motion:
        """Return the motion along it that rests at both ends, of samples t, q, dq, ddq, dddq and s."""
        ends = np.array([0.0, duration])
        return Motion(
            *samples[:4],
            ends,
            ends,
            *samples[4:],
            tuple(tight),
            margin,
            deviation=deviation,
            limits=self.limits,
            description=self.description,
        )

    @property
    def h(self) -> Array:
        """(k,) lengths of the pieces."""
        return np.diff(self.curve.s)

    @property
    def eased(self) -> Array:
        """(k,) `easing`, ones where there is none."""
        return np.ones(len(self.share)) if self.easing is None else self.easing

    @cached_property
    def most(self) -> Array:
        """Return bounds (k + 1,) of x = (ds/dt)^2 that keep the tool's speeds; infinite where there are none."""
        out = np.full(len(self.curve.s), np.inf)
        if self.tool is None:
            return out
        turn = np.full(len(self.share), np.inf if self.limits.turn_speed is None else self.limits.turn_speed)
        for value, strays, most in (
            (self.tool.point, self.tool.point_strays, self.tool_speed * self.eased),
            (self.tool.turn, self.tool.turn_strays, turn * self.share * self.eased),
        ):
            out = np.minimum(out, _caps(value, strays, most))
        return out

    @cached_property
    def rows(self) -> tuple[Array, Array, Array]:
        """Return a, b, c (k, rows) of |a u + b x| <= c that keep the tool's acceleration at both ends of each piece."""
        k, most = len(self.share), self.limits.tool_acceleration
        if most is None or self.tool is None:
            empty = np.zeros((k, 0))
            return empty, empty, empty
        angle = np.arange(DIRECTIONS) * np.pi / DIRECTIONS
        a: list[Array] = []
        b: list[Array] = []
        for end in (0, 1):
            p, d = self.tool.point[end : k + end], self.tool.bend[end : k + end]
            # the plane that both lie in
            e1 = p / np.maximum(np.linalg.norm(p, axis=1, keepdims=True), TINY)
            across = d - (d * e1).sum(1, keepdims=True) * e1
            e2 = across / np.maximum(np.linalg.norm(across, axis=1, keepdims=True), TINY)
            way = np.cos(angle)[:, None, None] * e1 + np.sin(angle)[:, None, None] * e2
            along, bent = (way * p).sum(-1).T, (way * d).sum(-1).T
            # across the way u does nothing: what rounding leaves of it would let x be anything
            along[:, DIRECTIONS // 2] = 0.0
            # u and x at the piece's beginning; x at its end is x + 2 h u
            a.append(along + 2 * self.h[:, None] * bent * end)
            b.append(bent)
        rows = np.hstack(a), np.hstack(b)
        return *rows, np.repeat(self.eased[:, None] ** 2 * (most * np.cos(np.pi / (2 * DIRECTIONS))), 2 * DIRECTIONS, 1)

    def run(self, wanted: Array | None = None, start: float = 0.0, end: float = 0.0) -> tuple[Array, Array, bool, int]:
        """Return x (k + 1,), upper ends of the controllable sets (k + 1,), whether it can be done, and where not."""
        a, b, c = self.rows
        return _kernel.fastest(
            s=self.curve.s,
            d1=self.curve.d1,
            d2=self.curve.d2,
            d3=self.curve.d3,
            speed=self.bound.speed,
            acceleration=self.bound.acceleration,
            share=self.share,
            easing=self.eased,
            a=a,
            b=b,
            c=c,
            most=self.most,
            wanted=np.full(len(self.curve.s), np.nan) if wanted is None else wanted,
            start=start,
            end=end,
        )


def _caps(value: Array, strays: Array, most: Array) -> Array:
    """Return x (k + 1,) so low that |f| sqrt(x) stays within `most` (k,) on each piece, whatever smaller x is taken."""
    size = np.linalg.norm(value, axis=1)
    # where a value passes zero its neighbours bound x: with f0 = 0 the largest of f^2 x beside it is f1^2 x0 / 3
    beside, inside = np.concatenate([[0.0], size, [0.0]]) / np.sqrt(3), np.concatenate([[0.0], strays, [0.0]])
    size = np.max([size, beside[:-2], beside[2:], inside[:-1], inside[1:]], axis=0)
    inner = np.minimum(np.append(most, np.inf), np.append(np.inf, most))
    with np.errstate(divide="ignore"):
        x = np.where(np.isinf(inner), np.inf, (inner / np.maximum(size, SQUARES_LEAST)) ** 2)
    bounded = np.isfinite(most)
    if not bounded.any():
        return x
    finite = np.where(np.isfinite(x), x, 0.0)
    peaks = vector_peaks(value, strays, finite)
    shrink = np.where(bounded, np.maximum(peaks / np.where(bounded, most, 1.0), 1.0), 1.0)
    return x / np.maximum(np.append(shrink, 1.0), np.append(1.0, shrink)) ** 2


def timed_path(
    path: JointPath | ArrayLike,
    limits: Limits,
    arm: Planned | None = None,
    at: Sequence[float] = (),
) -> tuple[TimedPath, JointCurve]:
    """Return a path on its grid, and the curve through its own points.

    Args:
        path: A route or a track, or points (N, n).
        limits: What must be kept.
        arm: Whose tool it is, for points alone.
        at: Values of s that the grid must hold.

    Raises:
        InputError: No points that a curve can go through, limits for another arm, or limits of a tool nobody knows.
    """
    arguments.a(Limits, limits, "limits", SAY_LIMITS)
    if arm is not None:
        arguments.like(Planned, arm, "arm", "a pieper.Arm")
    plan = None if arm is None else arm.plan
    # a protocol is asked for every name it has, which takes longer than the fastest way: arrays are known sooner
    known: JointPath | None = None if type(path) is np.ndarray else path if isinstance(path, JointPath) else None
    if known is not None:
        points, plan = _whole(known), known.plan
        s = np.asarray(known.s, float)[: len(points)]
    else:
        given: Any = path
        points = checked_points(given)
        s = np.linspace(0.0, 1.0, len(points))
    n = points.shape[1]
    if plan is not None and plan.n != n:
        raise InputError(f"the points have {plural(n, 'joint')}, {plan.name} has {plan.n}.", given=n)
    names = tuple(f"joint {j + 1}" for j in range(n)) if plan is None else plan.names
    curve = JointCurve.through(s, points)
    return on_grid(curve, limits, names, plan, at=at), curve


def on_grid(
    curve: JointCurve,
    limits: Limits,
    names: tuple[str, ...],
    plan: Plan | None,
    *,
    at: Sequence[float] = (),
    share: Array | None = None,
    tool_speed: Array | None = None,
) -> TimedPath:
    """Return a curve split into `GRID` pieces or more; `share` and `tool_speed` are one number a piece of the curve."""
    if limits.of_the_tool and plan is None:
        raise InputError(
            "limits of the tool need an arm: give a track or a route instead of points, or say arm=.", given="points"
        )
    bound = limits.of(curve.q.shape[1], names)
    # with a jerk the profile is evened out anyway
    few = len(curve.q) <= FEW and limits.jerk is None
    each = max(-(-(GRID - 1) // len(curve.q)), min(GRID_OF_A_PIECE, GRID_OF_FEW // len(curve.q)) if few else 1)
    grid = curve.s
    if each > 1:
        part = np.arange(each) / each
        grid = np.append((curve.s[:-1, None] + np.diff(curve.s)[:, None] * part).ravel(), curve.s[-1])
    if len(at):
        grid = np.union1d(grid, np.asarray(at, float))
        # a grid point next to one that must be there makes a cell of no length
        must = np.union1d(curve.s, at)
        gap = np.abs(grid[:, None] - must[None]).min(1)
        grid = grid[(gap == 0) | (gap > ONE_POINT_OF_PATH)]
    whole = len(grid) == len(curve.s)
    i = np.arange(len(curve.q)) if whole else curve.piece(grid[:-1])
    split = curve if whole else curve.split(grid)
    shares = np.ones(len(i)) if share is None else share[i]
    most = np.full(len(i), np.inf if limits.tool_speed is None else limits.tool_speed)
    if tool_speed is not None:
        most = np.minimum(most, tool_speed[i])
    # what nothing limits is not looked at; sections of constant speed ask for it
    wanted = limits.of_the_tool or tool_speed is not None or bool(len(at))
    tool = tool_curve(plan.chain, split) if plan is not None and wanted else None
    return TimedPath(split, tool, bound, limits, shares, most, names, plan)


def _whole(path: JointPath) -> Array:
    """Return the points of a path that reaches its end."""
    return checked_points(_to_its_end(path, "a motion is timed to its end", "Time", "nothing to time"), "the path")


def joint_points(path: JointPath | Motion | ArrayLike) -> ArrayLike:
    """Return the joint points (N, n) of a route or a track that reaches its end, or of a motion; others unchanged.

    Raises:
        InputError: A track that stops, or a route that was not found.
    """
    if isinstance(path, Motion):
        return path.q
    if type(path) is np.ndarray or not isinstance(path, JointPath):
        return path
    return _to_its_end(path, "a path is looked at to its end", "Look at", "no path to look at")


def _to_its_end(path: JointPath, asked: str, cure: str, none: str) -> Array:
    if isinstance(path, Track) and not path.complete:
        raise InputError(
            f"the track stops at point {len(path.followed)} of {len(path.path)}; {asked}. "
            f"{path.explain().splitlines()[1] if path.stop else ''} {cure} track.followed, or follow another way.",
            reached=len(path.followed),
        )
    if isinstance(path, Route) and not path.found:
        raise InputError(f"the route's verdict is {path.verdict.name}: there is {none}. {path.reason}")
    return path.q
