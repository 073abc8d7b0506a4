"""Tables of numbers: a CSV file with one thing a row, its columns by name in any order, read a block at a time."""

from __future__ import annotations

import csv
import hashlib
import io
import re
import sys
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from itertools import islice
from pathlib import Path
from typing import Any, BinaryIO, ClassVar

import numpy as np
import numpy.typing as npt

from pieper import InputError
from pieper.cli import pipes
from pieper.cli.arguments import number
from pieper.cli.decimal_sign import DecimalSign
from pieper.cli.output import plural
from pieper.cli.units import ANGLES, LENGTHS, Units

#: Rows that are read, worked on and written at once. A pose of some arms takes 2 ms: a run is stopped within a few
#: seconds, and its progress seen; larger blocks are no faster.
BLOCK = 2_000


@dataclass(frozen=True)
class Place:
    """How much of a table was read.

    Args:
        lines: How many lines; 0 for none.
        sha256: The checksum of them all.
    """

    lines: int = 0
    sha256: str = ""


@dataclass(frozen=True, eq=False)
class Form:
    """How the lines of a file are cut: which columns to take, in which order, and what their numbers are times."""

    delimiter: str
    width: int
    pick: list[int]
    factors: npt.NDArray[np.float64]


@dataclass
class NumberTable(ABC):
    """A table with one thing a row.

    Args:
        name: Its place.
        units: Of columns whose name says none.

    Attributes:
        size: Its bytes.
        unused: Columns that say nothing about the thing; known when reading has begun.
    """

    name: str
    units: Units
    size: int = field(init=False)
    unused: tuple[str, ...] = field(default=(), init=False)
    _read: int = field(default=0, init=False)
    _checksum: Any = field(default_factory=hashlib.sha256, init=False)
    _sign: DecimalSign = field(init=False)
    _twice: set[str] = field(default_factory=set[str], init=False)
    #: What a row is.
    thing: ClassVar[str]

    def __post_init__(self) -> None:
        self._sign = DecimalSign(self.name)
        self.size = max(1, Path(self.name).stat().st_size) if Path(self.name).exists() else 1

    @abstractmethod
    def columns(self, heads: list[str]) -> tuple[list[int], npt.NDArray[np.float64]]:
        """Return which of the named columns to take in which order, and what makes their numbers the units said."""

    @abstractmethod
    def made(self, values: npt.NDArray[np.float64], what: str) -> npt.NDArray[np.float64]:
        """Return the things (k, ...) of rows (k, columns taken)."""

    def blocks(
        self, read: Callable[[int], None] = lambda _: None, after: Place | None = None
    ) -> Iterator[npt.NDArray[np.float64]]:
        """Yield the things, some thousands at a time.

        Args:
            read: Told how many bytes were read since it was last told.
            after: Where an earlier reading of the same table was; what comes after it is yielded.

        Raises:
            InputError: The file cannot be read, a column is missing, or a row is not such a thing; the line is named.
                Or it is not the table of the earlier reading.
        """
        with opened(self.name, self.thing) as file:
            lines = self._lines(file, read)
            first = next(lines, None)
            if first is None:
                raise InputError(f"{self.name} holds no {self.thing}.", path=self.name)
            _, line = first
            delimiter = delimiter_of(line)
            cells = cells_of(line, delimiter)
            named = has_names(cells)
            pick, factors = self.columns(cells) if named else (list(range(len(cells))), np.ones(len(cells)))
            got = bool(after and after.lines)
            lines = lines if named or got else _chained(first, lines)
            form = Form(delimiter, len(cells), pick, factors)
            if after and got:
                self._skip(lines, after)
            while block := list(islice(lines, BLOCK)):
                got = True
                yield self._block(block, form)
            if not got:
                raise InputError(f"{self.name} has names of columns, but no {self.thing} beneath them.", path=self.name)

    @property
    def place(self) -> Place:
        """How much of the table was read."""
        return Place(self._read, self._checksum.hexdigest())

    def _skip(self, lines: Iterator[tuple[int, str]], after: Place) -> None:
        """Read on to where an earlier reading was, and hold that it read the same."""
        while self._read < after.lines and next(lines, None) is not None:
            pass
        if self.place != after:
            raise InputError(
                f"{self.name} is not what the stopped run read: something up to line {after.lines:,} is another.",
                path=self.name,
                read_before=after.lines,
            )

    def _lines(self, file: BinaryIO, read: Callable[[int], None]) -> Iterator[tuple[int, str]]:
        self._checksum = hashlib.sha256()
        for at, raw in enumerate(file, 1):
            read(len(raw))
            self._checksum.update(raw)
            self._read = at
            if text := text_of(raw, self.name, self.thing):
                yield at, text

    def _block(self, block: list[tuple[int, str]], form: Form) -> npt.NDArray[np.float64]:
        """Return the things (k, ...) of lines: all at once, or, where that fails, one by one to say which is wrong."""
        if form.delimiter in ";\t":
            block = [(at, self._with_points(at, line, form)) for at, line in block]
        try:
            mark = None if form.delimiter == " " else form.delimiter
            if any((line.count(mark) + 1 if mark else len(line.split())) != form.width for _, line in block):
                raise ValueError
            lines = [line for _, line in block]
            values = np.loadtxt(lines, delimiter=mark, comments=None, usecols=form.pick, ndmin=2)
            if not np.isfinite(values).all():
                raise ValueError
            return self.made(values * form.factors, self.name)
        except ValueError:
            return np.array([self._one(at, line, form) for at, line in block])

    def _with_points(self, at: int, line: str, form: Form) -> str:
        if self._sign.unsure(line):
            cells = cells_of(line, form.delimiter)
            self._sign.look(at, [cells[j] for j in form.pick if j < len(cells)])
        return self._sign.with_points(line)

    def _one(self, at: int, line: str, form: Form) -> npt.NDArray[np.float64]:
        cells = cells_of(line, form.delimiter)
        what = f"{self.name}, line {at}"
        if len(cells) != form.width:
            said = f"{what}: {plural(len(cells), 'cell')} where the first line has {form.width}."
            raise InputError(said, path=self.name, line=at)
        values = np.array([number(cells[j], what) for j in form.pick])
        return self.made(values[None] * form.factors, what)[0]

    def known(self, heads: list[str]) -> dict[str, tuple[int, str]]:
        """Return name -> (column, unit) of the headings of a table."""
        known: dict[str, tuple[int, str]] = {}
        for j, head in enumerate(heads):
            name, unit = name_and_unit(head)
            if name in known:
                self._twice.add(name)
            known.setdefault(name, (j, unit))
        return known

    def factor(self, name: str, unit: str, kind: str) -> float:
        """Return the factor that takes a column's numbers, "length", "angle" or neither, into the units said."""
        if name in self._twice:
            raise InputError(f"{self.name}: the column {name} stands there twice.", path=self.name)
        said = {"angle": self.units.radians, "length": self.units.metres}
        sizes = {"length": LENGTHS, "angle": ANGLES}.get(kind, {})
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


#: How many lines, and bytes of standard input, say what kind of file it is.
LOOKED_AT, PEEKED_AT = 20, 1 << 16


def opened(name: str, thing: str) -> BinaryIO:
    """Return a file to read from, standard input for "-", or refuse it by name."""
    try:
        return pipes.opened(name)
    except OSError as error:
        raise InputError(f"{thing}: cannot read {name}: {error.strerror}.", path=name) from None


def first_lines(name: str, thing: str) -> list[str]:
    """Return the first lines of a file without their comments; standard input stays to be read."""
    if name == "-":
        given = sys.stdin.buffer if isinstance(sys.stdin, io.TextIOWrapper) else None
        raw = given.peek(PEEKED_AT).splitlines(keepends=True) if isinstance(given, io.BufferedReader) else []
        # the last one may go on
        raw = raw[:LOOKED_AT] if len(raw) < 2 or raw[-1].endswith(b"\n") else raw[:-1][:LOOKED_AT]
    else:
        try:
            raw = pipes.looked_at(name, LOOKED_AT)
        except OSError as error:
            raise InputError(f"{thing}: cannot read {name}: {error.strerror}.", path=name) from None
    return [text_of(line, name, thing) for line in raw]


def refuse_same(name: str, csv: str) -> None:
    """Refuse to write the answer over the table that is read.

    Raises:
        InputError: They are one file.
    """
    if csv and Path(csv).exists() and name != "-" and Path(csv).samefile(name):
        raise InputError(f"--csv {csv} would write over the table it reads; give another name.", given=csv)


def text_of(raw: bytes, name: str, thing: str) -> str:
    """Return a line without its comment."""
    try:
        return raw.decode("utf-8-sig").split("#")[0].strip()
    except UnicodeDecodeError:
        raise InputError(f"{thing}: {name} is not a text file.", path=name) from None


def delimiter_of(line: str) -> str:
    """Return what parts the cells of a line: semicolons or tabs, beside which a comma stands before decimals."""
    return max(";\t", key=line.count) if ";" in line or "\t" in line else "," if "," in line else " "


def cells_of(line: str, delimiter: str) -> list[str]:
    """Return the cells of a line."""
    if delimiter == " ":
        return line.split()
    return [cell.strip() for cell in next(csv.reader([line], delimiter=delimiter))]


def has_names(cells: list[str]) -> bool:
    """Return whether a line holds names of columns: a word that is no number, infinity or expression."""
    words = [cell.lower() for cell in cells if re.fullmatch(r"[A-Za-z_]\w*(?:[, (/\[]+\w+[)\]]?)?", cell)]
    return any(word not in ("nan", "inf", "pi") for word in words)


def name_and_unit(head: str) -> tuple[str, str]:
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
