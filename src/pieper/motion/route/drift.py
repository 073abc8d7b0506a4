"""Ways over few stations whose turn drifts as it likes, some of every branch: which is short is told by Newton.

A ladder moves by whole cells: what its steps are off the turn that would be best costs as much as the joints move with
it, and near a singular posture they move much. Here a step is free to end half a cell beside: what of it lies along
the turn is shortened by that. The ways differ from the best ones by less than from each other, and are made short next.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from pieper.kinematics.arrays import Array, Bools, Indices
from pieper.kinematics.joints import TURN
from pieper.motion.route.grid import REACH, Grid
from pieper.motion.route.ladder import STEP, Rungs
from pieper.motion.route.setting import Setting
from pieper.tolerances import TINY

#: Ways that are looked at cost at most so much more than the cheapest, as they are told.
DEARER = 1.5


def drifting(setting: Setting, grid: Grid, ladder: Rungs) -> Iterator[tuple[float, Array]]:
    """Yield costs, roughly, and continuous ways (M, m), cheapest first, no two of one branch that end near each other.

    Args:
        setting: What is solved: one coordinate is free. Whole turns of its joints are left open.
        grid: The cells.
        ladder: Their rows at stations.
    """
    (free,) = grid.coordinates
    if len(free.values) < 3:
        return
    cell = float(free.values[1] - free.values[0])
    inside = ladder.valid & setting.chain.joints.inside_limits(ladder.x, setting.limits)[1]
    used = inside.any((0, 1))
    x, inside = ladder.x[:, :, used], inside[:, :, used]
    if not x.size:
        return
    reach = min(max(1, round(REACH / cell)), (len(free.values) - 1) // 2)
    cost, origin = _climbed(setting, x, inside, reach, free.cyclic)
    # the best of each branch, and what is better than what ends beside it
    after, before = np.roll(cost, -1, 0), np.roll(cost, 1, 0)
    if not free.cyclic:
        after[-1] = before[0] = np.inf
    end, branch = np.nonzero((cost <= after) & (cost < before) & (cost <= DEARER * cost.min()) & np.isfinite(cost))
    for k in np.argsort(cost[end, branch], kind="stable").tolist():
        at, b, way = int(end[k]), int(branch[k]), list[Array]()
        for station in range(len(x) - 1, -1, -1):
            way.append(x[station, at, b])
            at = int(origin[station, at, b])
        yield float(cost[end[k], branch[k]]), _continuous(setting, np.array(way[::-1]))


def _climbed(setting: Setting, x: Array, inside: Bools, reach: int, cyclic: bool) -> tuple[Array, Indices]:
    """Return the costs (C, B) of ways up to the last rows, and the cells (M, C, B) that they come from."""
    C, n = int(x.shape[1]), setting.n
    weights = np.sqrt(setting.weights[:n])
    round_ = ~setting.chain.prismatic[:n]
    longest = STEP * setting.chain.joints.unit[:n]
    q = x[..., :n]
    cost = np.where(inside[0], 0.0, np.inf)
    origin = np.zeros(inside.shape, np.int64)
    every = np.arange(C, dtype=np.int64)
    shifts: list[int] = sorted(range(-reach, reach + 1), key=abs)
    for k in range(1, len(x)):
        rate = _rate(q[k], inside[k], weights, round_, cyclic)
        size = np.sqrt(np.einsum("cbj,cbj->cb", rate, rate))
        along = rate / np.maximum(size, TINY)[..., None]
        best = np.full(inside.shape[1:], np.inf)
        for shift in shifts:
            source = every - shift
            ok: Bools = np.ones(C, np.bool_) if cyclic else (source >= 0) & (source < C)
            source %= C
            e: Array = q[k] - q[k - 1, source]
            e -= TURN * np.round(e / TURN) * round_
            short = (np.abs(e) <= longest).all(-1) & inside[k] & ok[:, None]
            e = e * weights
            turned = np.abs(np.einsum("cbj,cbj->cb", e, along))
            # half a cell of the turn is free: so much of what lies along it is not counted
            spared = turned**2 - np.maximum(turned - 0.5 * size, 0.0) ** 2
            total = np.where(short, np.einsum("cbj,cbj->cb", e, e) - spared + cost[source], np.inf)
            better = total < best
            best[better] = total[better]
            origin[k][better] = np.broadcast_to(source[:, None], best.shape)[better]
        cost = best
    return cost, origin


def _rate(q: Array, inside: Bools, weights: Array, round_: Bools, cyclic: bool) -> Array:
    """Return by how much rows (C, B, n) move, weighed, from cell to cell; nothing where that is not told."""
    e = np.roll(q, -1, 0) - q
    e -= TURN * np.round(e / TURN) * round_
    near = (np.abs(e) < STEP).all(-1) & inside & np.roll(inside, -1, 0)
    if not cyclic:
        near[-1] = False
    e = np.where(near[..., None], e * weights, 0.0)
    before, told = np.roll(e, 1, 0), np.roll(near, 1, 0)
    return (e + before) / np.maximum(near.astype(float) + told, 1.0)[..., None]


def _continuous(setting: Setting, x: Array) -> Array:
    """Return a way (M, m) without jumps of whole turns."""
    steps = np.diff(x, axis=0)
    turns = np.where(~setting.chain.prismatic, -TURN * np.round(steps / TURN), 0.0)
    return x + np.vstack([np.zeros(setting.m), np.cumsum(turns, axis=0)])
