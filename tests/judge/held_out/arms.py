"""Twenty arms as a reader would type them, with right formulas found by hand; their poses in mpmath."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import mpmath as mp

Row = tuple[str, str, str, int]


@dataclass(frozen=True)
class HeldOutArm:
    """An arm's table with its facts.

    Attributes:
        name: Its name.
        rows: theta, d, a as text and the twist in degrees, one a joint.
        values: Lengths in metres.
        joints: Formulas: the angle or slide, its right formula, the task.
        equations: Equations that hold at every pose.
        entries: Entries of the pose to print, beside the formulas.
        modified: Whether the table is Craig's.
    """

    name: str
    rows: tuple[Row, ...]
    values: dict[str, float]
    joints: tuple[tuple[str, str], ...] = ()
    equations: tuple[str, ...] = ()
    entries: tuple[str, ...] = ("Px", "Py", "Pz", "nx", "oy", "az")
    modified: bool = False
    task: str = ""
    facts: tuple[tuple[str, str], ...] = field(default=())

    @property
    def slides(self) -> tuple[bool, ...]:
        """Which joints slide."""
        return tuple(row[0].find("q") < 0 for row in self.rows)

    def rewritten(self) -> list[Row]:
        """The rows with a and alpha behind the joint, whatever the convention was."""
        if not self.modified:
            return list(self.rows)
        after = [*self.rows[1:], ("", "", "0", 0)]
        return [(row[0], row[1], nxt[2], nxt[3]) for row, nxt in zip(self.rows, after, strict=True)]

    def pose(self, joints: list[Any], lengths: dict[str, Any]) -> Any:
        """The 4 x 4 pose in mpmath at joint values (rad, m)."""
        out = mp.eye(4)
        for k, (theta, d, a, alpha) in enumerate(self.rewritten()):
            turn = quarter(theta) * mp.pi / 2 + (0 if self.slides[k] else joints[k])
            rise = joints[k] if self.slides[k] else (lengths[d] if d != "0" else mp.mpf(0))
            along = lengths[a] if a != "0" else mp.mpf(0)
            c, s, ca, sa = mp.cos(turn), mp.sin(turn), _cos(alpha), _sin(alpha)
            out = out * mp.matrix(
                [[c, -s * ca, s * sa, along * c], [s, c * ca, -c * sa, along * s], [0, sa, ca, rise], [0, 0, 0, 1]]
            )
        return out


def quarter(theta: str) -> int:
    """Quarter turns in a row's angle, "q2 - 90 deg" or "90 deg"."""
    rest = theta.replace(" ", "")
    rest = rest[2:] if rest.startswith("q") else rest
    return int(rest.replace("deg", "").replace("+", "") or 0) // 90


def _cos(alpha: int) -> int:
    return {0: 1, 90: 0, -90: 0, 180: -1}[alpha]


def _sin(alpha: int) -> int:
    return {0: 0, 90: 1, -90: -1, 180: 0}[alpha]


def _read(arm: dict[str, Any]) -> HeldOutArm:
    pairs = {key: tuple((of, text) for of, text in arm.get(key, ())) for key in ("joints", "facts")}
    return HeldOutArm(
        arm["name"],
        tuple(tuple(row) for row in arm["rows"]),
        arm["values"],
        pairs["joints"],
        tuple(arm["equations"]),
        tuple(arm["entries"]),
        arm.get("modified", False),
        arm.get("task", ""),
        pairs["facts"],
    )


ARMS: tuple[HeldOutArm, ...] = tuple(
    _read(arm) for arm in tomllib.loads(Path(__file__).with_name("arms.toml").read_text(encoding="utf-8"))["arm"]
)
