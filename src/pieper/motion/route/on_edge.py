"""A route whose tool leans as far as its cone allows: points that rest on the cone's edge slide along it.

At such a point the cost would fall if the tool could lean farther. What is left free there is what does not change the
lean, and the edge counts in the cost's bending with its multiplier, as constraints do in Newton's method.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.newton import missed, newton
from pieper.kinematics.pose import inverse, rotation_about, rotation_x
from pieper.motion.route.freedom import Freedom
from pieper.motion.route.setting import Setting
from pieper.tolerances import CLOSES, CONE_KEPT, TINY


def cone_slope(setting: Setting, x: Array) -> Array:
    """Return the slope (N, 2) of how far tilts are inside the cone."""
    a, b = x[:, -2], x[:, -1]
    return -np.stack([np.sin(a) * np.cos(b), np.cos(a) * np.sin(b)], -1) / np.sin(setting.free.cone)


def cone_bend(setting: Setting, x: Array) -> Array:
    """Return the second derivative (N, 2, 2) of how far tilts are inside the cone."""
    a, b = x[:, -2], x[:, -1]
    same, other = -np.cos(a) * np.cos(b), np.sin(a) * np.sin(b)
    return np.stack([np.stack([same, other], -1), np.stack([other, same], -1)], -2) / np.sin(setting.free.cone)


def along_edge(setting: Setting, x: Array, g: Array, Z: Array, edge: Bools) -> tuple[Array, Array, Array]:
    """Return the cost's slope (N, m) with the edge's part, what is free along it (N, m, d), and its multipliers (N,).

    Args:
        setting: What is solved.
        x: (N, m) the points.
        g: (N, m) slope of the cost.
        Z: (N, m, d) what each pose leaves free; of a point on the edge the first of these becomes zero.
        edge: (N,) which points rest on the edge.
    """
    n: Array = np.zeros_like(x)
    n[:, -2:] = cone_slope(setting, x)
    u: Array = np.einsum("kma,km->ka", Z, n)
    size = np.maximum(np.linalg.norm(u, axis=1), TINY)
    first = u / size[:, None]
    multiplier = np.where(edge, -np.einsum("ka,kma,km->k", first, Z, g) / size, 0.0)
    # the first direction is across the edge, the others lie along it
    Q = np.linalg.qr(np.concatenate([first[:, :, None], np.tile(np.eye(Z.shape[2]), (len(x), 1, 1))], axis=2))[0]
    turned: Array = Z @ Q
    turned[:, :, 0] = 0.0
    return g + multiplier[:, None] * n, np.where(edge[:, None, None], turned, Z), multiplier


def onto_edge(setting: Setting, x: Array, T: Array, edge: Bools) -> tuple[Array, Bools]:
    """Return points (N, m) moved onto poses (N, 4, 4), some with their tilt on the edge, and which were."""
    moved, on = setting.on(x, T)
    if not edge.any():
        return moved, on
    y = x[edge]
    a, b = y[:, -2], y[:, -1]
    size = setting.free.cone * (1 - CONE_KEPT)
    towards = np.arctan2(np.cos(a) * np.sin(b), np.sin(a))
    a = np.arcsin(np.sin(size) * np.cos(towards))
    b = np.arctan2(np.sin(size) * np.sin(towards), np.cos(size))
    tilt: Array = np.zeros((len(y), 4, 4))
    tilt[:, 3, 3] = 1.0
    tilt[:, :3, :3] = rotation_about(np.array([0.0, 1.0, 0.0]), a)
    upright = replace(setting, free=Freedom(turn=setting.free.turn, axis=setting.free.axis)).chain
    poses = T[edge] @ inverse(tilt @ rotation_x(b))
    there = newton(upright, y[:, :-2], poses, steps=8)
    moved[edge] = np.hstack([there, a[:, None], b[:, None]])
    on[edge] = missed(upright, there, poses) < CLOSES
    return moved, on
