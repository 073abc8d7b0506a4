"""A route where no ladder leads: postures that drift along the path and wander on the way, as many as can live.

An arm that leans its tool only as its own joints decide, one of four joints or one whose last joint turns about the
axis that is meant, meets no even grid of turns and tilts: what it holds is thin among them. A narrow passage between
limits and the edge of a cone is thin as well. A swarm needs no grid: postures are carried from place to place by Newton
steps, what leaves the limits dies, and what lives has descendants beside it. Who descends from whom is a chain from the
first pose to the last, carried and made short like any other before it is a route. A swarm that dies proves nothing.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from pieper.kinematics.arrays import Array, Bools, Indices
from pieper.kinematics.joints import inside
from pieper.kinematics.newton import missed, newton
from pieper.motion.route.grid import grid
from pieper.motion.route.ladder import rungs
from pieper.motion.route.search import Found, Task, carried, cost_of, dense
from pieper.motion.route.setting import Setting
from pieper.motion.route.smooth import Smoothed
from pieper.motion.route.windows import backwards, rungs_backwards
from pieper.tolerances import CLOSES, CONE_INSIDE, LIMIT_SLACK

#: Postures that live at a place at most, rounds of wandering there, and places from end to end: of a thin set,
#: which has few sheets, and of another.
THIN, WIDE = (120, 1, 60), (400, 4, 200)
#: Postures that are tried for the first place at once, and how often.
TRIED, TIMES, SETTLING = 1000, 12, 6
#: Part of what the turn may change by that it is drawn into: a little is left for what the pose takes back.
INSIDE_TURNS = 0.7
#: How far they wander (rad; lengths of the arm), and how far from place to place and at a place they may get.
FAR, LONGEST = (0.01, 0.05, 0.15), 0.3
#: Chains that are tried, each from another posture at the first place.
CHAINS = 6


@dataclass(frozen=True, eq=False)
class _Generation:
    """Postures x (k, m) at a place of the path, which of the generation before each descends from (k,).

    And which turn each had where it came to that place (k,): what may change until the next is counted from there.
    """

    place: int
    x: Array
    parent: Indices
    turn: Array


def search_by_swarm(task: Task) -> Found | None:
    """Return the cheapest route that a swarm found from the first pose to the last, None where none holds."""
    if task.ends[0] is None and task.ends[1] is not None:
        found = search_by_swarm(backwards(task))
        return None if found is None else replace(found, x=found.x[::-1], rungs=rungs_backwards(found.rungs))
    alive, rounds, places = THIN if task.setting.thin else WIDE
    fine, each = dense(task, 1, places, places)
    best: Smoothed | None = None
    for x in _chains(fine, alive, rounds) if task.ends[1] is None else _joined(fine, alive, rounds):
        found = carried(fine, x, np.arange(len(x), dtype=float))
        if found is None:
            continue
        own = found.x[::each]
        one = carried(task, own, np.arange(len(own), dtype=float))
        one = Smoothed(own, cost_of(task.setting, own, task.largest), np.inf) if one is None else one
        if _turns_slowly(task, one.x) and (best is None or one.cost < best.cost):
            best = one
    if best is None:
        return None
    cells, s = grid(task.setting), task.setting.s
    return Found(best.x, best.cost, best.slope, cells, rungs(task.setting, cells, s, np.ones(len(s) - 1)))


def _turns_slowly(task: Task, x: Array) -> bool:
    """Whether a route (N, m) keeps the turn rate."""
    if task.turn_step is None:
        return True
    return bool((np.abs(np.diff(x[:, task.setting.n])) <= task.turn_step + LIMIT_SLACK).all())


def _lived(task: Task, most: int, rounds: int) -> list[_Generation]:
    """Return the generations from the first place to the last, or to where none is left."""
    world, rng = task.setting, np.random.default_rng(1)
    x = _first(task, most, rng)
    lived = [_Generation(0, x, np.arange(len(x)), world.turn_of(x))]
    for k in range(len(world.path)):
        if k:
            before = lived[-1]
            x, alive = _moved(task, before.x, world.path[k], turns=_turns(task, k - 1, before.turn))
            alive &= _near(world, x, before.x)
            kept = np.flatnonzero(alive)
            lived.append(_Generation(k, x[kept], kept, world.turn_of(x[kept])))
        for _ in range(rounds):
            if not len(lived[-1].x):
                return lived
            lived.append(_wandered(task, lived[-1], most, rng))
    return lived


def _turns(task: Task, step: int, before: Array) -> tuple[Array, Array] | None:
    """Return between which turns (k,) a step of the path may be at its end where it begins at others; None for any."""
    if task.turn_step is None or step >= len(task.turn_step):
        return None
    return before - task.turn_step[step], before + task.turn_step[step]


def _chains(task: Task, most: int, rounds: int) -> Iterator[Array]:
    """Yield chains (N, m) with a point at each pose, those of different first postures."""
    lived, N = _lived(task, most, rounds), len(task.setting.path)
    if lived[-1].place < N - 1:
        return
    root = np.arange(len(lived[0].x))
    for generation in lived[1:]:
        root = root[generation.parent]
    for first in np.random.default_rng(2).permutation(np.unique(root))[:CHAINS]:
        yield _back(lived, int(np.flatnonzero(root == first)[0]), N)


def _joined(task: Task, most: int, rounds: int) -> Iterator[Array]:
    """Yield chains (N, m) from the posture that is told to the one to end with, of which one half came from each.

    Two swarms, one from each end, are laid side by side at every place; where two postures are nearest they are joined.
    """
    N, unit = len(task.setting.path), task.setting.chain.joints.unit
    there, back = _lived(task, most, rounds), _lived(backwards(task), most, rounds)
    last = [{g.place: k for k, g in enumerate(lived) if len(g.x)} for lived in (there, back)]
    pairs: list[tuple[float, int, int, int, int]] = []
    for place in range(N):
        i, j = last[0].get(place), last[1].get(N - 1 - place)
        if i is None or j is None:
            continue
        n = task.setting.n
        gap = np.abs((there[i].x[:, None, :n] - back[j].x[None, :, :n]) / unit[:n]).max(-1)
        a, b = (int(v) for v in np.unravel_index(int(gap.argmin()), gap.shape))
        if gap[a, b] < LONGEST:
            pairs.append((float(gap[a, b]), i, a, j, b))
    for _, i, a, j, b in sorted(pairs)[:CHAINS]:
        from_start, from_end = _back(there[: i + 1], a, N), _back(back[: j + 1], b, N)[::-1]
        place = there[i].place
        x = np.vstack([from_start[: place + 1], from_end[place + 1 :]])
        x[0], x[-1] = from_start[0], from_end[-1]
        yield x


def _back(lived: list[_Generation], last: int, count: int) -> Array:
    """Return the ancestors (N, m) of one of the last generation: of each place the first that led on."""
    out = np.zeros((count, lived[0].x.shape[1]))
    for generation in reversed(lived):
        out[generation.place] = generation.x[last]
        last = int(generation.parent[last])
    return out


def _first(task: Task, most: int, rng: np.random.Generator) -> Array:
    """Return postures (k, m) at the first pose: the one that is told, or what is found from anywhere in the limits."""
    world = task.setting
    if task.ends[0] is not None:
        return task.ends[0][None]
    low, high = np.where(np.isfinite(world.plan.limits), world.plan.limits, np.pi * np.array([-1.0, 1.0])).T
    found, T = np.zeros((0, world.m)), world.path[0]
    for _ in range(TIMES):
        x, alive = _moved(task, world.whole(rng.uniform(low, high, (TRIED, world.n)), T), T, SETTLING)
        found = np.vstack([found, x[alive]])
        if len(found) >= most:
            break
    return found[:most]


def _wandered(task: Task, now: _Generation, most: int, rng: np.random.Generator) -> _Generation:
    """Return a generation with descendants beside it, at the same pose."""
    world = task.setting
    unit = world.chain.joints.unit
    parent = rng.integers(len(now.x), size=most)
    step = rng.normal(size=(most, world.m)) * rng.choice(FAR, size=(most, 1)) * unit
    turns = _turns(task, now.place, now.turn[parent])
    x, alive = _moved(task, now.x[parent] + step, world.path[now.place], turns=turns)
    alive &= _near(world, x, now.x[parent])
    every, of = np.vstack([now.x, x[alive]]), np.append(np.arange(len(now.x)), parent[alive])
    kept = rng.permutation(len(every))[:most]
    return _Generation(now.place, every[kept], of[kept], now.turn[of[kept]])


def _near(world: Setting, x: Array, y: Array) -> Bools:
    """Return which postures (k, m) have their joints near others."""
    n = world.n
    return np.abs((x - y)[:, :n] / world.chain.joints.unit[:n]).max(1) < LONGEST


def _moved(
    task: Task, x: Array, T: Array, times: int = 1, turns: tuple[Array, Array] | None = None
) -> tuple[Array, Bools]:
    """Return coordinates (k, m) moved onto a pose, and which get there and keep limits, cone, clearance and the like.

    They are drawn inside, and their turns between two (k,) each, and moved onto the pose, in turns so many times.
    """
    world = task.setting
    for _ in range((times if turns is None else SETTLING) - 1):
        x, _ = _onto(world, _drawn_in(world, x, turns), T, 3)
    x, on = _onto(world, _drawn_in(world, x, turns), T, 8)
    on &= inside(x, world.limits).all(1)
    if world.tilts:
        on &= world.tilt_of(x) < world.free.cone - LIMIT_SLACK
    if turns is not None:
        turn = world.turn_of(x)
        on &= (turn >= turns[0]) & (turn <= turns[1])
    return x, task.keep.rows(world, x, on)


def _onto(world: Setting, x: Array, T: Array, steps: int) -> tuple[Array, Bools]:
    """Return coordinates (k, m) moved onto a pose with a turn that is held where it is, and which get there."""
    low, high = world.limits[world.n] if world.turns else (0.0, 1.0)
    if low == high and world.coupling is None:
        held = world.chain.locked(world.n, float(low))
        x = np.insert(newton(held, np.delete(x, world.n, 1), T, steps=steps), world.n, low, axis=1)
    else:
        x = newton(world.chain, x, T, steps=steps)
    return x, missed(world.chain, x, T) < CLOSES


def _drawn_in(world: Setting, x: Array, turns: tuple[Array, Array] | None) -> Array:
    """Return coordinates (k, m) with each inside its limits, the tilt inside the cone and the turn between two (k,)."""
    x = np.clip(x, *world.limits.T)
    if turns is not None:
        middle, half = (turns[1] + turns[0]) / 2, INSIDE_TURNS * (turns[1] - turns[0]) / 2
        x[:, world.n] = -np.clip(world.turn_of(x), middle - half, middle + half)
    if world.tilts:
        size = np.linalg.norm(x[:, -2:], axis=1, keepdims=True)
        x[:, -2:] *= np.minimum(1.0, world.free.cone * (1 - CONE_INSIDE) / np.maximum(size, world.free.cone / 2))
    return x
