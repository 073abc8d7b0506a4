"""One tile of a map: some voxels, all orientations, solved completely; only bits and counts are kept."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any

import numpy as np

from pieper.kinematics.arrays import Array, Bits, Bools, Indices
from pieper.kinematics.chain import Chain
from pieper.kinematics.pose import inverse
from pieper.maps.around import Around
from pieper.maps.aspects import posture_shapes
from pieper.maps.grid import Grid
from pieper.maps.images import Images, images_of
from pieper.solver import verbs
from pieper.solver.plan.plan import Plan
from pieper.solver.results import Status
from pieper.solver.rows import Flag
from pieper.solver.singular.self_motion import SelfMotion
from pieper.tolerances import GEOMETRY_EXACT

#: Poses that are solved at once: what is held in memory, whatever the tile's size.
AT_ONCE = 32_768
#: Postures of each interval of a self-motion that are looked at for touching something.
LOOKED_AT = 33
_LOOK = int(Flag.DEGENERATE | Flag.UNCERTAIN)


#: What is measured of the solutions inside the limits of a voxel, and what of two sets makes the measure of both.
MEASURES = {
    "manipulability": np.maximum,
    "margin": np.maximum,
    "negative": np.add,
    "positive": np.add,
    "least_singular": np.minimum,
    "most_singular": np.maximum,
}


@dataclass(frozen=True, eq=False)
class Tile:
    """What is known of some voxels.

    Args:
        bits: (v, ceil(k / 8)) one bit an orientation: reached inside the limits.
        count: (v,) solutions inside the limits, all orientations together.
        measures: (v, 6) `MEASURES` of them, or (v, 0) where they were not asked for; zeros where there is none.
    """

    bits: Bits
    count: Indices
    measures: Array


@dataclass(frozen=True, eq=False)
class Question:
    """What a worker is told once: plain data that can be sent.

    Args:
        plan: How the arm is solved.
        grid: What is asked.
        rolls_by_last: Whether a roll of the tool is a turn of the last joint, so that one roll answers for all.
        sense: Which way it turns then.
        measure: Whether `MEASURES` are asked for.
        around: What solutions must keep clear of to count; None where nothing was said.
        by_first: Whether a turn of the first joint may answer for other voxels.
    """

    plan: Plan
    grid: Grid
    rolls_by_last: bool
    sense: float = 1.0
    measure: bool = False
    around: Around | None = None
    by_first: bool = False

    @cached_property
    def images(self) -> Images:
        """Which voxels answer for which."""
        nx, ny, nz = self.grid.shape
        each = Images(1, 1.0, np.arange(nx * ny)[:, None], nz)
        return images_of(self.grid, self.plan.chain) if self.by_first else each

    def __getstate__(self) -> dict[str, Any]:
        return {entry.name: getattr(self, entry.name) for entry in fields(self)}

    @property
    def words(self) -> str:
        """Which symmetry answered for what."""
        said = []
        if self.images.fold > 1:
            turn = {2: "half a turn", 4: "a quarter turn"}[self.images.fold]
            said.append(
                f"{turn} about the first axis is a turn of the first joint, so {self.images.count:,} of "
                f"{self.grid.count:,} voxels were solved and answer for all, limits kept"
            )
        if self.rolls_by_last:
            said.append(
                f"a roll of the tool is a turn of the last joint, so one of {self.grid.rolls} rolls was solved and "
                "answers for all, limits kept"
            )
        return "; ".join(said) or "every pose was solved"


def question_of(plan: Plan, grid: Grid, symmetry: str, measure: bool = False, around: Around | None = None) -> Question:
    """Return the question; symmetry is used where the arm has it, and `none` was not said.

    What the last joint carries is seldom round, and a scene never: with bodies each pose is a question of its own.
    """
    fused = plan.direct and plan.solver.reach is not None and around is None
    sense = last_joint_rolls(plan.chain) if fused else 0.0
    use = symmetry == "auto" and grid.rolls > 1 and sense != 0.0
    return Question(plan, grid, use, sense or 1.0, measure, around, fused and symmetry == "auto")


def last_joint_rolls(chain: Chain) -> float:
    """Return 1 or -1 where the last joint turns the tool about its own z axis, by that sense; 0 where it does not."""
    if chain.prismatic[-1] or chain.coupling is not None:
        return 0.0
    link, nearly = chain.links[-1], GEOMETRY_EXACT
    on_axis = np.hypot(link[0, 3], link[1, 3]) <= nearly * chain.length
    return float(np.sign(link[2, 2])) if on_axis and np.hypot(link[0, 2], link[1, 2]) <= nearly else 0.0


def solved(question: Question, images: Indices, threads: int | None) -> Tile:
    """Return the tile of voxels by their numbers (v, fold): those that are there, row by row."""
    plan = question.plan
    if plan.direct and plan.solver.reach is not None and question.around is None:
        return _fused(question, plan.solver.reach, images, threads)
    grid, which = question.grid, images[:, 0]
    each = max(1, AT_ONCE // len(grid.turns))
    parts = []
    for first in range(0, len(which), each):
        some = which[first : first + each]
        q, inside, hit, many = _directly(question, grid.poses(some, grid.turns), threads)
        bits = np.packbits(hit.reshape(len(some), -1), axis=1)
        parts.append((bits, many.reshape(len(some), -1).sum(1), _measures(question, q, inside, len(some))))
    bits, count, measures = (np.concatenate(part) for part in zip(*parts, strict=True))
    return Tile(bits, count.astype(np.int64), measures)


def _fused(question: Question, reach: Callable[..., Any], images: Indices, threads: int | None) -> Tile:
    """Return the tile as the kernel makes it, poses that want a look of their own looked at."""
    plan, grid, own = question.plan, question.grid, question.images
    sense = question.sense if question.rolls_by_last else 0.0
    links = plan.chain.links if question.measure else None
    there = images >= 0
    numbers = np.where(there, np.cumsum(there).reshape(images.shape) - 1, -1)
    solve = (numbers, own.sense, links, plan.chain.length, threads or os.cpu_count() or 1)
    bits, look, count, measures = reach(grid.centres(images[:, 0]), grid.turns, grid.rolls, sense, *solve)
    which = images[there]
    for voxel in np.flatnonzero(look.any(1)):
        turns = np.flatnonzero(np.unpackbits(look[voxel])[: len(grid.turns)])
        q, inside, hit, many = _directly(question, grid.poses(which[voxel : voxel + 1], grid.turns[turns]), 1)
        known = np.unpackbits(bits[voxel])
        known[turns] = hit
        bits[voxel] = np.packbits(known)
        count[voxel] += many.sum()
        measures[voxel] = _together(measures[voxel], _measures(question, q, inside, 1)[0])
    return Tile(bits, count, measures)


def _together(a: Array, b: Array) -> Array:
    """Return the measures of two sets of solutions as one's."""
    if not a.any() or not b.any():
        return a if a.any() else b
    return np.array([both(x, y) for both, x, y in zip(MEASURES.values(), a, b, strict=False)])


def _measures(question: Question, q: Array, inside: Bools, voxels: int) -> Array:
    """Return the measures (voxels, 6) of rows q (N, M, n), those inside the limits; (voxels, 0) where not asked for."""
    plan = question.plan
    if not question.measure:
        return np.zeros((voxels, 0))
    shape = posture_shapes(plan, q[inside])
    lower, upper = plan.limits.T
    limited = np.isfinite(lower) & np.isfinite(upper)
    half = np.where(limited, (upper - lower) / 2, 1.0)
    away = np.minimum(q[inside] - lower, upper - q[inside])
    share = np.where(limited, np.where(half > 0, away / np.where(half > 0, half, 1.0), 0.0), 1.0)
    values = {
        "manipulability": shape.manipulability,
        "margin": np.clip(share, 0.0, 1.0).min(-1),
        "negative": (shape.sign < 0).astype(np.float64),
        "positive": (shape.sign >= 0).astype(np.float64),
        "least_singular": shape.smallest,
        "most_singular": shape.smallest,
    }
    voxel = np.broadcast_to(np.arange(inside.size).reshape(inside.shape) // (inside.size // voxels), inside.shape)[
        inside
    ]
    out = np.zeros((voxels, len(MEASURES)))
    out[:, list(MEASURES).index("least_singular")] = np.inf
    for column, (name, both) in enumerate(MEASURES.items()):
        both.at(out[:, column], voxel, values[name])
    out[np.isinf(out)] = 0.0
    return out


def _rows(plan: Plan, T: Array, threads: int | None) -> tuple[Array, Bools, Bools, Bools]:
    """Return rows (N, M, n), which hold and which lie inside limits (N, M), which poses need a look of their own (N,).

    An arm that is its own six-joint chain is asked without the careful look that `ik_many` gives to poses out of reach,
    which most poses of a box are.
    """
    if plan.direct:
        q, valid, inside, flags = plan.solver.many(np.ascontiguousarray(T), threads or os.cpu_count() or 1)
        return q, valid, inside, (flags & _LOOK) > 0
    batch = verbs.ik_many(plan, T, threads)
    special = (batch.status == Status.SINGULAR) | (batch.status == Status.UNCERTAIN)
    return batch.q, batch.valid, batch.in_limits, special


def _directly(question: Question, T: Array, threads: int | None) -> tuple[Array, Bools, Bools, Indices]:
    """Return of poses (N, 4, 4) rows and which lie inside, which poses are reached (N,), by how many solutions (N,)."""
    q, _, inside, special = _rows(question.plan, T, threads)
    around = question.around
    if around is not None and inside.any():
        inside = inside.copy()
        inside[inside] = around.clear(q[inside])
    count = inside.sum(1)
    reached = count > 0
    # a self-motion may pass through the limits where none of its representatives lies there
    for i in np.flatnonzero(~reached & special):
        one = verbs.ik(question.plan, T[i])
        rows = one.q if around is None or not len(one.q) else one.q[around.clear(one.q)]
        count[i] = len(rows)
        reached[i] = len(rows) > 0 or any(_passes(motion, around) for motion in one.self_motions)
    return q, inside, reached, count


def _passes(motion: SelfMotion, around: Around | None) -> bool:
    """Return whether a self-motion lies inside the limits anywhere; with bodies, at one of the postures looked at."""
    if around is None or not motion.inside:
        return len(motion.inside) > 0
    u = np.concatenate([np.linspace(lo, hi, LOOKED_AT) for lo, hi in motion.inside])
    return bool(around.clear(np.stack([motion.at(value) for value in u])).any())


def reached_exactly(plan: Plan, T: Array, around: Around | None = None) -> Bools:
    """Return which poses (N, 4, 4) are reached inside the limits, each solved; clear of what is around, if anything."""
    alone = Question(plan, Grid(np.zeros(3), 1.0, (1, 1, 1), np.eye(3)[None], 1), False, around=around)
    return _directly(alone, T, None)[2] if len(T) else np.zeros(0, bool)


def shares(plan: Plan, T: Array, places: Array) -> Array:
    """Return the share (k,) of poses T (N, 4, 4) that is reached from each place (k, 4, 4) of the base."""
    return np.array([reached_exactly(plan, np.ascontiguousarray(inverse(B) @ T)).mean() for B in places])
