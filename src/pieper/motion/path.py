"""Straight lines between poses: constant speed in position, one constant axis in orientation."""

from __future__ import annotations

import operator

import numpy as np

from pieper import arguments
from pieper.errors import InputError
from pieper.kinematics.arrays import Array, ArrayLike
from pieper.kinematics.pose import PoseLike, as_pose, checked_pose, rotation_about, rotation_vector
from pieper.tolerances import HALF_TURN_MARGIN


def line(T0: PoseLike, T1: PoseLike, n: int = 50) -> Array:
    """Return n poses on the straight line from T0 to T1.

    The position moves with constant speed; the orientation turns with constant speed about one axis that is fixed in
    the base and in the tool, by the shorter way. At exactly half a turn both ways are equally short: the tool then
    turns positively about the axis (seen from the tool at T0) whose largest component is positive. The first and the
    last pose are T0 and T1 themselves, and equal orientations stay equal to the last bit.

    A line of zero length is allowed: the tool turns on the spot, or rests when the orientations agree too.

    Args:
        T0: (4, 4) first pose, m.
        T1: (4, 4) last pose, m.
        n: Number of poses, at least 2, both ends included.

    Returns:
        (n, 4, 4) poses, m.

    Raises:
        InputError: T0 or T1 is not a pose, or n is not a whole number of at least 2.
    """
    first, last = checked_pose(T0, "T0"), checked_pose(T1, "T1")
    try:
        n = operator.index(n)
    except TypeError:
        raise InputError(
            f"n, the number of poses on the line, must be a whole number, got {arguments.kind_of(n)}.", given=n
        ) from None
    if n < 2:
        raise InputError(f"a line needs at least 2 poses, its two ends; got n = {n}.", given=n)
    return between(first, last, np.linspace(0.0, 1.0, n))


def between(T0: Array, T1: Array, s: ArrayLike) -> Array:
    """Return the poses at s on the straight line from T0 (s = 0) to T1 (s = 1).

    Args:
        T0: (4, 4) first pose, m; not checked.
        T1: (4, 4) last pose, m; not checked.
        s: (...) path parameter in [0, 1].

    Returns:
        (..., 4, 4) poses, m.
    """
    s = np.asarray(s, float)
    T = np.zeros((*s.shape, 4, 4))
    T[..., 3, 3] = 1.0
    T[..., :3, 3] = T0[:3, 3] + s[..., None] * (T1[:3, 3] - T0[:3, 3])
    turn = shortest_turn(T0[:3, :3], T1[:3, :3])
    angle = float(np.linalg.norm(turn))
    if angle == 0.0:
        T[..., :3, :3] = T0[:3, :3]
    else:
        T[..., :3, :3] = T0[:3, :3] @ rotation_about(turn / angle, s * angle)
    T[s == 1.0] = T1
    return T


def shortest_turn(R0: Array, R1: Array) -> Array:
    """Return the rotation vectors (..., 3), rad, in the axes of R0 (..., 3, 3), that turn it into R1 the shorter way.

    Equal matrices give exactly zero. Within `HALF_TURN_MARGIN` of half a turn the rounding of the matrices would choose
    the sign of the axis, so its largest component is made positive instead.
    """
    turn = rotation_vector(np.swapaxes(R0, -1, -2) @ R1)
    angle = np.linalg.norm(turn, axis=-1, keepdims=True)
    largest = np.take_along_axis(turn, np.argmax(np.abs(turn), axis=-1, keepdims=True), axis=-1)
    turn = np.where((angle > np.pi - HALF_TURN_MARGIN) & (largest < 0), -turn, turn)
    return np.where((R0 == R1).all((-2, -1))[..., None], 0.0, turn)


def checked_path(path: PoseLike) -> Array:
    """Return a path as an array of exact poses, or say what is wrong with it.

    Args:
        path: (N, 4, 4) poses, m; one pose is a path too.

    Returns:
        (N, 4, 4).

    Raises:
        InputError: Not a stack of at least one pose; the message names the first bad one by its index.
    """
    poses = arguments.numbers(as_pose(path), "a path", "an array of 4x4 poses with shape (N, 4, 4)")
    if poses.ndim != 3 or poses.shape[1:] != (4, 4):
        hint = " For a single pose write path[None]." if poses.shape == (4, 4) else ""
        raise InputError(f"a path must have shape (N, 4, 4), got {poses.shape}.{hint}", given=poses.shape)
    if len(poses) == 0:
        raise InputError("a path needs at least one pose, this one is empty.", given=poses.shape)
    return checked_pose(poses, "path", batch=True)
