"""Postures at which several expressions vanish together, looked for from random ones."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

from pieper.tolerances import (
    DEGENERATE_EXACT,
    DEGENERATE_NEAR,
    DEGENERATE_RANK,
    DEGENERATE_RANK_NEAR,
    DEGENERATE_STEP,
)

Array = npt.NDArray[np.float64]
Values = Callable[[Array], Array]

NEWTON = 30  # steps; those that converge need about ten
STARTS = 24  # random postures


def random_postures(count: int, n: int, sliding: list[int], size: float, rng: np.random.Generator) -> Array:
    """Return postures (count, n): any angle, slides (0-based `sliding`) as far as `size`."""
    q = rng.uniform(-np.pi, np.pi, (count, n))
    q[:, sliding] = rng.uniform(-1, 1, (count, len(sliding))) * size
    return q


def scale_of(n: int, sliding: list[int], size: float) -> Array:
    """What counts as one for each joint (n,): a radian, and for slides (0-based `sliding`) the arm's longest length."""
    scale = np.ones(n)
    scale[sliding] = size
    return scale


def vanishing_near(values: Values, q: Array, scale: Array) -> tuple[Array, Array, npt.NDArray[np.bool_]]:
    """Return postures (N, n) that Newton's steps lead to from q (N, n), what is left (N,), and whether that is nothing.

    Lengths of an arm may lie six decades apart, so nothing is measured in metres: expressions are taken by their size
    at the start, and they vanish where what is left is less than what a ten-millionth of a turn makes of it. The square
    of a small length is not a zero by this, however small, and rounding is.

    Args:
        values: q (N, n) -> (N, m), what is to vanish.
        q: Where to start.
        scale: (n,) what counts as one for each joint, see `scale_of`.
    """
    n = q.shape[1]
    typical = np.abs(np.nan_to_num(values(q))).max(axis=0)
    typical = np.where(typical > 0, typical, 1.0)

    def measured(u: Array) -> Array:
        return np.nan_to_num(values(u * scale)) / typical

    with np.errstate(all="ignore"):
        u = _led(measured, q / scale, DEGENERATE_RANK)
        left = np.abs(measured(u))
        near = (left.max(axis=1) < DEGENERATE_NEAR) & (left.max(axis=1) > DEGENERATE_EXACT)
        if near.any():
            # what vanishes twice over hardly changes beside the place, and its direction was not gone along
            nearer = _led(measured, u[near], DEGENERATE_RANK_NEAR)
            better = np.abs(measured(nearer)).max(axis=1) < left[near].max(axis=1)
            u[near] = np.where(better[:, None], nearer, u[near])
            left = np.abs(measured(u))
        ways = np.concatenate([np.eye(n), np.random.default_rng(37).uniform(-1, 1, (n, n))])
        beside = np.abs([measured(u + way * DEGENERATE_STEP) - measured(u) for way in ways]).max(axis=0)
    return u * scale, left.max(axis=1), np.asarray((left <= beside).all(axis=1), dtype=bool)


def _led(measured: Values, u: Array, rank: float) -> Array:
    """Return where Newton's steps lead from u (N, n); directions below `rank` are not gone along."""
    n = u.shape[1]
    for _ in range(NEWTON):
        points = np.concatenate([u, *(u + h for h in DEGENERATE_STEP * np.eye(n))])
        every = measured(points).reshape(n + 1, len(u), -1)
        here, J = every[0], (every[1:] - every[0]) / DEGENERATE_STEP
        if np.abs(here).max() < DEGENERATE_EXACT:
            break
        move = np.einsum("kij,kj->ki", np.linalg.pinv(np.moveaxis(J, 0, 2), rcond=rank), here)
        u = u - np.clip(move, -0.5, 0.5)
    return u


def vanish_together(values: list[Callable[[Array], Any]], n: int, sliding: list[int], size: float) -> bool:
    """Return whether postures are found at which several expressions, q (N, n) -> (N,) or a number, vanish together."""
    start = random_postures(STARTS, n, sliding, size, np.random.default_rng(31))

    def stacked(q: Array) -> Array:
        return np.stack([np.broadcast_to(v(q), len(q)) for v in values], axis=1)

    return bool(vanishing_near(stacked, start, scale_of(n, sliding, size))[2].any())


def pose_gap(T: Array, wanted: Array, given: str) -> Array:
    """Return by how much poses (..., 4, 4) miss what is given of others, such as "noap": (...,).

    Columns of the rotation are taken as they are, whatever the arm's size; the position by its size where that is more
    than one, as rounding leaves it.
    """
    size = np.maximum(1.0, np.abs(wanted[..., :3, 3]).max(axis=-1))
    gap = np.abs(T - wanted)[..., :3, :].max(axis=-2)
    gap[..., 3] /= size
    return np.asarray(gap[..., ["noap".index(c) for c in given]].max(axis=-1), dtype=float)
