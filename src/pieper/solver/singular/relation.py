"""What holds between two joints that move together, in words."""

from __future__ import annotations

import math

from pieper.tolerances import SAID_AS_ZERO


def related(names: tuple[str, ...], pair: tuple[int, int], sign: float, total: float, *, slides: bool) -> str:
    """Say that two joints add up, or keep their difference, as in 'joint_4 + joint_6 = 30 deg'.

    Args:
        names: Names of all joints.
        pair: The two, 0-based.
        sign: Above 0 where they add up, below where the second is taken from the first.
        total: What that comes to, rad or m.
        slides: Whether they slide.
    """
    i, j = pair
    value, unit = (1e3 * total, "mm") if slides else (math.degrees(total), "deg")
    return f"{names[i]} {'+' if sign > 0 else '-'} {names[j]} = {said(value, unit)}"


def said(value: float, unit: str) -> str:
    """Say a number of degrees or millimetres to six digits, rounding as 0."""
    return f"{0.0 if abs(value) < SAID_AS_ZERO else value:.6g} {unit}"
