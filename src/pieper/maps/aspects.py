"""Which aspect postures belong to, and how near to a singular one they are."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from pieper import _kernel
from pieper.kinematics.arrays import Array, ArrayLike
from pieper.kinematics.forward import checked_joints
from pieper.solver.plan.plan import Plan


class Aspects(NamedTuple):
    """What is known of postures: two of different sign have a singular posture on every way between them.

    Attributes:
        sign: (...,) of the determinant of the Jacobian, -1, 0 or 1; 1 for all where it is not square.
        smallest: (...,) its smallest singular value, lengths in units of the arm: 0 at a singular posture.
        manipulability: (...,) sqrt(det(J J^T)), or of J^T J where joints are fewer; in m and rad as they come.
    """

    sign: npt.NDArray[np.int64]
    smallest: Array
    manipulability: Array


def posture_shapes(plan: Plan, q: Array) -> Aspects:
    """Return what is known of joint vectors (N, n): of a position's task, of the rows that move the position."""
    J = plan.chain.native.jacobian(np.ascontiguousarray(q))[:, : 3 if plan.task == "position" else 6]
    if J.shape[1:] == (6, 6):
        determinant, smallest = _kernel.posture_measures(J, plan.chain.length).T
        return Aspects(np.sign(determinant).astype(np.int64), smallest, np.abs(determinant))
    wide = plan.n >= J.shape[1]
    small = J @ np.swapaxes(J, 1, 2) if wide else np.swapaxes(J, 1, 2) @ J
    square = J.shape[1] == plan.n
    sign = np.sign(np.linalg.det(J)) if square else np.ones(len(q))
    scaled = J.copy()
    scaled[:, :3] /= plan.chain.length
    smallest = np.linalg.svd(scaled, compute_uv=False)[:, -1] if len(q) else np.zeros(0)
    best = np.abs(np.linalg.det(J)) if square else np.sqrt(np.maximum(np.linalg.det(small), 0.0))
    return Aspects(np.asarray(sign, np.int64), np.asarray(smallest, np.float64), np.asarray(best, np.float64))


def aspects(plan: Plan, q: ArrayLike) -> Aspects:
    """Return which aspects joint vectors (..., n) belong to; see `pieper.Arm.aspects`."""
    given = checked_joints(q, plan.n)
    found, shape = posture_shapes(plan, given.reshape(-1, plan.n)), given.shape[:-1]
    return Aspects(found.sign.reshape(shape), found.smallest.reshape(shape), found.manipulability.reshape(shape))
