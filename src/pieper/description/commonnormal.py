"""A chain of joint axes written as a standard DH table, by the common normals between neighbouring axes."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from pieper.description.dh import DH, Slid
from pieper.description.fold import FAR_LONGER
from pieper.tolerances import (
    ALL_BUT_ZERO,
    ANGLE_ROUNDED,
    FRAME_ROUNDED,
    MEETING_AXES,
    NEARLY_PARALLEL,
    NO_DIRECTION,
    PARALLEL_AXES,
    SMALLEST_ARM,
)

_LENGTH_DECIMALS = 15


@dataclass(frozen=True, eq=False)
class Table:
    """A standard DH table with what stands before and after it.

    Args:
        rows: One row a joint.
        base: (4, 4), first frame of the table.
        tool: (4, 4), tool in the last frame.
        largest_turn: The largest angle (rad) between axes that were taken for parallel.
    """

    rows: tuple[DH, ...]
    base: np.ndarray
    tool: np.ndarray
    largest_turn: float


def standard_table(axes: np.ndarray, points: np.ndarray, home: np.ndarray, farthest: float = math.inf) -> Table:
    """Return the standard DH table of a chain of axes, its joint variables zero in the given posture.

    Each x axis is turned as little as its common normal allows, so link lengths may come out negative and joints that
    are drawn stretched read zero. The last row leads to the tool's z axis, so that a tool on the last axis needs no
    pose of its own.

    Args:
        axes: (n, 3) unit directions of the joint axes, all joints at zero.
        points: (n, 3) a point on each axis, m.
        home: (4, 4) pose of the tool, all joints at zero.
        farthest: Rows between nearly parallel axes are slid ones; axes that meet no farther away than this, m, still
            meet. No row is, when left out.

    Returns:
        The table; its product at zero is `home` to rounding.

    Source: Denavit and Hartenberg (1955); Spong, Hutchinson and Vidyasagar (2006), section 3.2.
    """
    axes = np.asarray(axes, float) / np.linalg.norm(axes, axis=1, keepdims=True)
    size = max(float(np.abs(points).max(initial=0.0)), float(np.abs(home[:3, 3]).max()), SMALLEST_ARM)
    directions, places = [*axes, home[:3, 2]], [*points, home[:3, 3]]
    base = _first_frame(directions[0], places[0])
    rows, turn = [], 0.0
    T = base.copy()
    for i in range(len(axes)):
        last = i == len(axes) - 1
        row, off = _row(T, directions[i + 1], places[i + 1], size, home[:3, 0] if last else None)
        if math.isfinite(farthest) and 0 < abs(math.sin(row.alpha)) < NEARLY_PARALLEL:
            slid = _slid(T, directions[i + 1], places[i + 1], size, row)
            # axes that meet amid the arm are left to meet
            row = slid if row.a or abs(row.d) > farthest else row
        rows.append(row)
        turn = max(turn, off)
        T = _on_line(T @ _row_pose(row), directions[i + 1], places[i + 1], size)
    tool = np.linalg.inv(T) @ home
    tool[3] = 0, 0, 0, 1
    return Table(tuple(rows), base, _without_rounding(tool), turn)


def _first_frame(z: np.ndarray, point: np.ndarray) -> np.ndarray:
    """Return the frame on the first axis that is closest to the base frame."""
    z = _tidy(z)
    helper = np.eye(3)[0] if abs(z[0]) < 0.9 else np.eye(3)[1]
    x = helper - (helper @ z) * z
    x = _tidy(x / np.linalg.norm(x))
    T = np.eye(4)
    T[:3, 0], T[:3, 1], T[:3, 2] = x, np.cross(z, x), z
    T[:3, 3] = point - (point @ z) * z
    T[:3] = np.round(T[:3], _LENGTH_DECIMALS) + 0.0
    return T


def _row(T: np.ndarray, u: np.ndarray, point: np.ndarray, size: float, prefer: np.ndarray | None) -> tuple[DH, float]:
    """Return the DH row from frame T to the line (point, u), and the angle by which it was taken for parallel."""
    x, z, origin = T[:3, 0], T[:3, 2], T[:3, 3]
    cross = np.cross(z, u)
    sine, cosine = float(np.linalg.norm(cross)), float(z @ u)
    w = point - origin
    if sine > PARALLEL_AXES:
        new_x = cross / sine
        if _turned(new_x, x, z):
            new_x = -new_x
        a = float(w @ new_x)
        d = float(np.cross(w, u) @ cross) / sine**2
        alpha = math.atan2(float(cross @ new_x), cosine)
        off = 0.0
    else:
        d = float(w @ z) if prefer is not None else 0.0
        across = w - float(w @ z) * z
        a = float(np.linalg.norm(across))
        if a > MEETING_AXES * size:
            new_x = across / a
            if _turned(new_x, x, z):
                new_x, a = -new_x, -a
        else:
            new_x, a = (x if prefer is None else prefer - float(prefer @ z) * z), 0.0
            new_x = new_x / np.linalg.norm(new_x)
        alpha, off = (0.0 if cosine > 0 else math.pi), sine
    theta = math.atan2(float(np.cross(x, new_x) @ z), float(x @ new_x))
    row = DH(a=_round_length(a, size), alpha=_round_angle(alpha), d=_round_length(d, size), theta=_round_angle(theta))
    return row, off


def _on_line(T: np.ndarray, u: np.ndarray, point: np.ndarray, size: float) -> np.ndarray:
    """Return frame T, whose z axis is the line (point, u) but for rounding, brought onto it where rounding was coarse.

    A row to a common normal far away and the row back are rounded as coarsely as they are long. The row back makes up
    for the row there. Would those behind it make up for it, axes that meet or are parallel would not be any longer.
    """
    w = T[:3, 3] - point
    along = float(w @ u)
    foot = point + along * u
    if abs(along) > FAR_LONGER * size or float(np.linalg.norm(T[:3, 3] - foot)) <= MEETING_AXES * size:
        return T
    z = u if float(T[:3, 2] @ u) > 0 else -u
    x = T[:3, 0] - float(T[:3, 0] @ z) * z
    out, x = np.eye(4), x / np.linalg.norm(x)
    out[:3, 0], out[:3, 1], out[:3, 2], out[:3, 3] = x, np.cross(z, x), z, foot
    return out


def _slid(T: np.ndarray, u: np.ndarray, point: np.ndarray, size: float, row: DH) -> Slid:
    """Return the row from frame T to where the line (point, u) crosses the plane of T's x and y, turned as a row is."""
    z, origin = T[:3, 2], T[:3, 3]
    across = point + u * (float((origin - point) @ z) / float(u @ z)) - origin
    x = math.cos(row.theta) * T[:3, 0] + math.sin(row.theta) * T[:3, 1]
    f = _round_length(float(across @ np.cross(z, x)), size)
    return Slid(a=_round_length(float(across @ x), size), alpha=row.alpha, theta=row.theta, f=f)


def _turned(new_x: np.ndarray, x: np.ndarray, z: np.ndarray) -> bool:
    """Return whether turning x over gives the smaller joint angle (a quarter turn stays positive)."""
    along = float(x @ new_x)
    return along < -NO_DIRECTION or (abs(along) <= NO_DIRECTION and float(np.cross(x, new_x) @ z) < 0)


def _row_pose(row: DH) -> np.ndarray:
    ct, st, ca, sa = math.cos(row.theta), math.sin(row.theta), math.cos(row.alpha), math.sin(row.alpha)
    f = row.f if isinstance(row, Slid) else 0.0
    return np.array(
        [
            [ct, -st * ca, st * sa, row.a * ct - f * st],
            [st, ct * ca, -ct * sa, row.a * st + f * ct],
            [0.0, sa, ca, row.d],
            [0.0, 0.0, 0.0, 1.0],
        ]
    )


def _round_angle(angle: float) -> float:
    """Return the double of a multiple of 15 deg where the angle is one to rounding."""
    near = math.radians(15 * round(math.degrees(angle) / 15))
    return near + 0.0 if abs(angle - near) <= ANGLE_ROUNDED else angle


def _round_length(length: float, size: float) -> float:
    return 0.0 if abs(length) < MEETING_AXES * size else round(length, _LENGTH_DECIMALS)


def _tidy(v: np.ndarray) -> np.ndarray:
    return np.where(np.abs(v) < ALL_BUT_ZERO, 0.0, v)


def _without_rounding(T: np.ndarray) -> np.ndarray:
    """Return a pose with its rounding around 0 and 1 removed: the identity stays the identity."""
    whole = np.round(T)
    return np.where(np.abs(T - whole) < FRAME_ROUNDED, whole, T) + 0.0
