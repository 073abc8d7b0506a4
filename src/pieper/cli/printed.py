"""What commands print: tables for people, JSON for machines, numbers with units and sensible digits."""

from __future__ import annotations

import json
import sys
from typing import TYPE_CHECKING, Any

import numpy as np

from pieper.kinematics.orientation import rpy_of

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

    from pieper.arm import Arm
    from pieper.cli.given import Units


#: Columns that the table of solutions of a six-joint arm needs.
NARROWEST = 124


def console() -> Console:
    """Return a console for standard output, never so narrow that numbers would be cut off."""
    import shutil

    from rich.console import Console

    width = shutil.get_terminal_size().columns if sys.stdout.isatty() else 160
    return Console(width=max(width, NARROWEST), highlight=False, soft_wrap=False)


def table(title: str, *columns: str, left: tuple[int, ...] = ()) -> Table:
    """Return an empty table whose columns are right-aligned but those named by number in `left`."""
    from rich import box
    from rich.table import Table

    made = Table(title=title, box=box.SIMPLE_HEAD, title_justify="left", title_style="bold", pad_edge=False)
    for i, column in enumerate(columns):
        made.add_column(column, justify="left" if i in left else "right", no_wrap=i not in left)
    return made


def number(value: float, digits: int = 3) -> str:
    """Return a number with fixed digits and no negative zero."""
    if not np.isfinite(value):
        return "∞" if value > 0 else "-∞"
    return f"{round(float(value), digits) + 0.0:.{digits}f}"


def small(value: float, unit: str) -> str:
    """Return a residual: scientific with its unit, zero as 0."""
    return f"0 {unit}" if value == 0 else f"{value:.1e} {unit}"


def as_json(value: Any) -> None:
    """Print a value as JSON; arrays become lists, infinities null."""
    print(json.dumps(_plain(value), indent=2, ensure_ascii=False, allow_nan=False))


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
        return None if not np.isfinite(value) else value + 0.0
    return value


def pose_table(T: np.ndarray, units: Units, title: str) -> Table:
    """Return a pose as its matrix, position and roll, pitch, yaw."""
    made = table(title, "n", "o", "a", f"p, {units.length}", "", "", left=(4, 5))
    roll, pitch, yaw = (v / units.radians for v in rpy_of(T[:3, :3]))
    digits = 3 if units.length == "mm" else 6
    words = (
        ("position", ", ".join(number(v / units.metres, digits) for v in T[:3, 3]) + f" {units.length}"),
        ("roll, pitch, yaw", ", ".join(number(v, 4) for v in (roll, pitch, yaw)) + f" {units.angle}"),
        ("", "about the fixed x, y, z"),
    )
    for row, (name, text) in zip(T[:3], words, strict=True):
        made.add_row(*(number(v, 6) for v in row[:3]), number(row[3] / units.metres, digits), f"   {name}", text)
    return made


def joint_columns(arm: Arm, units: Units) -> list[str]:
    """Return the headings of joint columns, each with its unit."""
    plain = [f"q{i + 1}" if name == f"joint_{i + 1}" else name for i, name in enumerate(arm.joint_names)]
    return [f"{name}, {unit}" for name, unit in zip(plain, units.names_of_joints(arm), strict=True)]


def joint_cells(arm: Arm, q: np.ndarray, units: Units) -> list[str]:
    """Return a joint vector (n,) as cells in the units asked for."""
    return [
        number(value / unit, 3 if name in ("deg", "mm") else 6)
        for value, unit, name in zip(q, units.of_joints(arm), units.names_of_joints(arm), strict=True)
    ]


def rpy_text(T: np.ndarray) -> list[float]:
    """Return roll, pitch, yaw of a pose, rad."""
    return [float(v) for v in rpy_of(T[:3, :3])]
