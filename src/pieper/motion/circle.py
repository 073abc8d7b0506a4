"""A circle through three points, the tool turning evenly along it."""

from __future__ import annotations

import numpy as np

from pieper.errors import InputError
from pieper.kinematics.arrays import Array
from pieper.kinematics.pose import rotation_about
from pieper.motion.path import between

#: Sine of the angle at the via point under which three points are in line.
IN_LINE = 1e-6


def circle(T0: Array, via: Array, T1: Array, s: Array) -> Array:
    """Return the poses (k, 4, 4) at s (k,) of the circle from T0 over the point of `via` to T1.

    The centre and the angle follow from the three points; the orientation goes evenly from that of T0 to that of T1
    about one axis, by the shorter way, as on a line: the one of `via` is not used.

    Raises:
        InputError: The three points do not make a circle: two are equal, or all are in line.
    """
    a, b, c = T0[:3, 3], via[:3, 3], T1[:3, 3]
    size = max(float(np.linalg.norm(b - a)), float(np.linalg.norm(c - b)), float(np.linalg.norm(c - a)))
    for one, other, words in ((a, b, "the via and the start"), (b, c, "the via and the end"), (a, c, "start and end")):
        if np.linalg.norm(one - other) <= IN_LINE * max(size, 1e-12):
            raise InputError(f"{words} of the circle are one point; three different points make a circle.")
    normal = np.cross(b - a, c - a)
    if np.linalg.norm(normal) <= IN_LINE * np.linalg.norm(b - a) * np.linalg.norm(c - a):
        raise InputError("start, via and end of the circle are in line: use move_l, or move the via aside.")
    normal = normal / np.linalg.norm(normal)
    # the centre from the two perpendicular bisectors
    M = np.stack([b - a, c - a, normal])
    centre = np.linalg.solve(M, [(b - a) @ (a + b) / 2, (c - a) @ (a + c) / 2, normal @ a])
    spoke, last = a - centre, c - centre
    angle = float(np.arctan2(normal @ np.cross(spoke, last), spoke @ last)) % (2 * np.pi)
    T = between(T0, T1, s)
    T[..., :3, 3] = centre + rotation_about(normal, s * angle) @ spoke
    T[s == 0.0] = T0
    T[s == 1.0] = T1
    return T
