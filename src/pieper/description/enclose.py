"""Points enclosed by a capsule or a box, whichever is smaller: what a mesh comes down to."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from pieper.description.shapes import Box, Capsule
from pieper.tolerances import ROUNDING, THINNEST

Array = npt.NDArray[np.float64]
#: Steps of the enclosing circle's centre (Badoiu and Clarkson, 2003): within one per cent of the smallest.
STEPS = 200


def enclosing(points: Array, name: str) -> Capsule | Box:
    """Return the smaller of a capsule and a box about points (k, 3), along their main or their own axes."""
    middle = points.mean(0)
    _, _, main = np.linalg.svd(points - middle, full_matrices=False)
    main[2] = np.cross(main[0], main[1])
    choices: list[tuple[float, Capsule | Box]] = []
    for axes in (np.eye(3), main):
        seen = points @ axes.T
        low, high = seen.min(0), seen.max(0)
        size = np.maximum(high - low, THINNEST)
        T = np.eye(4)
        T[:3, :3], T[:3, 3] = axes.T, axes.T @ ((low + high) / 2)
        choices.append((float(np.prod(size)), Box(T, size, name)))
        for k in range(3):
            choices.append(_capsule(points, axes[k], axes[(k + 1) % 3], axes[(k + 2) % 3], name))
    return min(choices, key=lambda choice: choice[0])[1]


def _rim(flat: Array) -> Array:
    """Return the points (k, 2) that may lie on the hull of points (N, 2): those inside a polygon of some cannot."""
    angle = np.arange(64) * (np.pi / 32)
    ring = flat[np.argmax(flat @ np.stack([np.cos(angle), np.sin(angle)]), axis=0)]
    inside = np.ones(len(flat), bool)
    for corner, edge in zip(ring, np.roll(ring, -1, 0) - ring, strict=True):
        if edge.any():
            inside &= edge[0] * (flat[:, 1] - corner[1]) - edge[1] * (flat[:, 0] - corner[0]) > 0
    return flat[~inside]


def _capsule(points: Array, along: Array, x: Array, y: Array, name: str) -> tuple[float, Capsule]:
    """Return the volume and the capsule of least radius along a direction."""
    flat = np.stack([points @ x, points @ y], 1)
    rim = _rim(flat)
    centre = (flat.min(0) + flat.max(0)) / 2
    best, radius = centre, float(np.linalg.norm(rim - centre, axis=1).max())
    for k in range(STEPS):
        away = np.linalg.norm(rim - centre, axis=1)
        if away.max() < radius:
            best, radius = centre.copy(), float(away.max())
        centre = centre + (rim[np.argmax(away)] - centre) / (k + 2)
    radius = max(radius, THINNEST)
    height = points @ along
    room = np.sqrt(np.maximum(radius**2 - ((flat - best) ** 2).sum(1), 0.0))
    # each point lies inside the ball about an end, or between the ends
    low, high = float((height + room).min()), float((height - room).max())
    if low > high:
        low = high = (low + high) / 2
        radius = float(np.linalg.norm(np.column_stack([flat - best, height - low]), axis=1).max())
    a, b = (best[0] * x + best[1] * y + h * along for h in (low, high))
    volume = np.pi * radius**2 * (high - low + 4 / 3 * radius)
    # rounding must not leave a corner outside
    return float(volume), Capsule(a, b, radius * (1 + ROUNDING), name)
