"""Read numbers out of source text that look like thresholds and stand elsewhere than on the pages of tolerances.

A threshold is a number below a thousandth, one written with a negative exponent, one from 1e5 on, or one that misses
1 by less than a thousandth. Factors of units (`x * 1e6`, `x / 1e9`) are none, and more than six digits are a
coefficient.
"""

from __future__ import annotations

import ast
import io
import re
import tokenize
from collections.abc import Iterator

_TEXT = r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"'
_NUMBER = r"(?<![\w.])(?:\d+\.\d*|\.\d+|\d+)(?:[eE][+-]?\d+)?(?![\w.])"


def bare(text: str, suffix: str) -> Iterator[tuple[int, str]]:
    """Yield the line and the spelling of each bare threshold of a Python or C++ file."""
    for line, spelled, before in _python(text) if suffix == ".py" else _cpp(text):
        if is_threshold(spelled) and not (before in ("*", "/") and is_unit(spelled)):
            yield line, spelled


def is_threshold(spelled: str) -> bool:
    """Return whether a number, as it is spelled, looks like a threshold."""
    mantissa, _, exponent = spelled.lower().partition("e")
    if not exponent and "." not in spelled:
        return False
    value = float(spelled)
    if value == 0 or 0 < abs(value - 1) < 0.001:
        return value != 0
    coefficient = len(re.sub(r"\D", "", mantissa).strip("0")) > 6
    return not coefficient and (value < 0.001 or value >= 1e5 or exponent.startswith("-"))


def is_unit(spelled: str) -> bool:
    """Return whether a number is a power of ten up to a thousand million, as units are apart."""
    return spelled in {f"1e{k}" for k in range(1, 10)}


def _python(text: str) -> Iterator[tuple[int, str, str]]:
    before = ""
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.NUMBER and isinstance(ast.literal_eval(token.string), float):
            yield token.start[0], token.string, before
        before = token.string


def _cpp(text: str) -> Iterator[tuple[int, str, str]]:
    code = re.sub(_TEXT, lambda found: re.sub(r"[^\n]", " ", found[0]), text, flags=re.DOTALL)
    for found in re.finditer(_NUMBER, code):
        yield code.count("\n", 0, found.start()) + 1, found[0], code[: found.start()].rstrip()[-1:]
