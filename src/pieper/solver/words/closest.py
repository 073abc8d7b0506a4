"""How far an unreachable pose is out of reach, and the nearest place that can be reached."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.chain import Chain
from pieper.kinematics.forward import fk
from pieper.kinematics.newton import pose_difference, scaled_jacobian
from pieper.kinematics.pose import pose_error
from pieper.solver.plan.six_joints import sample_joints

#: Random starts and steps of the search; the answer is the best of them, so it bounds the distance from above.
STARTS, STEPS = 64, 60


def nearest_reachable(chain: Chain, T: np.ndarray, seeds: np.ndarray | None = None) -> tuple[np.ndarray, float, float]:
    """Find a posture whose tool has the orientation of T, if any has, and comes closest in position.

    The squared pose difference is minimised (Levenberg-Marquardt from many starts) with the orientation weighted up
    in stages, so that position gives way and orientation does not.

    Args:
        chain: The arm, or the arm with its task's virtual joints.
        T: (4, 4).
        seeds: (k, n) further starts.

    Returns:
        The joint vector (n,), the remaining distance in metres, and the remaining angle in radians.
    """
    q = sample_joints(chain, STARTS, seed=5)
    if seeds is not None and len(seeds):
        q = np.vstack([q, seeds])
    unit = np.where(chain.prismatic, chain.length, 1.0)
    for weight, steps in ((1.0, STEPS), (30.0, STEPS // 2), (1e3, STEPS // 2)):
        w = np.array([1.0, 1.0, 1.0, weight, weight, weight])
        damping = np.full(len(q), 1e-2)
        e = pose_difference(chain, q, T) * w
        cost = np.sum(e * e, -1)
        for _ in range(steps):
            J = scaled_jacobian(chain, q) * w[:, None]
            A = np.swapaxes(J, -1, -2) @ J
            A += damping[:, None, None] * np.eye(chain.n) * np.trace(A, axis1=-2, axis2=-1)[:, None, None] / chain.n
            step = np.linalg.solve(A, np.einsum("bij,bi->bj", J, e)[..., None])[..., 0]
            step *= np.minimum(1.0, 0.7 / np.maximum(np.linalg.norm(step, axis=-1, keepdims=True), 1e-300))
            tried = q + step * unit
            e_new = pose_difference(chain, tried, T) * w
            new = np.sum(e_new * e_new, -1)
            good = new < cost
            q = np.where(good[:, None], tried, q)
            e, cost = np.where(good[:, None], e_new, e), np.where(good, new, cost)
            damping = np.clip(np.where(good, damping * 0.3, damping * 4.0), 1e-12, 1e6)
        keep = np.argsort(cost)[: max(8, len(q) // 4)]
        q = q[keep]
    error = pose_error(fk(chain, q), T)
    # orientation first (to a tenth of a degree), then position
    best = np.lexsort((error[:, 0], np.round(error[:, 1] / 2e-3)))[0]
    return q[best], float(error[best, 0]), float(error[best, 1])
