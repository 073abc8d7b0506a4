"""Where along a path a proof that nothing gets through is worth a try: places from which a rough front dies.

Whatever gets from the first pose to the last passes every place between them. So a proof may begin at any of them, with
all that is inside the limits there, and go to either end; it costs as much as the front has to do on its way.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.motion.route.front import Ended, Front, everything_at
from pieper.motion.route.ladder import Rungs
from pieper.motion.route.passed import follow_past, reversed_setting
from pieper.motion.route.search import Task

#: Steps, in those that the bounds allow, with which an end is looked for without proof close to where rows end;
ROUGH = 2.5
#: along the whole path the same, points it may look at, and as many more for each point it begins with; where no
#: end is found so, more points and then smaller steps: a gap that is less than a tenth of a step wide is not seen.
SCOUTS = ((ROUGH, 60_000, 40), (ROUGH, 1_000_000, 0), (1.05, 1_500_000, 0))
#: Places at which a rough front is begun.
PLACES = 11
#: How far behind the end of a rough front a proof may go on, as a part of the path.
ON = 0.03
#: Parts of the steps that the bounds allow with which a window is tried, and points that may be looked at then.
TRIED = ((0.7, 4_000_000), (0.4, 6_000_000), (0.15, 12_000_000))
#: Windows that are tried, and how far apart two of them end at least, as a part of the path.
MOST, APART = 3, 0.01
#: How often the place at which a window begins is moved on by halves.
LATER = 3


@dataclass(frozen=True)
class Window:
    """A stretch of the path, or of the path gone backwards, to look for a proof in.

    Attributes:
        first: Where everything inside the limits is collected, counted from where the path is begun.
        last: Where the proof ends at the latest.
        fine: Part of the steps that the bounds allow.
        most: Points that may be looked at.
        back: Whether the path is gone backwards.
    """

    first: float
    last: float
    fine: float
    most: int
    back: bool = False


def backwards(task: Task) -> Task:
    """Return the task along the same path from its end to its beginning."""
    turned = reversed_setting(task.setting)
    step = None if task.turn_step is None else task.turn_step[::-1]
    return replace(task, setting=turned, ends=task.ends[::-1], turn_step=step)


def rungs_backwards(ladder: Rungs) -> Rungs:
    """Return rows at stations as they come along the path gone backwards."""
    return Rungs(1.0 - ladder.s[::-1], ladder.x[::-1], ladder.valid[::-1], ladder.parts[::-1])


def known(task: Task, limits: Array, begin: float) -> Array:
    """Return joint vectors on all that may be reached at a place where a proof begins."""
    start = task.ends[0]
    if begin == 0.0 and start is not None:
        return start[None]
    return everything_at(task.setting, limits, begin)


def misses_end(task: Task, found: Front) -> bool:
    """Whether a front arrived, but not at the posture that the route is to end with."""
    end = task.ends[1]
    if end is None or found.ended is not Ended.ARRIVED or found.s < 1.0:
        return False
    gap = task.setting.chain.joints.difference(found.q, end)
    return bool((np.linalg.norm(gap, axis=1) > found.within).all())


def scouted(task: Task, limits: Array) -> Iterator[Window]:
    """Yield windows that a rough front does not get through, those in which it had least to do first.

    Args:
        task: What is asked.
        limits: (m, 2) that are kept.
    """
    seen: dict[tuple[float, float, bool], Ended] = {}
    for rough in SCOUTS:
        yield from _scouted(task, limits, rough, seen)


def _scouted(
    task: Task, limits: Array, rough: tuple[float, int, int], seen: dict[tuple[float, float, bool], Ended]
) -> Iterator[Window]:
    """Yield the windows of `scouted` that a front of some steps shows, but for those of fronts that were seen end."""
    back = backwards(task)
    found: list[tuple[int, float, float, bool]] = []
    for way in (task, back):
        for first in np.linspace(0.0, 1.0, PLACES)[:-1].tolist():
            key = (rough[0], first, way is back)
            ended = seen.get(key, Ended.TIRED)
            if ended is Ended.TIRED:
                front = _front(way, limits, first, rough)
                ended = Ended.DIED if _is_end(way, front) else front.ended
                seen[key] = ended
                if ended is Ended.DIED:
                    found.append((front.looked, first, front.s, way is back))
            if ended is Ended.ARRIVED:
                # all of it is among what is inside at later places: from there something gets to the end as well
                break
    kept: list[tuple[int, float, float, bool]] = []
    for window in sorted(found):
        if all(window[3] != other[3] or abs(window[2] - other[2]) > APART for other in kept):
            kept.append(window)
    near = [_later(back if window[3] else task, limits, window, rough) for window in kept[:MOST]]
    for fine, most in TRIED:
        for first, last, backward in near:
            yield Window(first, min(last + ON, 1.0), fine, most, backward)


def _front(way: Task, limits: Array, first: float, rough: tuple[float, int, int]) -> Front:
    """Return the rough front that is begun at a place."""
    seeds = known(way, limits, first)
    steps, points, each = rough
    return follow_past(way.setting, limits, seeds, (first, 1.0), steps, points + each * len(seeds))


def _is_end(way: Task, front: Front) -> bool:
    """Whether a front does not get through."""
    return front.ended is Ended.DIED or misses_end(way, front)


def _later(
    way: Task, limits: Array, window: tuple[int, float, float, bool], rough: tuple[float, int, int]
) -> tuple[float, float, bool]:
    """Return from where, as near to the end as it still dies there, and to where, a front has least to do."""
    _, first, last, backward = window
    return *later(way, limits, (first, last), min(first + 1 / (PLACES - 1), last), rough, LATER), backward


def later(
    way: Task, limits: Array, ends: tuple[float, float], beyond: float, rough: tuple[float, int, int], halvings: int
) -> tuple[float, float]:
    """Return from where, before a place beyond, a rough front dies where one from farther back does, and where."""
    first, last = ends
    for _ in range(halvings):
        middle = (first + beyond) / 2
        front = _front(way, limits, middle, rough)
        if _is_end(way, front) and abs(front.s - last) < APART:
            first, last = middle, front.s
        else:
            beyond = middle
    return first, last
