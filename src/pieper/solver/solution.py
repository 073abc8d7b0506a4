"""One posture of an arm for a pose: a solution, or what comes nearest where there is none; solutions as columns."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pieper.document.columns import Column, Units
from pieper.kinematics.arrays import Array, Bools
from pieper.solver.plan.plan import Plan


@dataclass(frozen=True, slots=True, eq=False)
class Closest:
    """The posture inside the limits that comes nearest to a pose.

    Attributes:
        q: (n,) rad or m.
        metres: How far its tool is from the pose.
        radians: How far it is turned from it, of what the task asks for.
        T: (4, 4) where its tool is.
    """

    q: Array
    metres: float
    radians: float
    T: Array


@dataclass(frozen=True, eq=False, slots=True)
class Solution:
    """One solution of a pose.

    Attributes:
        q: (n,) joint vector, rad or m.
        label: Its posture label.
        residual: (2,) metres and radians by which forward kinematics misses the pose.
    """

    q: Array
    label: str
    residual: Array


def solution_columns(
    plan: Plan, q: Array, labels: Sequence[str], residual: Array, inside: Bools, units: Units
) -> dict[str, Column]:
    """Return the solutions (k, n) of one pose as columns, those inside the limits told apart."""
    return {
        "solution": np.arange(1, len(q) + 1),
        **units.joints(plan.names, plan.prismatic, q),
        "in_limits": inside,
        "label": np.array(labels, dtype=str),
        **units.metres("residual", residual[:, 0]),
        **units.radians("residual", residual[:, 1]),
    }


def batch_columns(
    plan: Plan, q: Array, valid: Bools, inside: Bools, status: Sequence[str], units: Units
) -> dict[str, Column]:
    """Return the rows of a batch (N, slots, n) as columns, poses and solutions counted from 1.

    A pose without a solution keeps a row: solution 0, its joints NaN.
    """
    shown = valid.copy()
    shown[~valid.any(1), 0] = True
    pose, slot = np.nonzero(shown)
    first = np.concatenate([[0], np.cumsum(shown.sum(1))[:-1]])
    number = np.where(valid[pose, slot], np.arange(len(pose)) - first[pose] + 1, 0)
    rows = np.where(valid[pose, slot][:, None], q[pose, slot], np.nan)
    return {
        "pose": pose + 1,
        "solution": number,
        "status": np.array(status, dtype=str)[pose],
        **units.joints(plan.names, plan.prismatic, rows),
        "in_limits": inside[pose, slot] & valid[pose, slot],
    }
