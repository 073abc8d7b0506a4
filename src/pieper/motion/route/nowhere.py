"""That no posture inside the limits holds a pose with its axis within a cone: every box of joint values is ruled out.

The joints' ranges are halved until each box is ruled out by what joints can do at most inside it. With J the tool
point's Jacobian in the middle of a box of half widths h, e the way from there to the pose, and R what is left of the
second order, a posture of the box would need e = J x + R with |x_j| <= h_j; no direction along which e is longer than
that allows is one. The cosine of the axis with that of the pose changes by at most g x and a second order in turn,
and for any multiplier l the sum g x is at most |g - J' l| h + l (e - R) there: where that stays below the cosine of
the cone, nothing in the box is within it.

Source:
    Moore, Kearfott and Cloud (2009), Introduction to Interval Analysis, 6 and 8.
"""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.forward import fk
from pieper.kinematics.pose import rotation_z
from pieper.motion.route.keep import Keep
from pieper.motion.route.setting import Setting
from pieper.tolerances import BOX_ROUNDING, LIMIT_SLACK, MULTIPLIER_DAMPED, TINY

#: Boxes looked at in all, and at once.
MOST, AT_ONCE = 2_000_000, 20_000


def nothing_within_cone(setting: Setting, T: Array, most: int = MOST, keep: Keep | None = None) -> int | None:
    """Return how many boxes were looked at to prove that no posture inside the limits holds a pose; None where not.

    With what is to be kept: that none which keeps the clearance does. Of a box whose middle is nearer to what stands
    around than all its joints can move away none does.

    Args:
        setting: What is solved.
        T: (4, 4) the pose, its z axis the one that may tilt, m.
        most: Boxes that may be looked at.
        keep: What is to be kept beside limits, or None.
    """
    limits = setting.plan.limits
    turns = ~setting.plan.prismatic
    if setting.coupling is not None or not np.isfinite(limits[~turns]).all():
        return None
    low, high = limits.T.copy()
    round_ = turns & ~(high - low < 2 * np.pi)
    low, high = np.where(round_, -np.pi, low), np.where(round_, np.pi, high)
    middle, half = ((low + high) / 2)[None], ((high - low) / 2)[None] + LIMIT_SLACK
    looked, held = 0, _held(setting, T)
    while len(middle):
        looked += min(len(middle), AT_ONCE)
        if looked > most:
            return None
        now, h = middle[-AT_ONCE:], half[-AT_ONCE:]
        middle, half = middle[:-AT_ONCE], half[:-AT_ONCE]
        out, split = _ruled_out(setting, T[:3, 3], held, now, h)
        if keep is not None and keep.at_most is not None:
            left = np.flatnonzero(~out)
            out[left] = keep.at_most(now[left], h[left]) < keep.clearance
        now, h, split = now[~out], h[~out], split[~out]
        one: Bools = np.equal(split[:, None], np.arange(h.shape[1]))
        smaller: Array = np.where(one, h / 2, h)
        shift: Array = np.where(one, smaller, 0.0)
        middle = np.concatenate([middle, now - shift, now + shift])
        half = np.concatenate([half, smaller, smaller])
    return looked


def _held(setting: Setting, T: Array) -> list[tuple[Array, Array, float]]:
    """Return directions (3,) of the tool, those (3,) of the pose they are near to, and the least cosines with these.

    The orientation is T's tilted and then turned: a turn within w of a middle one and a tilt by an angle t in all move
    no direction by more than w + t. Two tilts about axes across each other, whose cosines have a product of at least c
    and so a sum of at least 2 sqrt(c), make up one by no more than cos t = sqrt(c) + (c - 1) / 2.

    Tilted by b about y and then turned by t the pose's x axis has cos b cos t and -cos b sin t along the tool's x and
    y, whatever the tilt about x: where low <= t <= high <= low + pi, sin(t - low) and sin(high - t) are not negative.
    """
    if setting.curves.task == "position":
        return []
    c = float(np.cos(setting.free.cone))
    own = np.eye(3)
    out = [(own[2], T[:3, 2], c - BOX_ROUNDING)]
    low, high = setting.free.interval if setting.turns else (0.0, 0.0)
    most = (high - low) / 2 + float(np.arccos(min(1.0, np.sqrt(c) + (c - 1) / 2)))
    if most < np.pi:
        R = T[:3, :3] @ rotation_z(np.asarray((low + high) / 2))[:3, :3]
        out += [(own[k], R[:, k], float(np.cos(most)) - BOX_ROUNDING) for k in (0, 1)]
    if high - low <= np.pi:
        for end, sense in ((low, -1.0), (high, 1.0)):
            out.append((sense * np.array([np.sin(end), np.cos(end), 0.0]), T[:3, 0], -BOX_ROUNDING))
    return out


def _ruled_out(
    setting: Setting, p: Array, held: list[tuple[Array, Array, float]], q: Array, h: Array
) -> tuple[Bools, Array]:
    """Return which boxes (k, n) hold nothing (k,), and along which joint to halve each (k,)."""
    chain, turning = setting.plan.chain, (~setting.plan.prismatic).astype(float)
    here, J = fk(chain, q), chain.native.jacobian(q)
    h = h * (1 + BOX_ROUNDING) + BOX_ROUNDING
    linear: Array = J[:, :3]
    axes: Array = J[:, 3:]
    # how far the tool's point can be from each axis inside the box: joints behind it move it farther
    lever = _length(linear, 1)
    behind: Array = np.zeros(len(q))
    most: Array = np.empty_like(lever)
    for j in range(q.shape[1] - 1, -1, -1):
        most[:, j] = lever[:, j] + behind * turning[j]
        behind = behind + most[:, j] * h[:, j]
    way, bend = h * turning, most * h
    before = np.asarray(np.cumsum(way, axis=1), np.float64) - way
    point: Array = (before * bend).sum(1) + 0.5 * (way * bend).sum(1) + BOX_ROUNDING * chain.length
    turned: Array = 0.5 * way.sum(1) ** 2
    e: Array = p - here[:, :3, 3]
    towards = e / np.maximum(_length(e, 1), TINY)[:, None]
    u: Array = np.concatenate([np.tile(np.eye(3), (len(q), 1, 1)), towards[:, None]], axis=1)
    along = np.abs(_apply(u, e))
    can = _apply(np.abs(u @ linear), h) + point[:, None]
    out: Bools = np.asarray((along > can).any(1), np.bool_)
    square: Array = linear @ np.swapaxes(linear, 1, 2)
    damp: Array = MULTIPLIER_DAMPED * np.trace(square, axis1=1, axis2=2) + TINY
    square = square + damp[:, None, None] * np.eye(3)
    for own, direction, cosine in held:
        now: Array = here[:, :3, :3] @ own
        g: Array = _apply(np.swapaxes(np.cross(axes, now[:, :, None], axis=1), 1, 2), np.tile(direction, (len(q), 1)))
        best = np.asarray(np.linalg.solve(square, _apply(linear, g)[..., None]), np.float64)[..., 0]
        for by in (np.zeros_like(best), best):
            left = np.abs(g - _apply(np.swapaxes(linear, 1, 2), by))
            reached = now @ direction + turned + (left * h).sum(1) + (by * e).sum(1) + _length(by, 1) * point
            out |= np.asarray(reached < cosine, np.bool_)
    weight = h * (lever / chain.length + 0.5 * turning)
    return out, np.argmax(weight, axis=1)


def _length(v: Array, axis: int) -> Array:
    return np.asarray(np.sqrt((v * v).sum(axis)), np.float64)


def _apply(M: Array, v: Array) -> Array:
    """Return M v of matrices (k, a, b) and vectors (k, b)."""
    return np.asarray((M @ v[..., None])[..., 0], np.float64)
