"""Two axes in one line: a self-motion along a straight line of joint space, exact in everything that is asked of it."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from pieper.kinematics.arrays import Array, Indices
from pieper.kinematics.joints import TURN, short_way
from pieper.solver.singular.known_motion import StraightMotion
from pieper.solver.singular.relation import related
from pieper.solver.singular.self_motion import FREE
from pieper.tolerances import CURVE_STEP, HALF_TURN_EDGE, LIMIT_SLACK, NEARER_BY

#: Whole turns of a joint without limits that are tried to either side of the nearest.
TURNS = 2


@dataclass(frozen=True, eq=False, repr=False)
class LineMotion(StraightMotion):
    """Joints i and j turn against each other, q_i + sense q_j constant.

    Attributes:
        through: (n,) a joint vector on it.
        pair: i and j, 0-based.
        sense: 1 where the axes point the same way, else -1.
    """

    pair: tuple[int, int]
    sense: float
    closed: bool = True
    dimension: int = 1

    @cached_property
    def total(self) -> float:
        """What q_i + sense q_j comes to, rad, in (-pi, pi]; equal for all points that it may be made of."""
        i, j = self.pair
        total = float(short_way(self.through[i] + self.sense * self.through[j]))
        return total if total > HALF_TURN_EDGE - np.pi else total + TURN

    def points(self, first: Array) -> Array:
        """Return joint vectors (k, n) with values (k,) of joint i; joint j follows without a jump."""
        i, j = self.pair
        q = np.tile(self.through, (len(first), 1))
        q[:, i] = first
        q[:, j] = self.sense * (self.total - first)
        return q

    @cached_property
    def samples(self) -> Array:
        """(k, n) points once round."""
        count = int(np.ceil(TURN * np.sqrt(2) / CURVE_STEP)) + 1
        return self.points(np.linspace(-np.pi, np.pi, count))

    @cached_property
    def free(self) -> tuple[int, ...]:
        """Joints (0-based) that move along the curve."""
        return tuple(k for k in self.pair if k < self.shown)

    @cached_property
    def full_direction(self) -> Array:
        """(n,) unit tangent, a task's virtual joints included."""
        way = np.zeros(self.chain.n)
        way[list(self.pair)] = np.sqrt(0.5), -self.sense * np.sqrt(0.5)
        return way

    @cached_property
    def direction(self) -> Array:
        """(n,) unit tangent."""
        return self.full_direction[: self.shown]

    def point(self, u: float) -> Array:
        """Return the point (n,) at u in [0, 1], a task's virtual joints included."""
        return self.points(np.array([TURN * u - np.pi]))[0]

    @cached_property
    def _spans(self) -> list[tuple[float, float]]:
        """Intervals of joint i in [-pi, pi] where both joints are inside their limits, the others included."""
        others = np.setdiff1d(np.arange(self.chain.n), self.pair)
        if not self.chain.joints.inside_limits(self.through, self._limits_of(others))[1]:
            return []
        i, j = self.pair
        # what limits with their slack leave, beside what the limits themselves do
        spans = [(-np.pi, np.pi, -np.pi, np.pi)]
        for joint, scale, shift in ((i, 1.0, 0.0), (j, -self.sense, self.sense * self.total)):
            lower, upper = self.limits[joint]
            if upper - lower + 2 * LIMIT_SLACK >= TURN:
                continue
            # scale x + shift + whole turns inside the limits
            a, b = sorted(((lower - shift) / scale, (upper - shift) / scale))
            first, last = np.ceil((-np.pi - b - LIMIT_SLACK) / TURN), np.floor((np.pi - a + LIMIT_SLACK) / TURN)
            turns = TURN * np.arange(int(first), int(last) + 1)
            allowed = [(a + t - LIMIT_SLACK, b + t + LIMIT_SLACK, a + t, b + t) for t in turns]
            spans = [
                (max(s[0], t[0]), min(s[1], t[1]), max(s[2], t[2]), min(s[3], t[3])) for s in spans for t in allowed
            ]
            spans = sorted(s for s in spans if s[0] <= s[1])
        # where only slack holds, as in a posture with both joints at a stop, it is a single point
        middle = [(low + high) / 2 for _, _, low, high in spans]
        return [(min(s[2], m), max(s[3], m)) for s, m in zip(spans, middle, strict=True)]

    def _limits_of(self, joints: Indices) -> Array:
        limits = np.tile(FREE, (self.chain.n, 1))
        limits[joints] = self.limits[joints]
        return limits

    @cached_property
    def inside(self) -> tuple[tuple[float, float], ...]:
        """Intervals of u where the curve lies inside the joint limits, exactly."""
        return tuple(((a + np.pi) / TURN, (b + np.pi) / TURN) for a, b in self._spans)

    @cached_property
    def full_representative(self) -> Array:
        """The point with the smallest joint values of those inside the limits, or of all."""
        found = self._closest(np.zeros(self.chain.n), self.limits) if self._spans else None
        if found is None:
            found = self._closest(np.zeros(self.chain.n), np.tile(FREE, (self.chain.n, 1)))
        return self.through if found is None else found

    def _nearest(self, q_now: Array, weights: Array) -> Array | None:
        found = self._closest(self.padded(q_now), self.limits, weights) if self._spans else None
        return None if found is None else found[: self.shown]

    def _closest(self, q_now: Array, limits: Array, weights: Array | None = None) -> Array | None:
        """Return the point (n,) inside limits nearest to q_now: for every whole turn of joint j a clipped parabola."""
        i, j = self.pair
        q = self.chain.joints.unwound(self.through, q_now, limits)
        weight = self.counts(weights)[[i, j]]
        if not weight.any():
            weight[:] = 1.0
        (low_i, high_i), (low_j, high_j) = limits[i], limits[j]
        # x = q_i, q_j = sense (total - x) + turns
        best, least = None, np.inf
        for turns in self._turns(q_now, limits):
            a, b = sorted(
                (self.total - self.sense * (low_j - TURN * turns), self.total - self.sense * (high_j - TURN * turns))
            )
            low, high = max(a, low_i), min(b, high_i)
            if low > high + 2 * LIMIT_SLACK:
                continue
            wanted = self.total - self.sense * (q_now[j] - TURN * turns)
            x = float(np.clip((weight[0] * q_now[i] + weight[1] * wanted) / weight.sum(), low, max(low, high)))
            away = weight[0] * (x - q_now[i]) ** 2 + weight[1] * (x - wanted) ** 2
            if away < least - NEARER_BY:
                best, least = (x, turns), away
        if best is None:
            return None
        q[i], q[j] = best[0], self.sense * (self.total - best[0]) + TURN * best[1]
        return q

    def _turns(self, q_now: Array, limits: Array) -> list[int]:
        """Return whole turns of joint j worth trying, the best first: what is far away is never nearer."""
        i, j = self.pair
        (low_i, high_i), (low_j, high_j) = limits[i], limits[j]
        wish = (q_now[j] - self.sense * (self.total - q_now[i])) / TURN
        ends = [self.sense * (self.total - x) for x in (low_i, high_i)]
        least, most = (low_j - max(ends)) / TURN, (high_j - min(ends)) / TURN
        middle = round(float(np.clip(wish, least, most)))
        around = itertools.chain([0], *((k, -k) for k in range(1, TURNS + 1)))
        return [middle + k for k in around]

    def distances(self, q: Array) -> Array:
        """Return how far joint vectors (m, n), virtual joints included, are from the line."""
        i, j = self.pair
        gap = self.gaps(q, self.through)
        off = np.asarray(short_way(q[:, i] + self.sense * q[:, j] - self.total))
        if i >= self.shown or j >= self.shown:
            off = np.zeros(len(q))
        gap[:, [i, j]] = 0.0
        return np.sqrt(np.sum(gap * gap, 1) + off * off / 2)

    @cached_property
    def relation(self) -> str:
        """The relation in words, such as 'joint_4 + joint_6 = 30 deg'."""
        if len(self.free) != 2:
            return ""
        return related(self.names, self.pair, self.sense, self.total, slides=False)
