"""Cutting a corner within a radius: the two ways are left and met with their own slope and bend."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.kinematics.chain import Chain
from pieper.kinematics.forward import fk
from pieper.motion.curve import JointCurve
from pieper.motion.segments import Segment
from pieper.tolerances import BLEND_SHRUNK, LAST_BLENDED, NO_BLEND, REVERSES, TINY

#: Places of a way that are looked at for where it enters the radius.
PLACES = 129
#: Points of a blend.
BLEND_POINTS = 25


@dataclass(frozen=True, eq=False)
class Blend:
    """A corner cut off.

    Attributes:
        leaves: s of the way before at which it is left.
        meets: s of the way behind at which it is met.
        radius: What it came to, m.
    """

    leaves: float
    meets: float
    radius: float


def blend(chain: Chain, before: Segment, after: Segment, number: int) -> tuple[Blend | None, str | None]:
    """Return how the corner between two moves is cut, None where it cannot be, and a remark where it is not as asked.

    Args:
        chain: The arm.
        before: The way to the corner; its move says the radius.
        after: The way on.
        number: The move's number, 1-based.
    """
    asked = before.move.blend
    out, into = before.curve.at(np.ones(1))[1][0], after.curve.at(np.zeros(1))[1][0]
    unit = chain.joints.unit
    cosine = (out / unit) @ (into / unit) / (np.linalg.norm(out / unit) * np.linalg.norm(into / unit))
    if cosine < REVERSES:
        return (
            None,
            f"The corner at move {number} turns back the way it came and cannot be blended: it is a stop.",
        )
    corner = fk(chain, before.curve.end)[:3, 3]
    # each way gives up at most one half, so that the blends at its two ends never overlap
    back = 1 - np.linspace(0.0, 0.5, PLACES)
    away = [_distances(chain, before.curve, back, corner), _distances(chain, after.curve, 1 - back, corner)]
    radius = min(asked, *(float(d.max()) for d in away))
    if radius < NO_BLEND:
        # the tool's point stays: there is no radius to speak of, and the turn is cut at its half
        return Blend(0.5, 0.5, 0.0), None
    s = [_enters(d, radius) for d in away]
    remark = None
    if radius < asked * (1 - BLEND_SHRUNK):
        remark = (
            f"The blend of {asked * 1e3:g} mm at move {number} shrinks to {radius * 1e3:.4g} mm: half of the way "
            "before or behind it is no longer."
        )
    return Blend(1 - s[0], s[1], radius), remark


def blended_points(before: JointCurve, after: JointCurve, corner: Blend) -> Array:
    """Return joint points (BLEND_POINTS, n) of the curve that cuts a corner, both ends included.

    A curve of fifth degree with the place, slope and bend of both ways, by a parameter on which both run through the
    corner at 1: the way before from 0, the way behind to 2.
    """
    a, b = 1 - corner.leaves, corner.meets
    q0, v0, w0, _ = (x[0] for x in before.at(np.array([corner.leaves])))
    q1, v1, w1, _ = (x[0] for x in after.at(np.array([corner.meets])))
    # on [0, 1] of the whole blend: half of it for each way
    v0, w0, v1, w1 = 2 * a * v0, 4 * a * a * w0, 2 * b * v1, 4 * b * b * w1
    control = [q0, q0 + v0 / 5, q0 + 2 * v0 / 5 + w0 / 20, q1 - 2 * v1 / 5 + w1 / 20, q1 - v1 / 5, q1]
    u = np.linspace(0.0, 1.0, BLEND_POINTS)[:, None]
    weight = [1, 5, 10, 10, 5, 1]
    return sum((w * u**k * (1 - u) ** (5 - k) * c for k, (w, c) in enumerate(zip(weight, control, strict=True))), 0 * u)


def _distances(chain: Chain, curve: JointCurve, s: Array, corner: Array) -> Array:
    return np.linalg.norm(fk(chain, curve.at(s)[0])[:, :3, 3] - corner, axis=1)


def _enters(distance: Array, radius: float) -> float:
    """Return how much of a way, 0 to a half, lies within a radius of the corner it begins at."""
    i = int(np.argmax(distance >= radius * (1 - LAST_BLENDED)))
    step = 0.5 / (PLACES - 1)
    if i == 0:
        return step
    low, high = distance[i - 1], distance[i]
    return step * (i - 1 + (radius - low) / max(high - low, TINY))
