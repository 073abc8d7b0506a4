"""Results as columns: a dictionary, a data frame, an npz or a CSV file, with the unit in every column's name."""

from __future__ import annotations

import io
import math
import os
from collections.abc import Sequence
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from pieper import arguments
from pieper.document.writing import write_whole
from pieper.errors import InputError

#: A column's values: numbers, booleans or words, one a row.
Column = npt.NDArray[Any]


@dataclass(frozen=True)
class Units:
    """In which units columns are written: degrees and millimetres where asked for, radians and metres otherwise."""

    degrees: bool = False
    mm: bool = False

    def joints(
        self, names: Sequence[str], prismatic: npt.NDArray[np.bool_], q: npt.NDArray[np.float64]
    ) -> dict[str, Column]:
        """Return joint vectors (k, n), rad or m, as a column a joint; prismatic (n,) says which slide."""
        return {
            f"{name}_{self._unit(bool(slides))}": q[:, i] * self._factor(bool(slides))
            for i, (name, slides) in enumerate(zip(names, prismatic, strict=True))
        }

    def rates(
        self,
        what: str,
        names: Sequence[str],
        prismatic: npt.NDArray[np.bool_],
        values: npt.NDArray[np.float64],
        order: int,
    ) -> dict[str, Column]:
        """Return derivatives (k, n) by time, of an order, as columns: `dq_joint_1_deg_per_s`, `..._per_s2`."""
        per = "per_s" if order == 1 else f"per_s{order}"
        named = self.joints([f"{what}_{name}" for name in names], prismatic, values)
        return {f"{name}_{per}": column for name, column in named.items()}

    def metres(self, name: str, values: npt.NDArray[np.float64]) -> dict[str, Column]:
        """Return lengths (k,), m, as a column."""
        return {f"{name}_{self._unit(True)}": values * self._factor(True)}

    def radians(self, name: str, values: npt.NDArray[np.float64]) -> dict[str, Column]:
        """Return angles (k,), rad, as a column."""
        return {f"{name}_{self._unit(False)}": values * self._factor(False)}

    def _unit(self, length: bool) -> str:
        return ("mm" if self.mm else "m") if length else ("deg" if self.degrees else "rad")

    def _factor(self, length: bool) -> float:
        return (1e3 if self.mm else 1.0) if length else (math.degrees(1.0) if self.degrees else 1.0)


class Tabular:
    """What can be written as columns of equal length, one row a point, a solution or a sample."""

    __slots__ = ()

    def columns(self, *, degrees: bool = False, mm: bool = False) -> dict[str, Column]:
        """Return the columns by name, the unit in the name; radians and metres unless asked otherwise."""
        raise NotImplementedError

    def to_dict(self, *, degrees: bool = False, mm: bool = False) -> dict[str, list[Any]]:
        """Return the columns as plain lists, which `json.dumps` takes."""
        return {name: values.tolist() for name, values in self.columns(degrees=degrees, mm=mm).items()}

    def to_frame(self, *, degrees: bool = False, mm: bool = False) -> Any:
        """Return the columns as a pandas DataFrame.

        Raises:
            InputError: pandas is not installed.
        """
        try:
            pandas: Any = import_module("pandas")
        except ModuleNotFoundError:
            raise InputError("a data frame needs pandas: pip install pandas. `to_dict` needs nothing.") from None
        return pandas.DataFrame(self.columns(degrees=degrees, mm=mm))

    def save(self, path: str | os.PathLike[str], *, degrees: bool = False, mm: bool = False) -> Path:
        """Write the columns as .npz or .csv, whole or not at all; CSV numbers read back to the last bit.

        Raises:
            InputError: Another ending, or a place that cannot be written.
        """
        target, columns = arguments.file(path), self.columns(degrees=degrees, mm=mm)
        if target.suffix == ".npz":
            content = io.BytesIO()
            np.savez_compressed(content, allow_pickle=False, **columns)
            return write_whole(target, content.getvalue())
        if target.suffix == ".csv":
            return write_whole(target, "".join(_lines(columns)))
        raise InputError(f"{target}: columns are written as .npz or .csv.", given=str(target), allowed=[".npz", ".csv"])


def _lines(columns: dict[str, Column]) -> list[str]:
    cells = [[_cell(value) for value in values.tolist()] for values in columns.values()]
    head = ",".join(_quoted(name) for name in columns)
    return [head + "\n", *(",".join(row) + "\n" for row in zip(*cells, strict=True))]


def _cell(value: object) -> str:
    if isinstance(value, bool):
        return str(int(value))
    return _quoted(value) if isinstance(value, str) else repr(value)


def _quoted(text: str) -> str:
    return '"' + text.replace('"', '""') + '"' if any(c in text for c in ',"\n') else text
