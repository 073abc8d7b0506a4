"""Commas before decimals, which many countries write between semicolons or tabs; what may be thousands is refused."""

from __future__ import annotations

import re
import warnings
from dataclasses import dataclass

from pieper import InputError, PieperWarning
from pieper.cli.arguments import with_points


@dataclass
class DecimalSign:
    """Which sign stands before the decimals of a table whose cells are apart by semicolons or tabs.

    Args:
        name: The table's place.

    Attributes:
        sign: "." or ","; None until a number has one.
    """

    name: str
    sign: str | None = None

    def unsure(self, line: str) -> bool:
        """Return whether the numbers of a line are to be looked at."""
        return self.sign is None or (("," if self.sign == "." else ".") in line)

    def look(self, at: int, cells: list[str]) -> None:
        """Take the sign from the numbers of a line.

        Raises:
            InputError: One has the comma and one the point, so that one of them may stand between thousands.
        """
        for cell in cells:
            signs = {sign for sign in ".," if re.search(rf"\d[{sign}]\d", cell)}
            if len(signs) == 2 or (signs and self.sign is not None and self.sign not in signs):
                raise InputError(
                    f"{self.name}, line {at}: {cell!r}: nobody can tell whether the comma or the point stands before "
                    "decimals here. Write the numbers of the file in one way, with nothing between thousands.",
                    path=self.name,
                    line=at,
                )
            if signs and self.sign is None:
                self.sign = signs.pop()
                if self.sign == "," and re.fullmatch(r"[+-]?\d{1,3},\d{3}", cell):
                    said = f"{self.name}: commas stand before decimals: {cell} is {with_points(cell)}."
                    warnings.warn(said, PieperWarning, stacklevel=2)

    def with_points(self, text: str) -> str:
        """Return text with points before its decimals."""
        return with_points(text) if self.sign == "," else text
