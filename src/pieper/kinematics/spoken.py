"""Poses as people say them: a position and an orientation in the words of the field and of the makers."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt
from numpy.typing import ArrayLike

from pieper import arguments
from pieper.errors import InputError
from pieper.kinematics.meant import remark_turned
from pieper.kinematics.orientation import quaternion_of, rotation, rpy_of, xyz_of, zyz_of
from pieper.kinematics.pose import PoseLike, checked_pose, rotation_vector, transform

#: How an orientation may be said -> (how many numbers, whether they are angles, what they mean)
SPOKEN = {
    "rpy": (3, True, "roll, pitch, yaw about the fixed x, y, z: R = Rz(yaw) Ry(pitch) Rx(roll)"),
    "zyz": (3, True, "Euler angles a, b, c: R = Rz(a) Ry(b) Rz(c)"),
    "abc": (3, True, "A, B, C as KUKA: R = Rz(A) Ry(B) Rx(C)"),
    "wpr": (3, True, "W, P, R as Fanuc: R = Rz(R) Ry(P) Rx(W)"),
    "quat_wxyz": (4, False, "unit quaternion, scalar first, as ABB's q1, q2, q3, q4"),
    "quat_xyzw": (4, False, "unit quaternion, scalar last, as ROS"),
    "rotvec": (3, True, "rotation vector, axis times angle, as UR's rx, ry, rz"),
    "staubli": (3, True, "Rx, Ry, Rz as Staubli: R = Rx(Rx) Ry(Ry) Rz(Rz)"),
    "yaskawa": (3, True, "Rx, Ry, Rz as Yaskawa: R = Rz(Rz) Ry(Ry) Rx(Rx)"),
    "R": (9, False, "rotation matrix (3, 3); row by row where it is read"),
}
#: Makers by name -> how they say an orientation.
MAKERS = {"kuka": "abc", "fanuc": "wpr", "ur": "rotvec", "abb": "quat_wxyz"}


def pose(
    x: float = 0.0,
    y: float = 0.0,
    z: float = 0.0,
    *,
    rpy: Sequence[float] | None = None,
    zyz: Sequence[float] | None = None,
    abc: Sequence[float] | None = None,
    wpr: Sequence[float] | None = None,
    quat_wxyz: Sequence[float] | None = None,
    quat_xyzw: Sequence[float] | None = None,
    rotvec: Sequence[float] | None = None,
    staubli: Sequence[float] | None = None,
    yaskawa: Sequence[float] | None = None,
    kuka: Sequence[float] | None = None,
    fanuc: Sequence[float] | None = None,
    ur: Sequence[float] | None = None,
    abb: Sequence[float] | None = None,
    R: ArrayLike | None = None,
    degrees: bool = False,
    mm: bool = False,
) -> npt.NDArray[np.float64]:
    """Return a pose (4, 4), m, said as a position and at most one orientation.

    Args:
        x: Position, m, or mm where `mm`.
        y: The same.
        z: The same.
        rpy: Roll, pitch, yaw about the fixed x, y, z: R = Rz(yaw) Ry(pitch) Rx(roll).
        zyz: Euler angles: R = Rz(a) Ry(b) Rz(c).
        abc: KUKA's A, B, C: R = Rz(A) Ry(B) Rx(C).
        wpr: Fanuc's W, P, R: R = Rz(R) Ry(P) Rx(W), the numbers of rpy.
        quat_wxyz: Unit quaternion, scalar first (ABB); its length may be off by 1e-3 and is made 1.
        quat_xyzw: Unit quaternion, scalar last (ROS); the same.
        rotvec: Rotation vector, axis times angle (UR).
        staubli: Staubli's Rx, Ry, Rz: R = Rx(Rx) Ry(Ry) Rz(Rz).
        yaskawa: Yaskawa's Rx, Ry, Rz: R = Rz(Rz) Ry(Ry) Rx(Rx), the numbers of rpy.
        kuka: Another name of abc.
        fanuc: Another name of wpr.
        ur: Another name of rotvec.
        abb: Another name of quat_wxyz.
        R: Rotation matrix (3, 3).
        degrees: Angles are in degrees, not rad.
        mm: The position is in millimetres, not m.

    Raises:
        InputError: Two orientations, not the right count of finite numbers, or no rotation.
    """
    said = {
        "rpy": rpy,
        "zyz": zyz,
        "abc": abc,
        "wpr": wpr,
        "quat_wxyz": quat_wxyz,
        "quat_xyzw": quat_xyzw,
        "rotvec": rotvec,
        "staubli": staubli,
        "yaskawa": yaskawa,
        "kuka": kuka,
        "fanuc": fanuc,
        "ur": ur,
        "abb": abb,
        "R": R,
    }
    given = [key for key, value in said.items() if value is not None]
    if len(given) > 1:
        raise InputError(f"{' and '.join(given)} say the orientation twice; keep one.", given=given)
    position = _finite([x, y, z], 3, "x, y, z") * (0.001 if arguments.flag(mm, "mm") else 1.0)
    matrix = np.eye(3) if not given else _spoken(given[0], said[given[0]], degrees)
    return checked_pose(transform(matrix, position), "the pose")


def read_pose(T: PoseLike, notation: str = "rpy", *, degrees: bool = False, mm: bool = False) -> tuple[float, ...]:
    """Return x, y, z and the numbers of an orientation: what `pose` makes the same pose of.

    Where an orientation has several names (roll and yaw about one axis), one of its angles is zero.

    Args:
        T: (4, 4), m, or another library's pose.
        notation: One of `SPOKEN`, such as "rpy", or a maker: "kuka", "fanuc", "ur", "abb", "staubli", "yaskawa".
        degrees: Give angles in degrees.
        mm: Give the position in millimetres.

    Raises:
        InputError: T is not a pose, or the notation is unknown.
    """
    name = notation_called(notation)
    M = checked_pose(T)
    numbers = _read(name, M[:3, :3])
    if arguments.flag(degrees, "degrees") and SPOKEN[name][1]:
        numbers = tuple(math.degrees(value) for value in numbers)
    scale = 1e3 if arguments.flag(mm, "mm") else 1.0
    return (*(float(value) * scale for value in M[:3, 3]), *numbers)


def _spoken(name: str, value: object, degrees: bool) -> npt.NDArray[np.float64]:
    name = MAKERS.get(name, name)
    count, angles, _ = SPOKEN[name]
    if name == "R":
        matrix = arguments.numbers(value, "R")
        if matrix.shape != (3, 3):
            raise InputError(f"R must be (3, 3), got {matrix.shape}.", given=matrix.shape)
        return matrix
    numbers = _finite(value, count, name)
    if arguments.flag(degrees, "degrees") and angles:
        # one number at a time, as math.radians does it: quarter turns stay exact
        numbers = np.array([math.radians(number) for number in numbers])
    elif angles:
        remark_turned(numbers, name, "numpy.radians(...) or degrees=True")
    kind = {
        "abc": "zyx",
        "wpr": "rpy",
        "yaskawa": "rpy",
        "staubli": "xyz",
        "rotvec": "rotation_vector",
        "quat_wxyz": "quaternion_wxyz",
        "quat_xyzw": "quaternion_xyzw",
    }.get(name, name)
    try:
        return rotation(kind, numbers.tolist())
    except InputError:
        raise
    except ValueError as error:
        raise InputError(f"{name}: {error}; a length off by up to 1e-3 is made 1.", given=numbers) from None


def _read(name: str, R: npt.NDArray[np.float64]) -> tuple[float, ...]:
    if name in ("rpy", "wpr", "yaskawa"):
        return rpy_of(R)
    if name == "abc":
        return rpy_of(R)[::-1]
    if name == "zyz":
        return zyz_of(R)
    if name == "staubli":
        return xyz_of(R)
    if name == "rotvec":
        return tuple(float(value) for value in rotation_vector(R))
    if name == "R":
        return tuple(float(value) for value in R.ravel())
    w, x, y, z = quaternion_of(R)
    return (w, x, y, z) if name == "quat_wxyz" else (x, y, z, w)


def _finite(value: object, count: int, what: str) -> npt.NDArray[np.float64]:
    wanted = f"{count} finite numbers"
    numbers = arguments.numbers(value, what, wanted)
    if numbers.shape != (count,) or not np.isfinite(numbers).all():
        raise InputError(f"{what} must be {wanted}, got {value!r}.", given=value, allowed=wanted)
    return numbers


def notation_called(name: str) -> str:
    """Return the notation of `SPOKEN` that a name of it, or a maker's, stands for.

    Raises:
        InputError: It stands for none.
    """
    said = arguments.word(name, "notation", (*SPOKEN, *MAKERS))
    return MAKERS.get(said, said)
