"""What was measured at joint vectors: poses, positions, distances from a fixed point, or heights over a plane."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from pieper import arguments
from pieper.errors import InputError
from pieper.kinematics.arrays import Array, ArrayLike
from pieper.kinematics.pose import PoseLike, as_pose, checked_pose, rotation_vector, skew
from pieper.tolerances import LEAST_NOISE, TURN_SERIES
from pieper.words_by_number import plural

KINDS = ("pose", "position", "distance", "plane")
#: Numbers a row has, and numbers of the set-up that are fitted along: the fixed point, or the plane's tilts and height.
WIDTH = {"pose": 6, "position": 3, "distance": 1, "plane": 1}
SETUP = {"pose": 0, "position": 0, "distance": 3, "plane": 3}
#: Directions that a kind cannot see of any arm: turns of the tool; with an unknown set-up the arm's place too, and over
#: a plane its size.
BLIND = {"pose": 0, "position": 3, "distance": 9, "plane": 10}


@dataclass(frozen=True, eq=False)
class Measurements:
    """What was measured.

    Args:
        kind: One of `KINDS`.
        values: (N, 4, 4) poses, (N, 3) positions, or (N,) distances or heights, m.
        point: (3,) the fixed point, of distances, m; or the plane's unit normal.
        height: Of a plane over the base frame's origin, along its normal, m.
    """

    kind: str
    values: Array
    point: Array
    height: float = 0.0

    @property
    def positions(self) -> Array:
        """(N, 3) measured positions, m, of poses and positions."""
        return self.values[:, :3, 3] if self.kind == "pose" else self.values

    def rows(self, which: npt.NDArray[np.int64]) -> Measurements:
        """Return some of the rows."""
        return replace(self, values=self.values[which])

    def moved(self, step: Array) -> Measurements:
        """Return the same with another set-up, a step (3,) away; unchanged where there is none."""
        if self.kind == "distance":
            return replace(self, point=self.point + step)
        if self.kind == "plane":
            a, b = np.linalg.svd(self.point[None])[2][1:]
            normal = self.point + step[0] * a + step[1] * b
            return replace(self, point=normal / np.linalg.norm(normal), height=self.height + step[2])
        return self

    def placed(self, p: Array) -> Measurements:
        """Return the same with the set-up that suits tool positions (N, 3) best, in one linear step."""
        if self.kind == "distance":
            # |p|^2 - d^2 = 2 p . c - |c|^2
            A = np.column_stack([2 * p, -np.ones(len(p))])
            x = np.linalg.lstsq(A, np.sum(p * p, 1) - self.values**2, rcond=None)[0]
            # points of a plane leave the way across it open, which |c|^2 says but for the side
            across = np.linalg.svd(A)[2][-1]
            a, b, c = across[:3] @ across[:3], 2 * x[:3] @ across[:3] - across[3], x[:3] @ x[:3] - x[3]
            ways = (-b + np.array([-1.0, 1.0]) * np.sqrt(max(b * b - 4 * a * c, 0.0))) / (2 * a) if a > 0 else []
            points = [x[:3] + way * across[:3] for way in (0.0, *ways)]
            gaps = [np.abs(np.linalg.norm(p - point, axis=1) - self.values).sum() for point in points]
            return replace(self, point=points[int(np.argmin(gaps))])
        if self.kind == "plane":
            centre, h = p.mean(0), self.values - self.values.mean()
            normal = np.linalg.svd(p - centre)[2][-1]
            if np.linalg.norm(h) > 0:
                said = np.linalg.lstsq(p - centre, h, rcond=None)[0]
                flat = np.abs((p - centre) @ normal - h).mean()
                size = np.linalg.norm(said)
                if size > 0 and np.abs((p - centre) @ said / size - h).mean() < flat:
                    normal = said / size
            return replace(self, point=normal, height=float(normal @ centre - self.values.mean()))
        return self

    def misses(self, T: Array) -> tuple[Array, Array]:
        """Return by how much poses T (N, 4, 4) miss: (N, 3 or 1), m, and (N, 3 or 0), rad."""
        p, none = T[:, :3, 3], np.zeros((len(T), 0))
        if self.kind == "pose":
            turn = T[:, :3, :3] @ np.swapaxes(self.values[:, :3, :3], 1, 2)
            return p - self.values[:, :3, 3], rotation_vector(turn)
        if self.kind == "position":
            return p - self.values, none
        if self.kind == "distance":
            return (np.linalg.norm(p - self.point, axis=1) - self.values)[:, None], none
        return (p @ self.point - self.height - self.values)[:, None], none

    def derivatives(self, T: Array, twists: Array) -> tuple[Array, Array]:
        """Return the derivatives of `misses` by the arm's parameters, then by the set-up.

        Args:
            T: (N, 4, 4) poses.
            twists: (N, 6, k) how they move with the parameters, turn first, base frame.
        """
        p = T[:, :3, 3]
        turn, way = twists[:, :3], twists[:, 3:] - skew(p) @ twists[:, :3]
        if self.kind == "pose":
            miss = self.misses(T)[1]
            return way, _left_inverse(miss) @ turn
        if self.kind == "position":
            return way, way[:, :0]
        if self.kind == "distance":
            gap = p - self.point
            u = (gap / np.linalg.norm(gap, axis=1, keepdims=True))[:, None]
            return np.concatenate([u @ way, -u], 2), way[:, :0]
        a, b = np.linalg.svd(self.point[None])[2][1:]
        own = np.stack([p @ a, p @ b, -np.ones(len(p))], 1)[:, None]
        along = np.einsum("i,nik->nk", self.point, way)[:, None]
        return np.concatenate([along, own], 2), way[:, :0]


def _left_inverse(v: Array) -> Array:
    """Return (N, 3, 3): how rotation vectors v (N, 3) change with a turn in the frame they are said in."""
    K, angle = skew(v), np.linalg.norm(v, axis=-1)[:, None, None]
    safe = np.where(angle < TURN_SERIES, 1.0, angle)
    full = 1 / safe**2 - (1 + np.cos(safe)) / (2 * safe * np.sin(safe))
    return np.eye(3) - K / 2 + np.where(angle < TURN_SERIES, 1 / 12 + angle**2 / 720, full) * (K @ K)


def measured_as(kind: str, given: PoseLike | None, count: int) -> Measurements:
    """Return checked measurements of `count` rows.

    Raises:
        InputError: An unknown kind, another shape or number of rows, numbers that are not finite, not poses.
    """
    arguments.word(kind, "kind", KINDS)
    if kind == "pose":
        values = checked_pose([] if given is None else given, "measured", batch=True)
        shape: tuple[int, ...] = (count, 4, 4)
    else:
        values = _numbers(np.zeros(count) if given is None and kind == "plane" else given)
        shape = (count, 3) if kind == "position" else (count,)
        if kind != "position" and values.shape == (count, 1):
            values = values[:, 0]
    if values.shape != shape:
        single = " For a single pose write measured[None]." if values.shape == (4, 4) else ""
        raise InputError(
            f"measured must have shape {shape} for kind {kind!r} and {plural(count, 'joint vector')}, got "
            f"{values.shape}.{single}",
            given=values.shape,
        )
    if kind == "distance" and np.min(values, initial=np.inf) <= 0:
        raise InputError("measured distances must be positive.", index=int(np.argmin(values)))
    return Measurements(kind, values, np.array([0.0, 0.0, 1.0]))


def _numbers(given: PoseLike | None) -> Array:
    values = arguments.numbers(as_pose(given), "measured")
    if not np.isfinite(values).all():
        index = tuple(int(i) for i in np.argwhere(~np.isfinite(values))[0])
        raise InputError(f"measured must be finite, got {values[index]} at index {index}.", index=index)
    return values


def spread(x: Array) -> float:
    """Return how far points (N, k) usually are from their middle."""
    return float(np.median(np.linalg.norm(x - np.median(x, axis=0), axis=1)))


def noise_of(sigma: ArrayLike | Sequence[float] | None) -> tuple[float, float] | None:
    """Return the noise (m, rad) of one number measured, None where it is not known.

    Raises:
        InputError: Not one or two positive numbers.
    """
    if sigma is None:
        return None
    said = np.atleast_1d(arguments.numbers(sigma, "sigma", "(metres, radians)"))
    if said.shape not in ((1,), (2,)) or not np.isfinite(said).all() or said.min() < LEAST_NOISE:
        raise InputError(
            "sigma must be (metres, radians), the noise of one number measured, positive and at least "
            f"{LEAST_NOISE:g}, or None; got {sigma!r}.",
            given=sigma,
        )
    return float(said[0]), float(said[-1])
