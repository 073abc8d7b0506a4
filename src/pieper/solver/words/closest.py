"""How far an unreachable pose is out of reach, and the nearest place that can be reached."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.kinematics.chain import Chain
from pieper.kinematics.newton import downhill
from pieper.kinematics.pose import pose_error
from pieper.solver.plan.six_joints import sample_joints

#: Random starts and steps of the search; the answer is the best of them, so it bounds the distance from above.
STARTS, STEPS = 64, 60
#: Damping of the descent: at first, its factor where a step helped and where not, and where a row rests.
DAMPING = (1e-2 / 0.3, 0.3, 4.0, 1e6)


def nearest_reachable(chain: Chain, T: Array, seeds: Array | None = None) -> tuple[Array, float, float]:
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
    for weight, steps in ((1.0, STEPS), (30.0, STEPS // 2), (1e3, STEPS // 2)):
        weights = np.array([1.0, 1.0, 1.0, weight, weight, weight])
        q, cost = downhill(chain, q, T, steps=steps + 1, weights=weights, damping=DAMPING, relative=_mean_square)
        q = q[np.argsort(cost)[: max(8, len(q) // 4)]]
    error = pose_error(chain.native.fk(q), T)
    # orientation first (to a tenth of a degree), then position
    best = np.lexsort((error[:, 0], np.round(error[:, 1] / 2e-3)))[0]
    return q[best], float(error[best, 0]), float(error[best, 1])


def _mean_square(J: Array, square: Array) -> Array:
    """Return the mean (k,) over the joints of what each moves: damping counts in that."""
    return np.einsum("kij,kij->k", J, J) / J.shape[-1]
