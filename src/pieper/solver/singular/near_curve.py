"""Curves that nearly hold a pose: next to a self-motion, isolated solutions hide along what is left of it.

A pose at a small distance from one with a self-motion has none, but the curve is still there on which
five of the six pose equations hold: all but the one that the weakest direction of the Jacobian cannot reach. What is
missed of that one changes sign at the isolated solutions, and nowhere else on the curve.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper.kinematics.arrays import Array, Indices
from pieper.kinematics.chain import Chain
from pieper.kinematics.newton import bounded, pose_difference, scaled_jacobian, turned_back
from pieper.tolerances import (
    CURVE_FAR,
    CURVE_STEEP,
    CURVE_WEAK,
    LINE_OF_SLIDES,
    NEAR_CURVE_HOLDS,
    NEAR_CURVE_ROUNDING,
    NEAR_CURVE_SHORTEST,
    TINY,
)

#: Step along a curve (rad; per length), and the most steps a way.
STEP, MOST_STEPS = 0.2, 240


@dataclass(frozen=True, eq=False)
class Points:
    """Joint vectors on curves on which only the weakest direction misses the pose.

    Args:
        q: (N, n).
        miss: (N,) what is missed along `left`.
        rest: (N,) size of what is missed otherwise.
        left: (N, 6) the pose direction that cannot be reached.
        null: (N, n) the joint direction along the curve, without units.
        sigma: (N,) relative smallest singular value.
    """

    q: Array
    miss: Array
    rest: Array
    left: Array
    null: Array
    sigma: Array


def onto(chain: Chain, q: Array, T: Array, steps: int = 4) -> Points:
    """Move joint vectors q (N, n) onto such curves by Newton steps in all but the weakest direction."""
    weakest = min(chain.n, 6) - 1

    def seen(q: Array) -> tuple[Array, Array, Array, Array, Array]:
        e = pose_difference(chain, q, T)
        U, s, Vt = np.linalg.svd(scaled_jacobian(chain, q), full_matrices=False)
        return e, U, s, Vt, np.einsum("nik,ni->nk", U, e)

    e, u, s, v, along = seen(q)
    for _ in range(steps):
        q = q + bounded(turned_back(s, v, along, CURVE_WEAK, weakest), 0.3) * chain.joints.unit
        e, u, s, v, along = seen(q)
    miss = along[:, weakest]
    left, null = u[:, :, weakest], v[:, weakest]
    rest = np.linalg.norm(e - miss[:, None] * left, axis=1)
    return Points(q, miss, rest, left, null, s[:, weakest] / np.maximum(s[:, 0], TINY))


@dataclass(frozen=True, eq=False)
class NearCurve:
    """Samples along such a curve, in order.

    Args:
        q: (k, n), angles continuous.
        miss: (k,) what is missed along `left`, its sign continuous too.
        left: (k, 6).
        closed: Whether the last sample is the first again, up to whole turns.
    """

    q: Array
    miss: Array
    left: Array
    closed: bool


def follow(chain: Chain, q: Array, T: Array) -> NearCurve:
    """Follow the curve through q (n,) both ways until it closes, turns steep or misses the pose by too much.

    Where slides alone move along it, it is a straight line without end and what is missed changes by an equal part a
    length: Newton's method from its first point finds the solution on it, if there is one.
    """
    start = onto(chain, q[None], T)
    if np.abs(start.null[0][~chain.prismatic]).max(initial=0.0) < LINE_OF_SLIDES and chain.prismatic.any():
        return NearCurve(start.q, start.miss, start.left, False)
    points, closed = _walk(chain, start, T, 1.0)
    if not closed:
        points = _walk(chain, start, T, -1.0)[0][:0:-1] + points
    q, miss, left = (np.array(column) for column in zip(*points, strict=True))
    return NearCurve(q, miss, left, closed)


def _walk(chain: Chain, start: Points, T: Array, sense: float) -> tuple[list[tuple[Array, float, Array]], bool]:
    unit = chain.joints.unit
    q, null, left = start.q[0], sense * start.null[0], start.left[0]
    points, step, first = [(q, float(start.miss[0]), left)], STEP, null
    for taken in range(MOST_STEPS):
        p = onto(chain, (q + step * null * unit)[None], T, 3)
        turn = float(p.null[0] @ null)
        size = np.linalg.norm((p.q[0] - q) / unit)
        held = p.rest[0] <= max(NEAR_CURVE_HOLDS * abs(p.miss[0]), NEAR_CURVE_ROUNDING)
        if not held or abs(turn) < 0.8 or not 0.5 * step < size < 2 * step:
            step /= 2
            if step < NEAR_CURVE_SHORTEST:
                return points, False
            continue
        if abs(p.miss[0]) > CURVE_FAR or p.sigma[0] > CURVE_STEEP:
            return points, False
        q, null = p.q[0], p.null[0] if turn > 0 else -p.null[0]
        # the missed direction keeps its sense along the curve, so that a change of sign means something
        same = 1.0 if p.left[0] @ left > 0 else -1.0
        left = same * p.left[0]
        points.append((q, float(same * p.miss[0]), left))
        home = chain.joints.way(q, start.q[0])
        if taken > 2 and np.linalg.norm(home / unit) < 0.75 * step and abs(null @ first) > 0.8:
            back = 1.0 if start.left[0] @ left > 0 else -1.0
            points.append((q - home, back * float(start.miss[0]), back * start.left[0]))
            return points, True
        step = min(STEP, 1.5 * step)
    return points, False


def hiding(chain: Chain, T: Array, curve: NearCurve) -> Array:
    """Return points (m, n) of a curve where what is missed vanishes, or where it is smallest without a change of sign.

    Changes of sign are narrowed down on the curve by false position, all at once.
    """
    q, miss, left = curve.q, curve.miss, curve.left
    if len(q) < 3:
        return q
    lower = np.flatnonzero(miss[:-1] * miss[1:] <= 0)
    a, b = _ends(q, miss, left, lower), _ends(q, miss, left, lower + 1)
    size = np.abs(miss)
    inner = np.arange(1, len(q) - 1)
    turns = inner[(size[inner] <= size[inner - 1]) & (size[inner] <= size[inner + 1])]
    turns = turns[(miss[turns] * miss[turns - 1] > 0) & (miss[turns] * miss[turns + 1] > 0)]
    tips = np.zeros((0, q.shape[1]))
    if len(turns):
        # two zeros between two samples show as a smallest value of the parabola through three
        bend = (miss[turns - 1] + miss[turns + 1]) / 2 - miss[turns]
        t = np.clip(np.where(bend == 0, 0.0, -(miss[turns + 1] - miss[turns - 1]) / (4 * bend)), -1, 1)[:, None]
        guess = q[turns] + np.where(t > 0, t * (q[turns + 1] - q[turns]), t * (q[turns] - q[turns - 1]))
        tip, value, sense = _valued(chain, guess, T, left[turns])
        tips = tip
        over = np.flatnonzero(value * miss[turns] < 0)
        for side in (-1, 1):
            other = _ends(q, miss, left, turns[over] + side)
            a = tuple(np.concatenate([x, y]) for x, y in zip(a, (tip[over], value[over], sense[over]), strict=True))
            b = tuple(np.concatenate([x, y]) for x, y in zip(b, other, strict=True))
    if not len(a[0]):
        return tips
    middle = a
    for _ in range(12):
        gap = b[1] - a[1]
        part = np.clip(np.where(gap == 0, 0.5, -a[1] / np.where(gap == 0, 1.0, gap)), 0.02, 0.98)[:, None]
        middle = _valued(chain, a[0] + part * (b[0] - a[0]), T, a[2])
        on_a = (middle[1] * a[1] > 0)[:, None]
        # false position keeps one end for ever: its value is halved each time (Illinois)
        weight_a, weight_b = np.where(on_a[:, 0], middle[1], a[1] / 2), np.where(on_a[:, 0], b[1] / 2, middle[1])
        a = (np.where(on_a, middle[0], a[0]), weight_a, np.where(on_a, middle[2], a[2]))
        b = (np.where(on_a, b[0], middle[0]), weight_b, np.where(on_a, b[2], middle[2]))
    return np.concatenate([middle[0], tips])


def _ends(q: Array, miss: Array, left: Array, index: Indices) -> tuple[Array, Array, Array]:
    return q[index], miss[index], left[index]


def _valued(chain: Chain, q: Array, T: Array, left: Array) -> tuple[Array, Array, Array]:
    """Return q moved onto the curve, what it misses along the sense of `left`, and that direction."""
    p = onto(chain, q, T, 4)
    same = np.where(np.einsum("ni,ni->n", p.left, left) > 0, 1.0, -1.0)
    return p.q, same * p.miss, same[:, None] * p.left
