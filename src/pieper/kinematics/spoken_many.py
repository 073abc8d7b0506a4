"""Many poses as people say them: positions and orientations as tables of numbers, turned into matrices at once."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from pieper import arguments
from pieper.errors import InputError
from pieper.kinematics.orientation import QUATERNION_SLACK
from pieper.kinematics.pose import checked_pose, rotation_about
from pieper.kinematics.spoken import SPOKEN, notation_called

#: Notations that are three turns about axes: the axes, in the order of the matrices' product, and of the numbers.
_TURNS = {
    "rpy": ((2, 1, 0), (2, 1, 0)),
    "wpr": ((2, 1, 0), (2, 1, 0)),
    "yaskawa": ((2, 1, 0), (2, 1, 0)),
    "abc": ((2, 1, 0), (0, 1, 2)),
    "zyz": ((2, 1, 2), (0, 1, 2)),
    "staubli": ((0, 1, 2), (0, 1, 2)),
}

Floats = npt.NDArray[np.float64]


def poses(
    position: npt.ArrayLike,
    notation: str | None = None,
    numbers: npt.ArrayLike | None = None,
    *,
    degrees: bool = False,
    mm: bool = False,
) -> Floats:
    """Return poses (..., 4, 4), m, said as positions and orientations; `pose` is for one.

    Args:
        position: (..., 3), m, or mm where `mm`.
        notation: What the numbers mean, a keyword of `pose` such as "rpy", "quat_wxyz" or "R"; None for R = I.
        numbers: (..., 3) angles, (..., 4) quaternions or (..., 3, 3) rotations.
        degrees: Angles are in degrees, not rad.
        mm: Positions are in millimetres, not m.

    Raises:
        InputError: An unknown notation, a wrong shape, numbers that are not finite, no rotation.
    """
    p = arguments.numbers(position, "positions") * (0.001 if arguments.flag(mm, "mm") else 1.0)
    if p.shape[-1:] != (3,):
        raise InputError(f"positions must be (..., 3), got {p.shape}.", given=p.shape)
    T = np.zeros((*p.shape[:-1], 4, 4))
    T[..., :3, 3], T[..., 3, 3] = p, 1.0
    T[..., :3, :3] = np.eye(3) if notation is None else _rotations(notation, numbers, degrees, p.shape[:-1])
    return checked_pose(T, "the pose", batch=True)


def _rotations(notation: str, numbers: npt.ArrayLike | None, degrees: bool, leading: tuple[int, ...]) -> Floats:
    name, v = notation_called(notation), arguments.numbers(numbers, notation)
    shape = (3, 3) if name == "R" else (SPOKEN[name][0],)
    if v.shape[-len(shape) :] != shape:
        raise InputError(f"{notation} must be (..., {', '.join(map(str, shape))}), got {v.shape}.", given=v.shape)
    if v.shape[: -len(shape)] not in ((), leading):
        raise InputError(
            f"{notation} must be one for all positions or one a position, {leading}, got {v.shape[: -len(shape)]}.",
            given=v.shape,
        )
    if not np.isfinite(v).all():
        raise InputError(f"{notation} must be finite numbers.", given=notation)
    if name == "R":
        return v
    if arguments.flag(degrees, "degrees") and SPOKEN[name][1]:
        v = v * (math.pi / 180)
    if name in _TURNS:
        axes, places = _TURNS[name]
        a, b, c = (_about(axis, v[..., place]) for axis, place in zip(axes, places, strict=True))
        return a @ b @ c
    if name == "rotvec":
        angle = np.linalg.norm(v, axis=-1)
        axis = np.where(angle[..., None] > 0, v, [0.0, 0.0, 1.0]) / np.where(angle > 0, angle, 1.0)[..., None]
        return rotation_about(axis, angle)
    return _of_quaternions(v if name == "quat_wxyz" else np.roll(v, 1, axis=-1))


def _of_quaternions(q: Floats) -> Floats:
    length = np.linalg.norm(q, axis=-1, keepdims=True)
    off = np.abs(length - 1.0)
    if np.any(off > QUATERNION_SLACK):
        worst = float(length.ravel()[np.argmax(off)])
        raise InputError(f"a rotation needs a quaternion of length 1, one has length {worst:.6g}.", given=worst)
    w, x, y, z = np.moveaxis(q / length, -1, 0)
    rows = (
        (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
    )
    return np.stack([np.stack(row, -1) for row in rows], -2)


def _about(axis: int, angle: Floats) -> Floats:
    """Return turns (..., 3, 3) about x, y or z; quarter turns are exact."""
    quarter = np.round(angle / (math.pi / 2))
    exact = (angle == quarter * (math.pi / 2)) & (np.abs(quarter) < 64)
    which = np.where(exact, quarter, 0).astype(int) % 4
    c = np.where(exact, np.array([1.0, 0.0, -1.0, 0.0])[which], np.cos(angle))
    s = np.where(exact, np.array([0.0, 1.0, 0.0, -1.0])[which], np.sin(angle))
    R = np.zeros((*angle.shape, 3, 3))
    i, j = (axis + 1) % 3, (axis + 2) % 3
    R[..., axis, axis] = 1.0
    R[..., i, i], R[..., j, j], R[..., i, j], R[..., j, i] = c, c, -s, s
    return R
