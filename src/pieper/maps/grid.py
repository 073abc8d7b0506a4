"""What a map asks: voxels of a box, and orientations of the tool at each."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, cast

import numpy as np

from pieper import arguments
from pieper.errors import InputError
from pieper.kinematics.arrays import Array, ArrayLike, Bools, Indices
from pieper.kinematics.pose import checked_pose, rotation_about, transform
from pieper.tolerances import RELATIVE_ROUNDING

#: A box wider than this many reaches of the arm was said in millimetres.
WIDEST = 50.0
GOLDEN_TURN = np.pi * (1 + 5**0.5)


@dataclass(frozen=True, eq=False)
class Grid:
    """Voxels and orientations.

    Args:
        low: (3,) the box's lower corner, m.
        step: Side of a voxel, m.
        shape: How many voxels along x, y and z.
        turns: (k, 3, 3) orientations of the tool, rolls innermost.
        rolls: How many neighbouring orientations are one direction of the tool's z axis, rolled about it evenly.
        fold: 4, 2 or 1: turned about z by a whole turn's part, orientation o is number o + k / fold, round and round.
    """

    low: Array
    step: float
    shape: tuple[int, int, int]
    turns: Array
    rolls: int
    fold: int = 1

    @property
    def count(self) -> int:
        """How many voxels there are."""
        return math.prod(self.shape)

    def centres(self, which: Indices) -> Array:
        """Return the centres (k, 3) of voxels by their numbers, z innermost, m."""
        return self.low + (np.stack(np.unravel_index(which, self.shape), -1) + 0.5) * self.step

    def voxel_of(self, p: Array) -> tuple[Bools, Indices]:
        """Return which points (N, 3) lie in the box (N,), and the numbers (N,) of their voxels, 0 outside."""
        index = np.floor((p - self.low) / self.step).astype(np.int64)
        inside = np.asarray(((index >= 0) & (index < np.array(self.shape))).all(1), np.bool_)
        i, j, k = np.where(inside[:, None], index, 0).T
        return inside, np.asarray((i * self.shape[1] + j) * self.shape[2] + k, np.int64)

    def turn_of(self, R: Array) -> Indices:
        """Return the numbers (N,) of the orientations nearest to rotations (N, 3, 3)."""
        return np.argmax(np.einsum("nij,kij->nk", R, self.turns), axis=1)

    def poses(self, which: Indices, turns: Array) -> Array:
        """Return poses (len(which) * len(turns), 4, 4): voxel by voxel, orientation by orientation."""
        T = np.zeros((len(which), len(turns), 4, 4))
        T[..., :3, :3] = turns
        T[..., :3, 3] = self.centres(which)[:, None]
        T[..., 3, 3] = 1.0
        return T.reshape(-1, 4, 4)


def fold_of(count: int) -> int:
    """Return by which part of a whole turn about z so many directions are taken to each other: 4, 2 or 1."""
    return 4 if count % 4 == 0 else 2 if count % 2 == 0 else 1


def orientations_of(count: int, rolls: int) -> Array:
    """Return rotations (count * rolls, 3, 3): z axes evenly on the sphere, each rolled evenly, rolls innermost.

    The z axes are Fibonacci's lattice (no crowd at poles) on the quarter of the sphere, or the half, that `fold_of`
    allows, and its images turned about z, exactly.
    """
    fold = fold_of(count)
    i = np.arange(count // fold) + 0.5
    z = 1 - 2 * i / len(i)
    r, azimuth = np.sqrt(1 - z * z), GOLDEN_TURN / fold * i
    d = np.stack([r * np.cos(azimuth), r * np.sin(azimuth), z], -1)
    aside = np.where(np.abs(d[:, 2:]) < 0.9, [0.0, 0.0, 1.0], [1.0, 0.0, 0.0])
    x = np.cross(aside, d)
    x /= np.linalg.norm(x, axis=1, keepdims=True)
    first = np.stack([x, np.cross(d, x), d], -1)
    part = {1: np.eye(3), 2: np.diag([-1.0, -1, 1]), 4: np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])}[fold]
    turn = rotation_about(np.array([0.0, 0.0, 1.0]), 2 * np.pi * np.arange(rolls) / rolls)
    rolled = (first[:, None] @ turn[None]).reshape(-1, 3, 3)
    parts = [rolled]
    for _ in range(fold - 1):
        # a product with zeros and ones has no rounding
        parts.append(part @ parts[-1])
    return np.asarray(np.concatenate(parts), np.float64)


def grid_of(
    box: Sequence[Sequence[float]],
    step: float,
    orientations: Sequence[int] | ArrayLike,
    task: str,
    reach: float,
    fits: Callable[[int, int], None] = lambda voxels, turns: None,
) -> Grid:
    """Return the checked grid.

    Args:
        box: ((x0, x1), (y0, y1), (z0, z1)), m.
        step: Side of a voxel, m; the box is widened upwards to whole voxels.
        orientations: (directions, rolls), or rotations (k, 3, 3).
        task: The arm's task: a position has no orientation, an axis no roll.
        reach: The arm's length, m.
        fits: Told how many voxels and orientations there will be before they are made; refuses what is too much.

    Raises:
        InputError: A box or step that is none, or in millimetres; orientations that are no rotations.
    """
    corners = arguments.numbers(box, "box", "((x0, x1), (y0, y1), (z0, z1)) with x0 < x1, in metres")
    if corners.shape != (3, 2) or not np.isfinite(corners).all() or (corners[:, 1] <= corners[:, 0]).any():
        raise InputError(f"box must be ((x0, x1), (y0, y1), (z0, z1)) with x0 < x1, in metres, got {box!r}.", given=box)
    side = corners[:, 1] - corners[:, 0]
    if side.max() > WIDEST * reach:
        raise InputError(
            f"the box is {side.max():.4g} m wide and the arm {reach:.3g} m long; metres are meant. Divide "
            "millimetres by 1000.",
            given=box,
        )
    arguments.number(step, "step", "m")
    if not 0 < step <= side.min() * (1 + RELATIVE_ROUNDING):
        raise InputError(
            f"step must be positive, in metres, at most the box's smallest side ({side.min():.4g} m), got {step!r}: "
            "20 mm is 0.02.",
            given=step,
        )
    shape = tuple(int(n) for n in np.ceil(side / step - RELATIVE_ROUNDING))
    counts = _counts(orientations)
    if counts is not None:
        fits(math.prod(shape), {"position": 1, "position+axis": counts[0]}.get(task, counts[0] * counts[1]))
        # an axis has no roll, a position no orientation
        counts = {"position": (1, 1), "position+axis": (counts[0], 1)}.get(task, counts)
    turns, rolls, fold = _orientations(orientations, counts)
    if counts is None:
        fits(math.prod(shape), len(turns))
    if task == "position":
        turns, rolls, fold = turns[:1], 1, 1
    elif task == "position+axis":
        turns, rolls = turns[::rolls], 1
    return Grid(corners[:, 0], float(step), cast("tuple[int, int, int]", shape), turns, rolls, fold)


def _counts(said: Any) -> tuple[int, int] | None:
    """Return (directions, rolls) where that is said."""
    counts = list(said) if isinstance(said, (tuple, list)) else []
    whole = len(counts) == 2 and all(isinstance(n, (int, np.integer)) and n >= 1 for n in counts)
    return (int(counts[0]), int(counts[1])) if whole else None


def _orientations(said: Any, counts: tuple[int, int] | None) -> tuple[Array, int, int]:
    if counts is not None:
        return orientations_of(*counts), counts[1], fold_of(counts[0])
    turns = arguments.numbers(said, "orientations", "(directions, rolls) or rotations (k, 3, 3)")
    if turns.ndim == 3 and len(turns):
        poses = turns if turns.shape[1:] == (4, 4) else transform(turns) if turns.shape[1:] == (3, 3) else None
        if poses is not None:
            return checked_pose(poses, "orientations", batch=True)[:, :3, :3], 1, 1
    raise InputError(
        "orientations must be (directions, rolls), both at least 1, or rotations (k, 3, 3), at least one, or poses "
        f"(k, 4, 4), whose rotations are taken; got {arguments.kind_of(said)}.",
        given=said,
    )
