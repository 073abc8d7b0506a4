"""Forward kinematics: poses, frames and Jacobians over any leading batch shape."""

from __future__ import annotations

import numpy as np

from pieper.errors import InputError
from pieper.kinematics.chain import Chain


def checked_joints(q: object, n: int, what: str = "q") -> np.ndarray:
    """Return joint vectors (..., n) as float64 or say what is wrong with them."""
    try:
        joints = np.asarray(q, dtype=float)
    except (TypeError, ValueError):
        raise InputError(f"{what} must be numbers, got {type(q).__name__}.", given=q) from None
    if joints.ndim == 0 or joints.shape[-1] != n:
        raise InputError(f"{what} must have shape (..., {n}), one number a joint, got {joints.shape}.", given=joints.shape)
    if not np.isfinite(joints).all():
        index = tuple(int(i) for i in np.argwhere(~np.isfinite(joints))[0])
        raise InputError(f"{what} must be finite, got {joints[index]} at index {index}.", index=index)
    return joints


def fk(chain: Chain, q: object) -> np.ndarray:
    """Return the tool poses (..., 4, 4) of joint vectors q (..., n)."""
    q = checked_joints(q, chain.n)
    T = np.broadcast_to(chain.links[0], (*q.shape[:-1], 4, 4))
    for i in range(chain.n):
        T = T @ _motion(q[..., i], chain.prismatic[i]) @ chain.links[i + 1]
    return T.copy() if chain.n == 0 else T


def frames(chain: Chain, q: object, base: np.ndarray) -> np.ndarray:
    """Return the frames (..., n + 2, 4, 4): base, the DH frame after each joint, tool."""
    q = checked_joints(q, chain.n)
    out = np.empty((*q.shape[:-1], chain.n + 2, 4, 4))
    out[..., 0, :, :] = base
    T = np.broadcast_to(chain.links[0], (*q.shape[:-1], 4, 4))
    for i in range(chain.n):
        T = T @ _motion(q[..., i], chain.prismatic[i])
        out[..., i + 1, :, :] = T @ chain.frames_after[i]
        T = T @ chain.links[i + 1]
    out[..., -1, :, :] = T
    return out


def jacobian(chain: Chain, q: object) -> np.ndarray:
    """Return the geometric Jacobians (..., 6, n) of the tool point in the base frame, linear rows first."""
    q = checked_joints(q, chain.n)
    z = np.empty((*q.shape[:-1], chain.n, 3))
    o = np.empty_like(z)
    T = np.broadcast_to(chain.links[0], (*q.shape[:-1], 4, 4))
    for i in range(chain.n):
        z[..., i, :], o[..., i, :] = T[..., :3, 2], T[..., :3, 3]
        T = T @ _motion(q[..., i], chain.prismatic[i]) @ chain.links[i + 1]
    p = T[..., None, :3, 3]
    J = np.empty((*q.shape[:-1], 6, chain.n))
    P = chain.prismatic[:, None]
    J[..., :3, :] = np.swapaxes(np.where(P, z, np.cross(z, p - o)), -1, -2)
    J[..., 3:, :] = np.swapaxes(np.where(P, 0.0, z), -1, -2)
    return J


def _motion(value: np.ndarray, prismatic: bool) -> np.ndarray:
    Z = np.zeros((*value.shape, 4, 4))
    Z[..., 2, 2] = Z[..., 3, 3] = 1.0
    if prismatic:
        Z[..., 0, 0] = Z[..., 1, 1] = 1.0
        Z[..., 2, 3] = value
    else:
        Z[..., 0, 0] = Z[..., 1, 1] = np.cos(value)
        Z[..., 1, 0] = np.sin(value)
        Z[..., 0, 1] = -Z[..., 1, 0]
    return Z
