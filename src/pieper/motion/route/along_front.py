"""A route sought on what a front reaches: where the arm swings fast beside a small change of what is free.

A ladder's turns are even, and beside a singular posture the joints may swing from limit to limit between two of them.
The points of a front (`front.py`) are even in the joints: on them the cheapest chain is found, carried to the points of
the path and looked at like any other. What is found is no less sure than by a ladder; what is not found says nothing.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from pieper.kinematics.arrays import Array, Indices
from pieper.kinematics.joints import turned_from
from pieper.motion.route.front import Ended, can_be_followed, follow
from pieper.motion.route.grid import grid
from pieper.motion.route.ladder import rungs
from pieper.motion.route.search import Found, Task, carried, cost_of, dense
from pieper.motion.route.setting import Setting
from pieper.motion.route.smooth import Smoothed
from pieper.motion.route.windows import known

#: Parts of the steps that the bounds allow; above one nothing is proved, and points stand less near.
FINE = 1.5
#: Points that are looked at from station to station, and those of one station that are kept.
MOST, KEPT = 40_000, 1500
#: Largest steps of a chain (rad; lengths) that are tried: what needs a longer one may jump to another branch.
STEPS = (0.15, 0.3, 0.6)
#: Points of a station whose steps are counted at once: those that lie side by side, from all that are near.
AT_ONCE = 64
#: Least and most points between those of a path.
EACH = (4, 20)


def search_on_front(task: Task) -> Found | None:
    """Return a route over the points of a front from the first pose to the last, None where none is found."""
    if task.setting.spare != 1 or task.turn_step is not None or not can_be_followed(task.setting):
        return None
    fine, each = dense(task, *EACH)
    stations = _stations(fine)
    if stations is None:
        return None
    world = fine.setting
    for step in STEPS:
        x = _cheapest(fine, stations, step)
        found = None if x is None else carried(fine, x, np.arange(len(x), dtype=float))
        if found is not None:
            cells, own = grid(world), found.x[::each]
            ladder = rungs(world, cells, world.s, np.ones(len(world.s) - 1))
            short = carried(task, own, np.arange(len(own), dtype=float))
            if short is None:
                short = Smoothed(own, cost_of(task.setting, own, task.largest), np.inf)
            return Found(short.x, short.cost, short.slope, cells, ladder)
    return None


def _stations(task: Task) -> list[Array] | None:
    """Return the points (k, m) that a front reaches at each point of the path, None where it ends on the way."""
    world = task.setting
    points, out = known(task, world.limits, 0.0), list[Array]()
    for s in [(0.0, 0.0), *zip(world.s[:-1].tolist(), world.s[1:].tolist(), strict=True)]:
        front = follow(world, world.limits, points, s, FINE, MOST)
        if front.ended is not Ended.ARRIVED or not 0 < len(front.q) <= KEPT:
            return None
        points = front.q
        wound, inside = world.chain.joints.inside_limits(points, world.limits)
        out.append(wound[task.keep.rows(world, wound, inside)])
        if not len(out[-1]):
            return None
    first, last = task.ends
    out[0] = out[0] if first is None else first[None]
    out[-1] = out[-1] if last is None else last[None]
    return out


def _cheapest(task: Task, stations: list[Array], longest: float) -> Array | None:
    """Return the cheapest chain (N, m) over points of the stations whose steps are at most so long."""
    world = task.setting
    weights, unit = world.weights, world.chain.joints.unit
    cost, came = np.zeros(len(stations[0])), list[Indices]()
    for a, b in zip(stations[:-1], stations[1:], strict=True):
        least, best = np.full(len(b), np.inf), np.zeros(len(b), np.int64)
        for some, near in _near(world, a, b, longest):
            e = world.chain.joints.way(b[some, None], a[None, near])
            size = np.abs(e / unit)[..., : world.n].max(-1)
            steps = (np.sqrt(weights) * np.abs(e)).max(-1) if task.largest else (weights * e * e).sum(-1)
            total = np.where(size <= longest, steps + cost[near], np.inf)
            least[some], best[some] = total.min(1), near[total.argmin(1)]
        cost = least
        came.append(best)
    if not np.isfinite(cost).any():
        return None
    chain = [int(np.argmin(cost))]
    for before in reversed(came):
        chain.append(int(before[chain[-1]]))
    x = np.array([points[k] for points, k in zip(stations, reversed(chain), strict=True)])
    return x[0] + np.vstack([np.zeros(world.m), np.cumsum(world.chain.joints.way(x[1:], x[:-1]), axis=0)])


def _near(world: Setting, a: Array, b: Array, longest: float) -> Iterator[tuple[Indices, Indices]]:
    """Yield rows of b, some at a time, and all rows of a that a step of at most `longest` can lead to them from."""
    joints = world.chain.joints
    spread = np.ptp(b[:, : world.n] / joints.unit[: world.n], axis=0)
    j = int(np.argmax(spread))
    turns = not joints.prismatic[j]
    key = turned_from(0.0, b[:, j]) if turns else b[:, j]
    order, room = np.argsort(key), longest * joints.unit[j]
    for some in np.array_split(order, -(-len(order) // AT_ONCE)):
        low, wide = key[some[0]] - room, key[some[-1]] - key[some[0]] + 2 * room
        beyond = (turned_from(low, a[:, j]) if turns else a[:, j]) - low
        near = np.flatnonzero((beyond >= 0) & (beyond <= wide) if joints.coupled is None else np.ones(len(a), bool))
        if len(near):
            yield some, near
