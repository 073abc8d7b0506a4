"""Tables of poses: a CSV file with one pose a row, its columns by name in any order, read a block at a time."""

from __future__ import annotations

import csv
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from itertools import islice
from pathlib import Path
from typing import BinaryIO

import numpy as np
import numpy.typing as npt

from pieper import InputError
from pieper.cli.arguments import ALSO, NOTATIONS, number, posed
from pieper.cli.output import plural
from pieper.cli.units import ANGLES, LENGTHS, Units

#: Poses that are read, solved and written at once.
BLOCK = 20_000
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


def is_table(word: str) -> bool:
    """Return whether a typed pose names a table of poses: @something.csv, unless it holds one matrix of 4 columns."""
    if not (word.startswith("@") and word.lower().endswith((".csv", ".tsv"))):
        return False
    with _opened(word[1:]) as file:
        lines = [line for line in (_text(raw, word[1:]) for raw in islice(file, 20)) if line]
    rows = [re.split(r"[,;\t]\s*|\s+", line) for line in lines]
    matrix = len(rows) in (3, 4) and all(len(row) == 4 for row in rows) and not _names(rows[0])
    return not matrix


@dataclass(frozen=True, eq=False)
class _Form:
    """How the lines of a file are cut: which columns to take, in which order, and what their numbers are times."""

    delimiter: str
    width: int
    pick: list[int]
    order: str
    factors: npt.NDArray[np.float64]


@dataclass
class PoseFile:
    """A table of poses.

    Args:
        name: Its place.
        units: Of columns whose name says none.
        order: The notation of columns without names, as --order says it.

    Attributes:
        size: Its bytes.
        unused: Columns that say nothing about a pose; known when reading has begun.
        bare: Whether it holds positions alone; known when reading has begun.
    """

    name: str
    units: Units
    order: str = "rpy"
    size: int = field(init=False)
    unused: tuple[str, ...] = field(default=(), init=False)
    bare: bool = field(default=False, init=False)

    def __post_init__(self) -> None:
        self.size = max(1, Path(self.name).stat().st_size) if Path(self.name).exists() else 1

    def blocks(self, read: Callable[[int], None] = lambda _: None) -> Iterator[npt.NDArray[np.float64]]:
        """Yield the poses (k, 4, 4), m, some thousands at a time.

        Args:
            read: Told how many bytes were read since it was last told.

        Raises:
            InputError: The file cannot be read, a column is missing, or a row is not a pose; the line is named.
        """
        with _opened(self.name) as file:
            lines = self._lines(file, read)
            first = next(lines, None)
            if first is None:
                raise InputError(f"{self.name} holds no pose.", path=self.name)
            at, line = first
            delimiter = max(",;\t", key=line.count)
            delimiter = delimiter if delimiter in line else " "
            cells = self._cells(line, delimiter)
            if _names(cells):
                pick, order, factors = self._columns(cells)
            else:
                pick, order, factors = list(range(len(cells))), self.order, np.ones(len(cells))
                lines = _chained(first, lines)
            self.bare = len(pick) == len(POSITION)
            form = _Form(delimiter, len(cells), pick, order, factors)
            got = False
            while block := list(islice(lines, BLOCK)):
                got = True
                yield self._poses(block, form)
            if not got:
                raise InputError(f"{self.name} has names of columns, but no pose beneath them.", path=self.name)

    def _lines(self, file: BinaryIO, read: Callable[[int], None]) -> Iterator[tuple[int, str]]:
        for at, raw in enumerate(file, 1):
            read(len(raw))
            if text := _text(raw, self.name):
                yield at, _with_points(text)

    def _cells(self, line: str, delimiter: str) -> list[str]:
        if delimiter == " ":
            return line.split()
        return [cell.strip() for cell in next(csv.reader([line], delimiter=delimiter))]

    def _poses(self, block: list[tuple[int, str]], form: _Form) -> npt.NDArray[np.float64]:
        """Return the poses (k, 4, 4) of lines: all at once, or, where that fails, one by one to say which is wrong."""
        try:
            if form.delimiter != " " and any(line.count(form.delimiter) != form.width - 1 for _, line in block):
                raise ValueError
            mark = None if form.delimiter == " " else form.delimiter
            lines = [line for _, line in block]
            values = np.loadtxt(lines, delimiter=mark, comments=None, usecols=form.pick, ndmin=2)
            if not np.isfinite(values).all():
                raise ValueError
            return posed(values * form.factors, self.units, form.order, self.name)[0]
        except ValueError:
            return np.array([self._pose(at, line, form) for at, line in block])

    def _pose(self, at: int, line: str, form: _Form) -> npt.NDArray[np.float64]:
        cells = self._cells(line, form.delimiter)
        what = f"{self.name}, line {at}"
        if len(cells) != form.width:
            said = f"{what}: {plural(len(cells), 'cell')} where the first line has {form.width}."
            raise InputError(said, path=self.name, line=at)
        values = [number(cells[j], what) for j in form.pick]
        return posed(values * form.factors, self.units, form.order, what)[0]

    def _columns(self, heads: list[str]) -> tuple[list[int], str, npt.NDArray[np.float64]]:
        """Return which columns to take in which order, their notation, and what makes their numbers the units said."""
        known: dict[str, tuple[int, str]] = {}
        for j, head in enumerate(heads):
            name, unit = _name_and_unit(head)
            if name in known:
                raise InputError(f"{self.name}: the column {name} stands there twice.", path=self.name)
            known[name] = (j, unit)
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
        factors = [self._factor(name, known[name][1], order if name in names else "", heads) for name in taken]
        self.unused = tuple(heads[j] for name, (j, _) in known.items() if name not in taken)
        return [known[name][0] for name in taken], order, np.array(factors)

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

    def _factor(self, name: str, unit: str, order: str, heads: list[str]) -> float:
        """Return the factor that takes a column's numbers into the units that the command speaks."""
        said = {"angle": self.units.radians, "length": self.units.metres}
        if name in POSITION:
            kind, sizes = "length", LENGTHS
        elif order and NOTATIONS[order][1] and name not in MATRIX:
            kind, sizes = "angle", ANGLES
        else:
            kind, sizes = "", {}
        if unit and unit not in sizes:
            raise InputError(
                f"{self.name}: the column {name} cannot be in {unit}; "
                f"{'it has no unit' if not sizes else 'it may be in ' + ' or '.join(sizes)}.",
                path=self.name,
            )
        return sizes[unit] / said[kind] if unit else 1.0


def _chained(first: tuple[int, str], rest: Iterator[tuple[int, str]]) -> Iterator[tuple[int, str]]:
    yield first
    yield from rest


def _opened(name: str) -> BinaryIO:
    try:
        return Path(name).open("rb")
    except OSError as error:
        raise InputError(f"pose: cannot read {name}: {error.strerror}.", path=name) from None


def _text(raw: bytes, name: str) -> str:
    try:
        return raw.decode("utf-8-sig").split("#")[0].strip()
    except UnicodeDecodeError:
        raise InputError(f"pose: {name} is not a text file.", path=name) from None


def _with_points(line: str) -> str:
    """Return a line of cells between semicolons or tabs with points for decimal commas, which many countries write."""
    return re.sub(r"(?<=\d),(?=\d)", ".", line) if ";" in line or "\t" in line else line


def _names(cells: list[str]) -> bool:
    """Return whether a line holds names of columns: a word that is no number, infinity or expression."""
    words = [cell.lower() for cell in cells if re.fullmatch(r"[A-Za-z_]\w*(?:[, (/\[]+\w+[)\]]?)?", cell)]
    return any(word not in ("nan", "inf", "pi") for word in words)


def _name_and_unit(head: str) -> tuple[str, str]:
    """Return the name and the unit of a heading such as x_mm, "x, mm", x [mm] or roll_deg; no unit is ""."""
    parts = [part for part in re.split(r"[\s,_()/\[\]]+", head.strip().lower()) if part]
    return (
        ("_".join(parts[:-1]), parts[-1])
        if len(parts) > 1 and parts[-1] in (*LENGTHS, *ANGLES)
        else (
            "_".join(parts),
            "",
        )
    )
