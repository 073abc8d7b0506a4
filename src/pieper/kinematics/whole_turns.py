"""Whole turns of coupled joints: the steps of the joints' numbers by which the arm's axes make whole turns."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from pieper.kinematics.arrays import Array, ArrayLike, Bools, Indices
from pieper.tolerances import LIMIT_SLACK, RELATIVE_ROUNDING

TURN = 2 * np.pi
#: How many turns a joint without a limit that is tied to others is looked for around where it is.
WOUND_TURNS = 8
#: Candidates that are compared at once: it bounds memory alone.
_AT_ONCE = 1 << 20


def short_way(angle: ArrayLike) -> Array:
    """Return angles (...) a whole number of turns away, in [-pi, pi), rad: differences the short way round."""
    given = np.asarray(angle, float)
    # the remainder that NumPy offers takes ten times as long on many angles, and drops digits of small ones
    turned = np.atleast_1d(given) + np.pi
    turned /= TURN
    np.floor(turned, out=turned)
    turned *= -TURN
    turned += given
    return turned.reshape(given.shape)


@dataclass(frozen=True, eq=False)
class WholeTurns:
    """The grid of joint vectors that put the arm's axes where one of them does.

    The axes are at v = coupling @ q. A whole turn of one axis moves no link, but it moves the number of each joint that
    drives it, by what the inverse of the coupling says: with an axis at 0.5 q2 + q3, a whole turn of q2 leads back to
    the same posture once q3 has made half a turn the other way.

    Args:
        coupling: (n, n), regular.
        prismatic: (n,) bool, which axes slide.
    """

    coupling: Array
    prismatic: Bools

    @cached_property
    def inverse(self) -> Array:
        """(n, n) joint values = inverse @ values of the axes."""
        return np.asarray(np.linalg.inv(self.coupling), np.float64)

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.prismatic)

    def first(self, count: int) -> WholeTurns:
        """Return that of the first joints alone, which are tied to none of the others."""
        return WholeTurns(self.coupling[:count, :count], self.prismatic[:count])

    @cached_property
    def blocks(self) -> tuple[Indices, ...]:
        """The joints that are tied to each other, and those that stand alone."""
        linked = (self.coupling != 0) | (self.coupling.T != 0) | np.eye(self.n, dtype=bool)
        for _ in range(len(linked)):
            linked = linked @ linked
        first = np.argmax(linked, axis=1)
        return tuple(np.flatnonzero(first == j) for j in np.unique(first))

    def axes(self, q: Array) -> Array:
        """Return the values (..., n) of the axes at joint vectors q (..., n)."""
        return q @ self.coupling.T

    def joints(self, values: Array) -> Array:
        """Return the joint vectors (..., n) at which the axes have these values (..., n)."""
        return values @ self.inverse.T

    def between(self, limits: Array, around: Array) -> list[Array]:
        """Return for each block the moves (k, n) by whole turns that can matter inside limits.

        Args:
            limits: (n, 2).
            around: (k, n) joint vectors; a side without a limit is looked at as far as `WOUND_TURNS` from them.
        """
        far = WOUND_TURNS * TURN
        lower = np.where(np.isfinite(limits[:, 0]), limits[:, 0], around.min(0) - far)
        upper = np.where(np.isfinite(limits[:, 1]), limits[:, 1], around.max(0) + far)
        ends = self.coupling * lower, self.coupling * upper
        least, most = np.minimum(*ends).sum(1), np.maximum(*ends).sum(1)
        values = self.axes(around)
        first = np.ceil((least - LIMIT_SLACK - values.max(0)) / TURN - RELATIVE_ROUNDING).astype(int)
        last = np.floor((most + LIMIT_SLACK - values.min(0)) / TURN + RELATIVE_ROUNDING).astype(int)
        moves: list[Array] = []
        for block in self.blocks:
            turning = block[~self.prismatic[block]]
            counts = itertools.product(*(range(first[i], max(last[i], first[i]) + 1) for i in turning))
            turns = np.array(list(counts), float)
            moves.append(TURN * turns @ self.inverse[:, turning].T)
        return moves

    def nearest(self, q: Array, near: Array, limits: Array, weight: Array) -> Array:
        """Return q (k, n) moved by whole turns inside limits (n, 2), the nearest to `near` (k, n) of those.

        Where none lies inside, the joints of that block are moved by whole turns of the axes the short way.

        Args:
            q: (k, n) rad or m.
            near: (k, n) rad or m.
            limits: (n, 2).
            weight: (n,) of the squared differences by which they are compared.
        """
        if not len(q):
            return q
        gap = self.axes(q - near)
        gap = np.where(self.prismatic, gap, short_way(gap))
        out = np.asarray(near + self.joints(gap), np.float64)
        endless = [not np.isfinite(limits[block]).any() for block in self.blocks]
        # what has no limits is not looked at around limits
        narrow = limits.copy()
        for block in itertools.compress(self.blocks, endless):
            narrow[block] = out[0, block, None]
        for block, moves, free in zip(self.blocks, self.between(narrow, out), endless, strict=True):
            moves = (self._nearer(block, out - near, weight) if free else moves)[:, block]
            low, high = limits[block].T
            rows = max(1, _AT_ONCE // max(1, moves.size))
            for first in range(0, len(q), rows):
                at = np.s_[first : first + rows]
                candidates = out[at, None, block] + moves
                beyond = np.maximum(low - candidates, candidates - high).max(-1)
                away = (weight[block] * np.square(candidates - near[at, None, block])).sum(-1)
                best = np.argmin(np.where(beyond <= LIMIT_SLACK, away, np.inf), axis=1)
                chosen = candidates[np.arange(len(best)), best]
                held = np.take_along_axis(beyond, best[:, None], 1) <= LIMIT_SLACK
                out[at, block] = np.where(held, chosen, out[at, block])
        return out

    def _nearer(self, block: Indices, gap: Array, weight: Array) -> Array:
        """Return the moves (m, n) of a block that can bring nearer what is gap (k, n) away, axes by half turns.

        What is nearer than r differs by no more than |C_i| r at axis i (C of the weighed joints), and no axis is more
        than half a turn away.
        """
        heavy = np.sqrt(weight[block])
        weighed = np.divide(self.coupling[:, block], heavy, out=np.zeros((self.n, len(block))), where=heavy > 0)
        farthest = float(np.linalg.norm(gap[:, block] * heavy, axis=1).max())
        turns = np.floor((np.linalg.norm(weighed, axis=1) * farthest + np.pi) / TURN + RELATIVE_ROUNDING).astype(int)
        turning = block[~self.prismatic[block]]
        counts = itertools.product(*(range(-turns[i], turns[i] + 1) for i in turning))
        return TURN * np.array(list(counts), float) @ self.inverse[:, turning].T

    def least_outside(self, q: Array, limits: Array) -> Array:
        """Return a joint vector q (n,) moved by the whole turns that are outside limits (n, 2) least, block by block.

        The joint that turns and is outside most comes first, slides that are tied to it second: one that is far outside
        is not brought nearer by winding its screw beyond a limit.
        """
        out = np.array(q, np.float64)
        low, high = limits.T
        for block in self.blocks:
            turning = block[~self.prismatic[block]]
            if not len(turning):
                continue
            moves = TURN * self.inverse[:, turning]
            ways, missing = np.linalg.pinv(moves[turning]), np.clip(out, low, high) - out
            start = out + moves @ np.round(ways @ missing[turning])
            # no better one has a joint that turns outside by more than this one
            least = float(np.maximum(low - start, start - high)[turning].max(initial=0.0))
            room = np.column_stack([low - least - start, high + least - start])[turning]
            room = np.where(np.isfinite(room), room, WOUND_TURNS * TURN * np.sign(room))
            reach = np.sort(ways[:, :, None] * room, axis=-1).sum(1) + RELATIVE_ROUNDING * np.array([-1.0, 1.0])
            counts = itertools.product(*(range(int(np.ceil(a)), int(np.floor(b)) + 1) for a, b in reach))
            tried = start + np.array([np.zeros(len(turning)), *counts]) @ moves.T
            beyond = np.maximum(np.maximum(low - tried, tried - high), 0.0)
            first, second = (beyond[:, part].max(1, initial=0.0) for part in (turning, np.setdiff1d(block, turning)))
            out = tried[np.lexsort((second, first))[0]]
        return out

    def inside(self, q: Array, limits: Array) -> Array:
        """Return every variant (k, n) of a joint vector q (n,) by whole turns inside limits (n, 2), in order.

        A joint without limits keeps its one value.
        """
        kept: Bools = np.all(np.isfinite(limits), axis=1)
        narrow = np.where(kept[:, None], limits, q[:, None])
        parts: list[Array] = []
        for block, moves in zip(self.blocks, self.between(narrow, q[None]), strict=True):
            some = q[block] + moves[:, block]
            low, high = narrow[block].T
            parts.append(some[((some >= low - LIMIT_SLACK) & (some <= high + LIMIT_SLACK)).all(1)])
        rows = [np.concatenate(row) for row in itertools.product(*parts)]
        order = np.argsort(np.concatenate(self.blocks))
        return np.array(rows).reshape(-1, len(q))[:, order]
