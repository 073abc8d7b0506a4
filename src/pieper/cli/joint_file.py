"""Tables of joint vectors: a CSV file with one a row, its columns by the joints' names or in their order."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import ClassVar

import numpy as np
import numpy.typing as npt

import pieper
from pieper import InputError
from pieper.cli.number_table import NumberTable, first_lines, has_names, name_and_unit
from pieper.cli.output import plural


def is_table(word: str, arm: pieper.Arm) -> bool:
    """Return whether typed joints name a table of joint vectors: @file or @-, several lines of one each, or named."""
    if not word.startswith("@"):
        return False
    if word.lower().endswith((".csv", ".tsv")):
        return True
    lines = [line for line in first_lines(word[1:], "joints") if line]
    rows = [[cell for cell in re.split(r"[,;\t]\s*|\s+", line) if cell] for line in lines]
    return len(rows) > 1 and (has_names(rows[0]) or all(len(row) == arm.n > 1 for row in rows))


@dataclass
class JointFile(NumberTable):
    """A table of joint vectors, (k, n) in rad or m.

    Args:
        name: Its place.
        units: Of columns whose name says none.
        arm: Whose joints they are.
    """

    arm: pieper.Arm = field(kw_only=True)
    thing: ClassVar[str] = "joint vector"

    def columns(self, heads: list[str]) -> tuple[list[int], npt.NDArray[np.float64]]:
        """Return the columns of the joints, by their names or as q1, q2, ..., and the factors of their units."""
        known, arm = self.known(heads), self.arm
        ways = [
            [name_and_unit(joint)[0] for joint in arm.joint_names],
            [f"q{i + 1}" for i in range(arm.n)],
            [f"joint_{i + 1}" for i in range(arm.n)],
        ]
        names = max(ways, key=lambda way: sum(name in known for name in way))
        missing = [name for name in names if name not in known]
        if missing:
            raise InputError(
                f"{self.name}: there is no column {' or '.join(missing)}; it has {', '.join(heads)}. {arm.name} has "
                f"the joints {', '.join(arm.joint_names)}, with their unit (_deg, _mm) or as q1, q2 ...",
                path=self.name,
                missing=missing,
            )
        kinds = ["angle" if kind == "R" else "length" for kind in arm.joint_types]
        self.unused = tuple(heads[j] for name, (j, _) in known.items() if name not in names)
        factors = [self.factor(name, known[name][1], kind) for name, kind in zip(names, kinds, strict=True)]
        return [known[name][0] for name in names], np.array(factors)

    def made(self, values: npt.NDArray[np.float64], what: str) -> npt.NDArray[np.float64]:
        """Return the joint vectors (k, n) of rows."""
        if values.shape[1] != self.arm.n:
            raise InputError(
                f"{what}: {self.arm.name} has {plural(self.arm.n, 'joint')} ({self.units.said_of_joints(self.arm)}), "
                f"got {plural(values.shape[1], 'number')} a row.",
                path=self.name,
            )
        return values * self.units.of_joints(self.arm)
