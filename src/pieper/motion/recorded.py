"""A motion read back from the files that hold one in time: the table (CSV) and the ROS trajectory (YAML)."""

from __future__ import annotations

import os
import re

import numpy as np

from pieper import arguments
from pieper.errors import InputError
from pieper.kinematics.arrays import Array
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
        t, q, dq, ddq = _table(text, n, file.name) if file.suffix.lower() == ".csv" else _trajectory(text)
    except InputError:
        raise
    except ValueError as error:
        raise InputError(f"{file.name}: {error}.", path=path) from None
    if q.ndim != 2 or q.shape[1] != n or len(q) == 0:
        raise InputError(f"{file.name} is no motion of {plural(n, 'joint')}.", path=path)
    if not (np.isfinite(q).all() and np.isfinite(t).all() and (np.diff(t) >= 0).all()):
        raise InputError(f"{file.name}: times must rise and all numbers be finite.", path=path)
    s = t / t[-1] if t[-1] > 0 else np.ones(len(t))
    ends = np.array([0.0, t[-1]])
    return Motion(t, q, dq, ddq, ends, ends, np.zeros_like(q), s, description=description)


def _table(text: str, n: int, name: str) -> tuple[Array, Array, Array, Array]:
    head, *rows = text.strip().splitlines()
    columns = head.split(",")
    if columns[0] != "t_s" or len(columns) < 1 + n:
        raise InputError(
            f"{name}: the first column must be t_s, time in s, and {n} joints follow. A path without times "
            "is timed first: `pieper time`, or pieper.time_law.",
            given=head,
        )
    units = [0.001 if re.sub(r"_per_s2?$", "", c).endswith("_mm") else np.pi / 180 for c in columns[1:]]
    values = np.array([[float(v) for v in row.split(",")] for row in rows])
    if values.ndim != 2 or values.shape[1] != len(columns):
        raise ValueError("rows have another number of columns than the head")
    rest = values[:, 1:] * units
    zeros = np.zeros((len(values), n))
    if rest.shape[1] < 3 * n:
        q = rest[:, :n]
        return values[:, 0], q, np.gradient(q, values[:, 0], axis=0) if len(q) > 1 else zeros, zeros
    return values[:, 0], rest[:, :n], rest[:, n : 2 * n], rest[:, 2 * n : 3 * n]


def _trajectory(text: str) -> tuple[Array, Array, Array, Array]:
    points = [m.groups() for m in _YAML.finditer(text)]
    q, dq, ddq = (np.array([[float(v) for v in p[k].split(",")] for p in points]) for k in range(3))
    return np.array([int(p[3]) + int(p[4]) / 1e9 for p in points]), q, dq, ddq
