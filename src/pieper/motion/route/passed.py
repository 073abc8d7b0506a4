"""A front followed past the places at which it loses its grip: where what a pose leaves free crosses itself or ends.

There the bounds of `front.py` allow no step. Behind such a place everything inside the limits is collected anew, and of
each of its stretches it is asked, followed backwards, what it may have come from: one that comes to nothing, or to
other stretches than those that were reached before the place, is not reached. Whatever moves from there to here moves
backwards from here to there, so that nothing is lost; a stretch that loses its grip on the way back is kept.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.kinematics.joints import short_way
from pieper.motion.route.front import Ended, Front, everything_at, follow
from pieper.motion.route.setting import Setting
from pieper.tolerances import TAKEN_UP_BEHIND

#: How far behind a place where a front lost its grip it is taken up again, in the least such distance.
BEHIND = (1, 3, 10, 30, 100)


def reversed_setting(setting: Setting) -> Setting:
    """Return what is solved along the same path from its end to its beginning."""
    return replace(setting, path=setting.path[::-1], asked=setting.asked[::-1], s=1.0 - setting.s[::-1])


def follow_past(setting: Setting, limits: Array, seeds: Array, s: tuple[float, float], fine: float, most: int) -> Front:
    """Follow what may be reached like `front.follow`, past places where the front loses its grip.

    Args:
        setting: What is solved.
        limits: (m, 2) that are kept.
        seeds: What is reached at the first place.
        s: The places.
        fine: Part of the largest steps that the bounds allow.
        most: Points that may be looked at in all.
    """
    first, last = s
    back, begin, looked = reversed_setting(setting), first, 0
    while True:
        front = follow(setting, limits, seeds, (begin, last), fine, most - looked)
        looked += front.looked
        if front.ended is Ended.SINGULAR and front.s < last:
            taken = _behind(setting, back, limits, front, last, fine, most - looked)
            if taken is not None:
                seeds, begin, more = taken
                looked += more
                if len(seeds):
                    continue
                none = front.q[:0]
                front = replace(
                    front, ended=Ended.DIED, s=begin, told=begin, q=none, within=none[:, 0], stretch=front.stretch[:0]
                )
        return replace(front, begun=first, looked=looked)


def _behind(
    setting: Setting, back: Setting, limits: Array, front: Front, last: float, fine: float, most: int
) -> tuple[Array, float, int] | None:
    """Return what is reached (k, m) a little behind a place where a front lost its grip, where, and points looked at.

    None where the bounds allow no step there either, or too many points would be looked at.
    """
    looked = 0
    for far in BEHIND:
        place = min(front.s + far * TAKEN_UP_BEHIND, last)
        every = follow(setting, limits, everything_at(setting, limits, place), (place, place), fine, most)
        looked += every.looked
        if every.ended is Ended.TIRED:
            return None
        if every.ended is not Ended.SINGULAR:
            reached = [front.q[:0]]
            for points, _ in stretches(every):
                came = follow(back, limits, points, (1.0 - place, 1.0 - front.told), fine, most)
                looked += came.looked
                if came.ended is Ended.DIED or (
                    came.ended is Ended.ARRIVED and not _meet(setting, limits, came, front)
                ):
                    continue
                reached.append(points)
            return np.concatenate(reached), place, looked
        if place == last:
            break
    return None


def stretches(front: Front) -> Iterator[tuple[Array, Array]]:
    """Yield the points (k, m) of each stretch of a front, and what each stands for (k,)."""
    ends = np.cumsum(np.abs(front.stretch))
    for first, behind in zip(ends - np.abs(front.stretch), ends, strict=True):
        yield front.q[first:behind], front.within[first:behind]


def _meet(setting: Setting, limits: Array, a: Front, b: Front) -> bool:
    """Whether two fronts at one place may have a posture in common; whole turns count where there are limits."""
    joints = setting.chain.joints
    apart = (a.q[:, None] - b.q) / joints.unit
    round_ = np.isinf(limits).any(1) & ~setting.chain.prismatic
    apart = np.where(round_, short_way(apart), apart)
    return bool((np.linalg.norm(apart, axis=-1) <= a.within[:, None] + b.within).any())
