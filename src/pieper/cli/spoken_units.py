"""Sentences of the library in the units a command speaks: they say degrees and millimetres beside each number."""

from __future__ import annotations

import math
import re

from pieper.cli.units import Units

#: Significant digits of a number told anew, where it was told with fewer: a degree is sixty times less than a radian.
LEAST = 4
_NUMBER = r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?"
#: One number, "a to b", "between a and b" or "(a, b, c)", and the unit behind it.
_SIZE = re.compile(
    rf"(?P<of>\({_NUMBER}(?:, {_NUMBER})+\)|between {_NUMBER} and {_NUMBER}|{_NUMBER}(?: to {_NUMBER})?)"
    r" (?P<unit>deg|degrees?|mm)(?![\w²³])(?! of freedom)"
)
_ALONE = re.compile(_NUMBER)


def in_units(text: str, units: Units) -> str:
    """Return sentences with every angle and length that has its unit beside it in the units said."""

    def told(found: re.Match[str]) -> str:
        length = found["unit"] == "mm"
        said, unit = (units.metres * 1000.0, units.length) if length else (units.radians * 180 / math.pi, units.angle)
        if said == 1.0:
            return found[0]
        return f"{_ALONE.sub(lambda number: _shifted(number[0], said), found['of'])} {unit}"

    return _SIZE.sub(told, text)


def _shifted(number: str, by: float) -> str:
    """Return a number divided, with as many digits as it was told with, or `LEAST`."""
    digits = len(re.sub(r"e.*|\D", "", number).lstrip("0"))
    return f"{float(number) / by:.{max(digits, LEAST)}g}"
