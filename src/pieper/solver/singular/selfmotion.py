"""Self-motion: the continuous families of joint vectors that hold one pose, traced and described."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from pieper.kinematics.chain import Chain
from pieper.kinematics.newton import newton, pose_difference, scaled_jacobian
from pieper.solver.results import TURN, joint_distance, unwound
from pieper.tolerances import LIMIT_SLACK

#: A curve point must hold the pose this well (per length; rad). A pose 1e-12 away from a singular one moves farther.
ON_CURVE = 2e-13
#: Longest step along a curve, rad or characteristic lengths, and the most steps a trace may take.
STEP, MOST_STEPS = 0.12, 1500


@dataclass(frozen=True, eq=False)
class Family:
    """A one-parameter curve of joint vectors that all reach the same pose.

    Attributes:
        samples: (k, n) points along the curve in order, angles continuous (not wrapped), rad or m.
        closed: Whether the last point leads back to the first, up to whole turns.
        dimension: Degrees of freedom of the whole self-motion; above 1 the curve is one line through it.
        limits: (n, 2) joint limits.
        names: Joint names.
        shown: How many of the joints are the arm's own; a partial task adds virtual ones behind them, which are part of
            `samples` and of nothing that is asked for.
    """

    chain: Chain
    T: np.ndarray
    samples: np.ndarray
    closed: bool
    dimension: int
    limits: np.ndarray
    names: tuple[str, ...]
    shown: int

    @property
    def _virtual(self) -> np.ndarray:
        return np.arange(self.chain.n) >= self.shown

    def _padded(self, q: np.ndarray) -> np.ndarray:
        """Return q with the virtual joints added as zeros, where it has the arm's own joints only."""
        q = np.asarray(q, float)
        return q if len(q) == self.chain.n else np.append(q, np.zeros(self.chain.n - self.shown))

    def _gaps(self, q: np.ndarray, points: np.ndarray) -> np.ndarray:
        """Return q - points without units, angles around the circle, virtual joints not counted."""
        gap = np.where(self.chain.prismatic, (q - points) / self.chain.length, (q - points + np.pi) % TURN - np.pi)
        return np.where(self._virtual, 0.0, gap)

    @cached_property
    def s(self) -> np.ndarray:
        """(k,) parameter of each sample: arc length along the curve, scaled to 0 ... 1."""
        length = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(self._unitless, axis=0), axis=1))])
        return length / max(length[-1], 1e-300)

    @property
    def _unitless(self) -> np.ndarray:
        return self.samples / np.where(self.chain.prismatic, self.chain.length, 1.0)

    @cached_property
    def free(self) -> tuple[int, ...]:
        """Joints (0-based) that move along the curve; the others stand still."""
        return tuple(int(j) for j in np.flatnonzero(np.ptp(self._unitless[:, : self.shown], axis=0) > 1e-6))

    @cached_property
    def direction(self) -> np.ndarray:
        """(n,) unit tangent at the representative: the self-motion a controller would see there."""
        return tangent(self.chain, self._representative)[0][: self.shown]

    def at(self, s: float) -> np.ndarray:
        """Return the joint vector (n,) at the curve parameter s in [0, 1], exactly on the pose."""
        return self._at(s)[: self.shown]

    def _at(self, s: float) -> np.ndarray:
        guess = np.array([np.interp(s, self.s, column) for column in self.samples.T])
        return newton(self.chain, guess, self.T, steps=6, cutoff=1e-7)

    def at_joint(self, joint: int, value: float) -> np.ndarray:
        """Return the points (m, n) of the curve where a joint (0-based) has a value, whole turns apart from it counted.

        Args:
            joint: 0-based index of a joint that moves along the curve.
            value: rad or m.
        """
        column = self.samples[:, joint] - value
        if not self.chain.prismatic[joint]:
            column = (column + np.pi) % TURN - np.pi
        found = []
        for i in np.flatnonzero((column[:-1] * column[1:] <= 0) & (np.abs(column[1:] - column[:-1]) < np.pi)):
            part = column[i] / (column[i] - column[i + 1]) if column[i] != column[i + 1] else 0.0
            point = self.samples[i] + part * (self.samples[i + 1] - self.samples[i])
            locked = self.chain.locked(joint, value)
            rest = newton(locked, np.delete(point, joint), self.T, steps=8)
            turned = (
                value + TURN * np.round((point[joint] - value) / TURN) if not self.chain.prismatic[joint] else value
            )
            point = np.insert(rest, joint, turned)
            if np.linalg.norm(pose_difference(self.chain, point, self.T)) < 1e-9 and not any(
                np.allclose(point, other, atol=1e-7) for other in found
            ):
                found.append(point)
        return np.array(found).reshape(-1, self.chain.n)[:, : self.shown]

    @cached_property
    def _sample_inside(self) -> np.ndarray:
        moved = unwound(self.samples, self.samples, self.limits, self.chain.prismatic)
        slack = LIMIT_SLACK
        return ((moved >= self.limits[:, 0] - slack) & (moved <= self.limits[:, 1] + slack)).all(1)

    @cached_property
    def inside(self) -> tuple[tuple[float, float], ...]:
        """Intervals of s where the curve lies inside the joint limits, to the spacing of the samples."""
        ok = self._sample_inside
        edges = np.flatnonzero(np.diff(np.concatenate([[False], ok, [False]]).astype(int)))
        return tuple((float(self.s[a]), float(self.s[b - 1])) for a, b in zip(edges[::2], edges[1::2], strict=True))

    @property
    def representative(self) -> np.ndarray:
        """(n,) one point: inside the limits if any is, and of those the one with the smallest joint values."""
        return self._representative[: self.shown]

    @cached_property
    def _representative(self) -> np.ndarray:
        wrapped = np.where(self.chain.prismatic, self.samples, self.samples - TURN * np.round(self.samples / TURN))
        wrapped = unwound(wrapped, wrapped, self.limits, self.chain.prismatic)
        shown = slice(0, self.shown)
        cost = joint_distance(wrapped[:, shown], np.zeros(self.shown), self.chain.prismatic[shown], self.chain.length)
        if self._sample_inside.any():
            cost = np.where(self._sample_inside, cost, np.inf)
        # rounding makes equal costs unequal: a coarse key first, then the first sample
        best = int(np.argmin(np.round(cost, 6)))
        return newton(self.chain, wrapped[best], self.T, steps=6, cutoff=1e-7)

    def nearest(self, q_now: np.ndarray) -> np.ndarray | None:
        """Return the point (n,) of the curve inside the limits closest to q_now, or None."""
        if not self._sample_inside.any():
            return None
        q_now = self._padded(q_now)
        wound = unwound(self.samples, np.broadcast_to(q_now, self.samples.shape), self.limits, self.chain.prismatic)
        away = np.where(self._sample_inside, self._straight(q_now, wound), np.inf)
        # samples a step apart do not say which of several minima along the curve is the lowest
        lowest = np.flatnonzero((away <= np.append(away[1:], np.inf)) & (away <= np.append(np.inf, away[:-1])))
        lowest = lowest[away[lowest] <= away.min() + STEP]
        points = [
            self._slid(wound[i], lambda p: np.where(self._virtual, 0.0, q_now - p) / self._unit, self.limits)
            for i in lowest[np.argsort(away[lowest], kind="stable")][:4]
        ]
        return points[int(np.argmin([self._straight(q_now, p) for p in points]))][: self.shown]

    @property
    def _unit(self) -> np.ndarray:
        return np.where(self.chain.prismatic, self.chain.length, 1.0)

    def _straight(self, q: np.ndarray, points: np.ndarray) -> np.ndarray:
        return np.linalg.norm(np.where(self._virtual, 0.0, (q - points) / self._unit), axis=-1)

    def _slid(self, point: np.ndarray, gap: Callable, limits: np.ndarray | None) -> np.ndarray:
        """Slide along the curve while the gap shrinks: along the tangent, then back onto the pose."""
        for _ in range(20):
            direction = tangent(self.chain, point)[0]
            weight = np.where(self._virtual, 0.0, direction)
            along = float(gap(point) @ weight) / max(float(weight @ weight), 1e-12)
            step = float(np.clip(along, -STEP, STEP))
            while abs(step) > 1e-10:  # a step that leaves the limits, or leads away, is too long
                moved = newton(self.chain, point + step * direction * self._unit, self.T, steps=5, cutoff=1e-7)
                inside = limits is None or _within(moved, limits)
                if inside and np.linalg.norm(gap(moved)) < np.linalg.norm(gap(point)):
                    break
                step /= 2
            else:
                break
            point = moved
        return point

    def distance(self, q: np.ndarray) -> float:
        """Return how far a joint vector (n,) is from the curve, rad or characteristic lengths, whole turns ignored."""
        return float(self.distances(self._padded(q)[None])[0])

    def distances(self, q: np.ndarray) -> np.ndarray:
        """Return how far joint vectors (m, n), virtual joints included, are from the curve, as `distance`."""
        difference = self._gaps(q[:, None], self.samples)
        to_samples = np.min(np.einsum("mkn,mkn->mk", difference, difference), axis=1)
        if difference.shape[1] == 1:
            return np.sqrt(to_samples)
        segment = np.where(self._virtual, 0.0, np.diff(self._unitless, axis=0))
        inner = np.einsum("mkn,kn->mk", difference[:, :-1], segment) / np.maximum(np.sum(segment * segment, 1), 1e-300)
        foot = difference[:, :-1] - np.clip(inner, 0, 1)[..., None] * segment
        return np.sqrt(np.minimum(to_samples, np.min(np.einsum("mkn,mkn->mk", foot, foot), axis=1)))

    def contains(self, q: np.ndarray, tolerance: float = 1e-6) -> bool:
        """Whether q (n,) lies on the curve within a tolerance (rad)."""
        q = self._padded(q)
        if self.distance(q) > 0.05:
            return False
        sizes = np.linalg.norm(self._gaps(q, self.samples), axis=1)
        point = self._slid(self.samples[int(np.argmin(sizes))], lambda p: self._gaps(q, p), None)
        return bool(np.linalg.norm(self._gaps(q, point)) <= tolerance)

    def __str__(self) -> str:
        moving = [self.names[j] for j in self.free]
        relation = self.relation
        where = "all the way round" if self.closed else "between two ends"
        text = f"{', '.join(moving)} move together {where}" + (f" with {relation}" if relation else "")
        return text + (f"; {self.dimension} degrees of freedom in all" if self.dimension > 1 else "")

    @cached_property
    def relation(self) -> str:
        """A linear relation in words, such as 'joint_4 + joint_6 = 30 deg', where two revolute joints obey one."""
        if len(self.free) != 2 or self.chain.prismatic[list(self.free)].any():
            return ""
        i, j = self.free
        for sign, symbol in ((1, "+"), (-1, "-")):
            total = self.samples[:, i] + sign * self.samples[:, j]
            if np.ptp(total) < 1e-9:
                value = np.degrees((total[0] + np.pi) % TURN - np.pi)
                return f"{self.names[i]} {symbol} {self.names[j]} = {value:.6g} deg"
        return ""


def tangent(chain: Chain, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the self-motion direction (n,) (unit, no units) at q and all singular values of the scaled Jacobian."""
    _, s, Vt = np.linalg.svd(scaled_jacobian(chain, q))
    return Vt[-1], s


def nullity(chain: Chain, q: np.ndarray, tolerance: float = 1e-7) -> int:
    """Return the number of independent self-motion directions at q."""
    _, s = tangent(chain, q)
    return chain.n - int(np.count_nonzero(s > tolerance * max(s[0], 1e-300)))


def corrected(chain: Chain, q: np.ndarray, T: np.ndarray, direction: np.ndarray) -> np.ndarray | None:
    """Pull q onto the pose within the plane normal to `direction`; None if it does not get there."""
    unit = np.where(chain.prismatic, chain.length, 1.0)
    for _ in range(12):
        e = pose_difference(chain, q, T)
        if np.linalg.norm(e) < ON_CURVE:
            return q
        A = np.vstack([scaled_jacobian(chain, q), direction])
        step = np.linalg.lstsq(A, np.append(e, 0.0), rcond=1e-9)[0]
        if np.linalg.norm(step) > 1.0:
            return None
        q = q + step * unit
    return q if np.linalg.norm(pose_difference(chain, q, T)) < ON_CURVE else None


def moved(chain: Chain, q: np.ndarray, T: np.ndarray, direction: np.ndarray, probe: float = 0.05) -> np.ndarray | None:
    """Return a point about `probe` (rad or lengths) from q along `direction` that holds the pose, or None."""
    unit = np.where(chain.prismatic, chain.length, 1.0)
    for side in (probe, -probe):
        point = corrected(chain, q + side * direction * unit, T, direction)
        if point is not None and np.linalg.norm((point - q) / unit) > 0.5 * probe:
            return point
    return None


def trace(
    chain: Chain,
    q: np.ndarray,
    T: np.ndarray,
    limits: np.ndarray,
    names: tuple[str, ...],
    direction: np.ndarray | None = None,
    *,
    shown: int | None = None,
    most_steps: int = MOST_STEPS,
) -> Family:
    """Trace the self-motion curve through q both ways until it closes or ends.

    Args:
        chain: The arm.
        q: (n,) a joint vector on the pose.
        T: (4, 4) the pose.
        limits: (n, 2).
        names: Joint names.
        direction: (n,) the direction to set out in; the null vector of the Jacobian if None.
        shown: Number of joints that are the arm's own; all if None.
        most_steps: Steps each way at the most.

    Returns:
        The Family; bounded by `most_steps`.
    """
    set_out = tangent(chain, q)[0] if direction is None else direction
    forward, closed = _walk(chain, q, T, set_out, most_steps)
    points = forward
    if not closed:
        backward, _ = _walk(chain, q, T, -set_out, most_steps)
        points = backward[:0:-1] + forward
    samples = np.array(points)
    middle = samples[len(samples) // 2]
    arm_joints = chain.n if shown is None else shown
    return Family(chain, T, samples, closed, max(1, nullity(chain, middle)), limits, names, arm_joints)


def crossings(family: Family) -> list[np.ndarray]:
    """Return points of a curve where a second self-motion direction opens: other curves cross there."""
    chain, samples = family.chain, family.samples
    second = second_smallest(chain, samples)
    found = []
    last = len(samples) - 1
    for i in range(len(samples)):
        # at a crossing the value falls to zero like |s - s0|: less than one and a half times what a step changes
        around = second[[(i + k) % last if family.closed else min(max(i + k, 0), last) for k in (-2, -1, 1, 2)]]
        change = max(abs(around[0] - around[1]), abs(around[3] - around[2]))
        if second[i] > min(around) or second[i] > 1.5 * change + 1e-9:
            continue
        low, high = family.s[max(i - 1, 0)], family.s[min(i + 1, last)]
        for _ in range(30):  # golden section
            a, b = high - 0.618 * (high - low), low + 0.618 * (high - low)
            if second_smallest(chain, family._at(a)) < second_smallest(chain, family._at(b)):
                high = b
            else:
                low = a
        point = family._at((low + high) / 2)
        if second_smallest(chain, point) < 1e-5:
            found.append(point)
    return found


def second_smallest(chain: Chain, q: np.ndarray) -> np.ndarray:
    """Return the size (...) of the second self-motion direction's singular value, relative to the largest."""
    s = np.linalg.svd(scaled_jacobian(chain, q), compute_uv=False)
    # n joints have n singular values, of which those beyond the sixth are zero
    k = chain.n - 2
    return (s[..., k] if k < s.shape[-1] else np.zeros(s.shape[:-1])) / s[..., 0]


def _walk(chain, q, T, direction, most_steps) -> tuple[list[np.ndarray], bool]:
    unit = np.where(chain.prismatic, chain.length, 1.0)
    points, step = [q], STEP / 2
    gone = 0.0
    while len(points) < most_steps:
        here = points[-1]
        ahead = corrected(chain, here + step * direction * unit, T, direction)
        if ahead is not None:
            move = (ahead - here) / unit
            turn = float(move @ direction) / max(np.linalg.norm(move), 1e-300)
        if ahead is None or turn < 0.95:
            step /= 2
            if step < 1e-5:
                return points, False
            continue
        gone += float(np.linalg.norm(move))
        new = _tangent_near(chain, ahead, direction)
        points.append(ahead)
        if gone > 3 * step and _gap(ahead, q, chain) < 0.75 * step and _closes(chain, q, ahead, points[0], new):
            end = q + np.where(chain.prismatic, 0.0, TURN * np.round((ahead - q) / TURN))
            points[-1] = end
            return points, True
        direction = new
        step = min(STEP, step * 1.3)
    return points, False


def _closes(chain, q, ahead, start, direction) -> bool:
    gap = np.where(chain.prismatic, ahead - q, (ahead - q + np.pi) % TURN - np.pi) / np.where(
        chain.prismatic, chain.length, 1.0
    )
    size = np.linalg.norm(gap)
    return size < 1e-9 or abs(float(gap @ direction)) > 0.9 * size


def _tangent_near(chain: Chain, q: np.ndarray, direction: np.ndarray) -> np.ndarray:
    """Return the null direction at q closest to the direction of travel: at a crossing of two curves go straight on."""
    _, s, Vt = np.linalg.svd(scaled_jacobian(chain, q))
    s = np.concatenate([s, np.zeros(chain.n - len(s))])
    null = Vt[s <= max(1e-7 * s[0], s[-1] * 1.0000001)]
    projected = null.T @ (null @ direction)
    size = np.linalg.norm(projected)
    return projected / size if size > 1e-6 else direction


def _gap(a: np.ndarray, b: np.ndarray, chain: Chain) -> float:
    gap = np.where(chain.prismatic, a - b, (a - b + np.pi) % TURN - np.pi)
    return float(np.linalg.norm(gap / np.where(chain.prismatic, chain.length, 1.0)))


def _within(q: np.ndarray, limits: np.ndarray) -> bool:
    return bool(np.all(q >= limits[:, 0] - LIMIT_SLACK) and np.all(q <= limits[:, 1] + LIMIT_SLACK))
