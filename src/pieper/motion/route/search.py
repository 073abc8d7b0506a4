"""The search for a route: a ladder at stations, carried to all points, made short, and looked at between the points."""

from __future__ import annotations

import itertools
from dataclasses import dataclass, field, replace

import numpy as np

from pieper.kinematics.arrays import Array, Bools, Indices
from pieper.kinematics.joints import inside
from pieper.motion.route.drift import drifting
from pieper.motion.route.freedom import Freedom
from pieper.motion.route.grid import TURNS, Grid, grid
from pieper.motion.route.keep import Keep
from pieper.motion.route.ladder import Rungs, Way, climb, fitted, from_ends, rungs
from pieper.motion.route.places import between, spread
from pieper.motion.route.reach import beyond_reach
from pieper.motion.route.setting import Setting, with_turn_limits
from pieper.motion.route.setting import setting as setting_of
from pieper.motion.route.smooth import Shape, Smoothed, smooth
from pieper.motion.route.together import branches, continuous, one_branch
from pieper.tolerances import CONE_INSIDE, LIMIT_SLACK, NO_LOOK_BETWEEN, POINTS_FAR_APART, SAME_COST

#: Stations of the first ladder, and how often twice as many are tried, each with a finer grid.
STATIONS, FINER = 51, (1, 2, 4)
#: Stations of a ladder beside the first, and how much finer its turns are. A move by one cell between two of many
#: stations costs more than the same spread over them all: what turns slowly is found over few stations and many turns.
SLOW = (13, 4)
#: Ways over such few stations that are made short to see which is cheapest.
DRIFTS = 8
#: By how much rows of the first ladder may be outside (rad) where none inside leads on.
WIDER = 0.08
#: Stations where nothing is free.
DENSE = 1200
#: Points in all where a route is made short with points between those of the path.
BETWEEN = 400
#: Rows that a ladder may have in all: it bounds memory and time.
MOST_ROWS = 4_000_000
#: Parts of the way from the ladder's route to the shortest one that are tried where something must be kept.
PARTS = (1.0, 0.75, 0.5, 0.25, 0.0)


@dataclass(frozen=True, eq=False)
class Task:
    """What a route is to be like.

    Attributes:
        setting: What is solved.
        largest: Whether the largest joint difference of a step counts (time) instead of the sum of squares.
        ends: Joint vectors (m,) it must begin and end with, or None.
        turn_step: (N - 1,) largest change of the turn, or None.
        keep: What it must keep beside limits.
    """

    setting: Setting
    largest: bool
    ends: tuple[Array | None, Array | None]
    turn_step: Array | None
    keep: Keep = field(default_factory=Keep)


@dataclass(frozen=True, eq=False)
class Found:
    """A route (N, m) with its cost and slope, and the ladder it came from."""

    x: Array
    cost: float
    slope: float
    grid: Grid
    rungs: Rungs


def stations(count: int, wanted: int) -> Indices:
    """Return indices of points, the ends among them."""
    return np.unique(np.round(np.linspace(0, count - 1, min(count, wanted))).astype(np.int64))


def search(task: Task, ladders: int = len(FINER)) -> Found | None:
    """Return the cheapest route that so many ladders, each finer than the one before, lead to; None for none."""
    setting = task.setting
    N = len(setting.path)
    if setting.spare > 1 and beyond_reach(setting) is not None:
        return None
    for finer in FINER[:ladders]:
        cells = grid(setting, finer, 0.0)
        fixed = len(cells.cells) == 1
        at = stations(N, (STATIONS - 1) * finer + 1)
        most = max(2, MOST_ROWS // (len(cells.cells) * 16))
        at = (at if len(at) <= most else stations(N, most)).astype(float)
        if fixed:
            # nothing is chosen, and quick: stations between the points as well
            each = max(1, -(-DENSE // (N - 1)))
            at = np.append((np.arange(N - 1)[:, None] + np.arange(each) / each).ravel(), N - 1.0)
        ladder = _ladder(task, cells, at)
        slow = _slow(task, at) if setting.spare == 1 and not fixed and not setting.tilts else _upright(task, at)
        found = climbed_and_carried(task, cells, ladder, slow)
        if fixed and (found is None or not one_branch(setting, found.x)):
            found = _cheapest_branch(task, cells)
        if found is not None:
            return Found(found.x, found.cost, found.slope, cells, ladder)
        if fixed:
            break
    return _held(task)


def _held(task: Task) -> Found | None:
    """Return a route on which a turn that is free is held, where the ladders lead nowhere.

    A route beside a singular posture may swing faster than any ladder steps; held, its branches are carried.
    """
    world, free = task.setting, task.setting.free
    if not world.turn_on_grid or not free.turns or world.spare > 1 or world.tilts:
        return None
    low, high = free.interval
    turn = min(max(0.0, low), high)
    turn = next((float(-end[world.n]) for end in task.ends if end is not None), turn)
    held = Freedom(turn=(turn, turn), axis=free.axis)
    there = setting_of(world.plan, with_turn_limits(world.curves, held), held, world.asked, world.s)
    found = search(replace(task, setting=there))
    if found is None:
        return None
    moved = carried(task, found.x, np.arange(len(found.x), dtype=float))
    if moved is None or moved.cost > found.cost:
        return replace(found, slope=np.inf)
    return replace(found, x=moved.x, cost=moved.cost, slope=moved.slope)


def _cheapest_branch(task: Task, cells: Grid) -> Smoothed | None:
    """Return the cheapest branch that is carried from end to end, where nothing is free."""
    setting, best = task.setting, None
    for branch in branches(setting, cells, task.ends):
        x, on = setting.on(branch, setting.path)
        if not on.all() or np.abs((x - branch) / setting.chain.joints.unit).max() > NO_LOOK_BETWEEN:
            continue
        cost = cost_of(setting, x, task.largest)
        if (best is None or cost < best.cost) and task.keep.holds(setting, x):
            best = Smoothed(x, cost, 0.0)
    return best


def leads(task: Task) -> bool:
    """Whether the first ladder leads from the first point to the last; nothing is made short, nothing looked at."""
    if task.setting.spare > 1 and beyond_reach(task.setting) is not None:
        return False
    cells = grid(task.setting, FINER[0], 0.0)
    at = np.arange(len(task.setting.path), dtype=float)
    ladder = _ladder(task, cells, at)
    spots = (False, True) if task.setting.spare else (False,)
    return any(_climbed(task, cells, ladder, at, spot, 0.0) is not None for spot in spots)


def _ladder(task: Task, cells: Grid, at: Array) -> Rungs:
    """Return the rows at stations (M,), counted in points of the path, that keep what must be kept."""
    setting = task.setting
    ladder = rungs(setting, cells, np.interp(at, np.arange(len(setting.s)), setting.s), np.diff(at))
    if task.keep.anything:
        ladder = replace(ladder, valid=task.keep.rows(setting, ladder.x, _inside(setting, ladder)))
    return ladder


def _slow(task: Task, at: Array) -> Array | None:
    """Return what leads over few stations where the turn moves slowly, at stations (M,); None where nothing does."""
    few = at[stations(len(at), SLOW[0])]
    cells = grid(task.setting, SLOW[1], 0.0)
    found = _climbed(task, cells, _ladder(task, cells, few), few, False, 0.0)
    ways = [*_drifting(task, few)] + ([] if found is None else [found.x])
    points, best = np.round(few).astype(np.int64), None
    shape = _shape(task, points, np.diff(few), _told(task))
    for way in ways:
        x, on = task.setting.on(way, task.setting.path[points])
        if on.all():
            short = smooth(shape, x, rough=True)
            best = short if best is None or short.cost < best.cost else best
    return None if best is None else between(best.x, few, at)


def _drifting(task: Task, few: Array) -> list[Array]:
    """Return ways over few stations (M,) that each stay on a branch and whose turn drifts, inside the limits."""
    setting = task.setting
    cells = grid(setting)
    if task.largest or task.turn_step is not None or _told(task).any() or len(cells.coordinates) != 1:
        return []
    ways, told = list[Array](), -np.inf
    for cost, way in itertools.islice(drifting(setting, cells, _ladder(task, cells, few)), DRIFTS):
        x = fitted(setting, way)
        # a wrist and the same flipped cost the same
        if x is not None and cost > told * (1 + SAME_COST):
            ways.append(x)
            told = cost
    return ways


def _upright(task: Task, at: Array) -> Array | None:
    """Return at stations (M,) the route without the tilt that is free here: where it is the best of all it is known."""
    world = task.setting
    if not world.tilts or any(end is not None and np.abs(end[-2:]).max() > CONE_INSIDE for end in task.ends):
        return None
    free = Freedom(turn=world.free.turn, axis=world.free.axis)
    ends = tuple(None if end is None else end[:-2] for end in task.ends)
    bare = replace(task, setting=setting_of(world.plan, world.curves, free, world.asked, world.s), ends=ends)
    found = search(bare, 1)
    if found is None:
        return None
    return between(np.hstack([found.x, np.zeros((len(found.x), 2))]), np.arange(len(found.x), dtype=float), at)


def dense(task: Task, least: int, most: int, wanted: int = BETWEEN) -> tuple[Task, int]:
    """Return the task with so many points from each of the path's to the next that there are `wanted` in all."""
    setting = task.setting
    each = int(np.clip(-(-wanted // (len(setting.path) - 1)), least, most))
    part = np.arange(each) / each
    s = np.append((setting.s[:-1, None] + np.diff(setting.s)[:, None] * part).ravel(), setting.s[-1])
    poses = setting.at(s)
    step = None if task.turn_step is None else np.repeat(task.turn_step / each, each)
    # the axis that is meant is the z of these poses; as they were asked for they serve a bound that is not taken here
    return replace(task, setting=replace(setting, path=poses, asked=poses, s=s), turn_step=step), each


def far_apart(setting: Setting) -> bool:
    """Whether points of the path are so far apart that rows at them alone do not lead from one to the next."""
    step = np.linalg.norm(np.diff(setting.path[:, :3, 3], axis=0), axis=1).max()
    _, angle = setting.twists(setting.s)
    return bool(step > POINTS_FAR_APART * setting.plan.chain.length or np.abs(angle).max() > POINTS_FAR_APART)


def search_between(task: Task, ladders: int = len(FINER)) -> Found | None:
    """Return a route that so many ladders lead to, made short with points between those of the path too.

    What is cheapest from point to point may change the branch where points are far apart, which is no route.
    """
    fine, each = dense(task, 1, BETWEEN)
    found = search(fine, ladders) if each > 1 else None
    if found is None:
        return None
    x = found.x[::each]
    kept = replace(found, x=x, cost=cost_of(task.setting, x, task.largest), slope=np.inf)
    moved = carried(task, x, np.arange(len(x), dtype=float))
    if moved is None or moved.cost > kept.cost:
        return kept
    return replace(kept, x=moved.x, cost=moved.cost, slope=moved.slope)


def _inside(setting: Setting, ladder: Rungs) -> Bools:
    """Return which rows are solutions and, whole turns aside, inside the limits."""
    return ladder.valid & setting.chain.joints.inside_limits(ladder.x, setting.limits)[1]


def climbed_and_carried(task: Task, cells: Grid, ladder: Rungs, slow: Array | None = None) -> Smoothed | None:
    """Return the route that a ladder leads to.

    Where its rows lead nowhere, moves on the spot are allowed, and then rows that are outside by up to a part of a
    cell: a route may pass between two rows, and is pulled inside where it is made short.

    Args:
        task: What the route is to be like.
        cells: The cells of the ladder.
        ladder: Its rows.
        slow: (M, m) another way over the same stations; the one that is shorter once made short is taken.
    """
    at = np.interp(ladder.s, task.setting.s, np.arange(len(task.setting.s)))
    widest = WIDER / max(1, len(cells.cells) // TURNS[1]) if task.setting.spare == 1 else 0.0
    for spot, wider in ((False, 0.0), (True, 0.0), (True, widest / 4), (True, widest)):
        if spot and wider == 0.0 and task.setting.spare == 0:
            continue
        way = _climbed(task, cells, ladder, at, spot, wider)
        for place, x in _shortest_first(task, way, at, slow):
            found = carried(task, x, place)
            if found is not None:
                return found
        if widest == 0.0 and spot:
            break
    return None


def _shortest_first(task: Task, way: Way | None, at: Array, slow: Array | None) -> list[tuple[Array, Array]]:
    """Return ways as places (k,) and points (k, m), nearly made short, the one that then costs least first."""
    ways: list[tuple[Array, Array]] = []
    if way is not None and len(np.unique(way.rung)) == len(way.rung):
        ways.append((at[way.rung], way.x))
    elif way is not None:
        return [(spread(at[way.rung]), way.x)]
    if slow is not None:
        ways.append((at, slow))
    if not task.setting.spare:
        return ways
    ends = _told(task)
    rough = list[Smoothed]()
    for place, x in ways:
        points: Indices = np.round(place).astype(np.int64)
        # beside its poses a way costs less than any on them: none of its steps would be taken
        on_path, on = task.setting.on(x, task.setting.path[points])
        shape = _shape(task, points, np.diff(place), ends)
        rough.append(smooth(shape, on_path, rough=True) if on.all() else Smoothed(x, np.inf, np.inf))
    order = sorted(range(len(ways)), key=lambda k: rough[k].cost)
    return [(ways[k][0], rough[k].x if np.isfinite(rough[k].cost) else ways[k][1]) for k in order]


def _told(task: Task) -> Bools:
    """Return whether the route is to begin, and to end, as told."""
    return np.array([end is not None for end in task.ends])


def _climbed(task: Task, cells: Grid, ladder: Rungs, at: Array, spot: bool, wider: float) -> Way | None:
    setting = task.setting
    turn_step = None
    if task.turn_step is not None:
        total = np.append(0.0, np.cumsum(task.turn_step))
        turn_step = np.diff(np.interp(at, np.arange(len(total)), total))
        if spot:
            return None
    told = any(end is not None for end in task.ends)
    for all_turns in (False, True):
        way = climb(
            setting,
            cells,
            ladder,
            largest=task.largest,
            on_the_spot=spot,
            turn_step=turn_step,
            ends=task.ends,
            all_turns=all_turns,
            wider=wider,
        )
        if not np.isfinite(way.cost):
            if not all_turns:
                return None  # nothing without whole turns: nothing with them
            continue
        if not told:
            x = fitted(setting, way.x, wider=wider)
        else:
            x = way.x if all_turns else from_ends(setting, way.x, task.ends, wider)
        if x is not None:
            return replace(way, x=x)
    return None


def carried(task: Task, x: Array, place: Array) -> Smoothed | None:
    """Return points x (k, m) at places (k,) carried to all points, made short, if that is a continuous route inside."""
    setting = task.setting
    N = len(setting.path)
    ends = _told(task)
    if len(place) != N:
        x = between(x, place, np.arange(N, dtype=float))
    x, on = setting.on(x, setting.path)
    if not on.all():
        return None
    done = Smoothed(x, 0.0, 0.0)
    if setting.spare:
        done = smooth(_shape(task, np.arange(N, dtype=np.int64), np.ones(N - 1), ends), x)
    for part in PARTS if task.keep.anything else (1.0,):
        # what must be kept may be lost where the route is made short: then part of the way there is taken
        y, on = (done.x, on) if part == 1.0 else setting.on(x + part * (done.x - x), setting.path)
        slope = done.slope if part == 1.0 else np.inf
        moved = y if ends.any() else fitted(setting, y)
        if moved is None or not on.all() or (ends.any() and not _kept(task, moved)):
            continue
        tilted = setting.tilt_of(moved).max(initial=0.0) > setting.free.cone + LIMIT_SLACK
        if (
            inside(moved, setting.limits).all()
            and not tilted
            and task.keep.holds(setting, moved)
            and continuous(setting, moved)
        ):
            return Smoothed(moved, cost_of(setting, moved, task.largest), slope)
    return None


def _kept(task: Task, x: Array) -> bool:
    """Whether a route begins and ends as told."""
    n = task.setting.n
    return all(
        end is None or bool(np.abs(x[i, :n] - end[:n]).max() < NO_LOOK_BETWEEN)
        for i, end in zip((0, -1), task.ends, strict=True)
    )


def _shape(task: Task, at: Indices, parts: Array, ends: Bools) -> Shape:
    setting = task.setting
    fixed = np.ones(len(at))
    fixed[0], fixed[-1] = ~ends
    step: Array | None = None
    if task.turn_step is not None:
        travelled: Array = np.append(0.0, np.cumsum(task.turn_step))
        step = np.diff(travelled[at])
    return Shape(setting, setting.path[at], parts, 8 if task.largest else 2, fixed, step)


def cost_of(setting: Setting, x: Array, largest: bool) -> float:
    """Return what a route (N, m) costs."""
    e = np.diff(x, axis=0)
    if largest:
        return float(np.sum(np.max(np.sqrt(setting.weights) * np.abs(e), axis=1, initial=0.0)))
    return float(np.sum(setting.weights * e * e))
