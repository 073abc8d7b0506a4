"""How far an arm is from what it must not touch: the nearest pair, its points, and how that changes with the joints."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

from pieper.collision.hulls import Hulls
from pieper.collision.model import Model
from pieper.kinematics.arrays import ArrayLike
from pieper.kinematics.forward import checked_joints
from pieper.tolerances import NOTHING_NEAR

Array = npt.NDArray[np.float64]


class Distance(np.ndarray):
    """Distances (...,) of the nearest pairs, m: an array that also says which pair, where, and how it changes.

    Negative where two bodies overlap: by how far one must be moved to part them. What is computed of it (a sum, a row)
    is a plain array.

    Attributes:
        pair: (..., 2) names: a body of the arm, and what it is nearest to.
        points: (..., 2, 3) the nearest points of the two, m.
        normal: (..., 3) unit vector from the second to the first.
        gradient: (..., n) how the distance changes with the joints, m per rad or m; at a place where two pairs are as
            near, that of one of them.
    """

    pair: npt.NDArray[np.str_]
    points: Array
    normal: Array
    _change: Callable[[], Array]

    def __new__(
        cls, metres: Array, pair: npt.NDArray[np.str_], points: Array, normal: Array, change: Callable[[], Array]
    ) -> Distance:
        """Return the distances (...,), unchangeable."""
        out = np.array(metres).view(cls)
        out.pair, out.points, out.normal, out._change = pair, points, normal, change
        out.setflags(write=False)
        return out

    @property
    def gradient(self) -> Array:
        """How each distance changes with the joints, (..., n), m per rad or m."""
        return self._change()

    def __array_wrap__(self, array: Any, context: Any = None, return_scalar: bool = False) -> Any:
        """Hand back what was computed of distances as a plain array."""
        plain = np.asarray(array)
        return plain[()] if return_scalar else plain

    def __getitem__(self, key: Any) -> Any:
        return np.asarray(self)[key]

    def __reduce__(self) -> Any:
        return (_again, (np.asarray(self), self.pair, self.points, self.normal, self.gradient))


def _again(metres: Array, pair: npt.NDArray[np.str_], points: Array, normal: Array, gradient: Array) -> Distance:
    return Distance(metres, pair, points, normal, lambda: gradient)


def distance(model: Model, given: ArrayLike) -> Distance:
    """Return how far the arm is from touching, at joint vectors (..., n)."""
    q = checked_joints(given, model.chain.n, prismatic=model.chain.prismatic)
    flat = np.ascontiguousarray(q.reshape(-1, model.chain.n))
    metres, which, points, normal = nearest(model, flat)
    names = np.array([*(model.names_of(k) for k in range(len(model.pairs))), ("", "")], dtype=np.str_)
    shape = q.shape[:-1]
    return Distance(
        metres.reshape(shape),
        names[which].reshape(*shape, 2),
        points.reshape(*shape, 2, 3),
        normal.reshape(*shape, 3),
        lambda: gradient(model, flat, which, points, normal).reshape(q.shape),
    )


def nearest(model: Model, q: Array) -> tuple[Array, npt.NDArray[np.int64], Array, Array]:
    """Return the distances (N,), pairs (N,), points (N, 2, 3) and normals (N, 3) of joint vectors (N, n)."""
    count = len(q)
    if model.exact is not None:
        metres, which, points, normal = model.exact.nearest(model.chain_values(q))
        which = which.astype(np.int64)
    else:
        metres, which = np.full(count, NOTHING_NEAR), np.full(count, -1)
        points, normal = np.zeros((count, 2, 3)), np.tile([0.0, 0.0, 1.0], (count, 1))
    if model.boxed is None or not count:
        return metres, which, points, normal
    hulls = Hulls(model)
    least = model.boxed.each(model.chain_values(q))
    for i in np.flatnonzero(least.min(1) < metres):
        frames = model.chain.native.frames(q[i], model.base)
        for k in np.argsort(least[i]):
            if least[i, k] >= metres[i]:
                break
            found = hulls.between(model.known + int(k), frames)
            if found.least < metres[i]:
                metres[i], which[i] = found.least, model.known + int(k)
                points[i], normal[i] = found.points, found.normal
    return metres, which, points, normal


def gradient(model: Model, q: Array, which: npt.NDArray[np.int64], points: Array, normal: Array) -> Array:
    """Return how the distances of pairs (N,) change with the joints, (N, n).

    The nearest points stay where they are to first order: the distance changes as the first body's point is moved along
    the normal, by the joints between the two bodies alone.
    """
    chain = model.chain
    frames = chain.native_axes.frames(q, np.eye(4))[:, 1:-1]
    axis, origin = frames[:, :, :3, 2], frames[:, :, :3, 3]
    arm = points[:, None, 0] - origin
    moves = np.where(chain.sliding[None, :, None], axis, np.cross(axis, arm))
    change = np.einsum("njc,nc->nj", moves, normal)
    if not len(model.pairs):
        return np.zeros_like(change)
    links = model.links[model.pairs[which]]
    joint = np.arange(chain.axis_count)
    change = np.where((joint >= links[:, 1:]) & (joint < links[:, :1]) & (which >= 0)[:, None], change, 0.0)
    return change if chain.coupling is None else change @ chain.coupling
