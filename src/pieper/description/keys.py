"""Quantities and poses as the keys of a table: the unit in the key, the one people choose where that is exact."""

from __future__ import annotations

import math

import numpy as np

from pieper.description.quantity import best_unit, in_unit
from pieper.kinematics.orientation import rotation, rpy_of

#: Which keys of a pose table belong together; any of them changing changes them all.
POSE_STEMS = ("xyz", "rpy", "zyx", "zyz", "rotation_vector", "quaternion", "matrix")


def quantity_key(stem: str, values: list[float], kind: str, *, single: bool = False) -> dict:
    """Return {key: value} of one quantity (SI values) in the unit people choose, or in SI where only that is exact."""
    unit = best_unit(values, kind)
    said = [in_unit(value, unit) for value in values]
    return {f"{stem}_{unit}": said[0] if single else said}


def pose_keys(T: np.ndarray, *, unsaid: str = "identity") -> dict:
    """Return the keys of a pose: xyz and rpy where those are exact, else the matrix.

    Args:
        T: (4, 4), m; NaN where nothing is known.
        unsaid: What a key that is not there means to the reader: "identity" or "unknown".
    """
    T = np.asarray(T, float)
    R, p = T[:3, :3], T[:3, 3]
    position = {} if unsaid == "identity" and same_matrix(p, np.zeros(3)) else quantity_key("xyz", p.tolist(), "length")
    if unsaid == "unknown" and np.isnan(R).all():
        return position
    if np.isfinite(T).all() and (angles := _short_rpy(R)) is not None:
        return position if unsaid == "identity" and angles == [0, 0, 0] else position | {"rpy_deg": angles}
    return {"matrix_m": [[in_unit(float(value), "m") for value in row] for row in T]}


def _short_rpy(R: np.ndarray) -> list[float | int] | None:
    """Return roll, pitch, yaw in degrees of at most six decimals that mean exactly this rotation, or None."""
    degrees = [round(math.degrees(angle), 6) + 0.0 for angle in rpy_of(R)]
    if not same_matrix(rotation("rpy", [math.radians(angle) for angle in degrees]), R):
        return None
    return [int(angle) if angle == int(angle) else angle for angle in degrees]


def same_matrix(A: np.ndarray, B: np.ndarray) -> bool:
    """Return whether two arrays hold the same doubles; NaN equals NaN, 0.0 equals -0.0."""
    return bool(np.array_equal(A, B, equal_nan=True))
