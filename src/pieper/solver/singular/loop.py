"""Joints that move by themselves, read off the axes: two in one line, or four that are parallel or meet in a point.

The twists of these joints at a solution close on themselves, exp(x1 d1) exp(x2 d2) ... = 1, and go on doing so over a
finite motion: two axes in one line turn against each other; four parallel ones are a planar four-bar linkage, four
through a point a spherical one. A four-bar is a scalar equation between the angle that leads and the one opposite,
each side a constant and one harmonic, so that every joint may lead, and where it can go is known exactly.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper.kinematics.arrays import Array, Bools, Indices
from pieper.kinematics.chain import Chain
from pieper.kinematics.joints import short_way
from pieper.tolerances import LOOP_CRITICAL, LOOP_MOVES


@dataclass(frozen=True, eq=False)
class Harmonic:
    """middle + size cos(angle - phase)."""

    middle: float
    size: float
    phase: float

    @staticmethod
    def of(constant: float, cosine: float, sine: float) -> Harmonic:
        """Make constant + cosine cos(angle) + sine sin(angle)."""
        return Harmonic(constant, float(np.hypot(cosine, sine)), float(np.arctan2(sine, cosine)))

    def at(self, angle: Array) -> Array:
        """Return values (k,) at angles (k,)."""
        return self.middle + self.size * np.cos(angle - self.phase)

    def from_phase(self, value: Array) -> Array:
        """Return how far (k,) from the phase, in [0, pi], the value is taken; the nearest end where it is not."""
        return np.arccos(np.clip((value - self.middle) / self.size, -1.0, 1.0))


@dataclass(frozen=True, eq=False)
class FourBar:
    """Four revolute joints that close on themselves.

    Args:
        joints: Their indices in the chain, ascending.
        axes: (4, 3) unit axes at the solution.
        points: (4,) points on the axes in the plane across them, as complex numbers; None for axes through one point.
        senses: (4,) which way each turns in that plane, 1 or -1.
    """

    joints: Indices
    axes: Array
    points: Array | None
    senses: Array

    def sides(self, lead: int) -> tuple[Harmonic, Harmonic]:
        """Return what must be equal: of the angle that leads, and of the one opposite."""
        i1, i2, i3, i4 = _from(lead)
        if self.points is None:
            z1, z2, z3, z4 = self.axes[[i1, i2, i3, i4]]
            both: list[Harmonic] = []
            for z, sense in ((z1, -1.0), (z3, 1.0)):
                constant = float((z @ z2) * (z @ z4))
                both.append(Harmonic.of(constant, float(z2 @ z4) - constant, sense * float(z2 @ np.cross(z, z4))))
            return both[0], both[1]
        p1, p2, p3, p4 = self.points[[i1, i2, i3, i4]]
        flat: list[Harmonic] = []
        for p, sense in ((p1, -self.senses[i1]), (p3, self.senses[i3])):
            m = 2 * np.conj(p - p2) * (p4 - p)
            constant = float(abs(p - p2) ** 2 + abs(p4 - p) ** 2)
            flat.append(Harmonic.of(constant, float(m.real), float(-sense * m.imag)))
        return flat[0], flat[1]

    def turned(self, lead: int, angle: Array, side: Array) -> tuple[Array, Bools]:
        """Return the four angles (k, 4) that a leading angle (k,) asks for, and whether it can go there (k,).

        Args:
            lead: Which of the four leads.
            angle: (k,) rad, from the solution.
            side: (k,) 1 or -1, on which side of its phase the opposite angle is.
        """
        mine, other = self.sides(lead)
        i1, i2, i3, i4 = _from(lead)
        value = mine.at(angle)
        across = other.phase + side * other.from_phase(value)
        out = np.empty((len(angle), 4))
        out[:, i1], out[:, i3] = angle, across
        if self.points is None:
            z1, z2, z3, z4 = self.axes[[i1, i2, i3, i4]]
            out[:, i2] = _angle_about(z2, _rotated(z3, across, z4), _rotated(z1, -angle, z4))
            out[:, i4] = _angle_about(z4, _rotated(z1, angle, z2), _rotated(z3, -across, z2))
        else:
            p1, p2, p3, p4 = self.points[[i1, i2, i3, i4]]
            s1, s2, s3, s4 = self.senses[[i1, i2, i3, i4]]
            ends = p1 + np.exp(-1j * s1 * angle) * (p4 - p1) - p2
            starts = p3 + np.exp(1j * s3 * across) * (p4 - p3) - p2
            out[:, i2] = s2 * np.angle(ends * np.conj(starts))
            out[:, i4] = -s4 * (s1 * angle + s2 * out[:, i2] + s3 * across)
        reached = np.abs(value - other.middle) <= other.size * (1 + 1e-14)
        return out, reached

    def range(self, lead: int) -> tuple[float, float] | None:
        """Return where (rad, from the solution) the leading angle can go on the solution's own piece of the curve.

        A whole turn where the linkage lets it go round. None where the pieces touch: there curves cross.
        """
        mine, other = self.sides(lead)
        if min(mine.size, other.size) < LOOP_CRITICAL:
            return None
        # cosines of the angle's distance from its phase at the two ends of what the opposite angle can do
        top = (other.middle + other.size - mine.middle) / mine.size
        bottom = (other.middle - other.size - mine.middle) / mine.size
        if min(abs(top - 1), abs(top + 1), abs(bottom - 1), abs(bottom + 1)) < LOOP_CRITICAL:
            return None
        least = np.arccos(top) if top < 1 else 0.0
        most = np.arccos(bottom) if bottom > -1 else np.pi
        if least == 0.0 and most == np.pi:
            return mine.phase - np.pi, mine.phase + np.pi
        if least == 0.0:
            return mine.phase - most, mine.phase + most
        if most == np.pi:
            return mine.phase + least, mine.phase + 2 * np.pi - least
        sign = 1.0 if float(short_way(-mine.phase)) > 0 else -1.0
        ends = sorted((mine.phase + sign * least, mine.phase + sign * most))
        return ends[0], ends[1]


def _from(lead: int) -> tuple[int, int, int, int]:
    return lead, (lead + 1) % 4, (lead + 2) % 4, (lead + 3) % 4


def _rotated(axis: Array, angle: Array, v: Array) -> Array:
    """Return v (3,) turned about a unit axis (3,) by angles (k,), (k, 3)."""
    along = axis * (axis @ v)
    return along + np.cos(angle)[:, None] * (v - along) + np.sin(angle)[:, None] * np.cross(axis, v)


def _angle_about(axis: Array, start: Array, end: Array) -> Array:
    """Return the angles (k,) about an axis (3,) that turn start (k, 3) to end (k, 3)."""
    return np.arctan2(np.cross(start, end) @ axis, np.sum(start * end, -1) - (start @ axis) * (end @ axis))


def line_gap(z: Array, o: Array, i: int, j: int, length: float) -> float:
    """Return by how much two axes miss being one line (rad and lengths, added up)."""
    return float(np.linalg.norm(np.cross(z[i], z[j])) + np.linalg.norm(np.cross(o[j] - o[i], z[i])) / length)


def four_bar(chain: Chain, z: Array, o: Array, null: Array) -> tuple[FourBar, float] | None:
    """Return the four-bar that a null direction (n,) of the Jacobian moves, and by how much its axes miss being one.

    None where the direction moves other than turning joints, or more than four of them.

    Args:
        chain: The arm.
        z: Unit axes (n, 3) at the solution.
        o: A point on each, (n, 3).
        null: The joint direction without units that the pose feels least.
    """
    size = np.abs(null)
    order = np.argsort(-size)
    moving = np.sort(order[:4])
    if size[order[4:]].max(initial=0.0) > LOOP_MOVES or chain.prismatic[moving].any():
        return None
    if size[order[3]] > LOOP_MOVES:
        return _closed_by(chain, z, o, moving)
    # one of the four may stand still for a moment, where it turns back
    three = order[:3]
    others = [j for j in np.flatnonzero(~chain.prismatic) if j not in three]
    found = [_closed_by(chain, z, o, np.sort(np.append(three, j))) for j in others]
    return min(found, key=lambda pair: pair[1], default=None)


def _closed_by(chain: Chain, z: Array, o: Array, joints: Indices) -> tuple[FourBar, float]:
    """Return four joints as a linkage, and by how much (rad and lengths, added up) their axes miss being one."""
    axes, points = z[joints], o[joints] / chain.length
    n = axes[0]
    tilt = float(np.linalg.norm(np.cross(axes, n), axis=1).max())
    across = np.eye(3) - axes[:, :, None] * axes[:, None, :]
    feet = np.einsum("kij,kj->i", across, points)
    point = np.asarray(np.linalg.lstsq(across.sum(0), feet, rcond=None)[0], np.float64)
    apart = float(np.linalg.norm(np.cross(points - point, axes), axis=1).max())
    if tilt > apart:
        return FourBar(joints, axes, None, np.ones(4)), apart
    x = np.cross(n, np.eye(3)[np.argmin(np.abs(n))])
    x /= np.linalg.norm(x)
    y = np.cross(n, x)
    flat = (points - points[0]) @ x + 1j * ((points - points[0]) @ y)
    return FourBar(joints, axes, flat, np.sign(axes @ n)), tilt
