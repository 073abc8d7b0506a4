"""Self-motions: the continuous sets of joint vectors that hold one pose, as curves that can be asked and described."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property

import numpy as np

from pieper import arguments
from pieper.description.dh import Description
from pieper.description.posture import posture
from pieper.errors import InputError
from pieper.kinematics.arrays import Array, ArrayLike, Bools
from pieper.kinematics.chain import Chain
from pieper.kinematics.forward import checked_joint_vector, checked_weights
from pieper.kinematics.joints import TURN, inside, short_way
from pieper.kinematics.newton import missed, newton, null_space
from pieper.solver.singular.beside_curve import is_known_exactly, on_followed, one_free
from pieper.solver.singular.relation import related
from pieper.tolerances import (
    CLOSED_TURN,
    CLOSES,
    CONTAINS,
    CURVE_RANK,
    CURVE_STEP,
    JOINT_TURNS,
    NEWTON_CUTOFF,
    NO_LENGTH,
    ONE_OF_MANY,
    SAME_VOUCHED,
    SLIDE_SHORTEST,
    TINY,
)

#: No limits at all, for joints as many as there are.
FREE = np.array([[-np.inf, np.inf]])
#: On a surface a posture is walked to from so many of a line's samples, in steps of so much (rad; per length), so many.
MOST_WALKS, WALK, MOST_WALKED = 24, 0.2, 120


class SelfMotion:
    """A one-parameter curve of joint vectors that all reach the same pose: traced, or known in closed form.

    Attributes:
        chain: The arm, a task's virtual joints behind its own.
        T: (4, 4) the pose.
        samples: (k, n) points along the curve in order, angles continuous (not wrapped), rad or m.
        closed: Whether the last point leads back to the first, up to whole turns.
        dimension: Degrees of freedom of the whole self-motion; above 1 the curve is one line through it.
        limits: (n, 2) joint limits.
        names: Joint names.
        shown: How many of the joints are the arm's own; a partial task adds virtual ones behind them, which are part of
            `samples` and of nothing that is asked for.
    """

    chain: Chain
    T: Array
    limits: Array
    names: tuple[str, ...]
    shown: int
    closed: bool
    dimension: int
    #: Whose postures' names are understood; set where a user is handed the self-motion.
    arm: Description | None = None

    @cached_property
    def samples(self) -> Array:
        """(k, n) points along the curve in order, angles continuous (not wrapped), rad or m."""
        raise NotImplementedError

    @property
    def _virtual(self) -> Bools:
        return np.arange(self.chain.n) >= self.shown

    def padded(self, q: Array) -> Array:
        """Return q with the virtual joints added as zeros, where it has the arm's own joints only."""
        q = np.asarray(q, float)
        return q if len(q) == self.chain.n else np.append(q, np.zeros(self.chain.n - self.shown))

    def told(self, arm: Description) -> None:
        """Say whose self-motion it is, so that names of postures are understood."""
        object.__setattr__(self, "arm", arm)

    def _vector(self, q: ArrayLike | str, what: str) -> Array:
        """Return a joint vector that a user said, (n,) or with the virtual joints behind."""
        if isinstance(q, str) and self.arm is not None:
            return posture(self.arm, q, what)
        if type(q) is np.ndarray and q.shape == (self.chain.n,) and self.shown < self.chain.n:
            return q
        return checked_joint_vector(q, self.shown, what, self.chain.prismatic[: self.shown])

    def _joint(self, joint: int | str) -> int:
        """Return the number (0-based) of a joint said by number or name."""
        if isinstance(joint, str):
            if joint not in self.names:
                raise InputError(
                    f"joint: there is no joint {joint!r}; the arm has {', '.join(self.names)}.",
                    given=joint,
                    allowed=self.names,
                )
            return self.names.index(joint)
        return arguments.whole(joint, "joint", 0, self.shown - 1)

    @cached_property
    def rank(self) -> float:
        """Directions weaker than this part of the strongest are left alone in a step back onto the curve."""
        # of seven joints one is free, and the next may be as weak as all along a curve a thousandth of a radian across
        return NEWTON_CUTOFF if self.dimension == 1 and one_free(self.chain) else CURVE_RANK

    @cached_property
    def is_line(self) -> bool:
        """Whether it is a line in joint space that is known exactly, however near another passes."""
        return self.dimension == 1 and is_known_exactly(self.chain, self.samples)

    def gaps(self, q: Array, points: Array) -> Array:
        """Return q - points without units, angles around the circle, virtual joints not counted."""
        return np.where(self._virtual, 0.0, self.chain.joints.difference(q, points))

    @cached_property
    def u(self) -> Array:
        """(k,) parameter of each sample: arc length along the curve, scaled to 0 ... 1."""
        length = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(self._unitless, axis=0), axis=1))])
        return length / max(length[-1], TINY)

    @property
    def _unitless(self) -> Array:
        return self.samples / self.chain.joints.unit

    @cached_property
    def free(self) -> tuple[int, ...]:
        """Joints (0-based) that move along the curve; the others stand still."""
        return tuple(int(j) for j in np.flatnonzero(np.ptp(self._unitless[:, : self.shown], axis=0) > JOINT_TURNS))

    @cached_property
    def direction(self) -> Array:
        """(n,) unit tangent at the representative: the self-motion a controller would see there."""
        return null_space(self.chain, self.full_representative)[1][-1, : self.shown]

    def between(self, u: Array) -> Array:
        """Return joint vectors (k, n) at u (k,) on the straight lines between samples, near the curve and not on it."""
        out = np.empty((len(u), self.chain.n))
        for j, column in enumerate(self.samples.T):
            out[:, j] = np.interp(u, self.u, column)
        return out

    def at(self, u: float) -> Array:
        """Return the joint vector (n,) at the curve parameter u in [0, 1], exactly on the pose.

        Raises:
            InputError: u is no number from 0 to 1.
        """
        return self._at(arguments.number(u, "u", "along the curve", least=0.0, most=1.0))

    def _at(self, u: float) -> Array:
        return self.point(u)[: self.shown]

    def point(self, u: float) -> Array:
        """Return the same with the task's virtual joints behind."""
        return newton(self.chain, self.between(np.array([u]))[0], self.T, cutoff=self.rank)

    def at_joint(self, joint: int | str, value: float) -> Array:
        """Return the points (m, n) of the curve where a joint (0-based) has a value, whole turns apart from it counted.

        Args:
            joint: A joint that moves along the curve, by its name or its 0-based index.
            value: rad or m.

        Raises:
            InputError: No such joint, or no finite number.
        """
        joint = self._joint(joint)
        value = arguments.number(value, "value", "m" if self.chain.prismatic[joint] else "rad")
        return self.points_at_joint(joint, value)[:, : self.shown]

    def points_at_joint(self, joint: int, value: float) -> Array:
        """Return the same with the task's virtual joints behind."""
        column = self.samples[:, joint] - value
        if not self.chain.prismatic[joint]:
            column = short_way(column)
        found: list[Array] = []
        for i in np.flatnonzero((column[:-1] * column[1:] <= 0) & (np.abs(column[1:] - column[:-1]) < np.pi)):
            part = column[i] / (column[i] - column[i + 1]) if column[i] != column[i + 1] else 0.0
            point = self.samples[i] + part * (self.samples[i + 1] - self.samples[i])
            turns = 0 if self.chain.prismatic[joint] else round(float(point[joint] - value) / TURN)
            if self.chain.coupling is None:
                rest = newton(self.chain.locked(joint, value), np.delete(point, joint), self.T, steps=8)
                point = np.insert(rest, joint, value + TURN * turns)
            else:
                point = self._halved(int(i), joint, value + TURN * turns)
            if missed(self.chain, point, self.T) < CLOSES and not any(
                np.allclose(point, other, atol=ONE_OF_MANY) for other in found
            ):
                found.append(point)
        return np.array(found).reshape(-1, self.chain.n)

    def _halved(self, i: int, joint: int, value: float) -> Array:
        """Return the point between samples i and i + 1 where a joint has a value: one that moves others is not held."""
        low, high = float(self.u[i]), float(self.u[i + 1])
        side = np.sign(self.samples[i + 1, joint] - self.samples[i, joint])
        for _ in range(HALVINGS):
            middle = (low + high) / 2
            low, high = (low, middle) if side * (self.point(middle)[joint] - value) > 0 else (middle, high)
        point = self.point((low + high) / 2)
        point[joint] = value
        return point

    @cached_property
    def _sample_inside(self) -> Bools:
        return self.chain.joints.inside_limits(self.samples, self.limits)[1]

    @cached_property
    def inside(self) -> tuple[tuple[float, float], ...]:
        """Intervals of u where the curve lies inside the joint limits, to the spacing of the samples."""
        ok = self._sample_inside
        edges = np.flatnonzero(np.diff(np.concatenate([[False], ok, [False]]).astype(int)))
        return tuple((float(self.u[a]), float(self.u[b - 1])) for a, b in zip(edges[::2], edges[1::2], strict=True))

    @property
    def representative(self) -> Array:
        """(n,) one point: inside the limits if any is, and of those the one with the smallest joint values."""
        return self.full_representative[: self.shown]

    @cached_property
    def full_representative(self) -> Array:
        """The same with the task's virtual joints behind."""
        joints, shown = self.chain.joints, self.shown
        near = joints.unwound(self.samples, np.zeros(self.chain.n), FREE)
        near = joints.unwound(near, near, self.limits)
        cost = joints.first(shown).straight(near[:, :shown], np.zeros(shown))
        if self._sample_inside.any():
            cost = np.where(self._sample_inside, cost, np.inf)
        # rounding makes equal costs unequal: a coarse key first, then the first sample
        best = int(np.argmin(np.round(cost, 6)))
        return newton(self.chain, near[best], self.T, steps=6, cutoff=CURVE_RANK)

    def counts(self, weights: Array | None = None) -> Array:
        """Return what each joint (n,) counts in a squared distance: its weight, nothing where it is virtual."""
        out = np.zeros(self.chain.n)
        out[: self.shown] = 1.0 if weights is None else weights
        return out

    def nearest(self, q_now: ArrayLike | str, weights: ArrayLike | None = None) -> Array | None:
        """Return the point (n,) of the curve inside the limits closest to q_now, or None.

        Args:
            q_now: (n,) rad or m, or a posture's name.
            weights: (n,) how much the square of each joint's difference counts; all the same if None.

        Raises:
            InputError: A wrong length or weight, or no such posture.
        """
        return self._nearest(self._vector(q_now, "q_now"), checked_weights(weights, self.shown))

    def _nearest(self, q_now: Array, weights: Array) -> Array | None:
        if not self._sample_inside.any():
            return None
        q_now, counts = self.padded(q_now), self.counts(weights)
        wound = self.chain.joints.unwound(self.samples, q_now, self.limits)
        away = np.where(self._sample_inside, self.straight(q_now, wound, counts), np.inf)
        # samples a step apart do not say which of several minima along the curve is the lowest
        lowest = np.flatnonzero((away <= np.append(away[1:], np.inf)) & (away <= np.append(np.inf, away[:-1])))
        lowest = lowest[away[lowest] <= away.min() + CURVE_STEP]
        points = [
            self._slid(wound[i], lambda p: (q_now - p) / self.chain.joints.unit, self.limits, counts)
            for i in lowest[np.argsort(away[lowest], kind="stable")][:4]
        ]
        return points[int(np.argmin([self.straight(q_now, p, counts) for p in points]))][: self.shown]

    def straight(self, q: Array, points: Array, counts: Array) -> Array:
        """Return the distances (...) of points (..., n) from q without units, joints weighted by `counts` (n,)."""
        gap = (q - points) / self.chain.joints.unit
        return np.sqrt(np.asarray(np.sum(counts * gap * gap, axis=-1), np.float64))

    def _slid(self, point: Array, gap: Callable[[Array], Array], limits: Array | None, counts: Array) -> Array:
        """Slide along the curve while the gap shrinks: along the tangent, then back onto the pose."""
        root = np.sqrt(counts)
        for _ in range(20):
            direction = null_space(self.chain, point)[1][-1]
            weight = counts * direction
            along = float(gap(point) @ weight) / max(float(weight @ direction), NO_LENGTH)
            step = float(np.clip(along, -CURVE_STEP, CURVE_STEP))
            while abs(step) > SLIDE_SHORTEST:  # a step that leaves the limits, or leads away, is too long
                ahead = point + step * direction * self.chain.joints.unit
                moved = newton(self.chain, ahead, self.T, steps=5, cutoff=CURVE_RANK)
                if (limits is None or inside(moved, limits).all()) and np.linalg.norm(
                    root * gap(moved)
                ) < np.linalg.norm(root * gap(point)):
                    break
                step /= 2
            else:
                break
            point = moved
        return point

    def distance(self, q: ArrayLike | str) -> float:
        """Return how far a joint vector (n,) is from the curve, rad or characteristic lengths, whole turns ignored."""
        return float(self.distances(self.padded(self._vector(q, "q"))[None])[0])

    def distances(self, q: Array) -> Array:
        """Return how far joint vectors (m, n), virtual joints included, are from the curve, as `distance`."""
        difference = self.gaps(q[:, None], self.samples)
        to_samples = np.min(np.einsum("mkn,mkn->mk", difference, difference), axis=1)
        if difference.shape[1] == 1:
            return np.sqrt(to_samples)
        segment = np.where(self._virtual, 0.0, np.diff(self._unitless, axis=0))
        inner = np.einsum("mkn,kn->mk", difference[:, :-1], segment) / np.maximum(np.sum(segment * segment, 1), TINY)
        foot = difference[:, :-1] - np.clip(inner, 0, 1)[..., None] * segment
        return np.sqrt(np.minimum(to_samples, np.min(np.einsum("mkn,mkn->mk", foot, foot), axis=1)))

    def contains(self, q: ArrayLike | str, tolerance: float = CONTAINS) -> bool:
        """Whether q (n,) lies on the self-motion within a tolerance (rad); a surface: whether the pose leads to it.

        Raises:
            InputError: A wrong length, no such posture, or a tolerance that is none.
        """
        within = arguments.number(tolerance, "tolerance", "rad", least=0.0)
        return self._contains(self.padded(self._vector(q, "q")), within)

    def _contains(self, q: Array, tolerance: float) -> bool:
        if self.dimension == 1 and self.distance(q) > 0.05:
            return False
        if self.shown == self.chain.n and self.is_line:
            return bool(on_followed(self.chain, self.T, self.samples, q[None], self.closed, tolerance)[0])
        sizes = np.linalg.norm(self.gaps(q, self.samples), axis=1)
        nearest = self.samples[int(np.argmin(sizes))]
        point = self._slid(nearest, lambda p: self.gaps(q, p), None, self.counts())
        if np.linalg.norm(self.gaps(q, point)) <= tolerance:
            return True
        if self.dimension == 1:
            return self._passes(q, tolerance)
        # what does not hold the pose need not be walked to; values of virtual joints are not known of a posture
        held = self.shown < self.chain.n or missed(self.chain, q, self.T) < 10 * max(tolerance, CLOSES)
        return bool(held) and self._leads_to(q, sizes, tolerance)

    def _passes(self, q: Array, tolerance: float) -> bool:
        """Whether the curve passes q (n,), by its parameter; a double root's blur counts, if all between holds."""
        away = np.linalg.norm(self.gaps(q, (self.samples[:-1] + self.samples[1:]) / 2), axis=1)
        i = int(np.argmin(away)) if len(away) else 0
        low, high = self.u[max(i - 1, 0)], self.u[min(i + 2, len(self.u) - 1)]
        u, beside, gap = (low + high) / 2, (high - low) / 100, np.full(self.chain.n, np.inf)
        for _ in range(CLOSING):
            gap = self.gaps(q, self.point(u))
            way = self.gaps(self.point(u + beside), self.point(u - beside))
            u = float(np.clip(u + 2 * beside * (gap @ way) / max(way @ way, TINY), low, high))
        between = q - np.array([[0.0], [0.5]]) * gap * self.chain.joints.unit
        near, holds = float(np.linalg.norm(gap)), missed(self.chain, between, self.T) < CLOSES
        return near <= tolerance or (near < SAME_VOUCHED and bool(holds.all()))

    def _leads_to(self, q: Array, sizes: Array, tolerance: float) -> bool:
        """Whether q (n,) is reached on the pose from one of the samples, at distances (k,), step by step towards it."""
        spread = np.unique(np.linspace(0, len(sizes) - 1, MOST_WALKS).astype(int))
        for start in (int(np.argmin(sizes)), *spread[np.argsort(sizes[spread], kind="stable")]):
            point = self.samples[start]
            for _ in range(MOST_WALKED):
                gap = self.gaps(q, point)
                left = float(np.linalg.norm(gap))
                if left <= tolerance:
                    return True
                ahead = point + min(1.0, WALK / left) * gap * self.chain.joints.unit
                point = newton(self.chain, ahead, self.T, steps=8, cutoff=CURVE_RANK)
                if missed(self.chain, point, self.T) > CLOSES or np.linalg.norm(self.gaps(q, point)) > 0.999 * left:
                    break
        return False

    @property
    def bounded(self) -> bool:
        """Whether what does not close ends somewhere: slides without limits lead away for ever."""
        return bool(np.isfinite(self.limits[[*self.free]]).any() or not self.chain.prismatic[[*self.free]].any())

    def __repr__(self) -> str:
        moving = ", ".join(self.names[j] for j in self.free) or "no joint of the arm"
        return f"<SelfMotion of {moving}: {('open', 'closed')[self.closed]}, dimension {self.dimension}>"

    def __str__(self) -> str:
        moving, relation = [self.names[j] for j in self.free], self.relation
        # where a line on a surface is no longer followed the surface has no end
        ends = "" if self.dimension > 1 else " between two ends" if self.bounded else " without an end"
        where = " all the way round" if self.closed else ends
        verb = "moves" if len(moving) == 1 else "move together"
        text = f"{', '.join(moving)} {verb}{where}" + (f" with {relation}" if relation else "")
        return text + (f"; {self.dimension} degrees of freedom in all" if self.dimension > 1 else "")

    @cached_property
    def relation(self) -> str:
        """A linear relation in words, such as 'joint_4 + joint_6 = 30 deg', where two revolute joints obey one."""
        if len(self.free) != 2 or self.chain.prismatic[list(self.free)].any():
            return ""
        i, j = self.free
        for sign in (1.0, -1.0):
            total = self.samples[:, i] + sign * self.samples[:, j]
            if np.ptp(total) < CLOSED_TURN:
                return related(self.names, (i, j), sign, float(short_way(total[0])), slides=False)
        return ""


#: Steps that bring a curve's parameter to the point beside a posture.
CLOSING = 12
#: Halvings that place a joint's value between two samples to rounding.
HALVINGS = 48
