"""Points of a pose met from anywhere: by descent from postures spread evenly, and by Newton steps from near ones."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array, Indices
from pieper.kinematics.chain import Chain
from pieper.kinematics.joints import short_way
from pieper.kinematics.newton import damped, downhill, missed, pose_difference, scaled_jacobian, settled
from pieper.solver.plan.plan import Plan
from pieper.solver.plan.six_joints import sample_joints
from pieper.tolerances import APPROACH_DAMPING, APPROACH_LEAST_DAMPING, CLOSES

#: How often a posture is tried in a free approach to a pose.
PULL_STEPS = 40


def holding(chain: Chain, q: Array, T: Array) -> Array:
    """Return the rows (m, n) of q (k, n) that hold the pose T (4, 4), angles in [-pi, pi)."""
    q = q[missed(chain, q, T) < CLOSES]
    return np.where(chain.prismatic, q, short_way(q))


def pulled(chain: Chain, q: Array, T: Array, steps: int) -> Array:
    """Return joint vectors (k, n) after so many shortest Newton steps towards poses T (k, 4, 4), each bounded."""

    def miss(at: Array, index: Indices) -> Array:
        return pose_difference(chain, at, T[index])

    def slope(at: Array, index: Indices) -> Array:
        return scaled_jacobian(chain, at)

    return settled(miss, slope, q, chain.joints.unit, steps=steps, longest=0.2, step=damped(APPROACH_LEAST_DAMPING))[0]


def from_anywhere(plan: Plan, T: Array, starts: int) -> list[Array]:
    """Return for each of poses T (N, 4, 4) points (m, n) of it found from anywhere.

    The distance to the pose is minimised (Levenberg-Marquardt) from so many postures, always the same ones. Where a
    curve of solutions is about to appear or has just appeared, that distance has a minimum to which a neighbourhood of
    ordinary size leads.
    """
    full = plan.exact.full
    q = np.tile(sample_joints(full, starts, seed=7), (len(T), 1))
    poses = np.repeat(T, starts, axis=0)
    q, _ = downhill(
        full,
        q,
        poses,
        steps=PULL_STEPS,
        weights=np.ones(6),
        damping=APPROACH_DAMPING,
        relative=lambda J, square: square,
    )
    return [holding(full, rows, pose) for rows, pose in zip(q.reshape(len(T), starts, full.n), T, strict=True)]
