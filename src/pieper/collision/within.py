"""How far apart the two nearest can be at most, of all postures near one: `swept.py` bounds the other side."""

from __future__ import annotations

import numpy as np

from pieper.collision.distance import nearest
from pieper.collision.model import Model
from pieper.description.shapes import corners
from pieper.kinematics.arrays import Array


def at_most(model: Model, q: Array, radius: Array) -> Array:
    """Return upper bounds (N,) of the arm's distance at every posture near joint vectors, m.

    The signed distance of two bodies changes by no more than the way that a point of the one can come as seen from the
    other: joint by joint the largest lever times the joint's change, and levers grow by what joints behind can do.

    Args:
        model: What must keep apart.
        q: (N, n) joint vectors, rad or m.
        radius: (N,) how far from q the axes' values may be, root of the sum of squares (rad; slides per length).

    Returns:
        Infinite where the nearest pair is one whose distance the kernel has not.
    """
    metres, which, _, _ = nearest(model, q)
    out, unit = np.full(len(q), np.inf), model.chain.joints.unit
    frames = model.chain.native.frames(q, model.base)
    axes = model.chain.native_axes.frames(q, np.eye(4))[:, 1:-1]
    for pair in np.unique(which[which < model.known]).tolist():
        rows = np.flatnonzero(which == pair)
        i, j = (int(k) for k in model.pairs[pair])
        points, layer = corners(model.shapes[i])
        frame = frames[rows, model.on[i]]
        at = points @ np.swapaxes(frame[:, :3, :3], 1, 2) + frame[:, None, :3, 3]
        way, squares = np.zeros(len(rows)), np.zeros(len(rows))
        for k in range(int(model.links[i]) - 1, int(model.links[j]) - 1, -1):
            if model.chain.sliding[k]:
                lever = np.full(len(rows), float(unit[k]) if model.chain.coupling is None else model.chain.length)
            else:
                z, p = axes[rows, k, :3, 2], axes[rows, k, :3, 3]
                far = np.linalg.norm(np.cross(z[:, None], at - p[:, None]), axis=2).max(1) + layer
                lever = far + way
            way = way + radius[rows] * lever
            squares = squares + lever**2
        out[rows] = metres[rows] + radius[rows] * np.sqrt(squares) + model.slack
    return out
