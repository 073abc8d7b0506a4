"""Values of no special kind at which joints stand while something about the others is decided."""

from __future__ import annotations

import math

import numpy as np

from pieper.kinematics.arrays import Array

#: The golden ratio less one: multiples of it are unlike each other.
GOLDEN = (math.sqrt(5) - 1) / 2


def unlike(count: int, value: float) -> Array:
    """Return values (count,) for joints that are to stand nowhere special, the first at `value`.

    No two alike: equal turns about parallel axes make up for each other.
    """
    return np.asarray(value * (1 + GOLDEN * np.arange(count)), np.float64)


def unlike_parts(count: int, part: float) -> Array:
    """Return parts (count,) of joints' limits at which these stand nowhere special, the first at `part`."""
    return np.asarray((part + GOLDEN * np.arange(count)) % 1.0, np.float64)
