"""Joints by their names, as tables and trajectories have them: in any order, in the unit that a column's name says."""

from __future__ import annotations

import csv
import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pieper.errors import InputError
from pieper.kinematics.arrays import Array, Bools, Indices
from pieper.words_by_number import plural

#: What one of a unit is in rad or m.
UNITS = {"deg": np.pi / 180, "rad": 1.0, "mm": 1e-3, "m": 1.0}
LENGTHS = ("mm", "m")
_HEAD = re.compile(r"(?P<joint>.+)_(?P<unit>deg|rad|mm|m)(?P<per>_per_s[23]?)?")
_ORDERS = {None: 0, "_per_s": 1, "_per_s2": 2, "_per_s3": 3}
_PREFIXES = ("", "dq_", "ddq_", "dddq_")


@dataclass(frozen=True)
class JointColumn:
    """A column of a table: where it stands, of which joint, what one of it is in rad or m, and its order in time."""

    at: int
    joint: str
    unit: str
    order: int


def read_table(text: str) -> tuple[list[str], Array]:
    """Return the heads of a table and its numbers (k, columns); a cell that is no number is NaN.

    Raises:
        ValueError: No row, or rows of another length than the head.
    """
    head, *rows = [row for row in csv.reader(text.removeprefix("\ufeff").splitlines()) if row] or [[]]
    if not rows:
        raise ValueError("it has a head and no row")
    if any(len(row) != len(head) for row in rows):
        raise ValueError("rows have another number of columns than the head")
    return [name.strip() for name in head], np.array([[_number(cell) for cell in row] for row in rows])


def _number(cell: str) -> float:
    try:
        return float(cell)
    except ValueError:
        return np.nan


def joint_columns(head: Sequence[str]) -> list[JointColumn]:
    """Return the columns of a table whose names end in a unit: values of joints, their rates and accelerations."""
    out: list[JointColumn] = []
    for at, name in enumerate(head):
        said = _HEAD.fullmatch(name)
        if said is not None:
            order = _ORDERS[said["per"]]
            out.append(JointColumn(at, said["joint"].removeprefix(_PREFIXES[order]), said["unit"], order))
    return out


def order_of(found: Sequence[str], own: Sequence[str], arm: str) -> Indices:
    """Return where each of an arm's joints stands among those that a file names.

    Raises:
        InputError: A joint is missing, named twice, or another's.
    """
    twice = sorted({name for name in found if list(found).count(name) > 1})
    if twice:
        raise InputError(f"the file names {twice[0]} twice.", given=twice[0])
    if set(found) != set(own):
        raise InputError(
            f"the file names {plural(len(found), 'joint')}, {', '.join(found)}; those of {arm} are called "
            f"{', '.join(own)}. Is it a motion of another arm? Else write the arm's own names into the file.",
            given=list(found),
            allowed=list(own),
        )
    return np.array([list(found).index(name) for name in own], np.int64)


def check_units(columns: Sequence[JointColumn], names: Sequence[str], prismatic: Bools) -> None:
    """Say where a slide is given in degrees or radians, or a turning joint in a length.

    Raises:
        InputError: One is; the joint is named.
    """
    slides = dict(zip(names, prismatic.tolist(), strict=True))
    for column in columns:
        if column.joint in slides and slides[column.joint] != (column.unit in LENGTHS):
            kind, units = ("slides", "mm or m") if slides[column.joint] else ("turns", "deg or rad")
            raise InputError(
                f"{column.joint} {kind}, and its column is in {column.unit}; say {units}.", joint=column.joint
            )
