"""A self-motion of a redundant arm that has the points at which it meets limits among its samples: exact intervals."""

from __future__ import annotations

from dataclasses import dataclass, field, fields
from functools import cached_property

import numpy as np

from pieper.kinematics.arrays import Array, Bools, Indices
from pieper.kinematics.golden_section import least_at
from pieper.kinematics.newton import newton
from pieper.solver.redundant.box import box, closest, descended
from pieper.solver.singular.beside_curve import on_followed
from pieper.solver.singular.self_motion import FREE, SelfMotion
from pieper.solver.singular.traced_motion import TracedMotion
from pieper.tolerances import BOUNDED_ON_CURVE, BOUNDED_PRECISE, CLOSES, NEAR_POLYLINE, ROUNDING, TINY

#: Halvings that place where a curve leaves the limits between two samples: from 0.12 rad to rounding.
HALVINGS = 48
#: A curve is no farther from the chord between two samples than this: half a step, turned as far as a step may turn.
BESIDE_CHORD = 0.025
#: An arc is at most this much longer than its chord, which bounds how near to a posture it can come.
ARC = 1.05
#: Parts into which a stretch of the curve is cut that may hold the nearest point, and how often.
PARTS, ROUNDS = 4, 12


@dataclass(frozen=True, eq=False, repr=False)
class BoundedMotion(TracedMotion):
    """A self-motion whose samples hold the points where it meets limits.

    Attributes:
        marks: (e,) indices of the samples at which a limit is met, ascending.
    """

    marks: Indices = field(default_factory=lambda: np.zeros(0, np.int64))

    def _at(self, u: float) -> Array:
        # whole turns as the limits want them
        point = self.points(np.array([u]))[0]
        moved, ok = self.chain.joints.inside_limits(point, self.limits)
        return (moved if ok else point)[: self.shown]

    def points(self, u: Array) -> Array:
        """Return the points (k, n) at parameters (k,), the task's virtual joints behind."""
        return newton(self.chain, self.between(u), self.T, cutoff=self.rank)

    def _within(self, points: Array) -> Bools:
        return self.chain.joints.inside_limits(points, self.limits)[1]

    @cached_property
    def _stretches(self) -> tuple[tuple[float, float], ...]:
        """Intervals of u inside the limits, ends included; a touch from outside is one of no length."""
        u, n = self.u, len(self.u)
        known = np.zeros(n, bool)
        known[self.marks] = True
        ok = self._within(self.samples)
        # between neighbours: inside where the middle is; where samples change without a stop, halving places it
        middle = self._middles()
        pieces: list[tuple[float, float]] = []
        for i in range(n - 1):
            a, b, mid = u[i], u[i + 1], (u[i] + u[i + 1]) / 2
            if middle[i]:
                pieces.append((a if ok[i] else self._edge(mid, a), b if ok[i + 1] else self._edge(mid, b)))
                continue
            if ok[i]:
                pieces.append((a, a if known[i] else self._edge(a, mid)))
            if ok[i + 1]:
                pieces.append((b if known[i + 1] else self._edge(b, mid), b))
        if n == 1 and ok[0]:
            pieces.append((u[0], u[0]))
        joined = _joined(pieces)
        # where a closed curve begins is where it ends: a touch there is the end of the last interval
        if self.closed and len(joined) > 1 and joined[0] == (u[0], u[0]) and joined[-1][1] == u[-1]:
            joined = joined[1:]
        return joined

    def _middles(self) -> Bools:
        """Return whether the curve is inside the limits halfway between neighbouring samples (k - 1,).

        A chord that is clear of all limits, or beyond one, by more than the curve can be from it decides that alone.
        """
        halfway, joints = (self.samples[:-1] + self.samples[1:]) / 2, self.chain.joints
        room = BESIDE_CHORD * joints.unit[:, None] * np.array([1.0, -1.0])
        inner = self.limits + room
        inside = (inner[:, 0] <= inner[:, 1]).all() & joints.inside_limits(halfway, inner)[1]
        open_ = ~inside & joints.inside_limits(halfway, self.limits - room)[1]
        u = ((self.u[:-1] + self.u[1:]) / 2)[open_]
        inside[open_] = self._within(self.points(u))
        return inside

    def _edge(self, within: float, without: float) -> float:
        """Return the last parameter inside between one that is and one that is not."""
        for _ in range(HALVINGS):
            middle = (within + without) / 2
            if self._within(self.points(np.array([middle])))[0]:
                within = middle
            else:
                without = middle
        return within

    @cached_property
    def inside(self) -> tuple[tuple[float, float], ...]:
        """Every interval of u in which the curve lies inside the joint limits, however short, to rounding."""
        return tuple((float(a), float(b)) for a, b in self._stretches)

    def _nearest(self, q_now: Array, weights: Array) -> Array | None:
        """Return the point (n,) of the curve inside the limits closest to q_now, whole turns resolved, or None.

        A distance changes no faster than the curve is long, so a stretch that cannot come nearer than what was found is
        done with, and the others are cut until none is left. Of a surface the whole of it counts, from this line on.
        """
        now, counts = self.padded(q_now), self.counts(weights)
        starts = self._beside(now) if self.dimension > 1 else np.zeros((0, self.chain.n))
        if self._stretches:
            point, u = self._nearest_along(now, counts)
            if self.chain.coupling is not None:
                # the kernel's descent moves axes, and not what joints say of several
                return self._nearest_beside(u, now, counts)[: self.shown]
            starts = np.concatenate([point[None], starts])
        if not len(starts):
            return None
        return closest(self.chain, starts, self.T, self.limits, now, counts)[: self.shown]

    def _beside(self, now: Array) -> Array:
        """Return the points (k, n) inside the limits that descent reaches from the posture itself, at most one.

        First the task's virtual joints alone move, so that a posture that holds the pose is that point.
        """
        low, high = box(self.chain, self.limits)
        start = np.clip(self.chain.joints.unwound(now, now, self.limits), low, high)[None]
        virtual = np.arange(self.chain.n) >= self.shown
        still = np.where(virtual, low, start), np.where(virtual, high, start)
        start = descended(self.chain, start, self.T[None], *still)[0]
        point, off = descended(self.chain, start, self.T[None], low, high)
        return point[off <= CLOSES]

    def _nearest_beside(self, u: float, now: Array, counts: Array) -> Array:
        """Return the point (n,) inside the limits closest to a posture near parameter u: a golden section."""
        low, high = next((a, b) for a, b in self._stretches if a <= u <= b)
        steps = np.diff(self.samples, axis=0) / self.chain.joints.unit
        reach = 2 * BOUNDED_PRECISE / max(float(np.linalg.norm(steps, axis=1).sum()), TINY)
        low, high = max(low, u - reach), min(high, u + reach)

        def away_at(u: float) -> float:
            return float(self._ends_away(np.array([u]), np.array([u]), now, counts)[1][0])

        ends = np.array([low, u, least_at(away_at, low, high, HALVINGS), high])
        points, away, _ = self._ends_away(ends, ends, now, counts)
        return points[int(np.argmin(away))]

    def _nearest_along(self, now: Array, counts: Array) -> tuple[Array, float]:
        """Return the point (n,) of the curve inside the limits closest to a posture, to the precision of a cut."""
        steps = np.diff(self.samples, axis=0) / self.chain.joints.unit
        length = float(np.linalg.norm(steps, axis=1).sum()) * ARC * float(np.sqrt(counts.max()))
        low, high = self._pieces()
        best, least, at = np.zeros(self.chain.n), np.inf, float(low[0])
        for _ in range(ROUNDS):
            points, away, which = self._ends_away(low, high, now, counts)
            if away.min() < least:
                least, best = float(away.min()), points[int(np.argmin(away))]
                at = float(np.unique(np.concatenate([low, high]))[int(np.argmin(away))])
            a, b = away[which[: len(low)]], away[which[len(low) :]]
            span = (high - low) * length
            open_ = ((a + b - span) / 2 < least - ROUNDING) & (span > BOUNDED_PRECISE)
            if not open_.any():
                break
            cuts = np.linspace(low[open_], high[open_], PARTS + 1)
            low, high = cuts[:-1].ravel(), cuts[1:].ravel()
        return best, at

    def _pieces(self) -> tuple[Array, Array]:
        """Return the two ends (k,), in u, of the pieces between samples that are inside the limits."""
        edges = [np.unique(np.concatenate([[a, b], self.u[(self.u > a) & (self.u < b)]])) for a, b in self._stretches]
        low = np.concatenate([e[:-1] if len(e) > 1 else e for e in edges])
        return low, np.concatenate([e[1:] if len(e) > 1 else e for e in edges])

    def _ends_away(self, low: Array, high: Array, now: Array, counts: Array) -> tuple[Array, Array, Indices]:
        """Return the points at the ends of pieces, how far from `now` they are, and which is which end (2 k,)."""
        both, which = np.unique(np.concatenate([low, high]), return_inverse=True)
        points = self.chain.joints.unwound(self.points(both), now, self.limits)
        return points, self.straight(now, points, counts), which

    def __getstate__(self) -> dict[str, object]:
        """What pickle keeps."""
        return {entry.name: getattr(self, entry.name) for entry in fields(self)}


def bounded_motion(motion: SelfMotion, ends: Array) -> BoundedMotion:
    """Return a traced self-motion with those of the points (m, n) that lie on it put among its samples.

    A closed curve begins at such a point, so that no interval inside the limits is cut where it begins.
    """
    samples, marks = _with_points(motion, ends)
    if motion.closed and len(marks):
        samples, marks = _turned(motion, samples, marks)
    limits, names = motion.limits, motion.names
    return BoundedMotion(
        motion.chain, motion.T, samples, motion.closed, motion.dimension, limits, names, motion.shown, marks=marks
    )


def _with_points(motion: SelfMotion, ends: Array) -> tuple[Array, Indices]:
    samples, joints = motion.samples, motion.chain.joints
    if not len(ends) or len(samples) < 2 or motion.dimension > 1:
        return samples, np.zeros(0, np.int64)
    near = np.flatnonzero(motion.distances(ends) < NEAR_POLYLINE)
    placed: list[tuple[float, Array]] = []
    for q in ends[near[_on(motion, ends[near])]]:
        gap = joints.difference(q, samples[:-1])
        along = np.diff(motion.samples / joints.unit, axis=0)
        square: Array = np.einsum("kn,kn->k", along, along)
        part: Array = np.clip(np.einsum("kn,kn->k", gap, along) / np.maximum(square, TINY), 0.0, 1.0)
        foot = samples[:-1] + (part[:, None] * along) * joints.unit
        i = int(np.argmin(np.linalg.norm(joints.difference(q, foot), axis=1)))
        placed.append((i + float(part[i]), joints.unwound(q, foot[i], FREE)))
    placed.sort(key=lambda entry: entry[0])
    out: list[Array] = [samples[0]]
    marks: list[int] = []
    for place, point in placed:
        whole = int(np.ceil(place))
        out.extend(samples[len(out) - len(marks) : whole])
        marks.append(len(out))
        out.append(point)
    out.extend(samples[len(out) - len(marks) :])
    return np.array(out), np.array(marks, np.int64)


def _on(motion: SelfMotion, points: Array) -> Bools:
    """Return which of the points (m, n) lie on the curve."""
    if motion.is_line:
        return on_followed(motion.chain, motion.T, motion.samples, points, motion.closed, BOUNDED_ON_CURVE)
    return np.array([motion.contains(q, BOUNDED_ON_CURVE) for q in points], bool)


def _turned(motion: SelfMotion, samples: Array, marks: Indices) -> tuple[Array, Indices]:
    """Let a closed curve begin at a point on a limit after which it runs outside, so that no interval is cut there."""
    ahead = samples[marks] + (samples[np.minimum(marks + 1, len(samples) - 1)] - samples[marks]) / 2
    ahead = newton(motion.chain, ahead, motion.T, steps=6, cutoff=motion.rank)
    leaving = marks[~motion.chain.joints.inside_limits(ahead, motion.limits)[1]]
    first = int(leaving[0]) if len(leaving) else int(marks[0])
    whole = motion.chain.joints.unwound(samples[0], samples[-1], FREE) - samples[0]
    out = np.concatenate([samples[first:-1], samples[: first + 1] + whole])
    at = (marks - first) % (len(samples) - 1)
    return out, np.unique(np.concatenate([at, [0, len(out) - 1]]))


def _joined(pieces: list[tuple[float, float]]) -> tuple[tuple[float, float], ...]:
    """Return pieces in order with those that touch made one."""
    out: list[tuple[float, float]] = []
    for a, b in sorted(pieces):
        if out and a <= out[-1][1] + CLOSES * CLOSES:
            out[-1] = (out[-1][0], max(out[-1][1], b))
        else:
            out.append((a, b))
    return tuple(out)
