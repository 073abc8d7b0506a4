"""Orientations that were made of radians as if they were degrees: 57 times less turned than they are."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.kinematics.joints import wrapped
from pieper.kinematics.orientation import rotation, rpy_of, zyz_of
from pieper.kinematics.pose import rotation_vector

#: Three angles of half a turn each, in radians taken for degrees, turn by no more than this (rad).
MOST_TURNED = 3 * np.pi * np.pi / 180


def as_degrees(R: Array) -> list[Array]:
    """Return rotations (N, 3, 3) with the angles of each notation taken back to degrees; none of turns that are large.

    Roll, pitch, yaw and the A, B, C of KUKA are the same three angles in two orders.
    """
    vectors = rotation_vector(R)
    if not len(R) or float(np.linalg.norm(vectors, axis=1).max()) > MOST_TURNED:
        return []
    told = {
        "rpy": [rpy_of(r) for r in R],
        "zyz": [_zyz_near_none(r) for r in R],
        "rotation_vector": vectors.tolist(),
    }
    return [
        np.array([rotation(notation, np.degrees(angles).tolist()) for angles in numbers])
        for notation, numbers in told.items()
    ]


def _zyz_near_none(R: Array) -> tuple[float, float, float]:
    """Return the three Euler angles (rad) of a rotation, of two readings the one whose first angle is small."""
    a, b, c = zyz_of(R)
    if abs(a) <= np.pi / 2:
        return a, b, c
    half = float(np.copysign(np.pi, a))
    return a - half, -b, float(wrapped(c - half))
