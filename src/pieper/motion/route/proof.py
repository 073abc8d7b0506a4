"""A place of the path that nothing inside the limits gets past, proved.

Where nothing is inside the limits the proof is one station. Else everything inside is collected somewhere and followed
with proved bounds: first close before the place at which a rough front ends, then wherever a rough front comes to
nothing, forwards or backwards, past places at which it loses its grip (`passed.py`), and with smaller steps.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.motion.route.front import Ended
from pieper.motion.route.ladder import Rungs
from pieper.motion.route.passed import follow_past
from pieper.motion.route.search import Task
from pieper.motion.route.windows import ROUGH, Window, backwards, known, later, misses_end, scouted

#: Parts of the largest steps that the bounds allow, tried one after the other at a station where no row is inside.
FINE = (1.0, 0.4, 0.15)
#: How far before the end of a rough front from the first pose a proof is tried first, as parts of the path, and with
#: what part of the steps that the bounds allow; and how far behind that end it may go on.
CLOSE, ON = ((0.003, 1.0), (0.003, 0.4), (0.02, 1.0)), 0.01
#: Part of the steps for all of the way from the first pose to there, where so many points are enough, and how often it
#: is tried to begin half way before that.
WHOLE, NEARER = (0.7, 4_000_000), 1
#: Points that a rough front from the first pose, and that each of the first tries may look at.
MOST, EACH = 1_500_000, 450_000
#: Parts of the steps that the bounds allow for all that is reached from a posture that is told, and points then.
TOLD = ((1.0, 3_000_000), (0.4, 6_000_000))


@dataclass(frozen=True, eq=False)
class Proof:
    """A place that nothing gets past.

    Attributes:
        begun: Where everything inside the limits was known, counted from where the path is begun.
        s: What is followed from there ends before.
        looked: Points looked at.
        arrived: Whether it gets to the last pose, and only the posture that it is to end with is not among it.
        back: Whether the path is gone backwards.
    """

    begun: float
    s: float
    looked: int
    arrived: bool = False
    back: bool = False

    def along(self, s: float) -> float:
        """Return a place counted from where the path is begun as counted from the path's beginning."""
        return 1.0 - s if self.back else s

    def between(self, first: float, last: float) -> tuple[float, float]:
        """Return two places counted so, in the order of the path."""
        return (self.along(last), self.along(first)) if self.back else (first, last)


def closely(task: Task, limits: Array, ladder: Rungs, reached: int) -> Proof | None:
    """Return a place that nothing gets past, looked for where the rows of a ladder and a rough front end.

    Args:
        task: What is asked.
        limits: (m, 2) that are kept.
        ladder: Rows at stations.
        reached: Last station that is reached over rows inside the limits, below zero for none.
    """
    return _first(task, limits, _close(task, limits, ladder, reached))


def anywhere(task: Task, limits: Array) -> Proof | None:
    """Return a place that nothing gets past, looked for along the whole path and along it gone backwards.

    Args:
        task: What is asked.
        limits: (m, 2) that are kept.
    """
    return _first(task, limits, scouted(task, limits))


def _first(task: Task, limits: Array, windows: Iterator[Window]) -> Proof | None:
    back = backwards(task)
    for window in windows:
        way = back if window.back else task
        seeds = known(way, limits, window.first)
        found = follow_past(way.setting, limits, seeds, (window.first, window.last), window.fine, window.most)
        arrived = misses_end(way, found)
        if found.ended is Ended.DIED or arrived:
            return Proof(window.first, found.s, found.looked, arrived, window.back)
    return None


def _close(task: Task, limits: Array, ladder: Rungs, reached: int) -> Iterator[Window]:
    s = ladder.s
    inside = ladder.valid & task.setting.chain.joints.inside_limits(ladder.x, task.setting.limits)[1]
    empty = np.flatnonzero(~inside.any((1, 2)))
    if len(empty):
        # the first stretch of stations without any row that the way leads to
        begin = int(empty[np.argmax(empty >= min(reached, int(empty[-1])))])
        end = begin
        while end + 1 in empty:
            end += 1
        # where the way ends is told most nearly by the stretch's first station; its middle is where least is in doubt
        near = (begin, (begin + end) // 2)
        for station in dict.fromkeys(near):
            for fine in FINE:
                yield Window(float(s[station]), float(s[station]), fine, EACH)
        # between the turns of a grid there may be more anywhere: elsewhere it is looked at what meets the limits itself
        for station in empty.tolist():
            place = float(s[station])
            if station not in near and not len(known(task, limits, place)):
                yield Window(place, place, FINE[0], EACH)
                break
    rough = follow_past(task.setting, limits, known(task, limits, 0.0), (0.0, 1.0), ROUGH, MOST)
    if rough.ended is not Ended.ARRIVED or misses_end(task, rough):
        for before, fine in CLOSE:
            yield Window(max(rough.s - before, 0.0), min(rough.s + ON, 1.0), fine, EACH)
        # close before it more may be inside than what comes from farther back: as near as it still dies there
        fine, most = WHOLE
        # of smaller steps it takes the square
        if rough.looked * (ROUGH / fine) ** 2 < most:
            first, enough = 0.0, (ROUGH, rough.looked, 0)
            if rough.ended is Ended.DIED:
                first, _ = later(task, limits, (0.0, rough.s), rough.s, enough, NEARER)
            for begin in dict.fromkeys((first, 0.0)):
                yield Window(begin, min(rough.s + ON, 1.0), fine, most)
    # from a posture that is told less is reached than from anything that is inside the limits
    for way, back in ((task, False), (backwards(task), True)):
        if way.ends[0] is None:
            continue
        if back:
            rough = follow_past(way.setting, limits, known(way, limits, 0.0), (0.0, 1.0), ROUGH, MOST)
        if rough.ended is Ended.DIED or misses_end(way, rough):
            for fine, most in TOLD:
                yield Window(0.0, 1.0, fine, most, back)
