"""Distances of convex bodies, and of cylinders from other than capsules: directions from `coal`, bounds of our own.

Coal (Pan, Chitta and Manocha, 2012; Montaut et al., 2022) finds the nearest points. Along their direction n two bodies
are apart by min over the one of n . x less max over the other, which is worked out here from the shapes themselves: a
lower bound of the distance whatever n is, and the distance itself where n is right.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from pieper.collision.model import Model
from pieper.description.shapes import KINDS, Box, Capsule, Convex, Cylinder, Shape
from pieper.errors import InputError
from pieper.tolerances import HULL_STEP, NOTHING_NEAR

Array = npt.NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Between:
    """Two bodies apart.

    Attributes:
        least: What their signed distance is at least, m: proved.
        said: What coal says of it, m.
        points: (2, 3) the nearest points, m.
        normal: (3,) from the second to the first.
    """

    least: float
    said: float
    points: Array
    normal: Array


class Hulls:
    """Pairs of a model that the kernel has no distance of."""

    def __init__(self, model: Model) -> None:
        self._model = model
        self._coal = _coal(model)
        self._made: dict[int, tuple[Any, Array, float]] = {}
        self._request = self._coal.DistanceRequest()
        self._request.gjk_tolerance = self._request.epa_tolerance = HULL_STEP
        self._request.gjk_max_iterations = self._request.epa_max_iterations = 512

    def between(self, pair: int, frames: Array) -> Between:
        """Return how far a pair is apart where the arm's frames are (n + 2, 4, 4)."""
        coal, model = self._coal, self._model
        i, j = (int(k) for k in model.pairs[pair])
        made, poses, shapes = [], [], []
        for k in (i, j):
            solid, place, layer = self._of(k)
            T = place if model.on[k] < 0 else frames[model.on[k]] @ place
            made.append((solid, coal.Transform3s(T[:3, :3], T[:3, 3]), layer))
            shapes.append(model.shapes[k] if model.on[k] < 0 else model.shapes[k].moved(frames[model.on[k]]))
            poses.append(T)
        result = coal.DistanceResult()
        said = coal.distance(made[0][0], made[0][1], made[1][0], made[1][1], self._request, result)
        layers = (made[0][2], made[1][2])
        a, b = np.array(result.getNearestPoint1()), np.array(result.getNearestPoint2())
        directions = [a - b, np.array(result.normal), poses[0][:3, 3] - poses[1][:3, 3]]
        directions += [poses[k][:3, c] for k in (0, 1) for c in range(3)]
        least, normal = _farthest_apart(shapes[0], shapes[1], directions)
        # what comes back of two deep inside each other is not always a distance
        said = least if not abs(said) < NOTHING_NEAR else said - sum(layers)
        if not np.isfinite(a).all() or not np.isfinite(b).all() or said <= 0:
            a = _support(shapes[0], -normal)
            b = a - least * normal
        else:
            a, b = a - layers[0] * normal, b + layers[1] * normal
        return Between(least, said, np.stack([a, b]), normal)

    def _of(self, k: int) -> tuple[Any, Array, float]:
        if k not in self._made:
            self._made[k] = _geometry(self._coal, self._model.shapes[k], self._model.names[k])
        return self._made[k]


def _coal(model: Model) -> Any:
    try:
        import coal  # pyright: ignore[reportMissingImports]
    except ImportError:
        i, j = model.pairs[model.known]
        one, other = (KINDS[type(model.shapes[k])] for k in (i, j))
        raise InputError(
            f"the distance of {model.names[i]} ({one}) from {model.names[j]} ({other}) needs an extra: pip install "
            "'pieper[collision]'. Without it there are capsules, boxes, and cylinders against capsules.",
            pair=(model.names[i], model.names[j]),
        ) from None
    return coal


def _geometry(coal: Any, shape: Shape, name: str) -> tuple[Any, Array, float]:
    """Return coal's geometry, its pose (4, 4) in the shape's frame, and the layer about it that coal is not told of."""
    if isinstance(shape, Box):
        return coal.Box(*(float(x) for x in shape.size)), shape.T, 0.0
    if isinstance(shape, Cylinder):
        return coal.Cylinder(shape.r, shape.h), shape.T, 0.0
    points = shape.points if isinstance(shape, Convex) else np.array([shape.a, shape.b])
    if isinstance(shape, Capsule):
        along = shape.b - shape.a
        length = float(np.linalg.norm(along))
        T = np.eye(4)
        T[:3, 3] = (shape.a + shape.b) / 2
        if length > 0:
            z = along / length
            x = np.cross(np.eye(3)[np.argmin(np.abs(z))], z)
            x /= np.linalg.norm(x)
            T[:3, :3] = np.stack([x, np.cross(z, x), z], 1)
        return coal.Capsule(shape.r, length), T, 0.0
    rows = coal.StdVec_Vec3s()
    for point in points:
        rows.append(point)
    try:
        hull = coal.ConvexBase.convexHull(rows, True, "Qt")
    except (RuntimeError, ValueError) as error:
        raise InputError(f"the points of {name} have no hull: {str(error)[:200]}", given=name) from None
    return hull, np.eye(4), shape.r


def _farthest_apart(one: Shape, other: Shape, directions: list[Array]) -> tuple[float, Array]:
    best, normal = -np.inf, np.array([0.0, 0.0, 1.0])
    for n in directions:
        length = float(np.linalg.norm(n))
        if not 0 < length < np.inf:
            continue
        for sign in (1.0, -1.0):
            unit = sign * n / length
            apart = float(_support(one, -unit) @ unit - _support(other, unit) @ unit)
            if apart > best:
                best, normal = apart, unit
    return best, normal


def _support(shape: Shape, n: Array) -> Array:
    """Return the point (3,) of a shape that is farthest along a unit vector n."""
    if isinstance(shape, Capsule):
        return (shape.a if shape.a @ n > shape.b @ n else shape.b) + shape.r * n
    if isinstance(shape, Convex):
        return shape.points[np.argmax(shape.points @ n)] + shape.r * n
    R, p = shape.T[:3, :3], shape.T[:3, 3]
    seen = R.T @ n
    if isinstance(shape, Box):
        return p + R @ (np.sign(seen) * shape.size / 2)
    flat = float(np.hypot(seen[0], seen[1]))
    rim = seen[:2] * (shape.r / flat) if flat > 0 else np.zeros(2)
    return p + R @ np.array([rim[0], rim[1], np.sign(seen[2]) * shape.h / 2])
