"""Rotations as numbers: what each notation means, and the numbers of a rotation in it."""

from __future__ import annotations

import math
import sys

import numpy as np
import numpy.typing as npt

from pieper.tolerances import QUATERNION_SLACK, ROLL_IS_YAW, ROUNDING

#: notation -> (how many numbers, what they are)
NOTATIONS = {
    "rpy": (3, "roll, pitch, yaw about the fixed x, y, z: R = Rz(yaw) Ry(pitch) Rx(roll)"),
    "zyx": (3, "the angles A, B, C of KUKA: R = Rz(A) Ry(B) Rx(C)"),
    "zyz": (3, "Euler angles: R = Rz(a) Ry(b) Rz(c)"),
    "rotation_vector": (3, "axis times angle"),
    "quaternion_wxyz": (4, "unit quaternion, scalar first"),
    "quaternion_xyzw": (4, "unit quaternion, scalar last"),
}
ANGLE_NOTATIONS = ("rpy", "zyx", "zyz", "rotation_vector")


def rotation(notation: str, numbers: list[float]) -> np.ndarray:
    """Return the rotation (3, 3) that the numbers of a notation mean.

    Quarter turns give exact zeros and ones.

    Args:
        notation: A key of `NOTATIONS`.
        numbers: Angles in rad, or a quaternion.

    Raises:
        ValueError: The quaternion is not of unit length.
    """
    if notation == "rpy":
        return rotation("zyx", numbers[::-1])
    if notation in ("zyx", "zyz", "xyz"):
        first, second, third = (_about("xyz".index(axis), x) for axis, x in zip(notation, numbers, strict=True))
        return first @ second @ third
    if notation == "rotation_vector":
        return _of_vector(np.array(numbers, float))
    w, x, y, z = numbers if notation == "quaternion_wxyz" else (numbers[3], *numbers[:3])
    length = math.sqrt(w * w + x * x + y * y + z * z)
    if not abs(length - 1) <= QUATERNION_SLACK:
        raise ValueError(f"a rotation needs a quaternion of length 1, this one has length {length:.6g}")
    w, x, y, z = w / length, x / length, y / length, z / length
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def rpy_of(R: npt.NDArray[np.float64]) -> tuple[float, float, float]:
    """Return roll, pitch, yaw (rad) of a rotation; roll is zero where pitch is a quarter turn."""
    across = math.hypot(R[0, 0], R[1, 0])
    pitch = math.atan2(-R[2, 0], across)
    if across < ROLL_IS_YAW:
        return 0.0, pitch, math.atan2(-R[0, 1], R[1, 1])
    yaw = math.atan2(R[1, 0], R[0, 0])
    # close to the pole yaw is known to a rounding over `across`: a quarter turn within that is what was meant
    quarters = round(yaw / (math.pi / 2)) * (math.pi / 2)
    if abs(yaw - quarters) * across < 4 * sys.float_info.epsilon:
        yaw = quarters
    # what is left of R behind the yaw that was found, so that the three agree however close the pole is
    c, s = math.cos(yaw), math.sin(yaw)
    return math.atan2(s * R[0, 2] - c * R[1, 2], c * R[1, 1] - s * R[0, 1]), pitch, yaw


def zyz_of(R: npt.NDArray[np.float64]) -> tuple[float, float, float]:
    """Return a, b, c (rad) with R = Rz(a) Ry(b) Rz(c), b in [0, pi]; a is zero where b is 0 or a half turn."""
    across = math.hypot(R[0, 2], R[1, 2])
    b = math.atan2(across, R[2, 2])
    if across < ROLL_IS_YAW:
        return 0.0, b, math.atan2(R[1, 0], R[1, 1])
    a = math.atan2(R[1, 2], R[0, 2])
    c, s = math.cos(a), math.sin(a)
    return a, b, math.atan2(c * R[1, 0] - s * R[0, 0], c * R[1, 1] - s * R[0, 1])


def xyz_of(R: npt.NDArray[np.float64]) -> tuple[float, float, float]:
    """Return x, y, z (rad) with R = Rx(x) Ry(y) Rz(z); x is zero where y is a quarter turn."""
    # the transpose is Rz(-z) Ry(-y) Rx(-x)
    x, y, z = rpy_of(R.T)
    return 0.0 - x, 0.0 - y, 0.0 - z


def quaternion_of(R: npt.NDArray[np.float64]) -> tuple[float, float, float, float]:
    """Return w, x, y, z of a rotation, w >= 0; of two opposite ones with w = 0 the first other number is positive."""
    trace = float(np.trace(R))
    # the largest of the four squares loses no digits
    squares = [trace, *(2 * float(R[i, i]) - trace for i in range(3))]
    largest = int(np.argmax(squares))
    if largest == 0:
        q = np.array([1 + trace, R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    else:
        i = largest - 1
        j, k = (i + 1) % 3, (i + 2) % 3
        q = np.empty(4)
        q[0] = R[k, j] - R[j, k]
        q[1 + i] = 1 + R[i, i] - R[j, j] - R[k, k]
        q[1 + j] = R[j, i] + R[i, j]
        q[1 + k] = R[k, i] + R[i, k]
    q = q / np.linalg.norm(q)
    first = next(value for value in q if abs(value) > ROUNDING)
    w, x, y, z = (float(value) + 0.0 for value in (q if first > 0 else -q))
    return w, x, y, z


def cos_sin(angle: float) -> tuple[float, float]:
    """Return cosine and sine of an angle (rad), exact where the angle is the double of a multiple of pi/2."""
    quarter = round(angle / (math.pi / 2))
    if abs(quarter) < 64 and angle == quarter * (math.pi / 2):
        return ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[quarter % 4]
    return math.cos(angle), math.sin(angle)


def _about(axis: int, angle: float) -> np.ndarray:
    c, s = cos_sin(angle)
    R = np.eye(3)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    R[i, i] = R[j, j] = c
    R[i, j], R[j, i] = -s, s
    return R


def _of_vector(vector: np.ndarray) -> np.ndarray:
    angle = float(np.linalg.norm(vector))
    if angle == 0.0:
        return np.eye(3)
    x, y, z = vector / angle
    c, s = cos_sin(angle)
    K = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.eye(3) + s * K + (1 - c) * (K @ K)
