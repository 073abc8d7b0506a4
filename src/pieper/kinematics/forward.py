"""Forward kinematics: poses, frames and Jacobians over any leading batch shape."""

from __future__ import annotations

import warnings

import numpy as np

from pieper import _kernel, arguments
from pieper.errors import InputError, PieperWarning
from pieper.kinematics.arrays import Array, ArrayLike, Bools
from pieper.kinematics.chain import Chain

#: Angles beyond this (rad) are taken, with a warning: eight turns, and few degrees of a usual posture are below it.
DEGREES_LIKELY = 50.0


def checked_joints(q: ArrayLike, n: int, what: str = "q", prismatic: Bools | None = None) -> Array:
    """Return joint vectors (..., n) as float64 or say what is wrong with them.

    Args:
        q: What was given.
        n: How many joints there are.
        what: The name to use in messages.
        prismatic: (n,) bool; where it is given, revolute joints that look like degrees get a warning.
    """
    if _kernel.usual_joints(q, n, DEGREES_LIKELY):
        return q
    joints = arguments.numbers(q, what)
    if joints.ndim == 0 or joints.shape[-1] != n:
        found = joints.shape if joints.ndim else arguments.kind_of(q)
        raise InputError(f"{what} must have shape (..., {n}), one number a joint, got {found}.", given=joints.shape)
    # these find NaN, infinities and degrees
    if not (joints.max(initial=0.0) < DEGREES_LIKELY and joints.min(initial=0.0) > -DEGREES_LIKELY):
        _look_closer(joints, what, prismatic)
    return joints


def checked_joint_vector(q: ArrayLike, n: int, what: str, prismatic: Bools | None = None) -> Array:
    """Return one joint vector (n,) as float64 or say what is wrong with it; see `checked_joints`."""
    joints = checked_joints(q, n, what, prismatic)
    if joints.ndim != 1:
        raise InputError(f"{what} must be one joint vector ({n},), got {joints.shape}.", given=joints.shape)
    return joints


def checked_weights(weights: ArrayLike | None, n: int) -> Array:
    """Return how much the square of each joint's difference counts (n,), all the same if None."""
    if weights is None:
        return np.ones(n)
    numbers = arguments.numbers(weights, "weights")
    if numbers.shape != (n,):
        raise InputError(f"weights must have shape ({n},), one a joint, got {numbers.shape}.", given=numbers.shape)
    if not (np.isfinite(numbers).all() and (numbers >= 0).all() and (numbers > 0).any()):
        raise InputError(
            f"weights must be finite, none negative and not all of them zero, got {numbers.tolist()}.", given=weights
        )
    # only their ratios count: by a power of two the digits stay, and no square of them is beyond what numbers can be
    return np.ldexp(numbers, -int(np.frexp(numbers.max())[1]))


def _look_closer(joints: np.ndarray, what: str, prismatic: np.ndarray | None) -> None:
    if not np.isfinite(joints).all():
        index = tuple(int(i) for i in np.argwhere(~np.isfinite(joints))[0])
        raise InputError(f"{what} must be finite, got {joints[index]} at index {index}.", index=index)
    if prismatic is not None and np.abs(joints[..., ~prismatic]).max(initial=0.0) >= DEGREES_LIKELY:
        value = float(np.abs(joints[..., ~prismatic]).max())
        warnings.warn(
            f"{what} holds {value:g}, taken as radians; more than {DEGREES_LIKELY:g} rad looks like degrees. Use "
            "np.radians(...) if degrees were meant.",
            PieperWarning,
            stacklevel=5,
        )


def fk(chain: Chain, q: ArrayLike) -> Array:
    """Return the tool poses (..., 4, 4) of joint vectors q (..., n)."""
    return chain.native.fk(checked_joints(q, chain.n, prismatic=chain.prismatic))


def frames(chain: Chain, q: ArrayLike, base: Array) -> Array:
    """Return the frames (..., n + 2, 4, 4): base, the DH frame after each joint, tool."""
    return chain.native.frames(checked_joints(q, chain.n, prismatic=chain.prismatic), base)


def jacobian(chain: Chain, q: ArrayLike) -> Array:
    """Return the geometric Jacobians (..., 6, n) of the tool point in the base frame, linear rows first."""
    return chain.native.jacobian(checked_joints(q, chain.n, prismatic=chain.prismatic))
