"""Exact numbers behind floats: 0.21 is 21/100, 1.5707963267948966 is pi/2, as far as rounding allows to say so."""

from __future__ import annotations

import math
from collections.abc import Sequence
from decimal import Decimal
from fractions import Fraction

from pieper.tolerances import EXACT_DEGREES


def rational(value: float) -> Fraction:
    """The decimal that a person wrote for this float.

    A float is read as its 12-digit rounding where the two differ by rounding only (4 units in the last place, which
    covers a conversion from millimetres); otherwise as the shortest decimal that gives the same float.
    """
    value = float(value)
    if value == 0:
        return Fraction(0)
    short = float(f"{value:.12g}")
    if abs(short - value) <= 4 * math.ulp(value):
        return Fraction(Decimal(f"{value:.12g}"))
    return Fraction(Decimal(repr(value)))


def pi_fraction(angle: float) -> Fraction | None:
    """The angle as a multiple of pi, when it is a whole number of thousandths of a degree within rounding."""
    degrees = math.degrees(float(angle))
    nearest = Fraction(round(degrees * 1000), 1000)
    if abs(degrees - float(nearest)) <= EXACT_DEGREES * max(1.0, abs(degrees)):
        return nearest / 180
    return None


def quarter_turns(angle: float) -> int | None:
    """How many quarter turns (0 to 3) the angle is, or None when it is not a whole number of them."""
    multiple = pi_fraction(angle)
    if multiple is None or (2 * multiple).denominator != 1:
        return None
    return int(2 * multiple) % 4


def decimal_text(value: Fraction, digits: int = 9) -> str | None:
    """The number as a terminating decimal of at most `digits` places, or None when it is not one."""
    scaled = value * 10**digits
    if scaled.denominator != 1:
        return None
    text = f"{Decimal(scaled.numerator) / Decimal(10**digits):f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def exact_inverse(matrix: Sequence[Sequence[float]]) -> tuple[tuple[Fraction, ...], ...]:
    """The inverse of a regular matrix of decimals, as fractions (Gauss and Jordan)."""
    n = len(matrix)
    rows = [[rational(x) for x in row] + [Fraction(int(i == j)) for j in range(n)] for i, row in enumerate(matrix)]
    for i in range(n):
        best = max(range(i, n), key=lambda r: abs(rows[r][i]))
        rows[i], rows[best] = rows[best], rows[i]
        rows[i] = [x / rows[i][i] for x in rows[i]]
        for r in range(n):
            if r != i and rows[r][i]:
                rows[r] = [x - rows[r][i] * y for x, y in zip(rows[r], rows[i], strict=True)]
    return tuple(tuple(row[n:]) for row in rows)
