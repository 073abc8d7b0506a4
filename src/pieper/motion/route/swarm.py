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
#: How far they wander (rad; lengths of the arm), and how far from place to place and at a place they may get.
FAR, LONGEST = (0.01, 0.05, 0.15), 0.3
#: Chains that are tried, each from another posture at the first place.
CHAINS = 6


@dataclass(frozen=True, eq=False)
class _Generation:
    """Postures x (k, m) at a place of the path, and which of the generation before each descends from (k,)."""

    place: float
    x: Array
    parent: Indices


def search_by_swarm(task: Task) -> Found | None:
    """Return the cheapest route that a swarm found from the first pose to the last, None where none holds."""
    if task.ends[0] is None and task.ends[1] is not None:
        found = search_by_swarm(backwards(task))
        return None if found is None else replace(found, x=found.x[::-1], rungs=rungs_backwards(found.rungs))
    if task.turn_step is not None or task.ends[1] is not None or task.keep.anything:
        return None
    alive, rounds, places = THIN if task.setting.thin else WIDE
    fine, each = dense(task, 1, places, places)
    best: Smoothed | None = None
    for x in _chains(fine, alive, rounds):
        found = carried(fine, x, np.arange(len(x), dtype=float))
        if found is None:
            continue
        own = found.x[::each]
        one = carried(task, own, np.arange(len(own), dtype=float))
        one = Smoothed(own, cost_of(task.setting, own, task.largest), np.inf) if one is None else one
        if best is None or one.cost < best.cost:
            best = one
    if best is None:
        return None
    cells, s = grid(task.setting), task.setting.s
    return Found(best.x, best.cost, best.slope, cells, rungs(task.setting, cells, s, np.ones(len(s) - 1)))


def _chains(task: Task, most: int, rounds: int) -> Iterator[Array]:
    """Yield chains (N, m) with a point at each pose, those of different first postures."""
    world, rng = task.setting, np.random.default_rng(1)
    x = _first(task, most, rng)
    lived = [_Generation(0.0, x, np.arange(len(x)))]
    for k in range(len(world.path)):
        if k:
            x, alive = _moved(world, lived[-1].x, world.path[k])
            kept = np.flatnonzero(alive & _near(world, x, lived[-1].x))
            lived.append(_Generation(float(k), x[kept], kept))
        for _ in range(rounds):
            now = lived[-1].x
            if not len(now):
                return
            lived.append(_wandered(world, lived[-1], world.path[k], most, rng))
    root = np.arange(len(lived[0].x))
    for generation in lived[1:]:
        root = root[generation.parent]
    for first in rng.permutation(np.unique(root))[:CHAINS]:
        yield _back(lived, int(np.flatnonzero(root == first)[0]), len(world.path))


def _back(lived: list[_Generation], last: int, count: int) -> Array:
    """Return the ancestors (N, m) of one of the last generation: of each place the first that led on."""
    out = np.zeros((count, lived[0].x.shape[1]))
    for generation in reversed(lived):
        out[int(generation.place)] = generation.x[last]
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
        x, alive = _moved(world, world.whole(rng.uniform(low, high, (TRIED, world.n)), T), T, SETTLING)
        found = np.vstack([found, x[alive]])
        if len(found) >= most:
            break
    return found[:most]


def _wandered(world: Setting, now: _Generation, T: Array, most: int, rng: np.random.Generator) -> _Generation:
    """Return a generation with descendants beside it, at the same pose."""
    unit = world.chain.joints.unit
    parent = rng.integers(len(now.x), size=most)
    step = rng.normal(size=(most, world.m)) * rng.choice(FAR, size=(most, 1)) * unit
    x, alive = _moved(world, now.x[parent] + step, T)
    alive &= _near(world, x, now.x[parent])
    every, of = np.vstack([now.x, x[alive]]), np.append(np.arange(len(now.x)), parent[alive])
    kept = rng.permutation(len(every))[:most]
    return _Generation(now.place, every[kept], of[kept])


def _near(world: Setting, x: Array, y: Array) -> Bools:
    """Return which postures (k, m) have their joints near others."""
    n = world.n
    return np.abs((x - y)[:, :n] / world.chain.joints.unit[:n]).max(1) < LONGEST


def _moved(world: Setting, x: Array, T: Array, times: int = 1) -> tuple[Array, Bools]:
    """Return coordinates (k, m) moved onto a pose, and which get there inside the limits and the cone.

    They are drawn inside and moved onto the pose in turns, so many times.
    """
    for _ in range(times - 1):
        x, _ = _onto(world, _drawn_in(world, x), T, 3)
    x, on = _onto(world, _drawn_in(world, x), T, 8)
    on &= inside(x, world.limits).all(1)
    if world.tilts:
        on &= world.tilt_of(x) < world.free.cone - LIMIT_SLACK
    return x, on


def _onto(world: Setting, x: Array, T: Array, steps: int) -> tuple[Array, Bools]:
    """Return coordinates (k, m) moved onto a pose with a turn that is held where it is, and which get there."""
    low, high = world.limits[world.n] if world.turns else (0.0, 1.0)
    if low == high and world.coupling is None:
        held = world.chain.locked(world.n, float(low))
        x = np.insert(newton(held, np.delete(x, world.n, 1), T, steps=steps), world.n, low, axis=1)
    else:
        x = newton(world.chain, x, T, steps=steps)
    return x, missed(world.chain, x, T) < CLOSES


def _drawn_in(world: Setting, x: Array) -> Array:
    """Return coordinates (k, m) with each inside its limits and the tilt inside the cone."""
    x = np.clip(x, *world.limits.T)
    if world.tilts:
        size = np.linalg.norm(x[:, -2:], axis=1, keepdims=True)
        x[:, -2:] *= np.minimum(1.0, world.free.cone * (1 - CONE_INSIDE) / np.maximum(size, world.free.cone / 2))
    return x
