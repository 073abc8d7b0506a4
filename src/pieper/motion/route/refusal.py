"""Why there is no route: a place that nothing inside the limits gets past, found on a grid and then proved.

A grid of turns and stations, and a front that is followed roughly, tell where the way ends. There the proof begins: at
a station everything inside the limits is known (each joint held at each of its limits and the others solved, and rows
between); followed along the path with bounds of how far anything can stray (`front.py`), it must come to nothing. Where
that fails the proof begins earlier, up to the first pose, and with smaller steps.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.motion.route.closed import blocked_at
from pieper.motion.route.freedom import Verdict
from pieper.motion.route.front import Ended, Front, can_be_followed, everything_at, follow, modulo_turns
from pieper.motion.route.grid import grid
from pieper.motion.route.keep import Keep
from pieper.motion.route.ladder import Rungs, climb, rungs
from pieper.motion.route.opening import Opening
from pieper.motion.route.reach import beyond_reach
from pieper.motion.route.result import Blocked
from pieper.motion.route.search import Task, search, stations
from pieper.motion.route.setting import Setting
from pieper.tolerances import TAKEN_UP_BEHIND
from pieper.words_by_number import plural

#: Stations of the grid where a coordinate is free, and where none is.
STATIONS, DENSE = 100, 400
#: Parts of the largest steps that the bounds allow, tried one after the other.
FINE = (1.0, 0.4, 0.15)
#: Steps, in those that the bounds allow, with which the end is looked for without proof; how far before it the proof
#: begins, as parts of the path, or None for the first pose, and with what part of the steps that the bounds allow; and
#: how far behind that end it may go on.
ROUGH, ON = 2.5, 0.01
TRIED = ((0.003, 1.0), (0.003, 0.4), (0.02, 1.0), (None, 1.0), (0.02, 0.4), (None, 0.4), (None, 0.15))
#: Part of the points that are left that one try may look at.
SHARE = 0.3
#: Places of the path that are looked at for what misses a clearance.
KEPT_AT = 26
#: Points that may be looked at, and how often a front that lost its grip is taken up again behind that place.
MOST, AGAIN = 1_500_000, 6


@dataclass(frozen=True, eq=False)
class Proof:
    """A place that nothing gets past.

    Attributes:
        begun: Where everything inside the limits was known.
        s: What is followed from there ends before.
        looked: Points looked at.
        arrived: Whether it gets to the last pose, and only the posture that it is to end with is not among it.
    """

    begun: float
    s: float
    looked: int
    arrived: bool = False


def refusal(task: Task) -> tuple[Verdict, Blocked | None, str]:
    """Return the verdict where no route was found, where it is blocked, and the reason in a sentence."""
    setting = task.setting
    if not can_be_followed(setting):
        far = beyond_reach(setting) if setting.spare > 1 else None
        return _nothing_proved(task) if far is None else _too_far(task, *far)
    more = task.keep.anything or task.turn_step is not None
    if more and search(replace(task, keep=Keep(), turn_step=None)) is not None:
        # limits alone let a route through: what closes the way can only be what is to be kept beside them
        return _uncertain(task)
    cells = grid(setting)
    s = _dense(setting.s, STATIONS if setting.spare else DENSE)
    ladder = rungs(setting, cells, s, np.ones(len(s) - 1))
    proof, reached = None, len(s) - 1
    for limits in _limits(setting):
        whole = limits is setting.limits
        way = climb(setting, cells, ladder, on_the_spot=True, ends=task.ends, all_turns=whole)
        reached = way.furthest
        proof = _closed(task, limits, ladder, reached, MOST)
        if proof is not None:
            return _told(task, ladder, reached, proof)
    return _uncertain(task)


def _limits(setting: Setting) -> list[Array]:
    """Return what is proved against: the limits without those of joints that can turn all the way round, then all."""
    loose = modulo_turns(setting)
    return [setting.limits] if np.array_equal(loose, setting.limits) else [loose, setting.limits]


def _closed(task: Task, limits: Array, ladder: Rungs, reached: int, most: int) -> Proof | None:
    """Return a place that nothing gets past, if one is proved."""
    looked = 0
    for first, last, fine in _windows(task, limits, ladder, reached, most):
        begin = first
        for _ in range(AGAIN):
            seeds = _known(task, limits, begin)
            found = follow(task.setting, limits, seeds, (begin, last), fine, int(SHARE * (most - looked)))
            looked += found.looked
            arrived = found.ended is Ended.ARRIVED and _misses_end(task, found)
            if found.ended is Ended.DIED or arrived:
                return Proof(begin, found.s, looked, arrived)
            begin = found.s + TAKEN_UP_BEHIND
            if found.ended is not Ended.SINGULAR or begin > last:
                break
    return None


def _windows(task: Task, limits: Array, ladder: Rungs, reached: int, most: int) -> Iterator[tuple[float, float, float]]:
    """Yield from where to where it is tried, and how finely: one station, then more and more of the path."""
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
        for station in dict.fromkeys((begin, (begin + end) // 2)):
            for fine in FINE:
                yield float(s[station]), float(s[station]), fine
    rough = follow(task.setting, limits, _known(task, limits, 0.0), (0.0, 1.0), ROUGH, most)
    if rough.ended is Ended.ARRIVED and not _misses_end(task, rough):
        return
    last = min(rough.s + ON, 1.0)
    for back, fine in TRIED:
        if back is None or back < rough.s:
            yield 0.0 if back is None else rough.s - back, last, fine


def _known(task: Task, limits: Array, begin: float) -> Array:
    """Return joint vectors on all that may be reached at a place where the proof begins."""
    start = task.ends[0]
    if begin == 0.0 and start is not None:
        return start[None]
    return everything_at(task.setting, limits, begin)


def _misses_end(task: Task, found: Front) -> bool:
    """Whether what may be reached at the last pose is not the posture that the route is to end with."""
    end = task.ends[1]
    if end is None or found.s < 1.0:
        return False
    gap = task.setting.chain.joints.difference(found.q, end) / task.setting.chain.joints.unit
    return bool((np.linalg.norm(gap, axis=1) > found.within).all())


def _told(task: Task, ladder: Rungs, reached: int, proof: Proof) -> tuple[Verdict, Blocked, str]:
    blocked = blocked_at(task, ladder, reached, proof.begun, proof.s)
    where = f"no motion gets past {proof.s:.6g} of the path" if proof.s > 0 else "no motion begins at the first pose"
    if proof.arrived:
        where = "the posture that it is to end with is not reached"
    if proof.looked:
        ends = "no posture so reached at the last pose is that one" if proof.arrived else "ends before"
        how = (
            f"Everything inside the limits at {proof.begun:.6g} of the path was followed with proved bounds and "
            f"{ends}: {plural(proof.looked, 'point')}."
        )
    else:
        there = "the first pose" if proof.begun == 0 else f"{proof.begun:.6g} of the path"
        how = f"At {there} nothing is inside the limits, each joint tried at each of its limits and in between."
    reason = f"Impossible: {where}, whatever the branch, the turn and the whole turns. {how}"
    return Verdict.IMPOSSIBLE, blocked, reason


def _too_far(task: Task, s: float, metres: float) -> tuple[Verdict, Blocked, str]:
    where = "At the first point of the path" if s == 0 else f"At {s:.6g} of the path"
    why = (
        f"{where} the tool's point is farther away than the links reach, however the tool is turned and tilted; it "
        f"goes on to {metres * 1e3:.4g} mm beyond."
    )
    reason = (
        f"Impossible: no motion gets past {s:.6g} of the path, whatever is free: all links in line do not reach it."
    )
    return Verdict.IMPOSSIBLE, Blocked((0.0, s), (), why, s, Opening(task, ())), reason


def _nothing_proved(task: Task) -> tuple[Verdict, Blocked | None, str]:
    spare = task.setting.spare
    if spare > 1:
        why = f"{plural(spare, 'coordinate')} are free, and with more than one a route is not ruled out."
    else:
        why = "of an arm whose joints decide this task in no regular way a route is not ruled out."
    return Verdict.UNCERTAIN, None, f"Uncertain: no route was found; {why}"


def _uncertain(task: Task) -> tuple[Verdict, Blocked | None, str]:
    if task.keep.anything or task.turn_step is not None:
        return (
            Verdict.UNCERTAIN,
            None,
            "Uncertain: no route was found that keeps the clearance, the distance to singular postures and the turn "
            f"rate asked for; without these none could be ruled out.{_nearest_kept(task)}",
        )
    return (
        Verdict.UNCERTAIN,
        None,
        "Uncertain: no route was found, and none could be ruled out: followed with proved bounds, something may lead "
        "from the first pose to the last. A little more room decides it.",
    )


def _nearest_kept(task: Task) -> str:
    """Return where and by what the clearance is missed by all postures that were looked at, in a sentence; or none."""
    keep, setting = task.keep, task.setting
    if keep.distance is None or keep.nearest is None:
        return ""
    at = setting.s[stations(len(setting.s), KEPT_AT)]
    ladder = rungs(setting, grid(setting), at, np.ones(len(at) - 1))
    x, ok = setting.chain.joints.inside_limits(ladder.x, setting.limits)
    worst: tuple[float, float, Array] | None = None
    for s, rows, valid in zip(at.tolist(), x, ladder.valid & ok, strict=True):
        postures = rows[valid][:, : setting.n]
        if not len(postures):
            continue
        room = np.asarray(keep.distance(postures), np.float64)
        best = int(np.argmax(room))
        if worst is None or room[best] < worst[0]:
            worst = float(room[best]), s, postures[best]
    if worst is None or worst[0] >= keep.clearance:
        return ""
    return (
        f" At {worst[1]:.4g} of the path no posture that was looked at keeps {keep.clearance * 1e3:.4g} mm: at "
        f"best {keep.nearest(worst[2])} are {worst[0] * 1e3:.4g} mm apart."
    )


def _dense(s: Array, count: int) -> Array:
    """Return the points of a path with as many between each two as make `count` stations."""
    each = max(1, -(-(count - 1) // (len(s) - 1)))
    part = np.arange(each) / each
    return np.append((s[:-1, None] + np.diff(s)[:, None] * part).ravel(), s[-1])
