"""Following a self-motion whose every point is a fold: across it the pose is left to second order only.

The Jacobian has one null direction too many there, and which of them is the curve's no tangent says. Steps along any of
them, brought back onto the pose, stay along the curve and are taken back across it: the way they go is the curve's.
"""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.kinematics.chain import Chain
from pieper.kinematics.newton import missed, newton, null_space
from pieper.tolerances import CURVE_STEP, FOLDS_STEP, HOLDS, INDEPENDENT_STEPS, OPEN_WAYS, PRECISE_RANK, TINY

#: How far along a null direction it is asked whether the solutions go that way (rad; per length).
PROBE = 0.05
#: Newton steps back onto the pose, where each only halves what lies across the folds.
SLOW_STEPS = 60
#: Cosine by which a step may turn, and by how much the next one is longer.
STRAIGHT, GROW = 0.95, 1.5


def open_ways(chain: Chain, q: Array) -> int:
    """Return how many directions the Jacobian at q (n,) leaves open, those that only lead nowhere counted."""
    s, _ = null_space(chain, q)
    return int(np.count_nonzero(s <= OPEN_WAYS * max(float(s[0]), TINY)))


def ways_gone(chain: Chain, q: Array, T: Array, count: int) -> Array:
    """Return the independent unit ways (k, n) in which steps along the last `count` null directions at q (n,) go."""
    steps = PROBE * null_space(chain, q)[1][chain.n - count :]
    there = newton(chain, q + steps * chain.joints.unit, T, steps=SLOW_STEPS, cutoff=PRECISE_RANK)
    gone = chain.joints.difference(there, q)[missed(chain, there, T) < HOLDS] / PROBE
    _, size, ways = np.linalg.svd(gone, full_matrices=False)
    return ways[size > INDEPENDENT_STEPS]


def along_folds(chain: Chain, q: Array, T: Array, most_steps: int) -> tuple[Array, bool]:
    """Return the points (k, n) of a curve of folds through q (n,), followed both ways, and whether it closed."""
    count = open_ways(chain, q)
    ways = ways_gone(chain, q, T, count) if count > max(1, chain.n - 6) else np.zeros((0, chain.n))
    if len(ways) != 1:
        return q[None], False
    forward, closed = _walk(chain, q, T, ways[0], most_steps)
    if closed:
        return forward, True
    backward, _ = _walk(chain, q, T, -ways[0], most_steps)
    return np.concatenate([backward[:0:-1], forward]), False


def _walk(chain: Chain, q: Array, T: Array, way: Array, most_steps: int) -> tuple[Array, bool]:
    """Return the points (k, n) from q on along a way (n,), and whether the curve closed."""
    unit, points, step = chain.joints.unit, [q], CURVE_STEP / 2
    while len(points) < most_steps:
        here = points[-1]
        ahead = newton(chain, here + step * way * unit, T, steps=SLOW_STEPS, cutoff=PRECISE_RANK)
        move = (ahead - here) / unit
        went = float(np.linalg.norm(move))
        straight = went > 0.5 * step and float(move @ way) > STRAIGHT * went
        if not straight or missed(chain, ahead, T) > HOLDS:
            step /= 2
            if step < FOLDS_STEP:
                break
            continue
        # the way from point to point, turned on as far again as it has turned
        new = 2 * move / went - way if len(points) > 1 else move / went
        points.append(ahead)
        home = chain.joints.difference(q, here)
        forth = float(home @ move) / went
        if len(points) > 3 and 0 < forth <= went and np.linalg.norm(home - forth * move / went) < 0.2 * went:
            points[-1] = here + chain.joints.way(q, here)
            return np.array(points), True
        way = new / np.linalg.norm(new)
        step = min(CURVE_STEP, GROW * step)
    return np.array(points), False
