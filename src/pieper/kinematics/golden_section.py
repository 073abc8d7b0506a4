"""Where a function of one number is least: a golden section, for functions that cost more than its steps."""

from __future__ import annotations

from collections.abc import Callable

#: The golden section, of the interval.
PART = 0.618


def least_at(function: Callable[[float], float], low: float, high: float, steps: int) -> float:
    """Return where a function with one valley between low and high is least, to 0.618^steps of the interval."""
    for _ in range(steps):
        a, b = high - PART * (high - low), low + PART * (high - low)
        if function(a) < function(b):
            high = b
        else:
            low = a
    return (low + high) / 2
