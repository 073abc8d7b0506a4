"""One tile of a map: some voxels, all orientations, solved completely; only bits and counts are kept."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from pieper.kinematics.arrays import Array, Bits, Bools, Indices
from pieper.kinematics.chain import Chain
from pieper.kinematics.pose import inverse
from pieper.maps.around import Around
from pieper.maps.grid import Grid
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


@dataclass(frozen=True, eq=False)
class Tile:
    """What is known of some voxels.

    Args:
        bits: (v, ceil(k / 8)) one bit an orientation: reached inside the limits.
        count: (v,) solutions inside the limits, all orientations together.
        manipulability: (v,) the best of them, sqrt(det(J J^T)); zeros where it was not asked for.
        margin: (v,) the best of them: the share of half a joint's range by which the nearest limit is away, 0 to 1.
    """

    bits: Bits
    count: Indices
    manipulability: Array
    margin: Array


@dataclass(frozen=True, eq=False)
class Question:
    """What a worker is told once: plain data that can be sent.

    Args:
        plan: How the arm is solved.
        grid: What is asked.
        rolls_by_last: Whether a roll of the tool is a turn of the last joint, so that one roll answers for all.
        sense: Which way it turns then.
        measure: Whether manipulability and margin are asked for.
        around: What solutions must keep clear of to count; None where nothing was said.
    """

    plan: Plan
    grid: Grid
    rolls_by_last: bool
    sense: float = 1.0
    measure: bool = False
    around: Around | None = None


def question_of(plan: Plan, grid: Grid, symmetry: str, measure: bool = False, around: Around | None = None) -> Question:
    """Return the question; symmetry is used where the arm has it, and `none` was not said.

    What the last joint carries is seldom round, so that with bodies each roll is a question of its own.
    """
    sense = last_joint_rolls(plan.chain) if plan.direct and around is None else 0.0
    use = symmetry == "auto" and grid.rolls > 1 and sense != 0.0
    return Question(plan, grid, use, sense or 1.0, measure, around)


def last_joint_rolls(chain: Chain) -> float:
    """Return 1 or -1 where the last joint turns the tool about its own z axis, by that sense; 0 where it does not."""
    if chain.prismatic[-1] or chain.coupling is not None:
        return 0.0
    link, nearly = chain.links[-1], GEOMETRY_EXACT
    on_axis = np.hypot(link[0, 3], link[1, 3]) <= nearly * chain.length
    return float(np.sign(link[2, 2])) if on_axis and np.hypot(link[0, 2], link[1, 2]) <= nearly else 0.0


def solved(question: Question, which: Indices, threads: int | None) -> Tile:
    """Return the tile of voxels by their numbers."""
    plan = question.plan
    if plan.direct and plan.solver.reach is not None and question.around is None:
        return _fused(question, plan.solver.reach, which, threads)
    grid = question.grid
    each = max(1, AT_ONCE // len(grid.turns))
    parts = []
    for first in range(0, len(which), each):
        some = which[first : first + each]
        q, inside, hit, many = _directly(question, grid.poses(some, grid.turns), threads)
        bits = np.packbits(hit.reshape(len(some), -1), axis=1)
        best, margin = _measures(question, q, inside, len(some))
        parts.append((bits, many.reshape(len(some), -1).sum(1), best, margin))
    bits, count, best, margin = (np.concatenate(part) for part in zip(*parts, strict=True))
    return Tile(bits, count.astype(np.int64), best, margin)


def _fused(question: Question, reach: Callable[..., Any], which: Indices, threads: int | None) -> Tile:
    """Return the tile as the kernel makes it, poses that want a look of their own looked at."""
    plan, grid = question.plan, question.grid
    sense = question.sense if question.rolls_by_last else 0.0
    links = plan.chain.links if question.measure else None
    bits, look, count, best, margin = reach(
        grid.centres(which), grid.turns, grid.rolls, sense, links, threads or os.cpu_count() or 1
    )
    voxels = np.flatnonzero(look.any(1))
    for voxel in voxels:
        turns = np.flatnonzero(np.unpackbits(look[voxel])[: len(grid.turns)])
        _, _, hit, many = _directly(question, grid.poses(which[voxel : voxel + 1], grid.turns[turns]), 1)
        known = np.unpackbits(bits[voxel])
        known[turns] = hit
        bits[voxel] = np.packbits(known)
        count[voxel] += many.sum()
    none = np.zeros(len(which))
    return Tile(bits, count, none if best is None else best, none if margin is None else margin)


def _measures(question: Question, q: Array, inside: Bools, voxels: int) -> tuple[Array, Array]:
    """Return the best manipulability and margin (voxels,) of rows q (N, M, n), those inside the limits."""
    plan = question.plan
    best, margin = np.zeros(inside.shape), np.zeros(inside.shape)
    if question.measure and inside.any():
        J = plan.chain.native.jacobian(np.ascontiguousarray(q[inside]))[:, : 3 if plan.task == "position" else 6]
        small = J @ np.swapaxes(J, 1, 2) if plan.n >= J.shape[1] else np.swapaxes(J, 1, 2) @ J
        best[inside] = np.sqrt(np.maximum(np.linalg.det(small), 0.0))
        lower, upper = plan.limits.T
        limited = np.isfinite(lower) & np.isfinite(upper)
        half = np.where(limited, (upper - lower) / 2, 1.0)
        away = np.minimum(q[inside] - lower, upper - q[inside])
        share = np.where(limited, np.where(half > 0, away / np.where(half > 0, half, 1.0), 0.0), 1.0)
        margin[inside] = np.clip(share, 0.0, 1.0).min(-1)
    return best.reshape(voxels, -1).max(1), margin.reshape(voxels, -1).max(1)


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
