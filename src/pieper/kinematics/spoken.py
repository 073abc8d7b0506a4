"""Poses as people say them: a position and an orientation in one of the usual notations."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from pieper.errors import InputError
from pieper.kinematics.pose import checked_pose

_OLD = {"abc": "zyx", "quat_wxyz": "quaternion_wxyz", "quat_xyzw": "quaternion_xyzw", "rotvec": "rotation_vector"}


def pose(
    x: float, y: float, z: float, *, degrees: bool = False, mm: bool = False, **orientation: npt.ArrayLike
) -> npt.NDArray[np.float64]:
    """Return a pose (4, 4), m, from a position and at most one orientation."""
    from pieper.description.orientation import rotation

    if len(orientation) > 1:
        raise InputError(f"say one orientation, not {' and '.join(orientation)}.", given=tuple(orientation))
    T = np.eye(4)
    T[:3, 3] = np.array([x, y, z], float) * (1e-3 if mm else 1.0)
    for name, value in orientation.items():
        if name == "R":
            T[:3, :3] = value
            continue
        unit = math.pi / 180 if degrees and not name.startswith("quat") else 1.0
        numbers = [float(v) * unit for v in np.asarray(value, float)]
        try:
            T[:3, :3] = rotation("rpy" if name == "wpr" else _OLD.get(name, name), numbers)
        except ValueError as error:
            raise InputError(f"{error}.", given=value) from None
    return checked_pose(T, "pose")


def read_pose(T: npt.ArrayLike, kind: str, degrees: bool = False, mm: bool = False) -> tuple[float, ...]:
    """Return a pose (4, 4) as x, y, z and the numbers of a notation."""
    from pieper.description.orientation import rpy_of

    T = checked_pose(T, "T")
    if kind not in ("rpy", "wpr"):
        raise InputError(f"{kind!r} is unknown.", given=kind)
    p = T[:3, 3] * (1e3 if mm else 1.0)
    angles = np.array(rpy_of(T[:3, :3])) * (180 / math.pi if degrees else 1.0)
    return (*(float(v) for v in p), *(float(v) for v in angles))
