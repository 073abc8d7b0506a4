"""Scenes that were probably meant otherwise: in millimetres, out of reach, or about the place where the arm stands."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from pieper.collision.model import Model
from pieper.description.shapes import Box, Shape, corners
from pieper.kinematics.meant import remark_far_shape, remark_out_of_reach, remark_stands_inside
from pieper.tolerances import DEEP_INSIDE

Array = npt.NDArray[np.float64]


def remark_doubtful_scene(model: Model, base: Sequence[float], reach: float, name: str) -> None:
    """Warn of the first body that is so far away or so large that millimetres were probably meant.

    Else of the first that holds the place where the arm stands, and of a scene of which the arm can touch nothing.

    Args:
        model: What must keep apart.
        base: (3,) where the arm stands, m.
        reach: How far it reaches at most, m.
        name: What it is called.
    """
    stands = np.asarray(base, np.float64)
    own, nearest, which = 0.0, np.inf, ""
    after = [*model.chain.frames_after, model.chain.links[-1]]
    for shape, on, called in zip(model.shapes, model.on, model.names, strict=True):
        points, layer = corners(shape)
        if on > 0:
            # from the axis that moves it: a table's frame may stand far outside the arm
            T = after[on - 1]
            points = points @ T[:3, :3].T + T[:3, 3]
        middle = points.mean(0)
        radius = float(np.linalg.norm(points - middle, axis=1).max()) + layer
        away = float(np.linalg.norm(middle - stands if on < 0 else middle)) - radius
        if remark_far_shape(called, away, 2 * radius, reach, name, on >= 0):
            return
        if on >= 0:
            own = max(own, float(np.linalg.norm(points, axis=1).max()) + layer)
            continue
        if remark_stands_inside(called, _depth(shape, stands), DEEP_INSIDE * reach, name):
            return
        beside = np.maximum(points.min(0) - layer - stands, stands - points.max(0) - layer)
        distance = float(np.linalg.norm(np.maximum(beside, 0.0)))
        nearest, which = min((nearest, which), (distance, called))
    # of the arm's bodies the farthest from its own frame is how much farther than its frames it gets
    if reach + own < nearest < np.inf:
        remark_out_of_reach(which, nearest, reach + own, name)


def _depth(shape: Shape, p: Array) -> float:
    """Return how deep inside a box a point (3,) lies, m; below zero outside it, and for what is no box."""
    if not isinstance(shape, Box):
        return -np.inf
    return float(np.min(shape.size / 2 - np.abs(shape.T[:3, :3].T @ (p - shape.T[:3, 3]))))
