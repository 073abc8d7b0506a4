"""Whether the Jacobian of a six-axis arm keeps a large block wherever one looks at it from: asked of numbers."""

from __future__ import annotations

import itertools
from collections.abc import Callable

import numpy as np

from pieper.algebra.determinant import blocks
from pieper.algebra.harmonic import Poly
from pieper.description.dh import Description
from pieper.kinematics.arrays import Array
from pieper.tolerances import ROUNDING

GENERAL_TWISTS = 3  # with as many that are no quarter turns the determinant has thousands of terms, which take minutes
JOINTS = 6
SMALL = 3  # blocks of up to three by three are written out


def one_long_block(description: Description, numeric: Callable[..., Array], frames: Callable[..., Array]) -> bool:
    """Say whether a determinant neither splits into small blocks nor has a length that anybody reads.

    Args:
        description: The arm.
        numeric: The numeric Jacobian, q (..., n) -> (..., 6, n), at the tool in the base frame.
        frames: Numeric frames, q (..., n) -> (..., n + 2, 4, 4).
    """
    twists = np.array([row.alpha for row in description.rows[: JOINTS - 1]]) / (np.pi / 2)
    general = np.abs(twists - np.round(twists)) > ROUNDING
    if description.n != JOINTS or np.count_nonzero(general) < GENERAL_TWISTS:
        return False
    q = np.random.default_rng(20262).uniform(-np.pi, np.pi, (3, JOINTS))
    J, F = numeric(q), frames(q)
    size = float(np.abs(J).max())
    spins = np.swapaxes(J[:, 3:], 1, 2)
    for k, point in itertools.product(range(1, JOINTS), range(1, JOINTS + 1)):
        arm = F[:, point, :3, 3] - F[:, -1, :3, 3]
        there = J[:, :3] + np.swapaxes(np.cross(spins, arm[:, None]), 1, 2)
        linear = np.swapaxes(F[:, k, :3, :3], -1, -2) @ there
        for turned in range(1, JOINTS):
            angular = np.swapaxes(F[:, turned, :3, :3], -1, -2) @ J[:, 3:]
            stands = np.abs(np.concatenate([linear, angular], axis=1)).max(0) > ROUNDING * size
            parts = blocks([[Poly.number(1) if entry else Poly() for entry in row] for row in stands])
            if parts is None or max(len(columns) for _, columns in parts) <= SMALL:
                return False
    return True
