"""A motion read back from the files that hold one in time: the table (CSV) and the ROS trajectory (YAML)."""

from __future__ import annotations

import os
import re

import numpy as np

from pieper import arguments
from pieper.description.dh import Description
from pieper.errors import InputError
from pieper.kinematics.arrays import Array
from pieper.motion.dialects.named_joints import UNITS, JointColumn, check_units, joint_columns, order_of, read_table
from pieper.motion.dialects.trajectory import joint_names
from pieper.motion.motion import Described, Motion
from pieper.words_by_number import plural

_YAML = re.compile(
    r"positions:\s*\[([^\]]*)\]\s*velocities:\s*\[([^\]]*)\]\s*accelerations:\s*\[([^\]]*)\]\s*"
    r"time_from_start:\s*sec:\s*(\d+)\s*nanosec:\s*(\d+)"
)


def read_motion(path: str | os.PathLike[str], arm: Described) -> Motion:
    """Return the timed motion that `Program.write` wrote as "csv" or "ros".

    Args:
        path: A .csv, .yaml or .yml file.
        arm: Whose motion it is.

    Raises:
        InputError: No such file, another ending, a table without time, or a motion of another arm.
    """
    file = arguments.file(path)
    if file.suffix.lower() not in (".csv", ".yaml", ".yml"):
        raise InputError(f"{file.name}: a motion in time is a .csv or a .yaml.", given=file.suffix)
    try:
        text = file.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"cannot read {path}: {arguments.cause(error)}.", path=path) from None
    description = arm.description
    n = description.n
    try:
        t, q, dq, ddq = (
            _table(text, description, file.name) if file.suffix.lower() == ".csv" else _trajectory(text, description)
        )
    except InputError as error:
        said = str(error)
        raise InputError(said if said.startswith(file.name) else f"{file.name}: {said}", **error.data) from None
    except ValueError as error:
        raise InputError(f"{file.name}: {error}.", path=path) from None
    if q.ndim != 2 or q.shape[1] != n or len(q) == 0:
        raise InputError(f"{file.name} is no motion of {plural(n, 'joint')}.", path=path)
    if not (np.isfinite(q).all() and np.isfinite(t).all() and (np.diff(t) > 0).all()):
        raise InputError(f"{file.name}: times must rise and all numbers be finite.", path=path)
    s = t / t[-1] if t[-1] > 0 else np.ones(len(t))
    ends = np.array([0.0, t[-1]])
    return Motion(t, q, dq, ddq, ends, ends, np.zeros_like(q), s, description=description)


def _table(text: str, arm: Description, name: str) -> tuple[Array, Array, Array, Array]:
    head, values = read_table(text)
    n, names = arm.n, arm.joint_names
    columns = joint_columns(head)
    if head[0] != "t_s" or not any(column.order == 0 for column in columns):
        raise InputError(
            f"{name}: the first column must be t_s, time in s, and {n} joints follow, each with its unit: "
            f"{names[0]}_{'mm' if arm.joint_types[0] == 'P' else 'deg'}. A path without times is timed first: "
            "`pieper time`, or pieper.time_law.",
            given=head,
        )
    check_units(columns, names, np.array([kind == "P" for kind in arm.joint_types]))
    t, found = np.asarray(values[:, 0], np.float64), list[Array]()
    for order in range(3):
        those: list[JointColumn] = [column for column in columns if column.order == order]
        if order and not those:
            found.append(np.gradient(found[-1], t, axis=0) if order == 1 and len(t) > 1 else np.zeros((len(t), n)))
            continue
        where = order_of([column.joint for column in those], names, arm.name)
        order_in_file = [int(k) for k in where]
        at = [those[k].at for k in order_in_file]
        found.append(np.asarray(values[:, at] * [UNITS[those[k].unit] for k in order_in_file], np.float64))
    return t, found[0], found[1], found[2]


def _trajectory(text: str, arm: Description) -> tuple[Array, Array, Array, Array]:
    order = order_of(joint_names(text), arm.joint_names, arm.name)
    points = [m.groups() for m in _YAML.finditer(text)]
    if not points:
        raise ValueError("it has no point with positions, velocities, accelerations and time_from_start")
    q, dq, ddq = (np.array([[float(v) for v in p[k].split(",")] for p in points]) for k in range(3))
    if any(part.ndim != 2 or part.shape[1] != len(order) for part in (q, dq, ddq)):
        raise ValueError(f"its points have not {plural(len(order), 'value')} each, as it names joints")
    t = np.array([int(p[3]) + int(p[4]) / 1e9 for p in points])
    return t, q[:, order], dq[:, order], ddq[:, order]
