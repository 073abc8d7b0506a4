"""The largest value of a formula over all joint vectors, approached from the best of some."""

from __future__ import annotations

from collections.abc import Callable, Collection

import numpy as np

from pieper.judge.model import ArmModel
from pieper.tolerances import CONDITION_STEP

CLIMBS, STEPS, TRIES = 8, 60, 32  # from so many joint vectors it is approached, in so many ever smaller steps


def climbed(
    model: ArmModel, value: Callable[[np.ndarray], np.ndarray], q: np.ndarray, *, held: Collection[int] = ()
) -> tuple[np.ndarray, np.ndarray]:
    """The joint vectors (m, n) to which the best of some (K, n) lead, and their values (m,).

    Args:
        model: The arm.
        value: Joint vectors (K, n) -> what is to be large, (K,); -inf where a joint vector is none of those meant.
        q: Where to start.
        held: Joints (1-based) that stay where they are.
    """
    start = value(q)
    top = np.argsort(-start)[:CLIMBS]
    q, reached = q[top], start[top]
    rng = np.random.default_rng(8)
    far = np.array([model.length() if model.sliding(j + 1) else 1.0 for j in range(model.n)])
    far[[j - 1 for j in held]] = 0.0
    for step in np.geomspace(1.0, CONDITION_STEP, STEPS):
        tried = (q[:, None] + step * far * rng.normal(size=(len(q), TRIES, model.n))).reshape(-1, model.n)
        values = value(tried).reshape(len(q), TRIES)
        pick = values.argmax(axis=1)
        better = values[np.arange(len(q)), pick] > reached
        q = np.where(better[:, None], tried.reshape(len(q), TRIES, -1)[np.arange(len(q)), pick], q)
        reached = np.maximum(reached, values.max(axis=1))
    return q, reached
