"""A pose in a table of a robot file: a position and one rotation in the notation that its key names, or a matrix."""

from __future__ import annotations

import numpy as np

from pieper.description.fields import numbers, one_key
from pieper.description.place import Place, kind_of
from pieper.description.quantity import UNITS, UNITS_OF
from pieper.errors import InputError
from pieper.kinematics.orientation import ANGLE_NOTATIONS, NOTATIONS, rotation
from pieper.kinematics.pose import checked_pose

POSE_KEYS = (
    *("xyz_mm", "xyz_m"),
    *(f"{name}_{unit}" for name in ANGLE_NOTATIONS for unit in UNITS_OF["angle"]),
    *(name for name in NOTATIONS if name not in ANGLE_NOTATIONS),
    *("matrix_mm", "matrix_m"),
)


def pose_of(table: dict, place: Place, *, also: tuple[str, ...] = (), unknown: bool = False) -> np.ndarray:
    """Return the pose (4, 4) of a table; what is not said is the identity, or NaN where unknown is meaningful."""
    place.only(table, (*POSE_KEYS, *also))
    key, unit = one_key(table, "matrix", UNITS_OF["length"], place, required=False)
    others = [name for name in POSE_KEYS if name in table and name != key]
    if key is not None:
        if others:
            place.fail(f"{key} and {others[0]} say the same thing twice; keep one.", key)
        return _matrix(table[key], unit, place, key, unknown)
    T = np.eye(4)
    if unknown:
        T[:3, :] = np.nan
    key, unit = one_key(table, "xyz", UNITS_OF["length"], place, required=False)
    if key is not None:
        T[:3, 3] = numbers(table[key], unit, 3, place, key, unknown=unknown)
    said = [name for name in others if not name.startswith("xyz_")]
    if len(said) > 1:
        place.fail(f"{' and '.join(said)} say the rotation twice; keep one.", said[-1], given=said)
    for name in said:
        notation = next(n for n in NOTATIONS if name.startswith(n))
        unit = name.rpartition("_")[2] if notation in ANGLE_NOTATIONS else ""
        try:
            T[:3, :3] = rotation(notation, numbers(table[name], unit, NOTATIONS[notation][0], place, name))
        except ValueError as error:
            if isinstance(error, InputError):
                raise
            place.fail(f"{error}.", name)
    return T


def _matrix(value: object, unit: str, place: Place, key: str, unknown: bool) -> np.ndarray:
    if not isinstance(value, list) or len(value) != 4 or any(not isinstance(row, list) for row in value):
        place.fail(f"must be four rows of four numbers, got {kind_of(value)}.", key)
    T = np.array([numbers(row, "", 4, place, key, unknown=unknown) for row in value])
    T[:3, 3] = [UNITS[unit][1](float(x)) for x in T[:3, 3]]
    if not unknown:
        try:
            checked_pose(T, "the matrix")
        except InputError as error:
            place.fail(str(error), key)
    return T
