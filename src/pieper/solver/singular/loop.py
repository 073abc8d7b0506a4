"""Joints that move by themselves, read off the axes: two in one line, or four that are parallel or meet in a point.

The twists of these joints at a solution close on themselves, exp(x1 d1) exp(x2 d2) ... = 1, and go on doing so over a
finite motion: two axes in one line turn against each other; four parallel ones are a planar four-bar linkage, four
through a point a spherical one. A four-bar is a scalar equation between the angle that leads and the one opposite,
each side a constant and one harmonic, so that every joint may lead. The kernel finds them (kernels/singular/).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper.kinematics.arrays import Array, Bools, Indices
from pieper.tolerances import DEAD_CENTRE


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
        value = mine.at(angle)
        reached = np.abs(value - other.middle) <= other.size * (1 + DEAD_CENTRE)
        return self.closed(lead, angle, other.phase + side * other.from_phase(value)), reached

    def closed(self, lead: int, angle: Array, across: Array) -> Array:
        """Return the four angles (k, 4) that those of the leading joint and of the one opposite (k,) leave."""
        i1, i2, i3, i4 = _from(lead)
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
        return out


def _from(lead: int) -> tuple[int, int, int, int]:
    return lead, (lead + 1) % 4, (lead + 2) % 4, (lead + 3) % 4


def _rotated(axis: Array, angle: Array, v: Array) -> Array:
    """Return v (3,) turned about a unit axis (3,) by angles (k,), (k, 3)."""
    along = axis * (axis @ v)
    return along + np.cos(angle)[:, None] * (v - along) + np.sin(angle)[:, None] * np.cross(axis, v)


def _angle_about(axis: Array, start: Array, end: Array) -> Array:
    """Return the angles (k,) about an axis (3,) that turn start (k, 3) to end (k, 3)."""
    return np.arctan2(np.cross(start, end) @ axis, np.sum(start * end, -1) - (start @ axis) * (end @ axis))
