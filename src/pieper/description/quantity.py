"""Numbers of a robot file: the unit stands in the key, and a value may be an expression such as "pi/2"."""

from __future__ import annotations

import math
import re

from pieper import arguments
from pieper.errors import InputError

#: unit -> (kind, reading: number in the unit -> SI, writing: SI -> number in the unit)
UNITS = {
    "deg": ("angle", math.radians, math.degrees),
    "rad": ("angle", float, float),
    "mm": ("length", lambda value: value / 1000.0, lambda value: value * 1000.0),
    "m": ("length", float, float),
}
UNITS_OF = {"angle": ("deg", "rad"), "length": ("mm", "m")}

_TOKEN = re.compile(r"\s*(?:(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)|(pi|sqrt)\b|([-+*/()]))")
_LONGEST_EXPRESSION = 80


class ExpressionError(InputError):
    """An expression is not one of numbers, pi, sqrt( ), + - * / and parentheses."""


def evaluate(text: str) -> float:
    """Return the value of an expression of numbers, pi, sqrt( ), + - * / and parentheses.

    Args:
        text: For example "pi/2", "-3*pi/4", "sqrt(2)/2".

    Returns:
        Its value, finite.

    Raises:
        ExpressionError: Anything else, said in one sentence.
    """
    if not isinstance(text, str):
        raise ExpressionError(f'an expression must be a text such as "pi/2", got {arguments.kind_of(text)}.')
    if len(text) > _LONGEST_EXPRESSION:
        raise ExpressionError(f"the expression has {len(text)} characters, at most {_LONGEST_EXPRESSION} are read.")
    tokens, position = [], 0
    stripped = text.rstrip()
    while position < len(stripped):
        match = _TOKEN.match(stripped, position)
        if match is None:
            raise ExpressionError(f"{stripped[position:].strip()!r} is not understood.")
        tokens.append(match.group().strip())
        position = match.end()
    if not tokens:
        raise ExpressionError("the expression is empty.")
    parser = _Parser(tokens)
    try:
        value = parser.sum()
    except ZeroDivisionError:
        raise ExpressionError("it divides by zero.") from None
    except ValueError as error:
        raise error if isinstance(error, ExpressionError) else ExpressionError(str(error)) from None
    if parser.rest():
        raise ExpressionError(f"{parser.rest()[0]!r} stands where the expression should end.")
    if not math.isfinite(value):
        raise ExpressionError("its value is not finite.")
    return value


class _Parser:
    """Recursive descent over the tokens: sum of products of signed atoms."""

    def __init__(self, tokens: list[str]) -> None:
        self._tokens = tokens
        self._at = 0

    def rest(self) -> list[str]:
        return self._tokens[self._at :]

    def _take(self, *wanted: str) -> str | None:
        if self._at < len(self._tokens) and self._tokens[self._at] in wanted:
            self._at += 1
            return self._tokens[self._at - 1]
        return None

    def sum(self) -> float:
        value = self.product()
        while sign := self._take("+", "-"):
            term = self.product()
            value = value + term if sign == "+" else value - term
        return value

    def product(self) -> float:
        value = self.signed()
        while sign := self._take("*", "/"):
            factor = self.signed()
            value = value * factor if sign == "*" else value / factor
        return value

    def signed(self) -> float:
        if self._take("-"):
            return -self.signed()
        if self._take("+"):
            return self.signed()
        return self.atom()

    def atom(self) -> float:
        if self._take("pi"):
            return math.pi
        root = self._take("sqrt")
        if self._take("("):
            value = self.sum()
            if not self._take(")"):
                raise ExpressionError("a closing parenthesis is missing.")
            if root and value < 0:
                raise ExpressionError("it takes the square root of a negative number.")
            return math.sqrt(value) if root else value
        if root:
            raise ExpressionError("sqrt needs parentheses, as in sqrt(2).")
        if self._at >= len(self._tokens):
            raise ExpressionError("it ends too early.")
        token = self._tokens[self._at]
        if token in ("+", "-", "*", "/", ")"):
            raise ExpressionError(f"{token!r} stands where a number should be.")
        self._at += 1
        return float(token)


def same_bits(x: float, y: float) -> bool:
    """Return whether two numbers are the same double, 0.0 and -0.0 told apart, NaN equal to NaN."""
    return (x == y and math.copysign(1, x) == math.copysign(1, y)) or (math.isnan(x) and math.isnan(y))


def in_unit(value: float, unit: str) -> float | int | None:
    """Return the shortest number that reads back as exactly this double in the unit, or None if there is none.

    Args:
        value: rad or m.
        unit: A key of `UNITS`.

    Returns:
        A number of at most ten decimals in a derived unit, the double itself in an SI unit.
    """
    _, read, write = UNITS[unit]
    if not math.isfinite(value):
        return value
    if unit in ("rad", "m"):
        return _plain(value)
    rough = write(value)
    if not math.isfinite(rough):
        return None
    for decimals in range(11):
        short = round(rough, decimals)
        if same_bits(read(short), value):
            return _plain(short)
    return None


def best_unit(values: list[float], kind: str) -> str:
    """Return the unit people choose (deg, mm) if every value can be said in it exactly, else the SI unit."""
    friendly, exact = UNITS_OF[kind]
    return friendly if all(in_unit(value, friendly) is not None for value in values) else exact


def _plain(value: float) -> float | int:
    """Return whole numbers as int (they print without a point), everything else unchanged."""
    whole = value == int(value) and abs(value) < 10**9 and math.copysign(1, value) == (1 if value >= 0 else -1)
    return int(value) if whole else value
