"""Poses as people say them: a position and an orientation in one of the usual notations."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from pieper.errors import InputError
from pieper.kinematics.pose import checked_pose, rotation_about

_TURNS = {"rpy": (2, 1, 0), "wpr": (2, 1, 0), "abc": (2, 1, 0), "zyz": (2, 1, 2)}


def pose(
    x: npt.ArrayLike,
    y: npt.ArrayLike,
    z: npt.ArrayLike,
    *,
    degrees: bool = False,
    mm: bool = False,
    **orientation: npt.ArrayLike,
) -> npt.NDArray[np.float64]:
    """Return poses (..., 4, 4), m, from positions (...) and at most one orientation (..., 3 or 4)."""
    if len(orientation) > 1:
        raise InputError(f"say one orientation, not {' and '.join(orientation)}.", given=tuple(orientation))
    p = np.stack(np.broadcast_arrays(x, y, z), -1) * (1e-3 if mm else 1.0)
    T = np.zeros((*p.shape[:-1], 4, 4))
    T[..., :3, 3], T[..., 3, 3] = p, 1.0
    T[..., :3, :3] = np.eye(3)
    for name, value in orientation.items():
        unit = math.pi / 180 if degrees and not name.startswith("quat") and name != "R" else 1.0
        T[..., :3, :3] = _rotation(name, np.asarray(value, float) * unit)
    return checked_pose(T, "pose", batch=True)


def _rotation(name: str, v: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    if name == "R":
        return v
    if name in _TURNS:
        angles = v[..., ::-1] if name in ("rpy", "wpr") else v
        a, b, c = (_about(axis, angles[..., i]) for i, axis in enumerate(_TURNS[name]))
        return a @ b @ c
    if name == "rotvec":
        angle = np.linalg.norm(v, axis=-1)
        axis = np.where(angle[..., None] > 0, v, [0.0, 0.0, 1.0]) / np.where(angle > 0, angle, 1.0)[..., None]
        return rotation_about(axis, angle)
    w, x, y, z = np.moveaxis(v if name == "quat_wxyz" else np.roll(v, 1, axis=-1), -1, 0)
    length = np.sqrt(w * w + x * x + y * y + z * z)
    if np.any(np.abs(length - 1) > 1e-3):
        raise InputError(f"a rotation needs a quaternion of length 1, this one has length {np.max(length):.6g}.")
    w, x, y, z = w / length, x / length, y / length, z / length
    return np.stack(
        [
            np.stack([1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)], -1),
            np.stack([2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)], -1),
            np.stack([2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)], -1),
        ],
        -2,
    )


def _about(axis: int, angle: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    quarter = np.round(angle / (math.pi / 2))
    exact = (angle == quarter * (math.pi / 2)) & (np.abs(quarter) < 64)
    c = np.where(exact, np.array([1.0, 0.0, -1.0, 0.0])[quarter.astype(int) % 4], np.cos(angle))
    s = np.where(exact, np.array([0.0, 1.0, 0.0, -1.0])[quarter.astype(int) % 4], np.sin(angle))
    R = np.zeros((*angle.shape, 3, 3))
    i, j = (axis + 1) % 3, (axis + 2) % 3
    R[..., axis, axis] = 1.0
    R[..., i, i], R[..., j, j], R[..., i, j], R[..., j, i] = c, c, -s, s
    return R


def read_pose(T: npt.ArrayLike, kind: str, degrees: bool = False, mm: bool = False) -> tuple[float, ...]:
    """Return a pose (4, 4) as x, y, z and the numbers of a notation."""
    from pieper.kinematics.orientation import rpy_of

    T = checked_pose(T, "T")
    if kind not in ("rpy", "wpr"):
        raise InputError(f"{kind!r} is unknown.", given=kind)
    p = T[:3, 3] * (1e3 if mm else 1.0)
    angles = np.array(rpy_of(T[:3, :3])) * (180 / math.pi if degrees else 1.0)
    return (*(float(v) for v in p), *(float(v) for v in angles))
