"""A circle through three points or about a centre, the tool turning evenly along it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper.errors import InputError
from pieper.kinematics.arrays import Array
from pieper.kinematics.joints import turned_from
from pieper.kinematics.pose import rotation_about
from pieper.motion.path import between
from pieper.tolerances import NO_LENGTH, OFF_CENTRE, THREE_IN_LINE


@dataclass(frozen=True, eq=False)
class Round:
    """A circle's arc.

    Attributes:
        centre: (3,), m.
        normal: (3,) axis about which it goes.
        spoke: (3,) from the centre to where it begins, m.
        angle: How far it goes, 0 to 2 pi, rad.
    """

    centre: Array
    normal: Array
    spoke: Array
    angle: float

    def at(self, s: Array) -> Array:
        """Return points (k, 3) at parts s (k,) of the arc."""
        return self.centre + rotation_about(self.normal, s * self.angle) @ self.spoke

    def part(self, point: Array) -> float:
        """Return at which part of the arc a point (3,) lies."""
        out = point - self.centre
        return _round(self.normal, self.spoke, out) / self.angle


def round_of(T0: Array, via: Array, T1: Array) -> Round:
    """Return the arc from the point of T0 over that of `via` to that of T1.

    Raises:
        InputError: The three points do not make a circle: two are equal, or all are in line.
    """
    a, b, c = T0[:3, 3], via[:3, 3], T1[:3, 3]
    size = max(float(np.linalg.norm(b - a)), float(np.linalg.norm(c - b)), float(np.linalg.norm(c - a)))
    for one, other, words in ((a, b, "the via and the start"), (b, c, "the via and the end"), (a, c, "start and end")):
        if np.linalg.norm(one - other) <= THREE_IN_LINE * max(size, NO_LENGTH):
            raise InputError(f"{words} of the circle are one point; three different points make a circle.")
    normal = np.cross(b - a, c - a)
    if np.linalg.norm(normal) <= THREE_IN_LINE * np.linalg.norm(b - a) * np.linalg.norm(c - a):
        raise InputError("start, via and end of the circle are in line: use move_l, or move the via aside.")
    normal = normal / np.linalg.norm(normal)
    # the centre from the two perpendicular bisectors
    M = np.stack([b - a, c - a, normal])
    centre = np.linalg.solve(M, [(b - a) @ (a + b) / 2, (c - a) @ (a + c) / 2, normal @ a])
    spoke, last = a - centre, c - centre
    return Round(np.asarray(centre, np.float64), normal, spoke, _round(normal, spoke, last))


def _round(normal: Array, spoke: Array, out: Array) -> float:
    """Return the angle in [0, 2 pi) about a normal from a spoke (3,) to a place out (3,) from the centre, rad."""
    return float(turned_from(0.0, np.arctan2(normal @ np.cross(spoke, out), spoke @ out)))


def circle(T0: Array, via: Array, T1: Array, s: Array) -> Array:
    """Return the poses (k, 4, 4) at s (k,) of the circle from T0 over the point of `via` to T1.

    The centre and the angle follow from the three points; the orientation goes evenly from that of T0 to that of T1
    about one axis, by the shorter way, as on a line: the one of `via` is not used.

    Raises:
        InputError: The three points do not make a circle: two are equal, or all are in line.
    """
    arc = round_of(T0, via, T1)
    T = between(T0, T1, s)
    T[..., :3, 3] = arc.at(s)
    T[s == 0.0] = T0
    T[s == 1.0] = T1
    return T


def via_about(T0: Array, T1: Array, centre: Array, *, the_long_way: bool = False) -> Array:
    """Return a pose (4, 4) halfway on the circle about a centre (3,) from T0 to T1, by the shorter or the longer way.

    Raises:
        InputError: The centre is not equally far from both ends, or in line with them: then a via decides the way.
    """
    a, c = T0[:3, 3] - centre, T1[:3, 3] - centre
    r0, r1 = float(np.linalg.norm(a)), float(np.linalg.norm(c))
    if r0 == 0 or r1 == 0 or abs(r0 - r1) > OFF_CENTRE * max(r0, r1):
        raise InputError(
            f"the centre is {r0 * 1e3:.4g} mm from the start and {r1 * 1e3:.4g} mm from the end of the circle; it must "
            "be as far from both.",
            start=r0,
            end=r1,
        )
    middle = a / r0 + c / r1
    size = float(np.linalg.norm(middle))
    if size < THREE_IN_LINE or np.linalg.norm(np.cross(a, c)) <= THREE_IN_LINE * r0 * r1:
        raise InputError("start, centre and end of the circle are in line: say a via, which decides the way.")
    via = T0.copy()
    via[:3, 3] = centre + (-1.0 if the_long_way else 1.0) * middle / size * (r0 + r1) / 2
    return via
