"""Forward kinematics: poses, frames and Jacobians over any leading batch shape."""

from __future__ import annotations

import numpy as np

from pieper.errors import InputError
from pieper.kinematics.arrays import Array, ArrayLike
from pieper.kinematics.chain import Chain


def checked_joints(q: ArrayLike, n: int, what: str = "q") -> Array:
    """Return joint vectors (..., n) as float64 or say what is wrong with them."""
    try:
        joints = np.asarray(q, dtype=float)
    except (TypeError, ValueError):
        raise InputError(f"{what} must be numbers, got {type(q).__name__}.", given=q) from None
    if joints.ndim == 0 or joints.shape[-1] != n:
        raise InputError(
            f"{what} must have shape (..., {n}), one number a joint, got {joints.shape}.", given=joints.shape
        )
    if not np.isfinite(joints).all():
        index = tuple(int(i) for i in np.argwhere(~np.isfinite(joints))[0])
        raise InputError(f"{what} must be finite, got {joints[index]} at index {index}.", index=index)
    return joints


def fk(chain: Chain, q: ArrayLike) -> Array:
    """Return the tool poses (..., 4, 4) of joint vectors q (..., n)."""
    return chain.native.fk(checked_joints(q, chain.n))


def frames(chain: Chain, q: ArrayLike, base: Array) -> Array:
    """Return the frames (..., n + 2, 4, 4): base, the DH frame after each joint, tool."""
    return chain.native.frames(checked_joints(q, chain.n), base)


def jacobian(chain: Chain, q: ArrayLike) -> Array:
    """Return the geometric Jacobians (..., 6, n) of the tool point in the base frame, linear rows first."""
    return chain.native.jacobian(checked_joints(q, chain.n))
