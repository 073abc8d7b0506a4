"""A pose of the path that no posture holds clear of what stands around, proved.

At one pose everything inside the limits is a set of curves (or, where nothing is free, points), and a front that is not
carried on has points on all of them, each of which stands for all within some distance (`front.py`). Where each of
these, moved by as much as that, still misses the clearance, so does every posture of the pose.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.motion.route.front import Ended, can_be_followed, everything_at, follow, modulo_turns
from pieper.motion.route.grid import grid
from pieper.motion.route.ladder import rungs
from pieper.motion.route.search import Task, stations

#: Places of the path that are looked at for what misses a clearance, and how many of them are tried to prove.
LOOKED_AT, TRIED = 26, 2
#: Parts of the steps that the bounds allow at which points stand, tried one after the other, and points at most.
FINE, MOST = (1.0, 0.3, 0.1, 0.03, 0.01), 400_000


@dataclass(frozen=True, eq=False)
class Missed:
    """A place of the path at which nothing that was looked at keeps the clearance.

    Attributes:
        s: Where.
        metres: The best distance there.
        q: (n,) the posture that has it.
    """

    s: float
    metres: float
    q: Array


def missed(task: Task) -> list[Missed]:
    """Return the places where all postures that were looked at miss the clearance, the most closed first."""
    keep, world = task.keep, task.setting
    if keep.distance is None:
        return []
    s = world.s[stations(len(world.s), LOOKED_AT)]
    ladder = rungs(world, grid(world), s, np.ones(len(s) - 1))
    x, ok = world.chain.joints.inside_limits(ladder.x, world.limits)
    out: list[Missed] = []
    for at, rows, valid in zip(s.tolist(), x, ladder.valid & ok, strict=True):
        postures = rows[valid][:, : world.n]
        if len(postures):
            room = np.asarray(keep.distance(postures), np.float64)
            best = int(np.argmax(room))
            if room[best] < keep.clearance:
                out.append(Missed(at, float(room[best]), postures[best]))
    return sorted(out, key=lambda place: place.metres)


def closed_by_scene(task: Task, places: list[Missed]) -> tuple[Missed, int] | None:
    """Return a place that is proved to be held by no posture that keeps the clearance, and points looked at.

    Args:
        task: What is asked.
        places: Where it is worth a try, the most closed first.
    """
    if not can_be_followed(task.setting):
        return None
    for place in places[:TRIED]:
        points = _proved(task, place.s)
        if points is not None:
            return place, points
    return None


def _proved(task: Task, s: float) -> int | None:
    keep, world = task.keep, task.setting
    if keep.distance is None or keep.at_most is None:
        return None
    limits = modulo_turns(world)
    seeds, looked = everything_at(world, limits, s), 0
    for fine in FINE:
        front = follow(world, limits, seeds, (s, s), fine, MOST)
        looked += max(front.looked, len(front.q))
        if front.ended is not Ended.ARRIVED:
            # nothing inside the limits, or too little grip, is told elsewhere
            return None
        q = front.q[:, : world.n]
        if (np.asarray(keep.distance(q), np.float64) >= keep.clearance).any():
            return None
        if (keep.at_most(q, front.within) < keep.clearance).all():
            return looked
    return None
