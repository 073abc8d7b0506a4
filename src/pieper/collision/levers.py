"""How far bodies come as seen from each other while joints change: what proofs about distances rest on."""

from __future__ import annotations

import numpy as np

from pieper.collision.distance import nearest
from pieper.collision.model import Model
from pieper.description.shapes import corners
from pieper.kinematics.arrays import Array


def levers(model: Model, pair: int, q: Array, change: Array) -> Array:
    """Return how far (N, axes) a point of one body comes at most, as seen from the other, for one of each axis's value.

    Args:
        model: What must keep apart.
        pair: Which two.
        q: (N, n) joint vectors, rad or m.
        change: (N, axes) by how much each axis's value may be off, rad or m: levers grow by what axes behind can do.
    """
    chain = model.chain
    i, j = (int(k) for k in model.pairs[pair])
    points, layer = corners(model.shapes[i])
    frame = chain.native.frames(q, model.base)[:, model.on[i]]
    at = points @ np.swapaxes(frame[:, :3, :3], 1, 2) + frame[:, None, :3, 3]
    axes = chain.native_axes.frames(q, np.eye(4))[:, 1:-1]
    out, way = np.zeros(change.shape), np.zeros(len(q))
    for k in range(int(model.links[i]) - 1, int(model.links[j]) - 1, -1):
        z, p = axes[:, k, :3, 2], axes[:, k, :3, 3]
        far = np.linalg.norm(np.cross(z[:, None], at - p[:, None]), axis=2).max(1) + layer
        out[:, k] = 1.0 if chain.sliding[k] else far + way
        way = way + change[:, k] * out[:, k]
    return out


def at_most(model: Model, q: Array, radius: Array) -> Array:
    """Return upper bounds (N,) of the arm's distance at every posture near joint vectors, m.

    The signed distance of two bodies changes by no more than a point of the one comes, seen from the other.

    Args:
        model: What must keep apart.
        q: (N, n) joint vectors, rad or m.
        radius: How far from q the axes' values may be: (N,) root of the sum of squares (rad; slides per length), or
            (N, axes) each of them (rad or m).

    Returns:
        Infinite where the nearest pair is one whose distance the kernel has not.
    """
    metres, which, _, _ = nearest(model, q)
    unit = np.where(model.chain.sliding, model.chain.length, 1.0)
    out = np.full(len(q), np.inf)
    for pair in np.unique(which[which < model.known]).tolist():
        rows = np.flatnonzero(which == pair)
        if radius.ndim == 2:
            ways = levers(model, pair, q[rows], radius[rows])
            out[rows] = metres[rows] + (radius[rows] * ways).sum(1) + model.slack
            continue
        ways = unit * levers(model, pair, q[rows], radius[rows, None] * unit)
        out[rows] = metres[rows] + radius[rows] * np.linalg.norm(ways, axis=1) + model.slack
    return out
