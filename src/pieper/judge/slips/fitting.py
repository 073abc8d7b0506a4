"""The one number that explains a wrong pose: the value of a joint, or of a length, with which the pose is right.

A pose is linear in the sine and cosine of one angle, in a slide and in a length, so that the value is a division away.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np

from pieper.algebra.expression import Expr, Num
from pieper.judge.model import ArmModel, Row
from pieper.tolerances import ROUNDING

Value = Callable[[ArmModel, np.ndarray], np.ndarray]
Maker = Callable[[ArmModel, Expr], ArmModel]


def joint_that_fits(
    model: ArmModel, q: np.ndarray, joint: int, value: Value, wanted: np.ndarray
) -> tuple[float, np.ndarray]:
    """Return the value of a joint (0-based) with which a matrix comes nearest to the wanted one, and the joint vector.

    Args:
        model: The arm.
        q: (n,) the other joints, rad or the arm's unit of length.
        joint: Which one is looked for.
        value: The matrix of an arm at a joint vector.
        wanted: The matrix as printed, nan where nothing is.
    """
    new = q.copy()
    if model.sliding(joint + 1):
        at = [value(model, _with(q, joint, x)) for x in (0.0, 1.0)]
        (new[joint],) = _least([at[1] - at[0]], wanted - at[0], wanted)
        return float(new[joint]), new
    at = [value(model, _with(q, joint, x)) for x in (0.0, np.pi / 2, np.pi)]
    middle, cosine = (at[0] + at[2]) / 2, (at[0] - at[2]) / 2
    c, s = _least([cosine, at[1] - middle], wanted - middle, wanted)
    new[joint] = np.arctan2(s, c)
    return float(new[joint]), new


def lengths_that_fit(
    model: ArmModel, q: np.ndarray, value: Value, wanted: np.ndarray
) -> Iterator[tuple[str, float, float, ArmModel]]:
    """Yield (its place, its value here, the value that fits best, the arm with it) for the lengths of a table."""
    for words, node, make in lengths_of(model):
        old = float(node.evaluate(model.at_zero))
        at = [value(make(model, Num(x)), q) for x in (0.0, 1.0)]
        if np.abs(at[1] - at[0]).max() > ROUNDING:
            (new,) = _least([at[1] - at[0]], wanted - at[0], wanted)
            yield words, old, float(new), make(model, Num(float(new)))


def lengths_of(model: ArmModel) -> Iterator[tuple[str, Expr, Maker]]:
    """Yield (words, cell, what puts another cell there) for each a and d of a table that is not nothing.

    Constant rows have theirs too. Rows are counted as they are printed.
    """
    printed = 0
    for k, row in enumerate(model.rows):
        every = [(row.before, "before", j) for j in range(len(row.before))]
        every += [((row,), "", 0), *((row.after, "after", j) for j in range(len(row.after)))]
        for group, where, j in every:
            printed += 1
            for column in ("a", "d"):
                node = getattr(group[j], column)
                moves = not where and column == "d" and model.sliding(k + 1)
                if not moves and abs(float(node.evaluate(model.at_zero))) > 0:
                    yield f"{column} of row {printed}", node, _maker(k, where, j, column)


def _maker(index: int, where: str, place: int, column: str) -> Maker:
    def make(model: ArmModel, cell: Expr) -> ArmModel:
        if not where:
            return model.with_row(index, **{column: cell})
        rows, group = list(model.rows), list[Row](getattr(model.rows[index], where))
        group[place] = replace(group[place], **{column: cell})
        rows[index] = replace(rows[index], **{where: tuple(group)})
        return replace(model, rows=tuple(rows))

    return make


def _with(q: np.ndarray, joint: int, value: float) -> np.ndarray:
    new = q.copy()
    new[joint] = value
    return new


def _least(parts: list[np.ndarray], left: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    """Return the factors (m,) of some matrices that make their sum nearest to what is left, where it is printed."""
    cells = np.isfinite(wanted)
    scale = 1 / (1 + np.abs(wanted[cells]))
    M = np.stack([part[cells] * scale for part in parts], axis=1)
    return np.asarray(np.linalg.lstsq(M, left[cells] * scale, rcond=None)[0], dtype=float)
