"""Poses that are out of reach whatever any solver says of them: farther away than the links laid end to end."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array, ArrayLike, Bits, Bools, Indices
from pieper.kinematics.pose import checked_pose
from pieper.solver.plan.plan import Plan
from pieper.solver.rows import Flag, Rows
from pieper.tolerances import BEYOND_REACH, FARTHEST

#: What a kernel may say of a pose that wants a second look; none of it can be true beyond reach.
DOUBTS = int(Flag.DEGENERATE | Flag.UNCERTAIN | Flag.EDGE)


def beyond(plan: Plan, T: Array) -> Bools:
    """Return which poses (N, 4, 4) lie farther from the first axis's frame than the links could reach (N,)."""
    away: Array = np.linalg.norm(T[:, :3, 3] - plan.exact.full.links[0][:3, 3], axis=1)
    return away > (1 + BEYOND_REACH) * plan.farthest


def without_doubt(plan: Plan, T: Array, rows: Rows) -> None:
    """Take the doubt off poses T (N, 4, 4) that have no rows and are beyond reach: nothing can be missing there."""
    doubts = rows.flags & DOUBTS
    if not np.count_nonzero(doubts):
        return
    far = np.flatnonzero((doubts > 0) & ~rows.valid.any(1))
    rows.flags[far[beyond(plan, T[far])]] &= np.uint8(255 ^ DOUBTS)


def too_far(pose: ArrayLike) -> bool:
    """Return whether the place of a pose (4, 4) is farther away than any is taken to be."""
    place: list[float] = np.asarray(pose, float)[:3, 3].tolist()
    return max(map(abs, place)) > FARTHEST


def refuse_too_far(poses: Array, without_rows: Indices) -> None:
    """Say which pose is too far away to be one, of those that have no rows: the kernels refuse no place."""
    if not len(without_rows):
        return
    # of most of a batch all places are looked at where they stand: picking out the few others takes longer
    places = poses[:, :3, 3] if 4 * len(without_rows) > len(poses) else poses[without_rows, :3, 3]
    if not np.all(np.abs(places) <= FARTHEST) and not np.all(np.abs(poses[without_rows, :3, 3]) <= FARTHEST):
        checked_pose(poses, "Ts", batch=True)


def without_denied(poses: Array, flags: Bits, index: Indices) -> Indices:
    """Return which of some poses are left to be looked at: those without rows and any other remark cannot be mended."""
    denied = flags[index] == int(Flag.OUT_OF_REACH)
    refuse_too_far(poses, index[denied])
    return index[~denied]
