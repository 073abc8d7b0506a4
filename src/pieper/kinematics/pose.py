"""Poses as 4x4 matrices: making, checking, inverting and measuring them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Protocol, TypeAlias, TypeGuard

import numpy as np

from pieper import _kernel, arguments
from pieper.errors import InputError
from pieper.kinematics.arrays import Array, ArrayLike
from pieper.tolerances import FARTHEST, NEAR_HALF_TURN, ROTATION_ACCEPTED, ROTATION_EXACT, SMALL_TURN, TINY

FLIP = np.diag([1.0, -1.0, -1.0, 1.0])


#: How other libraries hand out the matrix of a pose: attribute or method, the first that is there.
_ACCESSORS = (
    "as_matrix",
    "homogeneous",
    "A",
    "to_matrix",
    "matrix",
    "transformation_matrix",
    "as_transformation_matrix",
)


class HasAsMatrix(Protocol):
    """A pose such as SciPy's RigidTransform."""

    def as_matrix(self) -> Any:
        """Return (..., 4, 4)."""
        ...


class HasHomogeneous(Protocol):
    """A pose such as Pinocchio's SE3."""

    @property
    def homogeneous(self) -> Any:
        """(4, 4)."""
        ...


class HasA(Protocol):
    """A pose such as spatialmath's SE3."""

    @property
    def A(self) -> Any:
        """(4, 4), or a list of them."""
        ...


class HasParts(Protocol):
    """A pose that hands out its rotation (3, 3) and its translation (3,)."""

    rotation: Any
    translation: Any


#: What goes wherever a pose goes.
PoseLike: TypeAlias = ArrayLike | HasAsMatrix | HasHomogeneous | HasA | HasParts | Sequence[Any]


def as_pose(T: Any) -> Any:
    """Return the matrix of a pose that another library holds, anything else unchanged.

    SciPy's RigidTransform, spatialmath's SE3, Pinocchio's SE3 and whatever else hands out a (4, 4) or (N, 4, 4) by one
    of the usual names, or a `rotation` (3, 3) and a `translation` (3,); lists of such poses too.
    """
    held = T
    if isinstance(T, (np.ndarray, float, int)) or T is None:
        return held
    if isinstance(T, (list, tuple)):
        # numbers and nested lists are left to NumPy
        return [as_pose(item) for item in held] if T and not isinstance(held[0], (list, tuple, float, int)) else held
    for name in _ACCESSORS:
        found = getattr(T, name, None)
        if found is not None:
            matrix = found() if callable(found) else found
            return np.array(matrix, float) if isinstance(matrix, list) else matrix
    turn, place = getattr(T, "rotation", None), getattr(T, "translation", None)
    if turn is not None and place is not None:
        turn, place = (part() if callable(part) else part for part in (turn, place))
        turn = as_pose(turn)
        if np.shape(turn) == (3, 3) and np.size(place) == 3:
            return transform(np.asarray(turn, float), np.asarray(place, float).reshape(3))
    return T


def is_exact(T: Any) -> TypeGuard[Array]:
    """Return whether T is a float64 array (..., 4, 4) of poses that `checked_pose` finds nothing to say or mend about.

    Only the better half of what counts as exact is: products are rounded differently in the kernel and here.
    """
    return _kernel.exact_poses(T, ROTATION_EXACT / 2, FARTHEST)


def checked_pose(T: PoseLike, what: str = "T", *, batch: bool = False) -> Array:
    """Return poses as float64 with an exact rotation part, or say what is wrong with them.

    Rotation parts that depart from a rotation by up to `ROTATION_ACCEPTED` (a pose rounded to float32, for one) are
    replaced by the nearest rotation (polar decomposition).

    Args:
        T: (4, 4), or (..., 4, 4) when batch; or another library's pose, see `as_pose`.
        what: The name to use in messages.
        batch: Whether leading axes are allowed.

    Returns:
        A new float64 array of the same shape.

    Raises:
        InputError: Wrong shape, a number that is not finite, a last row other than 0 0 0 1, not a rotation.
    """
    if is_exact(T) and (batch or T.ndim == 2):
        return T.copy()
    try:
        given = np.asarray(as_pose(T))
        if np.iscomplexobj(given):
            raise InputError(f"{what} must be real, got complex numbers.", given=T)
        pose = np.array(given, dtype=np.float64)
    except InputError:
        raise
    except (TypeError, ValueError):
        if batch:
            _which_is_none(T, what)
        wanted = "4x4 matrices" if batch else "a 4x4 matrix"
        raise InputError(f"{what} must be {wanted} of numbers, got {arguments.kind_of(T)}.", given=T) from None
    if batch and pose.shape == (0,):
        return pose.reshape(0, 4, 4)  # an empty list holds no pose of a wrong shape
    if pose.shape[-2:] != (4, 4) or (not batch and pose.ndim != 2):
        hint = " It looks like a rotation alone: put it into a 4x4 with a position." if pose.shape == (3, 3) else ""
        if not batch and pose.shape[1:] == (4, 4):
            hint = " These are many poses and one is wanted: take one of them, or ask what takes many, such as ik_many."
        wanted = "(..., 4, 4)" if batch else "(4, 4)"
        found = pose.shape if pose.ndim else arguments.kind_of(T)
        raise InputError(f"{what} must have shape {wanted}, got {found}.{hint}", given=pose.shape)
    if pose.size == 0:
        return pose
    bad = ~np.isfinite(pose)
    if bad.any():
        index = tuple(int(i) for i in np.argwhere(bad)[0])
        raise InputError(f"{what} must be finite, got {pose[index]} at index {index}.", index=index)
    last = np.abs(pose[..., 3, :] - [0.0, 0.0, 0.0, 1.0]).max(-1)
    if np.max(last) > ROTATION_EXACT:
        index, where = _worst(last)
        raise InputError(
            f"the last row of {what}{where} must be 0 0 0 1, it is off by {np.max(last):.3g}. "
            "Is the matrix transposed?",
            deviation=float(np.max(last)),
            index=index,
        )
    if np.abs(pose[..., :3, 3]).max() > FARTHEST:
        index, where = _worst(np.abs(pose[..., :3, 3]).max(-1))
        raise InputError(
            f"the position of {what}{where} is farther than {FARTHEST:g} m; metres are meant.", index=index
        )
    R = pose[..., :3, :3]
    deviation = np.abs(np.swapaxes(R, -1, -2) @ R - np.eye(3)).max(axis=(-1, -2))
    worst = float(np.max(deviation))
    if worst > ROTATION_ACCEPTED:
        index, where = _worst(deviation)
        raise InputError(
            f"the rotation part of {what}{where} is not a rotation: R^T R departs from I by {worst:.3g}, allowed is "
            f"{ROTATION_ACCEPTED:g}. Scaled, sheared or noisy matrices must be made a rotation first.",
            deviation=worst,
            index=index,
        )
    handed = np.linalg.det(R)
    if np.min(handed) < 0:
        index, where = _worst(-handed)
        raise InputError(
            f"the rotation part of {what}{where} is left-handed (determinant -1): a mirror, not a rotation.",
            index=index,
        )
    if worst > ROTATION_EXACT:
        # the iteration for the polar factor (Higham, 1986), as the kernels do it: each step squares the deviation
        off = deviation > ROTATION_EXACT  # the others keep their digits, whatever company they are given in
        for _ in range(2):
            some = R[off]
            R[off] = some @ (1.5 * np.eye(3) - 0.5 * (np.swapaxes(some, -1, -2) @ some))
    return pose


def one_by_one(given: Any) -> list[Any] | None:
    """Return the poses of a list as they are, where it is one of poses: one of them at least is (4, 4); else None."""
    if not isinstance(given, (list, tuple)):
        return None
    poses = [as_pose(item) for item in given]  # pyright: ignore[reportUnknownVariableType]  # anything at all
    return poses if any(_is_square(pose) for pose in poses) else None


def _is_square(pose: Any) -> bool:
    try:
        return np.shape(pose) == (4, 4)
    except (TypeError, ValueError):
        return False


def _which_is_none(given: Any, what: str) -> None:
    """Say which of a list of poses is none."""
    for k, pose in enumerate(one_by_one(given) or ()):
        checked_pose(pose, f"{what}[{k}]")


def unsound(poses: Array, deviation: Array) -> Array:
    """Return which (N,) of poses (N, 4, 4) `checked_pose` refuses; deviation (N,) is the kernels' from a rotation."""
    last = np.abs(poses[:, 3] - [0.0, 0.0, 0.0, 1.0]).max(-1)
    far = np.abs(poses[:, :3, 3]).max(-1)
    return ~((deviation <= ROTATION_ACCEPTED) & (last <= ROTATION_EXACT) & (far <= FARTHEST))


def reason_against(pose: Array, what: str) -> str:
    """Return why a matrix (4, 4) is no pose, in the words of `checked_pose`; empty where it is one."""
    try:
        checked_pose(pose, what)
    except InputError as error:
        return str(error)
    return ""


def _worst(size: Array) -> tuple[tuple[int, ...], str]:
    """Return the index of the largest entry and words for it; both empty for a single pose."""
    size = np.asarray(size)
    if not size.ndim:
        return (), ""
    index = tuple(int(i) for i in np.unravel_index(np.argmax(size), size.shape))
    return index, f" (at index {index[0] if len(index) == 1 else index})"


def inverse(T: Array) -> Array:
    """Return the inverse poses, (..., 4, 4)."""
    out = np.zeros_like(T, dtype=float)
    Rt = np.swapaxes(T[..., :3, :3], -1, -2)
    out[..., :3, :3] = Rt
    out[..., :3, 3] = -(Rt @ T[..., :3, 3:])[..., 0]
    out[..., 3, 3] = 1.0
    return out


def transform(R: Array | None = None, p: Array | None = None) -> Array:
    """Return the pose (..., 4, 4) with rotation R (identity if None) and position p (zero if None)."""
    shape = np.shape(R)[:-2] if R is not None else () if p is None else np.shape(p)[:-1]
    T = np.zeros((*shape, 4, 4))
    T[..., :3, :3] = np.eye(3) if R is None else R
    if p is not None:
        T[..., :3, 3] = p
    T[..., 3, 3] = 1.0
    return T


def rotation_z(angle: ArrayLike) -> Array:
    """Return poses (..., 4, 4) of a rotation about z by angle (...), rad."""
    angle = np.asarray(angle, float)
    T = np.zeros((*angle.shape, 4, 4))
    T[..., 0, 0] = T[..., 1, 1] = np.cos(angle)
    T[..., 1, 0] = np.sin(angle)
    T[..., 0, 1] = -T[..., 1, 0]
    T[..., 2, 2] = T[..., 3, 3] = 1.0
    return T


def rotation_x(angle: ArrayLike) -> Array:
    """Return poses (..., 4, 4) of a rotation about x by angle (...), rad."""
    T = rotation_z(angle)
    return T[..., [2, 0, 1, 3], :][..., :, [2, 0, 1, 3]]


def translation(x: float = 0.0, y: float = 0.0, z: float = 0.0) -> Array:
    """Return the pose (4, 4) of a translation, m."""
    T = np.eye(4)
    T[:3, 3] = x, y, z
    return T


def rotation_about(axis: Array, angle: ArrayLike) -> Array:
    """Return rotations (..., 3, 3) about unit axes (..., 3) by angles (...), rad (Rodrigues)."""
    axis = np.asarray(axis, float)
    angle = np.asarray(angle, float)[..., None, None]
    K = skew(axis)
    return np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * (K @ K)


def stepped(T: Array, twists: Array, length: float) -> Array:
    """Return poses (N, 4, 4): T turned and moved by twists (N, 6), positions per length (m), world frame."""
    angle = np.linalg.norm(twists[:, 3:], axis=1)
    out = np.array(np.broadcast_to(T, (len(twists), 4, 4)))
    turn = rotation_about(twists[:, 3:] / np.maximum(angle, TINY)[:, None], angle)
    out[:, :3, :3] = turn @ out[:, :3, :3]
    out[:, :3, 3] += twists[:, :3] * length
    return out


def skew(v: Array) -> Array:
    """Return the matrices (..., 3, 3) that take w to the cross product v x w."""
    v = np.asarray(v, float)
    K = np.zeros((*v.shape[:-1], 3, 3))
    K[..., 2, 1], K[..., 0, 2], K[..., 1, 0] = v[..., 0], v[..., 1], v[..., 2]
    K[..., 1, 2], K[..., 2, 0], K[..., 0, 1] = -v[..., 0], -v[..., 1], -v[..., 2]
    return K


def rotation_vector(rotations: Array) -> Array:
    """Return the rotation vectors (..., 3), rad, of rotations (..., 3, 3), exact near 0 and near a half turn."""
    R = np.asarray(rotations, float)
    w, sine, cosine = _sine_of(R)
    angle = np.arctan2(sine, cosine)
    small = sine < SMALL_TURN
    scale = np.where(small, 1.0, angle / np.where(small, 1.0, sine))
    vector = w * scale[..., None]
    half_turn = (sine < NEAR_HALF_TURN) & (cosine < 0)
    if np.any(half_turn):
        # near a half turn the sine carries no axis; the symmetric part less the cosine, (1 - cos) a a^T, does
        S = (R + np.swapaxes(R, -1, -2)) / 2 - cosine[..., None, None] * np.eye(3)
        column = np.argmax(np.diagonal(S, axis1=-2, axis2=-1), axis=-1)
        a = np.take_along_axis(S, column[..., None, None], axis=-1)[..., 0]
        a = a / np.maximum(np.linalg.norm(a, axis=-1, keepdims=True), TINY)  # 0 beside it, where nothing is turned
        flip = np.where(np.sum(a * w, -1) < 0, -1.0, 1.0)
        vector = np.where(half_turn[..., None], a * (angle * flip)[..., None], vector)
    return vector


def pose_error(T: Array, wanted: Array) -> Array:
    """Return the distances (..., 2) between poses: metres, and radians of the rotation between them."""
    dp = np.linalg.norm(T[..., :3, 3] - wanted[..., :3, 3], axis=-1)
    _, sine, cosine = _sine_of(np.swapaxes(wanted[..., :3, :3], -1, -2) @ T[..., :3, :3])
    return np.stack([dp, np.arctan2(sine, cosine)], -1)


def _sine_of(R: Array) -> tuple[Array, Array, Array]:
    """Return axis times sine (..., 3), sine (...) and cosine (...) of rotations (..., 3, 3)."""
    w = np.stack([R[..., 2, 1] - R[..., 1, 2], R[..., 0, 2] - R[..., 2, 0], R[..., 1, 0] - R[..., 0, 1]], -1) / 2
    cosine: Array = (R[..., 0, 0] + R[..., 1, 1] + R[..., 2, 2] - 1) / 2
    return w, np.sqrt(np.sum(w * w, -1)), cosine
