"""Why there is no route: a place that nothing inside the limits gets past, found on a grid and then proved.

A grid of turns and stations, and fronts that are followed roughly, tell where the way ends. There the proof begins
(`proof.py`): at a station everything inside the limits is known (each joint held at each of its limits and the others
solved, and rows between); followed along the path with bounds of how far anything can stray (`front.py`), it must come
to nothing.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from pieper.kinematics.arrays import Array, Bools
from pieper.motion.route.closed import blocked_at
from pieper.motion.route.freedom import Verdict
from pieper.motion.route.front import can_be_followed, modulo_turns
from pieper.motion.route.grid import Grid, grid
from pieper.motion.route.in_the_scene import Missed, closed_by_scene, missed
from pieper.motion.route.keep import Keep
from pieper.motion.route.ladder import Rungs, climb, rungs
from pieper.motion.route.nowhere import nothing_within_cone
from pieper.motion.route.opening import Opening
from pieper.motion.route.proof import Proof, anywhere, closely
from pieper.motion.route.reach import beyond_reach
from pieper.motion.route.result import Blocked
from pieper.motion.route.search import Task, search, stations
from pieper.motion.route.setting import Setting
from pieper.motion.route.windows import backwards, rungs_backwards
from pieper.words_by_number import plural

#: Stations of the grid where a coordinate is free, and where none is.
STATIONS, DENSE = 100, 400
#: Poses at which it is looked whether anything holds them where more than one coordinate is free, and how many of them
#: are tried to prove of those that no row holds.
ONE_POSE_AT, ONE_POSE_TRIED = 26, 3
#: Poses that something in the way closes for all rows and that are tried to prove, and boxes looked at for each.
IN_THE_WAY_TRIED, IN_THE_WAY_BOXES = 1, 3_000_000


def refusal(task: Task, thorough: bool) -> tuple[Verdict, Blocked | None, str]:
    """Return the verdict where no route was found, where it is blocked, and the reason in a sentence.

    Args:
        task: What was asked.
        thorough: Whether a proof is looked for along the whole path; else where the way plainly ends, which is quick.
    """
    setting = task.setting
    if not can_be_followed(setting):
        if thorough:
            return _uncertain(task, missed(task))
        far = beyond_reach(setting) if setting.spare > 1 or setting.tilts else None
        return _at_one_pose(task) if far is None else _too_far(task, *far)
    places = missed(task)
    closed = None if thorough else closed_by_scene(task, places)
    if closed is not None:
        place, points = closed
        return _in_the_way(task, place, plural(points, "point"))
    more = task.keep.anything or task.turn_step is not None
    if more and search(replace(task, keep=Keep(), turn_step=None)) is not None:
        # limits alone let a route through: what closes the way can only be what is to be kept beside them
        return _uncertain(task, places)
    cells = grid(setting)
    s = _dense(setting.s, STATIONS if setting.spare else DENSE)
    ladder = rungs(setting, cells, s, np.ones(len(s) - 1))
    for limits in _limits(setting):
        if not thorough:
            reached = _reached(task, cells, ladder, limits)
            proof = closely(task, limits, ladder, reached)
        else:
            reached, proof = -1, anywhere(task, limits)
        if proof is None:
            continue
        if proof.back:
            turned, from_end = backwards(task), rungs_backwards(ladder)
            return _told(turned, from_end, _reached(turned, cells, from_end, limits), proof)
        return _told(task, ladder, _reached(task, cells, ladder, limits) if thorough else reached, proof)
    return _uncertain(task, places)


def _reached(task: Task, cells: Grid, ladder: Rungs, limits: Array) -> int:
    """Return the last station that is reached over rows inside the limits."""
    world = task.setting
    every = limits is world.limits
    return climb(world, cells, ladder, on_the_spot=True, ends=task.ends, all_turns=every).furthest


def _limits(setting: Setting) -> list[Array]:
    """Return what is proved against: the limits without those of joints that can turn all the way round, then all."""
    loose = modulo_turns(setting)
    return [setting.limits] if np.array_equal(loose, setting.limits) else [loose, setting.limits]


def _told(task: Task, ladder: Rungs, reached: int, proof: Proof) -> tuple[Verdict, Blocked, str]:
    blocked = blocked_at(task, ladder, reached, proof)
    place, begun = proof.along(proof.s), proof.along(proof.begun)
    where = f"no motion gets past {place:.6g} of the path"
    if proof.s == 0 and not proof.back:
        where = "no motion begins at the first pose"
    elif proof.s == 0:
        where = "no motion ends at the last pose"
    if proof.arrived:
        where = f"the posture that it is to {'begin' if proof.back else 'end'} with is not reached"
    there = {0.0: "the first pose", 1.0: "the last pose"}.get(begun, f"{begun:.6g} of the path")
    told = proof.begun == 0 and task.ends[0] is not None
    all_of = f"{'All that is reached from the posture told for' if told else 'Everything inside the limits at'} {there}"
    if proof.looked:
        last = "first" if proof.back else "last"
        ends = f"no posture so reached at the {last} pose is that one" if proof.arrived else "ends before"
        how = (
            f"{all_of} was followed{' backwards' if proof.back else ''} with "
            f"proved bounds and {ends}: {plural(proof.looked, 'point')}."
        )
    else:
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


def _at_one_pose(task: Task) -> tuple[Verdict, Blocked | None, str]:
    """Return the verdict where more than one coordinate is free: impossible where one pose is held by nothing."""
    setting = task.setting
    if setting.spare < 2 and not setting.tilts:
        why = "of an arm whose joints decide this task in no regular way a route is not ruled out."
        return Verdict.UNCERTAIN, None, f"Uncertain: no route was found; {why}"
    s = setting.s[stations(len(setting.s), ONE_POSE_AT)]
    ladder = rungs(setting, grid(setting), s, np.ones(len(s) - 1))
    inside = ladder.valid & setting.chain.joints.inside_limits(ladder.x, setting.limits)[1]
    empty: Bools = np.logical_not(np.logical_or.reduce(inside, axis=(1, 2)))
    for at in _middles(empty)[:ONE_POSE_TRIED]:
        boxes = nothing_within_cone(setting, setting.at(float(s[at])))
        if boxes is not None:
            proof = Proof(float(s[at]), float(s[at]), 0)
            blocked = blocked_at(task, ladder, max(int(np.argmax(empty)) - 1, -1), proof)
            tilted = f", its axis tilted by up to {np.degrees(setting.free.cone):.4g} deg" if setting.tilts else ""
            turned = ", whatever the turn" if np.isinf(setting.free.interval[0]) and setting.turns else ""
            reason = (
                f"Impossible: no motion gets past {s[at]:.6g} of the path. No posture inside the limits holds the pose "
                f"there{tilted}{turned}: {plural(boxes, 'box', 'boxes')} of joint values, which are all, "
                "were ruled out."
            )
            return Verdict.IMPOSSIBLE, blocked, reason
    places = missed(task)
    for place in places[:IN_THE_WAY_TRIED]:
        boxes = nothing_within_cone(setting, setting.at(place.s), IN_THE_WAY_BOXES, task.keep)
        if boxes is not None:
            return _in_the_way(task, place, plural(boxes, "box", "boxes") + " of joint values")
    if task.keep.anything or task.turn_step is not None:
        return _uncertain(task, places)
    which = "none was proved to be one" if empty.any() else "none is one"
    one = setting.spare == 1
    free = f"{plural(setting.spare, 'coordinate')} {'is' if one else 'are'}"
    what = "where the tool leans as the joints decide" if one else "with more than one"
    reason = (
        f"Uncertain: no route was found; {free} free, and {what} a route is ruled out only by a pose "
        f"that no posture inside the limits holds: of the {len(s)} looked at {which}."
    )
    return Verdict.UNCERTAIN, None, reason


def _middles(empty: Bools) -> list[int]:
    """Return the middle station of each stretch of stations without a row, the longest first."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], empty, [False]]).astype(np.int8)))
    stretches = sorted(zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True), key=lambda ends: ends[0] - ends[1])
    return [(first + behind - 1) // 2 for first, behind in stretches]


def _uncertain(task: Task, places: list[Missed]) -> tuple[Verdict, Blocked | None, str]:
    """Return that nothing is known, with the place of the path that something in the way closes most."""
    if task.keep.anything or task.turn_step is not None:
        where = f" {_misses(task, places[0])}" if places else ""
        return (
            Verdict.UNCERTAIN,
            None,
            "Uncertain: no route was found that keeps the clearance, the distance to singular postures and the turn "
            f"rate asked for; without these none could be ruled out.{where}",
        )
    return (
        Verdict.UNCERTAIN,
        None,
        "Uncertain: no route was found, and none could be ruled out: followed with proved bounds, something may lead "
        "from the first pose to the last. A little more room decides it.",
    )


def _misses(task: Task, place: Missed, that: str = "that was looked at ") -> str:
    """Return where and by what the clearance is missed, in a sentence: by all postures, or by all of some kind."""
    keep = task.keep
    pair = "" if keep.nearest is None else keep.nearest(place.q)
    apart = (
        f"{place.metres * 1e3:.4g} mm apart" if place.metres > 0 else f"{-place.metres * 1e3:.4g} mm into each other"
    )
    kept = f"keeps {keep.clearance * 1e3:.4g} mm" if keep.clearance else "is clear"
    best = "at best" if that else "of those on an even grid the best has"
    return f"At {place.s:.4g} of the path no posture {that}{kept}: {best} {pair} {'are ' if that else ''}{apart}."


def _in_the_way(task: Task, place: Missed, looked: str) -> tuple[Verdict, Blocked, str]:
    why = _misses(task, place, "")
    reason = (
        f"Impossible: no motion gets past {place.s:.6g} of the path, whatever the branch, the turn and the whole turns."
        f" All that holds the pose there inside the limits was looked at with proved bounds: {looked}."
    )
    return Verdict.IMPOSSIBLE, Blocked((place.s, place.s), (), why, place.s, Opening(task, ())), reason


def _dense(s: Array, count: int) -> Array:
    """Return the points of a path with as many between each two as make `count` stations."""
    each = max(1, -(-(count - 1) // (len(s) - 1)))
    part = np.arange(each) / each
    return np.append((s[:-1, None] + np.diff(s)[:, None] * part).ravel(), s[-1])
