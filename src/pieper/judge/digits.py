"""Do printed joints reach a printed pose to their last digits?

Every printed number stands for an interval: what rounds to it, or what it is cut off from. A joint vector is a solution
when some joints in their intervals give a pose in its own, and that is found and not estimated: with small intervals it
is a least-squares problem in a box, whose least value is zero only where such joints exist.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from pieper.judge.model import ArmModel
from pieper.judge.samples import samples_at
from pieper.tolerances import BEYOND_DIGITS, JUDGED_ZERO

ROUNDED = 0.51  # of a unit of the last digit: rounding either way, and a little for binary numbers
CUT_OFF = 0.98  # of a unit: what is cut off lies beyond the number by less than one
LINES = 6  # linearisations of the pose; the box is small, and each squares what is left


@dataclass(frozen=True, eq=False)
class Interval:
    """Numbers as printed, and the size of one unit of the last digit of each; 0 for what is exact."""

    value: np.ndarray
    unit: np.ndarray

    def box(self) -> tuple[np.ndarray, np.ndarray]:
        """Middle and half width of where the numbers lie, each of them rounded or cut off."""
        low, high = -ROUNDED * self.unit, np.where(self.value == 0, ROUNDED, CUT_OFF) * self.unit
        return self.value + np.where(self.value < 0, -1, 1) * (low + high) / 2, (high - low) / 2


def reaches(model: ArmModel, joints: Interval, pose: Interval, *, position: bool = False) -> bool:
    """Whether joints reach a pose to the digits of both.

    Args:
        model: The arm.
        joints: (n,) rad or the arm's unit of length.
        pose: (3, 4) in the arm's unit of length.
        position: The last column alone is meant.
    """
    columns = slice(3, 4) if position else slice(0, 4)
    size = np.broadcast_to([1.0, 1.0, 1.0, model.length()], (3, 4))[:, columns].ravel()

    def at(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        found = samples_at(model, q)
        T, J = found.frames["T"][0], found.frames["J"][0]
        turned = np.cross(J[3:].T[:, None, :], T[:3, :3].T[None]).transpose(0, 2, 1)
        slope = np.concatenate([turned, J[:3].T[:, :, None]], axis=2)
        return T[:3, columns].ravel(), slope[:, :, columns].reshape(len(q), -1).T

    def near(q: np.ndarray, width: np.ndarray, wanted: np.ndarray, slack: np.ndarray) -> bool:
        """Whether the pose is no further off than the joints could move it, with room for the bend of its way."""
        value, slope = at(q)
        bend = size * np.where(turning, width, width / model.length()).sum() ** 2
        return bool(np.all(np.abs(value - wanted) <= np.abs(slope) @ width + bend + slack * (1 + BEYOND_DIGITS)))

    turning = np.array([not model.sliding(j + 1) for j in range(model.n)])
    least = JUDGED_ZERO * size
    (q, width), (T, slack) = joints.box(), pose.box()
    wanted, allowed = T[:, columns].ravel(), np.maximum(slack[:, columns].ravel(), least)
    return near(q, width, wanted, allowed) and _within(at, q, width, wanted, allowed)


def _within(
    at: Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]],
    middle: np.ndarray,
    width: np.ndarray,
    wanted: np.ndarray,
    slack: np.ndarray,
) -> bool:
    q = middle
    for _ in range(LINES):
        value, slope = at(q)
        if np.all(np.abs(value - wanted) <= slack * (1 + BEYOND_DIGITS)):
            return True
        # joints and pose may each move in their interval: slope (q + du) + slack v = wanted, u and v in [-1, 1]
        A = np.concatenate([slope * width / slack[:, None], np.eye(len(slack))], axis=1)
        b = (wanted - value + slope @ (q - middle)) / slack
        q = middle + width * box_least_squares(A, b)[: len(middle)]
    return False


def box_least_squares(A: np.ndarray, b: np.ndarray) -> np.ndarray:
    """The z with every entry in [-1, 1] that makes A z - b (m, n) least; Stark and Parker's active sets.

    Source: P. B. Stark, R. L. Parker, Bounded-variable least-squares, Computational Statistics 10 (1995).
    """
    n = A.shape[1]
    z, free = np.zeros(n), np.ones(n, dtype=bool)
    least = np.inf
    while True:
        while free.any():
            step = np.linalg.lstsq(A[:, free], b - A @ z, rcond=None)[0]
            with np.errstate(all="ignore"):
                room = np.where(step == 0, np.inf, (np.sign(step) - z[free]) / step)
            first = int(np.argmin(room))
            if room[first] >= 1:
                z[free] += step
                break
            z[free] += max(room[first], 0.0) * step
            held = np.flatnonzero(free)[first]
            z[held] = np.sign(step[first])
            free[held] = False
        left = b - A @ z
        pull = A.T @ left
        now = float(left @ left)
        inwards = np.where(free, 0.0, -z * pull)
        if now >= least * (1 - JUDGED_ZERO) or inwards.max(initial=0.0) <= JUDGED_ZERO * np.abs(A).max():
            return z
        least = now
        free[int(np.argmax(inwards))] = True
