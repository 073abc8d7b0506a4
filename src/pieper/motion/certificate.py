"""Proven bounds of the tool's speed and acceleration on each piece of a curve."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from pieper.kinematics.arrays import Array, Bools, Indices
from pieper.motion.profile import Profile
from pieper.motion.tool_bounds import ToolCurve
from pieper.tolerances import BOUND_NEAR, LIMIT_BINDS


def vector_peaks(value: Array, strays: Array, x: Array) -> Array:
    """Return a bound (k,) of |f(s)| sqrt(x) on each piece, f within `strays` of the line between its ends' values.

    Args:
        value: (k + 1, 3) f at the pieces' ends.
        strays: (k,) how far f may be from the line between.
        x: (k + 1,) linear on each piece.
    """
    a, b = value[:-1], value[1:]
    aa, ab, bb = (a * a).sum(1), (a * b).sum(1), (b * b).sum(1)
    x0, x1 = x[:-1], x[1:]
    # Bernstein coefficients of |line|^2 x, a cubic
    top = np.max([aa * x0, (2 * ab * x0 + aa * x1) / 3, (bb * x0 + 2 * ab * x1) / 3, bb * x1], axis=0)
    return np.sqrt(np.maximum(top, 0.0)) + strays * np.sqrt(np.maximum(x0, x1))


def tool_acceleration_peaks(tool: ToolCurve, h: Array, x: Array) -> Array:
    """Return a bound (k,) of the tool point's acceleration p' u + p'' x on each piece.

    Its second derivative by s is 5 u p''' + x p'''', whose bounds say how far it departs from the larger of its ends.
    """
    u = np.diff(x) / (2 * h)
    ends = [np.linalg.norm(tool.point[k] * u[:, None] + tool.bend[k] * x[k][:, None], axis=1) for k in _ENDS]
    bent = 5 * np.abs(u) * tool.third + np.maximum(x[:-1], x[1:]) * tool.fourth
    return np.maximum(*ends) + h**2 / 8 * bent


@dataclass(frozen=True, eq=False)
class Felt:
    """A vector f(s) of the tool and what of it is limited: f v (power 1) or f a + f' v^2 (2), v = ds/dt, a = dv/dt.

    Attributes:
        at: From places s (k,) to f and f' (k, 3) there.
        power: 1 or 2.
        second: (c,) bound of |f''| on each cell of a grid.
        third: (c,) bound of |f'''|.
    """

    at: Callable[[Array], tuple[Array, Array]]
    power: int
    second: Array
    third: Array


def felt_at_ends(felt: Felt, profile: Profile) -> Array:
    """Return how large (k,) what is felt is where pieces of a profile begin and end, the larger of both."""
    return _pieces(felt, profile)[3]


def peaks_in_time(felt: Felt, cell: Indices, profile: Profile, allowed: Array, least: float) -> Array:
    """Return a bound (k,) of what is felt over what is allowed, on pieces of a profile that lie on one cell each.

    An eighth of its second derivative by time, times the piece's length squared, is how far it departs from the larger
    of its ends. Where a piece lasts long that is far: pieces whose bounds are among the largest are split in time until
    their bounds are near values that are there.

    Args:
        felt: What is felt.
        cell: (k,) the cell of each piece.
        profile: s(t) in k pieces.
        allowed: (k,) what is allowed on each.
        least: Bounds below this, over what is allowed, are not looked at more closely; above zero.
    """
    parts, begin, end, sizes = _pieces(felt, profile)
    out = np.zeros(len(cell))
    while True:
        limit = allowed[parts.piece]
        sizes = sizes / limit
        bounds = sizes + parts.strays(felt, cell, begin, end) / limit
        # the largest value that is there for sure
        least = max(least, float(sizes.max()))
        loose = (bounds > least * (1 - LIMIT_BINDS)) & (bounds - sizes > least * BOUND_NEAR)
        np.maximum.at(out, parts.piece[~loose], bounds[~loose])
        if not loose.any():
            return out
        # how far it strays falls with the square of the length
        parts = parts.split(loose, np.ceil(np.sqrt((bounds - sizes)[loose] / (least * BOUND_NEAR))).astype(np.int64))
        begin, end = felt.at(parts.c[:, 0]), felt.at(np.minimum(parts.after(parts.h)[:, 0], 1.0))
        sizes = parts.ends(felt, begin, end)


_Ends = tuple[Array, Array]


def _pieces(felt: Felt, profile: Profile) -> tuple[_Parts, _Ends, _Ends, Array]:
    """Return the pieces of a profile, f and f' where they begin and end, and how large (k,) what is felt is there."""
    parts = _Parts(np.arange(len(profile.c)), np.diff(profile.t), profile.c)
    f, slope = felt.at(np.append(profile.c[:, 0], 1.0))
    begin, end = (f[:-1], slope[:-1]), (f[1:], slope[1:])
    return parts, begin, end, parts.ends(felt, begin, end)


@dataclass(frozen=True, eq=False)
class _Parts:
    """Stretches of a profile: of which piece (k,), how long h (k,) in time, and s(t) where each begins, c (k, 4)."""

    piece: Indices
    h: Array
    c: Array

    def after(self, h: Array) -> Array:
        """Return s and its derivatives by time (k, 4) so long after the beginnings."""
        s, v, a, j = self.c.T
        return np.stack([s + h * (v + h * (a / 2 + h * j / 6)), v + h * (a + h * j / 2), a + h * j, j], 1)

    def split(self, which: Bools, count: Indices) -> _Parts:
        """Return some of them cut into so many even parts each."""
        of = np.repeat(np.flatnonzero(which), count)
        number = np.arange(len(of)) - np.repeat(np.cumsum(count) - count, count)
        h = self.h[of] / np.repeat(count, count)
        whole = _Parts(self.piece[of], h, self.c[of])
        return replace(whole, c=whole.after(number * h))

    def ends(self, felt: Felt, begin: _Ends, end: _Ends) -> Array:
        """Return the larger (k,) of what is felt at both ends, from f and f' there."""
        sizes: list[Array] = []
        for (f, slope), x in ((begin, self.c), (end, self.after(self.h))):
            v, a = x[:, 1:2], x[:, 2:3]
            sizes.append(np.linalg.norm(f * v if felt.power == 1 else f * a + slope * v**2, axis=1))
        return np.maximum(*sizes)

    def strays(self, felt: Felt, cell: Indices, begin: _Ends, end: _Ends) -> Array:
        """Return by how much (k,) more it can be between: an eighth of its second derivative, times h^2."""
        h, (_, v, a, j), last = self.h, self.c.T, self.after(self.h)
        most, j = np.maximum(np.abs(a), np.abs(last[:, 2])), np.abs(j)
        # Bernstein coefficients of a speed that is a quadratic of time
        v = np.max([v, v + h * a / 2, last[:, 1]], 0)
        third, second = felt.third[cell][self.piece], felt.second[cell][self.piece]
        size, slope = (np.linalg.norm(np.stack(both), axis=-1).max(0) for both in zip(begin, end, strict=True))
        slope = slope + second * h * v
        size = size + slope * h * v
        if felt.power == 1:
            return h**2 / 8 * (second * v**3 + 3 * slope * v * most + size * j)
        return h**2 / 8 * (third * v**4 + 6 * second * v**2 * most + slope * (3 * most**2 + 4 * v * j))


_ENDS = (slice(None, -1), slice(1, None))
