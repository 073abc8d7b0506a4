"""Between the given points: where a joint passes a limit and comes back, and how far joints lead from the line."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array, Bools, Indices
from pieper.kinematics.forward import fk
from pieper.kinematics.joints import inside
from pieper.kinematics.pose import rotation_vector
from pieper.motion.continuation import Continuation
from pieper.motion.path import between
from pieper.motion.track import OffLine
from pieper.tolerances import JOINT_RESTS, ROUNDING

#: A peak between two points is looked at from this part of the joint's way there before its limit: the cubic that
#: foretells it is off by far less.
NEAR_LIMIT = 0.25
#: A step is looked at where a joint is nearer to a limit than this many times what moves most in it or beside it.
ROOM = 2.0
#: Parts of a step at which straight motion of the joints is compared with the line.
PARTS = (0.25, 0.5, 0.75)


def outside_between(way: Continuation, q: Array) -> tuple[int, float] | None:
    """Return after which point, and where, a curve q (k, n) is outside a limit between two points inside; or None.

    Both ends of a step and their Jacobians foretell a cubic; where its peak comes near a limit the pose is solved.
    """
    low, high = way.plan.limits.T
    if len(q) < 2 or way.redundant or not (np.isfinite(low) | np.isfinite(high)).any():
        return None
    first, last = q[:-1], q[1:]
    # a joint may turn round between two points at which it stands the same: what any joint does there counts
    moved = (np.abs(last - first) / way.unit).max(1)
    moved = np.maximum.reduce([moved, *(np.roll(moved, side) for side in (1, -1))])
    reach = ROOM * moved[:, None] * way.unit
    near = (np.maximum(first, last) > high - reach) | (np.minimum(first, last) < low + reach)
    steps = np.flatnonzero(near.any(1))
    if not len(steps):
        return None
    m0, m1, regular = _slopes(way, q, steps)
    for at, t in _peaks(first[steps], last[steps], m0, m1, low, high):
        k = int(steps[at])
        if not regular[at] or way.solutions(float(k))[1] or way.solutions(float(k + 1))[1]:
            continue
        moved, place, _, _ = way.carry(q[k : k + 1], float(k), k + t)
        if place[0] == k + t and not inside(moved[0], way.plan.limits).all():
            return k, k + t
    return None


def _slopes(way: Continuation, q: Array, steps: Indices) -> tuple[Array, Array, Bools]:
    """Return (k, n) slopes at the begin and the end of some steps, joints per step, and which of them are regular."""
    begins, ends = np.empty((len(steps), q.shape[1])), np.empty((len(steps), q.shape[1]))
    for at, k in enumerate(steps.tolist()):
        begins[at] = way.predict(q[k], k, k + 1) - q[k]
        ends[at] = q[k + 1] - way.predict(q[k + 1], k + 1, k)
    size = np.abs(q[steps + 1] - q[steps]).max(1)
    steep = np.maximum(np.abs(begins).max(1), np.abs(ends).max(1))
    return begins, ends, steep < 10 * size + JOINT_RESTS


def _peaks(first: Array, last: Array, m0: Array, m1: Array, low: Array, high: Array) -> list[tuple[int, float]]:
    """Return (step, part) of every peak of the cubics that comes near a limit, in order."""
    gap = last - first
    a, b, c = 3 * (m0 + m1 - 2 * gap), 2 * (3 * gap - 2 * m0 - m1), m0
    found: set[tuple[int, float]] = set()
    root = np.sqrt(np.maximum(b * b - 4 * a * c, 0.0))
    with np.errstate(all="ignore"):
        flat = np.abs(a) < ROUNDING * (np.abs(b) + np.abs(c))
        places = [np.where(flat, -c / b, (-b + sign * root) / (2 * a)) for sign in (1, -1)]
    for t in places:
        t = np.where(np.isfinite(t) & (t > 0) & (t < 1) & (b * b >= 4 * a * c), t, 0.0)
        value = first + t * (c + t * (b / 2 + t * a / 3))
        room = NEAR_LIMIT * np.maximum(np.abs(gap), np.maximum(np.abs(value - first), np.abs(value - last)))
        beyond = (t > 0) & ((value > high - room) | (value < low + room))
        found |= {(int(k), float(t[k, j])) for k, j in np.argwhere(beyond)}
    return sorted(found)


def off_line(way: Continuation, q: Array) -> OffLine:
    """Return how far straight motion of the joints between points q (k, n) leads from the line."""
    if len(q) < 2:
        return OffLine(0.0, 0.0, 0)
    parts = np.array(PARTS)[:, None, None]
    T = fk(way.chain, q[:-1] + parts * (q[1:] - q[:-1]))
    a, b = way.path[: len(q) - 1, :3, 3], way.path[1 : len(q), :3, 3]
    along = b - a
    square = (along * along).sum(-1)
    at = np.clip(((T[..., :3, 3] - a) * along).sum(-1) / np.where(square > 0, square, 1.0), 0.0, 1.0)
    away = np.linalg.norm(T[..., :3, 3] - a - at[..., None] * along, axis=-1)
    turned = 0.0
    if way.plan.task == "pose":
        legs = zip(way.path[: len(q) - 1], way.path[1 : len(q)], strict=True)
        on = np.stack([between(start, end, PARTS)[:, :3, :3] for start, end in legs], axis=1)
        turned = float(np.linalg.norm(rotation_vector(np.swapaxes(on, -1, -2) @ T[..., :3, :3]), axis=-1).max())
    return OffLine(float(away.max()), turned, int(np.argmax(away.max(0))))
