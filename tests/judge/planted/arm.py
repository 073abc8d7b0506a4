"""An arm as a DH table with formulas that are right for it, multiplied out by NumPy alone."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import pi

import numpy as np
import numpy.typing as npt

H = pi / 2


@dataclass(frozen=True)
class Row:
    """One row of a table: which column turns or slides, and what the others are named."""

    kind: str
    a: str
    alpha: float
    d: str
    theta: float = 0.0


@dataclass(frozen=True)
class PlantedArm:
    """An arm, its lengths, and formulas that are right for it.

    Attributes:
        entries: Right formulas of forward kinematics, in Python's notation, by entry.
        joints: Right formulas for joints, as (joint, formula).
    """

    name: str
    convention: str
    rows: tuple[Row, ...]
    lengths: dict[str, float]
    entries: dict[str, str]
    joints: tuple[tuple[int, str], ...] = ()
    task: str = "position"
    where: dict[str, str] = field(default_factory=dict)

    @property
    def n(self) -> int:
        """How many joints."""
        return len(self.rows)

    def pose(self, q: npt.NDArray[np.float64], lengths: dict[str, float] | None = None) -> npt.NDArray[np.float64]:
        """Multiply the table out.

        Args:
            q: Joint values, shape (n,), rad or m.
            lengths: Other lengths than the arm's own, m.

        Returns:
            The pose, shape (4, 4).
        """
        named = self.lengths if lengths is None else lengths
        T = np.eye(4)
        for value, row in zip(q, self.rows, strict=True):
            a = _length(row.a, named)
            d = _length(row.d, named) if row.kind == "R" else float(value)
            theta = row.theta + (float(value) if row.kind == "R" else 0.0)
            Z = _turn(2, theta)
            Z[2, 3] = d
            X = _turn(0, row.alpha)
            X[0, 3] = a
            T = T @ (Z @ X if self.convention == "standard" else X @ Z)
        return T

    def toml(self) -> list[str]:
        """The arm as the head of a claims file."""
        rows: list[str] = []
        for i, row in enumerate(self.rows, start=1):
            theta = _plus(f"q{i}", row.theta) if row.kind == "R" else _angle(row.theta)
            d = f'"b{i}"' if row.kind == "P" else _cell(row.d)
            rows.append(f"[{_cell(row.a)}, {_angle(row.alpha)}, {d}, {theta}]")
        values = ", ".join(f"{name} = {value}" for name, value in self.lengths.items())
        return [
            "[arm]",
            f'name = "{self.name}"',
            f'convention = "{self.convention}"',
            'length_unit = "m"',
            'columns = ["a", "alpha", "d", "theta"]',
            f"rows = [{', '.join(rows)}]",
            f"values = {{ {values} }}",
        ]


def _length(text: str, named: dict[str, float]) -> float:
    if text in ("", "0"):
        return 0.0
    return -named[text[1:]] if text.startswith("-") else named[text]


def _cell(text: str) -> str:
    return "0" if text in ("", "0") else f'"{text}"'


def _angle(value: float) -> str:
    return "0" if value == 0 else f'"{value * 180 / pi:g} deg"'


def _plus(name: str, value: float) -> str:
    return f'"{name}"' if value == 0 else f'"{name} {"+" if value > 0 else "-"} {abs(value) * 180 / pi:g} deg"'


def _turn(axis: int, angle: float) -> npt.NDArray[np.float64]:
    out = np.eye(4)
    i, j = ((1, 2), (2, 0), (0, 1))[axis]
    out[i, i] = out[j, j] = np.cos(angle)
    out[i, j], out[j, i] = -np.sin(angle), np.sin(angle)
    return out
