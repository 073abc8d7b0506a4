"""Every feasible interval of the turn at a pose, one branch and one set of whole turns each, and what ends it.

The joint vectors that hold a pose with the turn free form self-motions of the arm with the turn as one more joint. What
bounds them are points at which a joint stands at a limit, solved for with that joint held there, and folds, at which
the turn goes back and one branch becomes another.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass, field, replace
from typing import TypeAlias

import numpy as np

from pieper.kinematics.arrays import Array, Bools, Indices
from pieper.kinematics.joints import TURN
from pieper.motion.route.curves_at import curves_at
from pieper.motion.route.setting import Setting
from pieper.solver.redundant.bounded_motion import BoundedMotion
from pieper.solver.words.labels import posture_words
from pieper.tolerances import (
    ARC_STILL,
    AT_A_LIMIT,
    FOLD_FOUND,
    FOLD_NARROW,
    LIMIT_SLACK,
    ROUNDING,
    SAME_FOLD,
    SHORTEST_ARC,
)

#: What ends an arc: a joint's limit, the turn's own interval, a fold, or nothing since it goes all the way round.
LIMIT, INTERVAL, FOLD, ROUND = "limit", "interval", "fold", "round"
#: Steps and golden sections that place a crossing or a fold: to rounding of the parameter.
HALVINGS, SECTIONS = 40, 60


@dataclass(frozen=True)
class End:
    """What ends an arc.

    Attributes:
        kind: "limit", "interval" (the turn's own), "fold" (two branches meet there, at a singular posture of the arm
            without the turn), or "round" (nothing: the turn goes all the way round).
        joint: Name of the joint at its limit, or None.
        value: The limit, rad or m, or None.
    """

    kind: str
    joint: str | None = None
    value: float | None = None
    side: str = field(default="", repr=False)

    def __str__(self) -> str:
        if self.kind == LIMIT:
            return f"{self.joint} at its {self.side} limit"
        if self.kind == INTERVAL:
            return f"the {self.side} end of the turn's interval"
        return "a fold, where two branches meet" if self.kind == FOLD else "all the way round"


@dataclass(frozen=True, eq=False)
class Arc:
    """One interval of the turn on one branch.

    Attributes:
        branch: Posture label in the arc's middle.
        winding: (n,) whole turns that each joint is away from (-pi, pi] in the arc's middle.
        lo: Where it begins, rad (or the spare joint's value, rad or m, where the turn is held).
        hi: Where it ends; not less than lo, and up to a turn and more above it.
        ends: What ends it at lo and at hi.
        q: (k, n) joint vectors along it, from lo to hi, whole turns as the limits want them.
        turn: (k,) the turn at these.
    """

    branch: str
    winding: tuple[int, ...]
    lo: float
    hi: float
    ends: tuple[End, End]
    q: Array = field(repr=False)
    turn: Array = field(repr=False)


#: Whole turns (m,) of the coordinates, and the intervals of a curve's parameter that are inside the limits with them.
_Lifted: TypeAlias = "list[tuple[Array, list[tuple[float, float]]]]"


def arcs_at(setting: Setting, T: Array) -> tuple[Arc, ...]:
    """Return every arc of a pose (4, 4), its z axis the one that is meant, by branch and turn."""
    plan = setting.plan
    out: list[Arc] = []
    for motion in curves_at(setting, T):
        if motion.dimension == 1 and len(motion.samples) > 1:
            out += _arcs_of(setting, motion)
    middles = np.reshape([arc.q[len(arc.q) // 2] for arc in out], (-1, setting.n))
    out = [replace(arc, branch=label) for arc, label in zip(out, posture_words(plan, middles), strict=True)]
    return tuple(sorted(out, key=lambda arc: (arc.branch, arc.winding, arc.lo)))


def coordinate(setting: Setting) -> int:
    """Return which coordinate an arc's ends are told in: the turn, or the spare joint."""
    return setting.n if setting.turns else setting.curves.reduction.locked[0]


def _arcs_of(setting: Setting, motion: BoundedMotion) -> list[Arc]:
    curve = _Curve(setting, motion)
    found: list[tuple[float, float, Array, float, float]] = []
    for lift, pieces in curve.lifted():
        for a, b in pieces:
            cuts = [a, *(f for f in curve.folds if a < f < b), b]
            found += [(c, d, lift, a, b) for c, d in itertools.pairwise(cuts) if d - c > SHORTEST_ARC]
    # all ends at once
    ends = curve.points(np.array([u for arc in found for u in arc[:2]])).reshape(len(found), 2, setting.m)
    return [curve.arc(*arc, at) for arc, at in zip(found, ends, strict=True)]


class _Curve:
    """A self-motion with its folds, begun where a closed one may be cut.

    Args:
        setting: What is solved.
        motion: The self-motion; points where it meets limits are among its samples.
    """

    def __init__(self, setting: Setting, motion: BoundedMotion) -> None:
        self.setting = setting
        self.motion = motion
        self.limits = setting.limits
        self.by = coordinate(setting)
        self.sign = -1.0 if setting.turns else 1.0
        self.u = motion.u
        self.q = motion.samples
        self.closed = motion.closed
        self.round = self.q[0], self.q[-1]
        self.folds = self._folds()
        self.whole = False
        #: whole turns of a joint that are tried instead of all that its limits allow
        self.turns_of: dict[int, list[int]] = {}
        if self.closed:
            self._begin()

    def points(self, u: Array) -> Array:
        """Return points (k, m) at parameters (k,); a closed curve goes round again and again."""
        if self.closed:
            turned = np.floor(u)
            turned = np.where(u == turned, np.maximum(turned - 1.0, 0.0), turned)
            return self.motion.points(u - turned) + turned[:, None] * (self.round[1] - self.round[0])
        return self.motion.points(np.clip(u, 0.0, 1.0))

    def _folds(self) -> list[float]:
        """Return the parameters at which the coordinate turns back."""
        v = self.sign * self.q[:, self.by]
        d = np.diff(v)
        out: list[float] = []
        # points that are listed twice say nothing
        moved = np.flatnonzero(np.abs(d) > ARC_STILL)
        sense = d[moved] > 0
        turned = np.flatnonzero(sense[:-1] != sense[1:])
        spans = [(float(self.u[moved[i]]), float(self.u[moved[i + 1] + 1]), bool(sense[i])) for i in turned]
        if self.closed and len(moved) > 1 and sense[-1] != sense[0]:
            spans.append((float(self.u[moved[-1]]) - 1.0, float(self.u[moved[0] + 1]), bool(sense[-1])))
        for low, high, peak in spans:
            out.append(self._extreme(low, high, peak) % 1.0 if self.closed else self._extreme(low, high, peak))
        return sorted(out)

    def _extreme(self, low: float, high: float, peak: bool) -> float:
        """Return where the coordinate is largest or smallest on [low, high], by golden section."""
        ratio = (np.sqrt(5.0) - 1) / 2
        a, b = low, high
        for _ in range(SECTIONS):
            c, d = b - ratio * (b - a), a + ratio * (b - a)
            v = self.sign * self._round(np.array([c, d]))[:, self.by]
            if (v[0] > v[1]) == peak:
                b = d
            else:
                a = c
            if b - a < SAME_FOLD:
                break
        return float((a + b) / 2)

    def _round(self, u: Array) -> Array:
        """Return points at parameters that may be below zero on a closed curve."""
        under = (u < 0) & self.closed
        return self.motion.points(np.where(under, u + 1.0, u)) - under[:, None] * (self.round[1] - self.round[0])

    def _begin(self) -> None:
        """Let a closed curve begin where no arc goes on: outside the limits, or at a fold; else it is whole."""
        outside = ~self.setting.chain.joints.inside_limits(self.q, self.limits)[1]
        start = None
        if outside.any():
            start = float(self.u[int(np.argmax(outside))])
        elif self.folds:
            start = self.folds[0]
        if start is None:
            self._unroll()
        elif start > 0.0:
            u = np.unique(np.concatenate([self.u, self.u + 1.0, [start, start + 1.0]]))
            u = u[(u >= start) & (u <= start + 1.0)]
            self._again(u)
            self.folds = sorted(f if f >= start else f + 1.0 for f in self.folds)

    def _again(self, u: Array) -> None:
        """Take other samples of the curve."""
        self.q, self.u = self.points(u), u

    def _unroll(self) -> None:
        """Let a closed curve on which a bounded joint turns all the way round go on until that is past its limits."""
        full = self.setting.chain
        begins, ends = (np.asarray(end, np.float64) for end in self.round)
        rounds = np.asarray(np.round((ends - begins) / TURN), np.float64)
        winds: Bools = np.isfinite(self.limits).all(1) & ~full.prismatic & (rounds != 0)
        if not winds.any():
            self.whole = True
            return
        j = int(np.argmax(winds))
        low, high = self.limits[j]
        span, each = float(np.ptp(self.q[:, j])), int(abs(rounds[j]))
        # begun up to two turns below, ended above: every part of the limits is passed
        count = int(np.ceil((high - low + 2 * span + 3 * TURN) / (TURN * each))) + 1
        u = np.unique(np.concatenate([self.u + k for k in range(count)]))
        if rounds[j] > 0:
            first = int(np.floor((low - self.q[:, j].max()) / TURN)) - 1
        else:
            first = int(np.ceil((high - self.q[:, j].min()) / TURN)) + 1
        # that many sets of whole turns are different curves; the others are one of these, farther along
        self.turns_of = {j: [first - k if rounds[j] > 0 else first + k for k in range(each)]}
        self._again(u)
        self.folds = [f + k for k in range(count) for f in self.folds]

    def lifted(self) -> _Lifted:
        """Return for each set of whole turns that occurs the intervals of u inside all limits."""
        full = self.setting.chain
        every: _Lifted = [(np.zeros(self.q.shape[1]), [(float(self.u[0]), float(self.u[-1]))])]
        for j in np.flatnonzero(np.isfinite(self.limits).any(1)).tolist():
            low, high = self.limits[j]
            v = self.q[:, j]
            lifts = [0]
            if not full.prismatic[j]:
                first = np.ceil((low - LIMIT_SLACK - v.max()) / TURN) if np.isfinite(low) else 0
                last = np.floor((high + LIMIT_SLACK - v.min()) / TURN) if np.isfinite(high) else first
                lifts = range(int(first if np.isfinite(low) else last), int(last) + 1)
            after: _Lifted = []
            for w in self.turns_of.get(j, lifts):
                mine = self._within(j, low - w * TURN, high - w * TURN)
                for lift, pieces in every:
                    both = _common(pieces, mine)
                    if both:
                        moved = lift.copy()
                        moved[j] = w
                        after.append((moved, both))
            every = after
        return every

    def _within(self, j: int, low: float, high: float) -> list[tuple[float, float]]:
        """Return where a coordinate lies between two values."""
        v = self.q[:, j]
        edges = [float(self.u[0]), float(self.u[-1])]
        for bound in (low, high):
            if not np.isfinite(bound):
                continue
            d = v - bound
            d = np.where(np.abs(d) < LIMIT_SLACK, 0.0, d)
            edges += [float(self.u[i]) for i in np.flatnonzero(d == 0.0)]
            crossed = np.flatnonzero(d[:-1] * d[1:] < 0)
            if len(crossed):
                edges += self._crossings(j, bound, crossed).tolist()
        edges = sorted(set(edges))
        middles = self.points(np.array([(a + b) / 2 for a, b in itertools.pairwise(edges)]))[:, j]
        ok = (middles >= low - LIMIT_SLACK) & (middles <= high + LIMIT_SLACK)
        pieces = [pair for pair, good in zip(itertools.pairwise(edges), ok, strict=True) if good]
        return _joined(pieces)

    def _crossings(self, j: int, bound: float, crossed: Indices) -> Array:
        """Return where a coordinate passes a value after samples (k,): regula falsi, the idle end's weight halved."""
        a, b = self.u[crossed], self.u[crossed + 1]
        va, vb = self.q[crossed, j] - bound, self.q[crossed + 1, j] - bound
        at = a
        for _ in range(HALVINGS):
            at = (a * vb - b * va) / (vb - va)
            v = self.points(at)[:, j] - bound
            left = v * va > 0
            # the end that stays twice is given half the weight, which makes it come nearer
            vb, va = np.where(left, vb / 2, v), np.where(left, v, va / 2)
            a, b = np.where(left, at, a), np.where(left, b, at)
            if np.abs(v).max() < FOLD_FOUND or (b - a).max() < FOLD_NARROW:
                break
        return at

    def arc(self, c: float, d: float, lift: Array, first: float, last: float, ends_of: Array) -> Arc:
        """Return the arc of u from c to d, its label left out.

        Args:
            c: Where it begins.
            d: Where it ends.
            lift: (m,) whole turns that are added.
            first: Where its stretch inside the limits begins.
            last: Where that ends.
            ends_of: (2, m) its ends, whole turns not added.
        """
        x = np.concatenate([ends_of[:1], self.q[(self.u > c) & (self.u < d)], ends_of[1:]]) + TURN * lift
        v = self.sign * x[:, self.by]
        ends = [self._end(c, x[0], c == first), self._end(d, x[-1], d == last)]
        if v[-1] < v[0]:
            x, v, ends = x[::-1], v[::-1], ends[::-1]
        n = self.setting.n
        middle = x[len(x) // 2, :n]
        turns = np.where(
            self.setting.plan.prismatic, 0, np.round((middle - self.setting.plan.chain.joints.wrapped(middle)) / TURN)
        )
        # an interval of the turn says which turn is meant; a free one begins in (-pi, pi]
        back = 0.0
        if self.setting.turns and np.isinf(self.limits[self.by]).all():
            back = TURN * np.ceil((v[0] - np.pi) / TURN)
        return Arc(
            "",
            tuple(int(t) for t in turns),
            float(v[0] - back),
            float(v[-1] - back),
            (ends[0], ends[1]),
            x[:, :n],
            v - back,
        )

    def _end(self, u: float, x: Array, outer: bool) -> End:
        if self.whole:
            return End(ROUND)
        if not outer or any(abs(u - f) < SAME_FOLD for f in self.folds):
            at_limit = self._limit_at(x, ROUNDING)
            if at_limit is None:
                return End(FOLD)
        return self._limit_at(x, AT_A_LIMIT) or End(FOLD)

    def _limit_at(self, x: Array, within: float) -> End | None:
        """Return the limit that a point is nearest to, if it is that near."""
        gap = np.abs(self.limits - x[:, None])
        j, side = np.unravel_index(int(np.argmin(gap)), gap.shape)
        if not gap[j, side] < within:
            return None
        word = ("lower", "upper")[side]
        if j >= self.setting.n:
            return End(INTERVAL, None, float(self.sign * self.limits[j, side]), ("upper", "lower")[side])
        return End(LIMIT, self.setting.plan.names[j], float(self.limits[j, side]), word)


def _common(a: list[tuple[float, float]], b: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Return where two lists of intervals overlap."""
    return [(max(p[0], q[0]), min(p[1], q[1])) for p in a for q in b if min(p[1], q[1]) > max(p[0], q[0])]


def _joined(pieces: list[tuple[float, float]]) -> list[tuple[float, float]]:
    out: list[tuple[float, float]] = []
    for a, b in pieces:
        if out and out[-1][1] == a:
            out[-1] = (out[-1][0], b)
        else:
            out.append((a, b))
    return out
