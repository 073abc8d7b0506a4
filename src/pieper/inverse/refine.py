"""Newton's method on the pose equation, batched: polish solutions and pull near ones onto the pose."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.chain import Chain
from pieper.kinematics.forward import fk, jacobian
from pieper.kinematics.pose import rotation_vector


def pose_difference(chain: Chain, q: np.ndarray, T: np.ndarray) -> np.ndarray:
    """Return what is missing from fk(q) to T, (..., 6): position per length of the arm, then rotation vector, rad."""
    now = fk(chain, q)
    dR = T[..., :3, :3] @ np.swapaxes(now[..., :3, :3], -1, -2)
    return np.concatenate([(T[..., :3, 3] - now[..., :3, 3]) / chain.length, rotation_vector(dR)], -1)


def scaled_jacobian(chain: Chain, q: np.ndarray) -> np.ndarray:
    """Return Jacobians (..., 6, n) without units: lengths per characteristic length, prismatic columns likewise."""
    J = jacobian(chain, q)
    J[..., :3, :] /= chain.length
    return np.where(chain.prismatic, J * chain.length, J)


def newton(
    chain: Chain,
    q: np.ndarray,
    T: np.ndarray,
    *,
    steps: int = 12,
    cutoff: float = 1e-12,
    max_step: float = 0.5,
) -> np.ndarray:
    """Move joint vectors q (..., n) towards the pose(s) T (..., 4, 4) by minimum-norm Newton steps.

    Singular directions below `cutoff` times the largest singular value are left alone, which lets the iteration settle
    on a point of a self-motion; a step is never longer than `max_step` (rad, or characteristic lengths).

    Args:
        chain: The arm.
        q: Start, rad or m.
        T: Wanted poses.
        steps: Number of steps.

    Returns:
        (..., n) joint vectors with the smallest pose difference met on the way.
    """
    unit = np.where(chain.prismatic, chain.length, 1.0)
    q = np.array(q, float)
    best, least = q.copy(), np.full(q.shape[:-1], np.inf)
    for _ in range(steps + 1):
        e = pose_difference(chain, q, T)
        size = np.linalg.norm(e, axis=-1)
        better = size < least
        best[better], least = q[better], np.minimum(size, least)
        if np.all(least < 1e-15):
            break
        U, s, Vt = np.linalg.svd(scaled_jacobian(chain, q), full_matrices=False)
        top = s[..., :1]
        gain = 1.0 / np.maximum(s, 1e-300)
        gain = np.where(s > cutoff * top, gain, 0.0)
        step = np.einsum("...kn,...k->...n", Vt, gain * np.einsum("...ik,...i->...k", U, e))
        length = np.linalg.norm(step, axis=-1, keepdims=True)
        step *= np.minimum(1.0, max_step / np.maximum(length, 1e-300))
        q = q + step * unit
    return best
