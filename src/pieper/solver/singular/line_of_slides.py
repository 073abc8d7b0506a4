"""Slides that make up for each other: a self-motion along a straight line that has no end but the slides' limits."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.kinematics.newton import newton
from pieper.solver.singular.known_motion import StraightMotion
from pieper.solver.singular.relation import related
from pieper.solver.singular.self_motion import FREE
from pieper.tolerances import CURVE_RANK, JOINT_TURNS, LIMIT_SLACK, SLIDES_ALIKE, SLIDES_SHOWN, TINY


@dataclass(frozen=True, eq=False, repr=False)
class SlideLine(StraightMotion):
    """Slides move along directions that depend on each other, by ways in fixed proportion; no joint turns.

    Attributes:
        through: (n,) a joint vector on it.
        way: (n,) unit direction without units, zero but for slides.
    """

    way: Array
    closed: bool = False
    dimension: int = 1

    @cached_property
    def _foot(self) -> float:
        """Where along the line the ways of the slides are shortest (lengths from `through`)."""
        return -float(self.through / self.chain.joints.unit @ self.way)

    @cached_property
    def _stops(self) -> Array:
        """Where each moving slide meets its limits, along the line (joints that move, 2), ascending; lengths."""
        moving, unit = np.abs(self.way) > JOINT_TURNS, self.chain.joints.unit
        at = (self.limits[moving] - self.through[moving, None]) / (self.way * unit)[moving, None]
        return np.sort(at, axis=1)

    @cached_property
    def _ends(self) -> tuple[float, float]:
        """From where to where u counts: between all limits, or so far that what is shown of an endless line is seen."""
        low, high = float(self._stops[:, 0].max()), float(self._stops[:, 1].min())
        some = [float(x) for x in self._stops.ravel() if np.isfinite(x)]
        if np.isfinite(low) and np.isfinite(high) and low < high:
            return low, high
        return min([self._foot - SLIDES_SHOWN, *some]), max([self._foot + SLIDES_SHOWN, *some])

    @property
    def bounded(self) -> bool:
        """Whether limits leave it two ends."""
        return bool(np.isfinite(self._stops[:, 0].max()) and np.isfinite(self._stops[:, 1].min()))

    def _held(self, q: Array) -> Array:
        """Return a point (n,) of the line to the last digit: where a root merges as well the line is known to half."""
        return newton(self.chain, q, self.T, steps=6, cutoff=CURVE_RANK)

    def points(self, t: Array) -> Array:
        """Return joint vectors (k, n) so far along it (k,), lengths from `through`."""
        return self.through + np.multiply.outer(t, self.way * self.chain.joints.unit)

    @cached_property
    def samples(self) -> Array:
        """(k, n) points along what u counts."""
        return self.points(np.linspace(*self._ends, 33))

    def point(self, u: float) -> Array:
        """Return the point (n,) at u in [0, 1], a task's virtual joints included."""
        low, high = self._ends
        return self._held(self.points(np.array([low + u * (high - low)]))[0])

    def points_at_joint(self, joint: int, value: float) -> Array:
        """Return the point (1, n) where a slide has a value, or none."""
        step = float(self.way[joint] * self.chain.joints.unit[joint])
        if abs(step) <= TINY:
            return np.zeros((0, self.chain.n))
        return self._held(self.points(np.array([(value - self.through[joint]) / step]))[0])[None]

    @cached_property
    def direction(self) -> Array:
        """(n,) unit tangent."""
        return self.way[: self.shown]

    @cached_property
    def _span(self) -> tuple[float, float] | None:
        """From where to where all joints are inside their limits; where only their slack holds, a single point."""
        still = np.abs(self.way) <= JOINT_TURNS
        others = np.where(still[:, None], self.limits, FREE)
        if not self.chain.joints.inside_limits(self.through, others)[1]:
            return None
        room = LIMIT_SLACK / np.abs(self.way[~still] * self.chain.joints.unit[~still])
        low, high = float(self._stops[:, 0].max()), float(self._stops[:, 1].min())
        if float((self._stops[:, 0] - room).max()) > float((self._stops[:, 1] + room).min()):
            return None
        return (low, high) if low <= high else ((low + high) / 2, (low + high) / 2)

    @cached_property
    def inside(self) -> tuple[tuple[float, float], ...]:
        """The interval of u where it lies inside the joint limits, exactly."""
        if self._span is None:
            return ()
        low, high = self._ends
        a, b = ((np.clip(t, low, high) - low) / (high - low) for t in self._span)
        return ((float(a), float(b)),)

    @cached_property
    def full_representative(self) -> Array:
        """The point with the shortest ways of those inside the limits, or of all."""
        low, high = self._span or (-np.inf, np.inf)
        q = self._held(self.points(np.array([np.clip(self._foot, low, high)]))[0])
        return self.chain.joints.unwound(q, np.zeros(self.chain.n), self.limits if self._span else FREE)

    def _nearest(self, q_now: Array, weights: Array) -> Array | None:
        if self._span is None:
            return None
        q_now, counts = self.padded(q_now), self.counts(weights) * self.way
        along = float(counts @ self.way)
        gap = (q_now - self.through) / self.chain.joints.unit
        t = float(counts @ np.where(self.way == 0, 0.0, gap)) / along if along > TINY else self._foot
        q = self._held(self.points(np.array([np.clip(t, *self._span)]))[0])
        return self.chain.joints.unwound(q, q_now, self.limits)[: self.shown]

    def distances(self, q: Array) -> Array:
        """Return how far joint vectors (m, n), virtual joints included, are from the line."""
        gap = self.gaps(q, self.through)
        return np.linalg.norm(gap - np.multiply.outer(gap @ self.way, self.way), axis=-1)

    @cached_property
    def relation(self) -> str:
        """The relation in words, such as 'joint_1 - joint_3 = 120 mm', where two slides move alike."""
        if len(self.free) != 2:
            return ""
        i, j = self.free
        sign = -np.sign(self.way[i] * self.way[j])
        if abs(abs(self.way[i]) - abs(self.way[j])) > SLIDES_ALIKE:
            return ""
        total = float(self.through[i] + sign * self.through[j])
        return related(self.names, (i, j), float(sign), total, slides=True)
