"""The search for a route: a ladder at stations, carried to all points, made short, and looked at between the points."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.joints import inside
from pieper.motion.route.grid import Grid, grid
from pieper.motion.route.ladder import Rungs, Way, climb, fitted, rungs
from pieper.motion.route.setting import Setting
from pieper.motion.route.smooth import Shape, Smoothed, smooth

#: Stations of the first ladder, and how often twice as many are tried, each with a finer grid.
STATIONS, FINER = 51, (1, 2, 4)
#: Rows that a ladder may have in all: it bounds memory and time.
MOST_ROWS = 4_000_000
#: How far the point of a route half way between two others may be off their middle, as a part of their distance, and
#: how often a stretch is halved to see.
STRAIGHT, HALVINGS = 0.3, 8
#: Two points this near (rad; lengths) need no look between them.
NEAR = 1e-6


@dataclass(frozen=True, eq=False)
class Task:
    """What a route is to be like.

    Attributes:
        setting: What is solved.
        largest: Whether the largest joint difference of a step counts (time) instead of the sum of squares.
        ends: Joint vectors (m,) it must begin and end with, or None.
        turn_step: (N - 1,) largest change of the turn, or None.
    """

    setting: Setting
    largest: bool
    ends: tuple[Array | None, Array | None]
    turn_step: Array | None


@dataclass(frozen=True, eq=False)
class Found:
    """A route (N, m) with its cost and slope, and the ladder it came from."""

    x: Array
    cost: float
    slope: float
    grid: Grid
    rungs: Rungs


def stations(count: int, wanted: int) -> Array:
    """Return indices of points, the ends among them."""
    return np.unique(np.round(np.linspace(0, count - 1, min(count, wanted))).astype(np.int64))


def search(task: Task) -> Found | None:
    """Return the cheapest route that ladders lead to, None where none is found."""
    setting = task.setting
    N = len(setting.path)
    for finer in FINER:
        cells = grid(setting, finer, 0.0)
        fixed = len(cells.cells) == 1
        at = stations(N, N if fixed else (STATIONS - 1) * finer + 1)
        most = max(2, MOST_ROWS // (len(cells.cells) * 16))
        at = at if len(at) <= most else stations(N, most)
        ladder = rungs(setting, cells, setting.s[at], np.diff(at).astype(float))
        found = climbed_and_carried(task, cells, ladder)
        if found is not None:
            return Found(found.x, found.cost, found.slope, cells, ladder)
        if fixed:
            break
    return None


def climbed_and_carried(task: Task, cells: Grid, ladder: Rungs) -> Smoothed | None:
    """Return the route that a ladder leads to, with moves on the spot where there is none without."""
    at = np.searchsorted(task.setting.s, ladder.s)
    for spot in (False, True):
        way = _climbed(task, cells, ladder, at, spot)
        found = None if way is None else _carried(task, way, at)
        if found is not None:
            return found
    return None


def _climbed(task: Task, cells: Grid, ladder: Rungs, at: Array, spot: bool) -> Way | None:
    setting = task.setting
    turn_step = None
    if task.turn_step is not None:
        total = np.append(0.0, np.cumsum(task.turn_step))
        turn_step = np.diff(total[at])
        if spot:
            return None
    told = any(end is not None for end in task.ends)
    for all_turns in (True,) if told else (False, True):
        way = climb(
            setting,
            cells,
            ladder,
            largest=task.largest,
            on_the_spot=spot,
            turn_step=turn_step,
            ends=task.ends,
            all_turns=all_turns,
        )
        if not np.isfinite(way.cost):
            if not all_turns:
                return None  # nothing without whole turns: nothing with them
            continue
        x = way.x if all_turns and told else fitted(setting, way.x)
        if x is not None:
            return replace(way, x=x)
    return None


def _carried(task: Task, way: Way, at: Array) -> Smoothed | None:
    """Return a way at stations carried to all points, made short, if it is a continuous route inside the limits."""
    setting = task.setting
    N = len(setting.path)
    ends = np.array([end is not None for end in task.ends])
    place = at[way.rung].astype(float)
    if len(np.unique(way.rung)) == len(way.rung):
        shape = _shape(task, at, np.diff(at).astype(float), ends)
        rough = smooth(shape, way.x) if setting.spare else Smoothed(way.x, way.cost, 0.0)
        x = rough.x if np.isfinite(rough.cost) else way.x
    else:
        x, place = way.x, _spread(place)
    points = np.arange(N, dtype=float)
    x = np.stack([np.interp(points, place, column) for column in x.T], -1) if len(place) != N else x
    x, on = setting.on(x, setting.path)
    if not on.all():
        return None
    done = Smoothed(x, 0.0, 0.0)
    if setting.spare:
        done = smooth(_shape(task, np.arange(N), np.ones(N - 1), ends), x)
    x = fitted(setting, done.x)
    if x is None or (ends.any() and not _kept(task, done.x)):
        return None
    x = done.x if ends.any() else x
    if not inside(x, setting.limits).all() or not continuous(setting, x):
        return None
    return Smoothed(x, cost_of(setting, x, task.largest), done.slope)


def _kept(task: Task, x: Array) -> bool:
    """Whether a route begins and ends as told."""
    n = task.setting.n
    return all(
        end is None or bool(np.abs(x[i, :n] - end[:n]).max() < NEAR) for i, end in zip((0, -1), task.ends, strict=True)
    )


def _shape(task: Task, at: Array, parts: Array, ends: Bools) -> Shape:
    setting = task.setting
    fixed = np.ones(len(at))
    fixed[0], fixed[-1] = ~ends
    step = None
    if task.turn_step is not None:
        step = np.diff(np.append(0.0, np.cumsum(task.turn_step))[at])
    return Shape(setting, setting.path[at], parts, 8 if task.largest else 2, fixed, step)


def _spread(place: Array) -> Array:
    """Return places of a chain that stands now and then, ascending: what happens on the spot takes half the way."""
    out = place.copy()
    for value in np.unique(place):
        same = np.flatnonzero(place == value)
        before = place[same[0] - 1] if same[0] > 0 else value
        after = place[same[-1] + 1] if same[-1] + 1 < len(place) else value
        out[same] = np.linspace(value - (value - before) * 0.45, value + (after - value) * 0.45, len(same))
    if len(out) > 1:
        out[0], out[-1] = place[0], place[-1]
    return out


def cost_of(setting: Setting, x: Array, largest: bool) -> float:
    """Return what a route (N, m) costs."""
    e = np.diff(x, axis=0)
    if largest:
        return float(np.sum(np.max(np.sqrt(setting.weights) * np.abs(e), axis=1, initial=0.0)))
    return float(np.sum(setting.weights * e * e))


def continuous(setting: Setting, x: Array) -> bool:
    """Whether the points (N, m) of a route hang together: half way between two lies a point of the path near both.

    A stretch whose middle is not where its ends say is halved; one that jumps to another branch never gets straight.
    """
    s0, s1, a, b = setting.s[:-1], setting.s[1:], x[:-1], x[1:]
    unit = setting.chain.joints.unit
    for _ in range(HALVINGS):
        middle = (a + b) / 2
        at = (s0 + s1) / 2
        there, on = setting.on(middle, setting.at(at))
        gap = np.abs((there - middle) / unit).max(1)
        size = np.abs((b - a) / unit).max(1)
        doubt = ~on | (gap > STRAIGHT * size + NEAR)
        if not doubt.any():
            return True
        if (~on & (size < NEAR)).any():
            return False
        s0, s1 = np.concatenate([s0[doubt], at[doubt]]), np.concatenate([at[doubt], s1[doubt]])
        a, b = np.concatenate([a[doubt], there[doubt]]), np.concatenate([there[doubt], b[doubt]])
    return False
