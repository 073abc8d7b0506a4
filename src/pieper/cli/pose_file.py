"""Tables of poses: a CSV file with one pose a row, its columns by name in any order, read a block at a time."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import ClassVar

import numpy as np
import numpy.typing as npt

from pieper import InputError
from pieper.cli.arguments import ALSO, NOTATIONS, posed
from pieper.cli.number_table import NumberTable, first_lines, has_names

#: The names of the columns of each notation.
NAMES = {
    "rpy": ("roll", "pitch", "yaw"),
    "abc": ("a", "b", "c"),
    "wpr": ("w", "p", "r"),
    "zyz": ("phi", "theta", "psi"),
    "rotvec": ("rx", "ry", "rz"),
    "quat_wxyz": ("qw", "qx", "qy", "qz"),
}
MATRIX = tuple(f"r{i}{j}" for i in (1, 2, 3) for j in (1, 2, 3))
POSITION = ("x", "y", "z")


#: How many numbers a pose is said with on one line: a position, with three angles or a quaternion, or a matrix.
ONE_POSE = (3, 6, 7, 12, 16)


def is_table(word: str) -> bool:
    """Return whether a typed pose names a table of poses, @file or @- for standard input: several lines of a pose each.

    One matrix of three or four lines of four numbers is one pose, and so are a position above its three angles and a
    single line without names.
    """
    if not word.startswith("@"):
        return False
    lines = [line for line in first_lines(word[1:], "pose") if line]
    rows = [[cell for cell in re.split(r"[,;\t]\s*|\s+", line) if cell] for line in lines]
    if not rows:
        return word.lower().endswith((".csv", ".tsv"))
    matrix = len(rows) in (3, 4) and all(len(row) == 4 for row in rows) and not has_names(rows[0])
    if matrix:
        return False
    if word.lower().endswith((".csv", ".tsv")):
        return True
    lengths = {len(row) for row in rows}
    if len(rows) == 2 and lengths == {3} and not has_names(rows[0]):
        return False
    return len(rows) > 1 and (has_names(rows[0]) or (len(lengths) == 1 and lengths <= set(ONE_POSE)))


@dataclass
class PoseFile(NumberTable):
    """A table of poses, (k, 4, 4) in m.

    Args:
        name: Its place.
        units: Of columns whose name says none.
        order: The notation of columns without names, as --order says it.

    Attributes:
        size: Its bytes.
        unused: Columns that say nothing about a pose; known when reading has begun.
        bare: Whether it holds positions alone; known when reading has begun.
    """

    order: str = "rpy"
    bare: bool = field(default=False, init=False)
    thing: ClassVar[str] = "pose"

    def made(self, values: npt.NDArray[np.float64], what: str) -> npt.NDArray[np.float64]:
        """Return the poses (k, 4, 4) of rows."""
        self.bare = values.shape[1] == len(POSITION)
        return posed(values, self.units, self.order, what)[0]

    def columns(self, heads: list[str]) -> tuple[list[int], npt.NDArray[np.float64]]:
        """Return which columns to take in which order, and what makes their numbers the units said."""
        known = self.known(heads)
        missing = [axis for axis in POSITION if axis not in known]
        if missing:
            raise InputError(
                f"{self.name}: there is no column {' or '.join(missing)}; it has {', '.join(heads)}. A pose needs x, "
                "y, z with their unit (x_mm, x_m).",
                path=self.name,
                missing=missing,
            )
        order, names = self._notation(known)
        taken = [*POSITION, *names]
        if names == MATRIX:
            taken = [name for i in (1, 2, 3) for name in (*MATRIX[3 * i - 3 : 3 * i], POSITION[i - 1])]
        turning = names if NOTATIONS[order][1] and names != MATRIX else ()
        kinds = {name: "length" if name in POSITION else "angle" if name in turning else "" for name in taken}
        self.unused = tuple(heads[j] for name, (j, _) in known.items() if name not in taken)
        self.order = order
        return [known[name][0] for name in taken], np.array([self.factor(n, known[n][1], kinds[n]) for n in taken])

    def _notation(self, known: dict[str, tuple[int, str]]) -> tuple[str, tuple[str, ...]]:
        """Return the notation whose columns are there; none of them is R = I, some of them an error."""
        asked = ALSO.get(self.order, self.order)
        asked = "quat_wxyz" if asked == "quat_xyzw" else asked
        choices = {asked: NAMES[asked], **NAMES, "matrix": MATRIX}
        partly = ""
        for order, names in choices.items():
            there = [name for name in names if name in known]
            if len(there) == len(names):
                return ("rpy" if order == "matrix" else order), names
            if there and not partly:
                lost = ", ".join(name for name in names if name not in known)
                partly = f"{self.name}: the orientation has {', '.join(there)}, but no column {lost}."
        if partly:
            raise InputError(partly, path=self.name)
        return "rpy", ()
