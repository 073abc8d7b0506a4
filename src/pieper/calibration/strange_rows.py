"""Single rows of a calibration that belong to another unit or to nothing, where the others are as they should be."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from pieper.calibration.measurements import Measurements
from pieper.calibration.model import AxesModel
from pieper.calibration.reading import Reading
from pieper.calibration.units import units_of
from pieper.errors import InputError
from pieper.kinematics.arrays import Array, Indices
from pieper.tolerances import FAR_BEYOND, MOST_ROWS, SUSPICIOUS
from pieper.words_by_number import plural

#: Rows that a message names.
NAMED_ROWS = 8


def misses_of_rows(model: AxesModel, q: Array, data: Measurements) -> tuple[Array, Array | None]:
    """Return by how much the nominal arm misses each row (N,), m, and of poses how far it is turned (N,), rad."""
    T = model.fk(q)
    way, turn = data.placed(T[:, :3, 3]).misses(T)
    return np.linalg.norm(way, axis=1), np.linalg.norm(turn, axis=1) if turn.shape[1] else None


def off(model: AxesModel, q: Array, data: Measurements, length: float) -> Array:
    """Return by how much the nominal arm misses each row (N,), per its length; of poses the turns (rad) are added."""
    metres, radians = misses_of_rows(model, q, data)
    return np.asarray(metres / length + (0.0 if radians is None else radians))


def in_part(model: AxesModel, q: Array, data: Measurements, best: Reading, length: float) -> Reading:
    """Return a reading that only some rows are meant by, where the others are right as they are."""
    if not best.units_alone or data.kind not in ("pose", "position"):
        return best
    before, after = off(model, q, data, length), off(model, best.q, best.data, length)
    right, cured = before < SUSPICIOUS, after < SUSPICIOUS
    if not (right & ~cured).any() or np.mean(right | cured) < MOST_ROWS:
        return best
    rows = np.flatnonzero(cured & ~right)
    values = data.values.copy()
    values[rows] = best.data.values[rows]
    joints = q.copy()
    joints[rows] = best.q[rows]
    return replace(
        best,
        words=f"{best.words} in {_rows(rows, len(q))} alone",
        cure=f"{best.cure} In these rows only: the others are right as they are.",
        q=joints,
        data=replace(data, values=values),
        facts=best.facts | {"rows": rows.tolist()},
    )


def refuse_strange_rows(model: AxesModel, q: Array, data: Measurements, length: float) -> None:
    """Raise where few rows miss the nominal arm by far more than it can be wrong, and the others do not.

    Args:
        model: The nominal arm.
        q: (N, n) joint vectors as given.
        data: Measurements as given, of poses or positions: a set-up that is fitted hides what single rows miss.
        length: The arm's length, m.

    Raises:
        InputError: The message names the rows, and another unit where one explains them.
    """
    if data.kind not in ("pose", "position") or not len(q):
        return
    missed = off(model, q, data, length)
    rows = np.flatnonzero(missed > max(SUSPICIOUS, FAR_BEYOND * float(np.median(missed))))
    if not len(rows):
        return
    unit = _unit(model, q, data, length, rows)
    largest = int(rows[np.argmax(missed[rows])])
    size = np.linalg.norm(model.fk(q[largest : largest + 1])[0, :3, 3] - data.positions[largest])
    raise InputError(
        f"{_rows(rows, len(q))} {'misses' if len(rows) == 1 else 'miss'} the nominal arm by far more than the others "
        f"do (measurement {largest + 1} by {size:.3g} m): {unit}no noise looks like that, and a fit by squares follows "
        'it. Mend these rows or leave them out; loss="huber" leaves them out by itself.',
        rows=rows.tolist(),
    )


def _unit(model: AxesModel, q: Array, data: Measurements, length: float, rows: Indices) -> str:
    """Say which other unit explains the rows, if one does."""
    for reading in units_of(model, q, data, length):
        if (off(model, reading.q, reading.data, length)[rows] < SUSPICIOUS).all():
            return f"there {reading.words}, since {'that explains it' if len(rows) == 1 else 'that explains them'}; "
    return ""


def _rows(rows: Indices, of: int) -> str:
    named = ", ".join(str(i + 1) for i in rows[:NAMED_ROWS]) + (", ..." if len(rows) > NAMED_ROWS else "")
    return f"{plural(len(rows), 'measurement')} of {of} ({named})"
