"""The self-motion of four joints that are a linkage: parametrised in closed form, exact at its limits."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from functools import cached_property

import numpy as np

from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.chain import Chain
from pieper.kinematics.joints import TURN, short_way
from pieper.solver.singular.loop import FourBar
from pieper.solver.singular.self_motion import FREE, SelfMotion
from pieper.tolerances import COURSE_STEP, LINKAGE_TOGETHER, ON_COURSE, ON_COURSE_TURN, ROUNDING, TINY

#: Samples once round: at most 0.12 rad or so of every joint.
SAMPLES = 241


class Course(IntEnum):
    """How a linkage goes through its curve, numbered as the kernel does.

    The leading joint turns back at both ends (BACK), or goes all the way round while the joint opposite stays above or
    below its phase; both go all the way round, alike or against each other, on courses that cross; or the leading joint
    goes round twice until the curve, which crosses itself once, closes.
    """

    BACK = 0
    ABOVE = 1
    BELOW = 2
    ALIKE = 3
    AGAINST = 4
    ROUND_TWICE = 5


@dataclass(frozen=True, eq=False, repr=False)
class LinkageMotion(SelfMotion):
    """Four joints move by themselves, one of them leads.

    Where the leading joint goes all the way round, u is its angle; where it turns back, u counts once there and back;
    where the curve crosses itself, u counts its two rounds.

    Attributes:
        through: (n,) a joint vector on it, from which the linkage counts its angles.
        linkage: The four joints.
        lead: Which of the four leads.
        span: From where to where it can go, rad from `through`; of `Course.ROUND_TWICE`, where it crosses itself.
        course: How it goes through the curve.
    """

    chain: Chain
    T: Array
    limits: Array
    names: tuple[str, ...]
    shown: int
    through: Array
    linkage: FourBar
    lead: int
    span: tuple[float, float]
    course: Course
    closed: bool = True
    dimension: int = 1

    @property
    def _middle(self) -> float:
        return (self.span[0] + self.span[1]) / 2

    @property
    def _half(self) -> float:
        return (self.span[1] - self.span[0]) / 2

    @property
    def _start(self) -> float:
        """Where the leading angle begins its round, rad from `through`: the joint at minus half a turn."""
        return -np.pi - float(self.through[self.linkage.joints[self.lead]])

    def points(self, u: Array) -> Array:
        """Return joint vectors (k, n) at u (k,), each angle the short way round from `through`."""
        linkage, lead, course = self.linkage, self.lead, self.course
        mine, other = linkage.sides(lead)
        angle = self._start + TURN * u
        if course in (Course.ALIKE, Course.AGAINST):
            turned = linkage.closed(lead, angle, other.phase + self._sense * (angle - mine.phase))
        elif course in (Course.ABOVE, Course.BELOW):
            turned = linkage.turned(lead, angle, np.full(len(u), 1.0 if course is Course.ABOVE else -1.0))[0]
        elif course is Course.ROUND_TWICE:
            angle = self._start + 2 * TURN * u
            turned = linkage.turned(lead, angle, self._way_at(angle))[0]
        else:
            angle, way = self._middle - self._half * np.cos(TURN * u), np.where(u % 1.0 < 0.5, 1.0, -1.0)
            turned = linkage.turned(lead, angle, way)[0]
        q = np.tile(self.through, (len(u), 1))
        q[:, linkage.joints] += short_way(turned)
        return q

    @property
    def _sense(self) -> float:
        return -1.0 if self.course is Course.AGAINST else 1.0

    def _way_at(self, angle: Array) -> Array:
        """Return on which side of its phase (k,) the joint opposite is on a course that goes round twice."""
        return np.where(np.floor((angle - self.span[0]) / TURN) % 2 == 0, 1.0, -1.0)

    def places(self, turned: Array) -> tuple[Array, Bools]:
        """Return u (k,) of angles (k, 4) of the linkage, and which are on this piece of the curve (k,)."""
        angle, (mine, other) = turned[:, self.lead], self.linkage.sides(self.lead)
        across = turned[:, (self.lead + 2) % 4] - other.phase
        above = np.asarray(short_way(across)) >= 0
        u = ((angle - self._start) / TURN) % 1.0
        if self.course is Course.ABOVE:
            return u, above
        if self.course is Course.BELOW:
            return u, ~above
        if self.course in (Course.ALIKE, Course.AGAINST):
            return u, np.abs(short_way(across - self._sense * (angle - mine.phase))) < LINKAGE_TOGETHER
        if self.course is Course.ROUND_TWICE:
            first = self._way_at(self._start + TURN * u) == np.where(above, 1.0, -1.0)
            return np.where(first, u / 2, u / 2 + 0.5), np.ones(len(u), bool)
        off = short_way(angle - self._middle)
        u = np.arccos(np.clip(-off / self._half, -1.0, 1.0)) / TURN
        return np.where(above, u, 1.0 - u) % 1.0, np.abs(off) <= self._half * (1 + ON_COURSE) + ON_COURSE_TURN

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

    def holds(self, q: Array, tolerance: float) -> bool:
        """Whether a solution q (n,) of the pose lies on this curve: by its leading angle, then by all."""
        gap = self.chain.joints.way(q, self.through)
        turned = gap[self.linkage.joints][None]
        still = np.delete(gap / self.chain.joints.unit, self.linkage.joints)
        if np.abs(still).max(initial=0.0) > tolerance:
            return False
        u, here = self.places(turned)
        if not here[0]:
            return False
        return bool(self.chain.joints.apart(self.points(u), q).min() < np.sqrt(tolerance))

    @cached_property
    def _crossings(self) -> Array:
        """Values of u where a joint meets a limit, the ends of [0, 1] included; any joint of a linkage may lead."""
        found = [np.array([0.0, 1.0])]
        for k, joint in enumerate(self.linkage.joints):
            values = self.limits[joint][np.isfinite(self.limits[joint])]
            if len(values) == 0 or np.ptp(self.limits[joint]) >= TURN:
                continue
            angle = np.repeat(short_way(values - self.through[joint]), 2)
            turned, reached = self.linkage.turned(k, angle, np.tile([1.0, -1.0], len(values)))
            u, here = self.places(turned[reached])
            found.append(u[here])
        return np.unique(np.concatenate(found))

    @cached_property
    def inside(self) -> tuple[tuple[float, float], ...]:
        """Intervals of u where the curve lies inside the joint limits, exactly."""
        ends = self._crossings
        ok = self.chain.joints.inside_limits(self.points((ends[:-1] + ends[1:]) / 2), self.limits)[1]
        edges = np.flatnonzero(np.diff(np.concatenate([[False], ok, [False]]).astype(int)))
        return tuple((float(ends[a]), float(ends[b])) for a, b in zip(edges[::2], edges[1::2], strict=True))

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

    def nearest(self, q_now: Array, weights: Array | None = None) -> Array | None:
        """Return the point (n,) of the curve inside the limits closest to q_now, or None; weights (n,) as `counts`."""
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
        turned = self.chain.joints.way(here, self.through)[self.linkage.joints][None]
        u = float(self.places(turned)[0][0])
        # a step at which neither the cube of it nor rounding over it counts
        before, after = self.points(np.array([u - COURSE_STEP, u + COURSE_STEP]))
        way = self.chain.joints.way(after, before) / self.chain.joints.unit
        return way[: self.shown] / max(float(np.linalg.norm(way)), TINY)
