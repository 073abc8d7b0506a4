"""What the page may say to a session: the shape of every message, checked before anything is done with it."""

from __future__ import annotations

import json
import math
import threading
from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

from pieper.tolerances import LARGEST_NUMBER

MAX_BYTES = 256 * 1024
MAX_JOINTS = 30
MAX_POINTS = 2_000
MAX_POSTURES = 40
MAX_CLOUD = 200_000
LONGEST_NAME = 80


class Refused(Exception):
    """A message that is turned down; its text is the reason, for the person who reads the page."""


def parse(text: str) -> dict[str, Any]:
    """Return a message as a dict with a known `op` and an integer `seq`, or refuse it.

    Args:
        text: One WebSocket text frame.
    """
    if len(text) > MAX_BYTES:
        raise Refused(f"The message has {len(text)} characters; at most {MAX_BYTES} are taken.")
    try:
        message = json.loads(text, parse_constant=_no_constant)
    except (ValueError, RecursionError) as error:
        raise Refused(f"The message is not JSON: {str(error)[:120]}.") from None
    if not isinstance(message, dict):
        raise Refused("A message is a JSON object with the keys op and seq.")
    seq = message.get("seq")
    if isinstance(seq, bool) or not isinstance(seq, int) or not 0 <= seq < 2**53:
        raise Refused("seq must be a whole number from 0 on.")
    if not isinstance(message.get("op"), str):
        raise Refused("op must be a word.")
    return message


def _no_constant(word: str) -> None:
    raise Refused(f"{word} is not a finite number.")


def number(value: object, what: str, *, largest: float = LARGEST_NUMBER) -> float:
    """Return a finite number of sane size."""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise Refused(f"{what} must be a number.")
    try:
        out = float(value)
    except OverflowError:
        raise Refused(f"{what} is too large.") from None
    if not math.isfinite(out) or abs(out) > largest:
        raise Refused(f"{what} must be finite and at most {largest:g}.")
    return out


class Stopped(Exception):
    """The page no longer wants the result."""


def go_on(stop: threading.Event) -> None:
    """Stop here where the page no longer wants the result."""
    if stop.is_set():
        raise Stopped


def whole(value: object, what: str, lowest: int, highest: int) -> int:
    """Return a whole number inside a range."""
    if isinstance(value, bool) or not isinstance(value, int) or not lowest <= value <= highest:
        raise Refused(f"{what} must be a whole number from {lowest} to {highest}.")
    return value


def word(value: object, what: str, allowed: tuple[str, ...] | None = None) -> str:
    """Return a short text, one of the allowed ones where they are given."""
    if not isinstance(value, str) or len(value) > LONGEST_NAME or any(ord(c) < 32 for c in value):
        raise Refused(f"{what} must be a text of at most {LONGEST_NAME} printable characters.")
    if allowed is not None and value not in allowed:
        raise Refused(f"{what} must be one of {', '.join(allowed)}.")
    return value


def vector(value: object, n: int, what: str) -> npt.NDArray[np.float64]:
    """Return n finite numbers."""
    if not isinstance(value, list) or len(value) != n:
        raise Refused(f"{what} must be a list of {n} numbers.")
    return np.array([number(v, f"{what}[{i + 1}]") for i, v in enumerate(value)], dtype=float)


def vectors(value: object, n: int, what: str, most: int) -> npt.NDArray[np.float64]:
    """Return (k, n) finite numbers, k from 1 to `most`."""
    if not isinstance(value, list) or not 1 <= len(value) <= most:
        raise Refused(f"{what} must be a list of 1 to {most} entries.")
    return np.array([vector(row, n, f"{what} {i + 1}") for i, row in enumerate(value)], dtype=float)


def pose(value: object, what: str) -> npt.NDArray[np.float64]:
    """Return 16 numbers, row by row, as a (4, 4) array; whether it is a pose is for the library to say."""
    return vector(value, 16, what).reshape(4, 4)


def optional(check: Callable, value: object, *args: object) -> Any:
    """Return None for null, else what the check returns."""
    return None if value is None else check(value, *args)
