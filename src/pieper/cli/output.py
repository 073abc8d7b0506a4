"""What commands print: numbers with sensible digits, joint vectors and poses with their units, JSON for machines."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

import pieper
from pieper.cli.layout import Column, sentences, table, terminal_width

if TYPE_CHECKING:
    from pieper.cli.units import Units


def say(text: str) -> None:
    """Print sentences, their lines broken to the terminal's width."""
    print(sentences(text, terminal_width()))


def print_table(
    title: str, columns: Sequence[Column], rows: Sequence[Sequence[str]], *, strong: int | None = None
) -> None:
    """Print a table that fits the terminal, and an empty line."""
    print(table(title, columns, rows, terminal_width(), strong=strong) + "\n")


def number(value: float, digits: int = 3) -> str:
    """Return a number with fixed digits and no negative zero."""
    if not math.isfinite(value):
        return "∞" if value > 0 else "-∞"
    return f"{float(value):z.{digits}f}"


def short(value: float, digits: int = 4) -> str:
    """Return a number with at most so many digits after the point and no zeros at its end."""
    text = number(value, digits)
    return text.rstrip("0").rstrip(".") if "." in text else text


def small(value: float, unit: str) -> str:
    """Return a residual: scientific with its unit, zero as 0."""
    return f"0 {unit}" if value == 0 else f"{value:.1e} {unit}"


def plural(count: int, word: str, many: str = "") -> str:
    """Return a count and its noun: 1 solution, 2 solutions."""
    return f"{count:,} {word if count == 1 else many or word + 's'}"


def as_json(value: Any, *, indent: int | None = 2) -> None:
    """Print a value as JSON; arrays become lists, infinities null."""
    print(json_text(value, indent=indent))


def json_text(value: Any, *, indent: int | None = 2) -> str:
    """Return a value as JSON; arrays become lists, infinities null."""
    import json

    return json.dumps(_plain(value), indent=indent, ensure_ascii=False, allow_nan=False)


def _plain(value: Any) -> Any:
    if isinstance(value, dict):
        return {str(k): _plain(v) for k, v in value.items()}
    if isinstance(value, np.ndarray):
        return _plain(value.tolist())
    if isinstance(value, (list, tuple)):
        return [_plain(v) for v in value]
    if isinstance(value, np.generic):
        return _plain(value.item())
    if isinstance(value, float):
        return None if not math.isfinite(value) else value + 0.0
    return value


def print_position(T: npt.NDArray[np.float64], units: Units) -> None:
    """Print the position of a pose."""
    digits = 3 if units.length == "mm" else 6
    say(f"position {', '.join(number(v / units.metres, digits) for v in T[:3, 3])} {units.length}")


def print_pose(T: npt.NDArray[np.float64], units: Units, title: str) -> None:
    """Print a pose as its matrix, position, and roll, pitch, yaw."""
    digits = 3 if units.length == "mm" else 6
    rows = [[*(number(v, 6) for v in row[:3]), number(row[3] / units.metres, digits)] for row in T[:3]]
    columns = [Column("n"), Column("o"), Column("a"), Column(f"p, {units.length}")]
    print(table(title, columns, rows, terminal_width()))
    angles = pieper.read_pose(T, "rpy")[3:]
    turned = ", ".join(number(v / units.radians, 4) for v in angles)
    print_position(T, units)
    say(f"roll, pitch, yaw {turned} {units.angle} about the fixed x, y, z\n")


def joint_columns(arm: pieper.Arm, units: Units) -> list[Column]:
    """Return the headings of joint columns, each with its unit; q3 stands for a name that ends in its number, 3."""
    plain = [f"q{i}" if _number_at_end(name) == str(i) else name for i, name in enumerate(arm.joint_names, 1)]
    return [Column(f"{name}, {unit}") for name, unit in zip(plain, units.names_of_joints(arm), strict=True)]


def _number_at_end(name: str) -> str:
    return name[len(name.rstrip("0123456789")) :]


def joint_cells(arm: pieper.Arm, q: npt.NDArray[np.float64], units: Units) -> list[str]:
    """Return a joint vector (n,) as cells in the units asked for."""
    return [
        number(value / unit, 3 if name in ("deg", "mm") else 6)
        for value, unit, name in zip(q, units.of_joints(arm), units.names_of_joints(arm), strict=True)
    ]


def si_units(arm: pieper.Arm) -> list[str]:
    """Return the SI unit of each joint, for machines."""
    return ["rad" if kind == "R" else "m" for kind in arm.joint_types]
