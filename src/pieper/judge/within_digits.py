"""Printed joints against a pose: does a joint vector that rounds, or is cut off, to the printed one reach it?

Each joint may move by what its own digits leave open and no farther; how far the tool then stays off the pose is found
by Newton steps inside that box, so that every joint counts by its own lever.
"""

from __future__ import annotations

import numpy as np

from pieper.judge.model import ArmModel
from pieper.judge.samples import samples_at

Array = np.ndarray
STEPS = 20  # Newton steps; those that arrive take four, beside a double solution a dozen


def room(printed: list, q: Array, unit: Array) -> Array:
    """How far joints may lie below and above their printed values, (n, 2): half a unit, cut off one away from zero.

    Args:
        printed: The joints as they stand there.
        q: (n,) their values, rad or the unit of length.
        unit: (n,) one unit of each one's last digit, the same units; 0 where it is exact.
    """
    away = np.where(q == 0, 0.0, unit)
    half = 0.51 * unit
    return np.stack([-np.where(q < 0, np.maximum(away, half), half), np.where(q > 0, np.maximum(away, half), half)], 1)


def nearest_inside(model: ArmModel, q: Array, box: Array, T: Array, position: bool) -> tuple[float, float]:
    """Return how far the tool stays off a pose, (length, rad), with the joints moved inside a box as is best.

    Args:
        model: The arm.
        q: (n,) the joints as printed.
        box: (n, 2) how far below and above each may lie.
        T: (4, 4) the pose, in the arm's unit.
        position: Whether only the position counts.
    """
    size, x = model.length(), q.copy()
    low, high = q + box[:, 0], q + box[:, 1]
    best = (np.inf, np.inf)
    for _ in range(STEPS):
        frames = samples_at(model, x).frames
        now, J = frames["T"][0], frames["J"][0].copy()
        error = np.concatenate([(T[:3, 3] - now[:3, 3]) / size, turn_between(now[:3, :3], T[:3, :3])])
        J[:3] /= size
        if position:
            error, J = error[:3], J[:3]
        here = float(np.linalg.norm(error[:3])) * size, float(np.linalg.norm(error[3:]))
        if here[0] / size + here[1] < best[0] / size + best[1]:
            best = here
        step = _step(J, error, low - x, high - x)
        if np.abs(step).max(initial=0.0) == 0:
            break
        x = x + step
    return best


def _step(J: Array, error: Array, low: Array, high: Array) -> Array:
    """The least-squares step inside its bounds: what would leave them is put there, the rest makes up for it."""
    step, free = np.zeros(len(low)), np.ones(len(low), dtype=bool)
    while free.any():
        rest = error - J[:, ~free] @ step[~free]
        step[free] = np.linalg.lstsq(J[:, free], rest, rcond=None)[0]
        out = free & ((step < low) | (step > high))
        if not out.any():
            break
        step[out] = np.clip(step, low, high)[out]
        free &= ~out
    return step


def turn_between(A: Array, B: Array) -> Array:
    """Return the rotation vector (3,) in the base frame that turns A into B, rad; B may be rounded."""
    R = B @ A.T
    spin = 0.5 * np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    sine = float(np.linalg.norm(spin))
    angle = float(np.arctan2(sine, (np.trace(R) - 1) / 2))
    if sine > 0:
        return spin * (angle / sine)
    return np.array([angle, 0.0, 0.0])
