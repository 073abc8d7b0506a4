"""Postures at which several expressions vanish together, looked for from random ones."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

from pieper.tolerances import COEFFICIENT_VANISHES, DEGENERATE_EXACT, DEGENERATE_RANK, DEGENERATE_STEP

Array = npt.NDArray[np.float64]
Values = Callable[[Array], Array]

NEWTON = 30  # steps; those that converge need about ten
STARTS = 24  # random postures


def random_postures(count: int, n: int, sliding: list[int], size: float, rng: np.random.Generator) -> Array:
    """Return postures (count, n): any angle, slides (0-based `sliding`) as far as `size`."""
    q = rng.uniform(-np.pi, np.pi, (count, n))
    q[:, sliding] = rng.uniform(-1, 1, (count, len(sliding))) * size
    return q


def vanishing_near(values: Values, q: Array) -> tuple[Array, Array]:
    """Return the postures (N, n) that Newton's steps lead to from q (N, n), and the largest value left there, (N,).

    Args:
        values: q (N, n) -> (N, m), what is to vanish.
        q: Where to start.
    """
    n = q.shape[1]
    with np.errstate(all="ignore"):
        for _ in range(NEWTON):
            points = np.concatenate([q, *(q + h for h in DEGENERATE_STEP * np.eye(n))])
            every = values(points).reshape(n + 1, len(q), -1)
            here, J = np.nan_to_num(every[0]), np.nan_to_num((every[1:] - every[0]) / DEGENERATE_STEP)
            if np.abs(here).max() < DEGENERATE_EXACT:
                break
            move = np.einsum("kij,kj->ki", np.linalg.pinv(np.moveaxis(J, 0, 2), rcond=DEGENERATE_RANK), here)
            q = q - np.clip(move, -0.5, 0.5)
        return q, np.abs(values(q)).max(axis=1)


def vanish_together(values: list[Callable[[Array], Any]], n: int, sliding: list[int], size: float) -> bool:
    """Return whether postures are found at which several expressions, q (N, n) -> (N,) or a number, vanish together."""
    start = random_postures(STARTS, n, sliding, size, np.random.default_rng(31))
    _, gap = vanishing_near(lambda q: np.stack([np.broadcast_to(v(q), len(q)) for v in values], axis=1), start)
    return bool(gap.min() < COEFFICIENT_VANISHES * max(1.0, size))
