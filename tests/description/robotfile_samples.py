"""What the tests of robot files share: a small file, the examples, and a comparison to the last bit."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import numpy as np

from pieper.description.dh import Description

EXAMPLES = Path(__file__).parents[2] / "examples" / "robots"

TWO_JOINTS = """\
# an arm
name = "two"            # its name
convention = "standard"

[[joints]]
name = "turn"
type = "revolute"
a_mm = 10               # the link
alpha_rad = "pi/2"      # a quarter turn
d_mm = 125
limits_deg = [-170, inf]

[[joints]]
name = "slide"
type = "P"
a_m = 0
alpha_deg = 30
theta_deg = 10
d_mm = 1.5
limits_mm = [0, 300]
"""


def same(one: Description, other: Description) -> bool:
    """Return whether two descriptions agree to the last bit."""
    for field in dataclasses.fields(Description):
        a, b = getattr(one, field.name), getattr(other, field.name)
        if field.name == "checks":
            if len(a) != len(b):
                return False
            for x, y in zip(a, b, strict=True):
                alike = np.array_equal(x.q, y.q) and np.array_equal(x.T, y.T, equal_nan=True)
                if not alike or (x.source, x.tolerance) != (y.source, y.tolerance):
                    return False
        elif field.name == "postures":
            if a.keys() != b.keys() or any(not np.array_equal(a[k], b[k]) for k in a):
                return False
        elif isinstance(a, np.ndarray):
            if not np.array_equal(a, b):
                return False
        elif a != b:
            return False
    return True
