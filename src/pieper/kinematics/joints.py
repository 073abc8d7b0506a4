"""The one joint metric: differences, distances, whole turns and limits of joint vectors, angles around the circle."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from pieper.kinematics.arrays import Array, ArrayLike, Bools, Indices
from pieper.kinematics.whole_turns import TURN as TURN
from pieper.kinematics.whole_turns import WholeTurns
from pieper.kinematics.whole_turns import short_way as short_way
from pieper.tolerances import LIMIT_SLACK


def wrapped(angle: ArrayLike) -> Array:
    """Return angles (...) a whole number of turns away, in (-pi, pi], rad."""
    return np.asarray(np.pi - (np.pi - np.asarray(angle, float)) % TURN)


def turned_from(start: ArrayLike, angle: ArrayLike) -> Array:
    """Return angles (...) a whole number of turns away, in the turn from `start` (...) on, rad."""
    first = np.asarray(start, np.float64)
    return np.asarray(first + (np.asarray(angle, np.float64) - first) % TURN, np.float64)


def inside(q: Array, limits: Array) -> Bools:
    """Return which entries of q (..., n) lie inside limits (n, 2), up to rounding at a stop."""
    return (q >= limits[:, 0] - LIMIT_SLACK) & (q <= limits[:, 1] + LIMIT_SLACK)


@dataclass(frozen=True, eq=False)
class JointSpace:
    """How joint vectors of an arm are measured: angles in radians, slides per characteristic length.

    Args:
        prismatic: (n,) bool.
        length: The arm's characteristic length, m.
        coupled: How whole turns move the joints' numbers, where they are no whole turns of each joint by itself.
    """

    prismatic: Bools
    length: float
    coupled: WholeTurns | None = None

    @cached_property
    def unit(self) -> Array:
        """(n,) what counts as one: 1 rad, or the characteristic length, m."""
        return np.where(self.prismatic, self.length, 1.0)

    @cached_property
    def _turning(self) -> bool:
        return self.coupled is None and not bool(self.prismatic.any())

    def first(self, count: int) -> JointSpace:
        """Return the space of the first joints alone."""
        coupled = None if self.coupled is None else self.coupled.first(count)
        return JointSpace(self.prismatic[:count], self.length, coupled)

    def way(self, end: Array, start: Array) -> Array:
        """Return end - start (..., n), angles the short way round, rad or m."""
        gap = np.asarray(end - start)
        if self.coupled is not None:
            axes = self.coupled.axes(gap)
            return self.coupled.joints(np.where(self.prismatic, axes, short_way(axes)))
        return short_way(gap) if self._turning else np.where(self.prismatic, gap, short_way(gap))

    def difference(self, a: Array, b: Array) -> Array:
        """Return a - b (..., n) without units, angles the short way round."""
        return self.way(a, b) if self._turning else self.way(a, b) / self.unit

    def apart(self, a: Array, b: Array) -> Array:
        """Return the largest joint difference (...) without units, angles the short way round."""
        return np.abs(self.difference(a, b)).max(-1, initial=0.0)

    def straight(self, q: Array, near: Array, weights: Array | None = None) -> Array:
        """Return Euclidean distances (...) without units, whole turns counted: angles are taken as they stand.

        Weights (n,) say how much the square of each joint's difference counts; all the same if None.
        """
        gap = q - near if self._turning else (q - near) / self.unit
        square = gap * gap
        return np.sqrt(np.sum(square if weights is None else weights * square, axis=-1))

    def wrapped(self, q: Array) -> Array:
        """Return q (..., n) with its angles in (-pi, pi]; of coupled joints those of the axes."""
        if self.coupled is not None:
            axes = self.coupled.axes(q)
            return self.coupled.joints(np.where(self.prismatic, axes, wrapped(axes)))
        return wrapped(q) if self._turning else np.where(self.prismatic, q, wrapped(q))

    def turns(self, q: Array, near: Array, limits: Array) -> Array:
        """Return the whole turns (..., n) that bring q as near to `near` as limits (n, 2) allow; zero for slides.

        Of coupled joints the parts of a turn by which their numbers move while axes make whole turns.
        """
        if self.coupled is not None:
            n, shape = self.coupled.n, np.broadcast_shapes(np.shape(q), np.shape(near))
            ends = np.array(np.broadcast_to(limits, (n, 2)), float)
            flat, to = (np.broadcast_to(x, shape).reshape(-1, n) for x in (q, near))
            return (self.coupled.nearest(flat, to, ends, self.unit**-2.0).reshape(shape) - q) / TURN
        turns = np.round((near - q) / TURN)
        lowest = np.ceil((limits[:, 0] - LIMIT_SLACK - q) / TURN)
        highest = np.floor((limits[:, 1] + LIMIT_SLACK - q) / TURN)
        possible = lowest <= highest
        turns = np.where(possible, np.clip(turns, lowest, np.maximum(lowest, highest)), turns)
        return turns if self._turning else np.where(self.prismatic, 0.0, turns)

    def unwound(self, q: Array, near: Array, limits: Array) -> Array:
        """Return q (..., n) with each angle moved by whole turns as near to `near` as its limits allow."""
        return q + TURN * self.turns(q, near, limits)

    def inside_limits(self, q: Array, limits: Array) -> tuple[Array, Bools]:
        """Return q (..., n), a whole turn added where only that lies inside, and whether all are inside (...)."""
        if self.coupled is not None:
            keep = np.logical_and.reduce(inside(q, limits), axis=-1, keepdims=True)
            moved = np.where(keep, q, self.unwound(q, q, limits))
            ok = np.logical_and.reduce(inside(moved, limits), axis=-1)
            return np.where(ok[..., None], moved, q), ok
        moved = self.unwound(q, q, limits)
        ok = inside(moved, limits)
        return np.where(ok, moved, q), np.logical_and.reduce(ok, axis=-1)

    def least_over(self, q: Array, limits: Array) -> Array:
        """Return by how much joints (k, n) are beyond limits (n, 2), in the whole turns where that is least.

        Rad or m; below zero where it is inside.
        """
        low, high = limits.T
        if self.coupled is not None:
            q = np.array([self.coupled.least_outside(row, limits) for row in q]).reshape(q.shape)
            return np.maximum(low - q, q - high)
        # the last variant below the upper limit, or below the lower one's next, and the one after it
        top = np.where(np.isfinite(high), high, np.where(np.isfinite(low), low + TURN, q))
        below = np.where(self.prismatic, q, q + TURN * np.floor((top - q) / TURN))
        above = np.where(self.prismatic, q, below + TURN)
        return np.minimum(*(np.maximum(low - x, x - high) for x in (below, above)))

    def variants(self, q: Array, limits: Array) -> Array:
        """Return every variant (k, n) of q (n,) by whole turns inside limits (n, 2); what is unlimited stays."""
        if self.coupled is not None:
            return self.coupled.inside(q, limits)
        choices: list[Array] = []
        for value, (lower, upper), slides in zip(q, limits, self.prismatic, strict=True):
            if slides or not (np.isfinite(lower) and np.isfinite(upper)):
                choices.append(np.array([value]))
                continue
            first = int(np.ceil((lower - LIMIT_SLACK - value) / TURN))
            last = int(np.floor((upper + LIMIT_SLACK - value) / TURN))
            choices.append(value + TURN * np.arange(first, last + 1))
        return np.array(list(itertools.product(*choices)), float).reshape(-1, len(q))

    def distinct(self, q: Array, tolerance: float) -> Indices:
        """Return the rows of q (k, n) that are no nearer than a tolerance (without units) to one kept before them."""
        near = self.apart(q[:, None], q[None]) < tolerance
        keep: list[int] = []
        for i in range(len(q)):
            if not near[i, keep].any():
                keep.append(i)
        return np.array(keep, np.int64)

    def without_repeats(self, q: Array, valid: Bools, tolerance: float) -> Bools:
        """Return valid (N, M) without rows of q (N, M, n) that repeat an earlier valid one of their pose."""
        first = valid.copy()
        for b in range(1, q.shape[1]):
            near = self.apart(q[:, b : b + 1], q[:, :b]) < tolerance
            first[:, b] &= ~(near & first[:, :b]).any(1)
        return first
