"""A joint path as cubic pieces: the spline through points, its derivatives, and how far it strays."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper import _kernel, arguments
from pieper.errors import InputError
from pieper.kinematics.arrays import Array, ArrayLike, Indices


@dataclass(frozen=True, eq=False)
class JointCurve:
    """q(s) in pieces of third degree, each derivative given at the piece's beginning.

    Attributes:
        s: (k + 1,) where pieces begin and end.
        q: (k, n) rad or m.
        d1: (k, n) dq/ds.
        d2: (k, n) d2q/ds2.
        d3: (k, n) d3q/ds3.
    """

    s: Array
    q: Array
    d1: Array
    d2: Array
    d3: Array

    @staticmethod
    def through(s: Array, q: Array) -> JointCurve:
        """Return the spline through points q (N, n) at s (N,), twice continuously differentiable."""
        return JointCurve(s, q[:-1], *_kernel.spline(s, q))

    @property
    def end(self) -> Array:
        """(n,) where it ends."""
        h = self.s[-1] - self.s[-2]
        return self.q[-1] + h * (self.d1[-1] + h * (self.d2[-1] / 2 + h * self.d3[-1] / 6))

    @property
    def points(self) -> Array:
        """(k + 1, n) where pieces begin and end."""
        return np.vstack([self.q, self.end])

    def piece(self, s: Array) -> Indices:
        """Return the number of the piece at s (...)."""
        return np.clip(np.searchsorted(self.s, s, side="right") - 1, 0, len(self.q) - 1)

    def at(self, s: Array) -> tuple[Array, Array, Array, Array]:
        """Return q and its first three derivatives by s (..., n) at s (...)."""
        i = self.piece(s)
        h = (np.asarray(s) - self.s[i])[..., None]
        q, d1, d2, d3 = self.q[i], self.d1[i], self.d2[i], self.d3[i]
        return q + h * (d1 + h * (d2 / 2 + h * d3 / 6)), d1 + h * (d2 + h * d3 / 2), d2 + h * d3, d3

    def split(self, s: Array) -> JointCurve:
        """Return the same curve whose pieces begin and end at s (k + 1,), which holds all of its own."""
        if len(s) == len(self.s):
            return self
        i = self.piece(s[:-1])
        h = (s[:-1] - self.s[i])[:, None]
        q, d1, d2, d3 = self.q[i], self.d1[i], self.d2[i], self.d3[i]
        return JointCurve(s, q + h * (d1 + h * (d2 / 2 + h * d3 / 6)), d1 + h * (d2 + h * d3 / 2), d2 + h * d3, d3)

    def between_points(self) -> float:
        """Return how far the pieces stray from their own chords, the largest of all joints: rad, or m of a slide."""
        return _kernel.strays(self.s, self.d2, self.d3)


def checked_points(q: ArrayLike, what: str = "q") -> Array:
    """Return joint points (N, n) that a curve can go through, or say what is wrong with them.

    Raises:
        InputError: Wrong shape, fewer than two points, numbers that are not finite, or a point given twice running.
    """
    points = np.array(arguments.numbers(q, what, "joint points (N, n)"))
    if points.ndim != 2 or not points.shape[1]:
        raise InputError(f"{what} must be joint points (N, n), got shape {points.shape}.", given=points.shape)
    if len(points) < 2:
        raise InputError(f"a motion needs at least 2 points, {what} has {len(points)}.", given=len(points))
    bad = ~np.isfinite(points)
    if bad.any():
        i, j = (int(k) for k in np.argwhere(bad)[0])
        raise InputError(f"{what} must be finite, got {points[i, j]} at point {i + 1}, joint {j + 1}.", index=(i, j))
    same = ~np.diff(points, axis=0).any(1)
    if same.any():
        i = int(np.argmax(same))
        raise InputError(
            f"points {i + 1} and {i + 2} of {what} are the same: a stretch of no length has no direction. Leave one "
            "out; a rest is a wait of a Program.",
            index=i + 1,
        )
    return points
