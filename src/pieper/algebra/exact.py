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


PLACES = 9  # of a decimal that reads better than a fraction
LONG = 10**6  # a denominator that nobody reads as a fraction
MOST_PLACES = 30  # of the shortest decimal of a float


def decimal_text(value: Fraction) -> str | None:
    """The number as a terminating decimal, or None when it is not one, or reads better as a fraction."""
    digits = MOST_PLACES if value.denominator > LONG else PLACES
    scaled = value * 10**digits
    if scaled.denominator != 1:
        return None
    whole, rest = divmod(abs(scaled.numerator), 10**digits)
    text = f"{rest:0{digits}d}".rstrip("0")
    return ("-" if value < 0 else "") + f"{whole}" + (f".{text}" if text else "")


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
