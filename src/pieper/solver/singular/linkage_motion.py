"""The self-motion of four joints that are a linkage: parametrised in closed form, exact at its limits."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from pieper import _kernel
from pieper.kinematics.arrays import Array
from pieper.solver.singular.known_motion import KnownMotion
from pieper.solver.singular.self_motion import FREE
from pieper.tolerances import COURSE_STEP, ROUNDING, TINY

#: Samples once round: at most 0.12 rad or so of every joint.
SAMPLES = 241


@dataclass(frozen=True, eq=False, repr=False)
class LinkageMotion(KnownMotion):
    """Four joints move by themselves, one of them leads: four parallel axes, or four through a point.

    Their twists at a solution close on themselves, exp(x1 d1) exp(x2 d2) exp(x3 d3) exp(x4 d4) = 1, and go on doing so
    over a finite motion. Where the leading joint goes all the way round, u is its angle; where it turns back, u counts
    once there and back; where the curve crosses itself, u counts its two rounds. The kernel finds linkages and knows
    their course (kernels/singular/motions.hpp).

    Attributes:
        through: (n,) a joint vector on it, from which the linkage counts its angles.
        linkage: What `_kernel.Linkage` is told of the four joints, from their numbers on.
    """

    linkage: tuple[Any, ...]
    closed: bool = True
    dimension: int = 1

    def __reduce__(self) -> tuple[Any, ...]:
        whose = self.chain, self.T, self.limits, self.names, self.shown
        return LinkageMotion, (*whose, self.through, self.linkage, self.closed, self.dimension)

    @cached_property
    def _native(self) -> _kernel.Linkage:
        return _kernel.Linkage(self.chain.plain, self.through, *self.linkage)

    def points(self, u: Array) -> Array:
        """Return joint vectors (k, n) at u (k,), each angle the short way round from `through`."""
        return self._native.points(u)

    @cached_property
    def samples(self) -> Array:
        """(k, n) points once round, angles continuous."""
        q = self.points(np.linspace(0.0, 1.0, SAMPLES))
        first = self.chain.joints.wrapped(q[0])
        q = np.where(self.chain.prismatic, q, np.unwrap(q, axis=0))
        return q + (first - q[0])

    @cached_property
    def u(self) -> Array:
        """(k,) parameter of each sample."""
        return np.linspace(0.0, 1.0, SAMPLES)

    def point(self, u: float) -> Array:
        """Return the point (n,) at u in [0, 1], a task's virtual joints included."""
        at = np.array([u])
        return self.chain.joints.unwound(self.points(at), self.between(at), FREE)[0]

    @cached_property
    def inside(self) -> tuple[tuple[float, float], ...]:
        """Intervals of u where the curve lies inside the joint limits, exactly; single points are intervals too."""
        found = self._native.inside(self.limits[:, 0], self.limits[:, 1])
        return tuple((float(low), float(high)) for low, high in found)

    @cached_property
    def _candidates(self) -> tuple[Array, Array]:
        """Points (k, n) inside the limits, spread along the curve, and their u (k,)."""
        u = [np.linspace(a, b, max(3, 1 + int(np.ceil((b - a) * (SAMPLES - 1))))) for a, b in self.inside]
        every = np.concatenate([*u, np.zeros(0)])
        return self.points(every), every

    @cached_property
    def full_representative(self) -> Array:
        """The point with the smallest joint values of those inside the limits, or of all, among even steps of u."""
        joints, shown = self.chain.joints, self.shown
        q = self._candidates[0] if self.inside else self.samples
        near = joints.unwound(q, np.zeros(self.chain.n), self.limits)
        cost = joints.first(shown).straight(near[:, :shown], np.zeros(shown))
        # rounding makes equal costs unequal: a coarse key first, then the first sample
        return near[int(np.argmin(np.round(cost, 6)))]

    def _nearest(self, q_now: Array, weights: Array) -> Array | None:
        if not self.inside:
            return None
        q_now = self.padded(q_now)
        joints, counts = self.chain.joints, self.counts(weights)

        def wound(u: Array) -> tuple[Array, Array]:
            q = joints.unwound(self.points(u), q_now, self.limits)
            return q, self.straight(q_now, q, counts)

        best: tuple[float, Array] | None = None
        for low, high in self.inside:
            u = np.linspace(low, high, max(5, 1 + int(np.ceil((high - low) * (SAMPLES - 1)))))
            away = wound(u)[1]
            for k in np.argsort(away)[:3]:
                a, b = u[max(k - 1, 0)], u[min(k + 1, len(u) - 1)]
                while b - a > ROUNDING:
                    some = np.linspace(a, b, 9)
                    m = int(np.argmin(wound(some)[1]))
                    a, b = some[max(m - 1, 0)], some[min(m + 1, 8)]
                q, d = wound(np.array([(a + b) / 2]))
                if best is None or d[0] < best[0]:
                    best = float(d[0]), q[0]
        return None if best is None else best[1][: self.shown]

    @cached_property
    def direction(self) -> Array:
        """(n,) unit tangent at the representative; where courses cross, of this one."""
        here = self.full_representative
        u = self._native.place(here)
        # a step at which neither the cube of it nor rounding over it counts
        before, after = self.points(np.array([u - COURSE_STEP, u + COURSE_STEP]))
        way = self.chain.joints.way(after, before) / self.chain.joints.unit
        return way[: self.shown] / max(float(np.linalg.norm(way)), TINY)
