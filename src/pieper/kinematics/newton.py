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
    out = np.empty((*dR.shape[:-2], 6))
    out[..., :3] = (T[..., :3, 3] - now[..., :3, 3]) / chain.length
    w = out[..., 3:]
    w[..., 0] = dR[..., 2, 1] - dR[..., 1, 2]
    w[..., 1] = dR[..., 0, 2] - dR[..., 2, 0]
    w[..., 2] = dR[..., 1, 0] - dR[..., 0, 1]
    w *= 0.5
    square = np.einsum("...i,...i->...", w, w)
    if np.all((square < 0.25) & (dR[..., 0, 0] + dR[..., 1, 1] + dR[..., 2, 2] > 1.0)):
        # less than 30 degrees: the skew part holds the sine, and that is the angle with its series' correction
        sine = np.sqrt(np.maximum(square, 1e-300))
        w *= (np.arcsin(sine) / sine)[..., None]
    else:
        w[...] = rotation_vector(dR)
    return out


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
    shape = q.shape
    q = q.reshape(-1, chain.n)
    T = T if T.ndim == 2 else np.broadcast_to(T, (*shape[:-1], 4, 4)).reshape(-1, 4, 4)
    best, least = q.copy(), np.full(len(q), np.inf)
    stalled = np.zeros(len(q), int)
    going = np.arange(len(q))
    for step in range(steps + 1):
        here = q[going]
        e = pose_difference(chain, here, T if T.ndim == 2 else T[going])
        size = np.linalg.norm(e, axis=-1)
        stalled[going] = np.where(size > 0.5 * least[going], stalled[going] + 1, 0)
        better = size < least[going]
        best[going[better]] = here[better]
        least[going[better]] = size[better]
        # rounding is reached, or what is missed has stopped shrinking: at a double root it shrinks by four a step
        on = (size > 1e-15) & ((least[going] > 1e-13) | (stalled[going] < 3))
        going, here, e = going[on], here[on], e[on]
        if not len(going) or step == steps:
            break
        U, s, Vt = np.linalg.svd(scaled_jacobian(chain, here), full_matrices=False)
        gain = np.where(s > cutoff * s[..., :1], 1.0 / np.maximum(s, 1e-300), 0.0)
        move = np.einsum("nkj,nk->nj", Vt, gain * np.einsum("nik,ni->nk", U, e))
        length = np.linalg.norm(move, axis=-1, keepdims=True)
        q[going] = here + move * np.minimum(1.0, max_step / np.maximum(length, 1e-300)) * unit
    return best.reshape(shape)
