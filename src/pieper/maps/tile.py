"""One tile of a map: some voxels, all orientations, solved completely; only bits and counts are kept."""

from __future__ import annotations

import os
from dataclasses import dataclass

import numpy as np

from pieper.kinematics.arrays import Array, Bits, Bools, Indices
from pieper.kinematics.chain import Chain
from pieper.kinematics.joints import TURN, JointSpace, wrapped
from pieper.kinematics.pose import inverse, rotation_z
from pieper.maps.grid import Grid
from pieper.solver import verbs
from pieper.solver.plan.plan import Plan
from pieper.solver.results import Status
from pieper.solver.rows import Flag
from pieper.tolerances import GEOMETRY_EXACT

#: Poses that are solved at once: what is held in memory, whatever the tile's size.
AT_ONCE = 32_768
#: One turning joint alone.
LAST = JointSpace(np.zeros(1, np.bool_), 1.0)
_LOOK = int(Flag.DEGENERATE | Flag.UNCERTAIN)


@dataclass(frozen=True, eq=False)
class Tile:
    """What is known of some voxels.

    Args:
        bits: (v, ceil(k / 8)) one bit an orientation: reached inside the limits.
        count: (v,) solutions inside the limits, all orientations together.
    """

    bits: Bits
    count: Indices


@dataclass(frozen=True, eq=False)
class Question:
    """What a worker is told once: plain data that can be sent.

    Args:
        plan: How the arm is solved.
        grid: What is asked.
        rolls_by_last: Whether a roll of the tool is a turn of the last joint, so that one roll answers for all.
        sense: Which way it turns then.
    """

    plan: Plan
    grid: Grid
    rolls_by_last: bool
    sense: float = 1.0


def question_of(plan: Plan, grid: Grid, symmetry: str) -> Question:
    """Return the question; symmetry is used where the arm has it, and `none` was not said."""
    sense = last_joint_rolls(plan.chain) if plan.direct else 0.0
    use = symmetry == "auto" and grid.rolls > 1 and sense != 0.0
    return Question(plan, grid, use, sense or 1.0)


def last_joint_rolls(chain: Chain) -> float:
    """Return 1 or -1 where the last joint turns the tool about its own z axis, by that sense; 0 where it does not."""
    if chain.prismatic[-1] or chain.coupling is not None:
        return 0.0
    link, nearly = chain.links[-1], GEOMETRY_EXACT
    on_axis = np.hypot(link[0, 3], link[1, 3]) <= nearly * chain.length
    return float(np.sign(link[2, 2])) if on_axis and np.hypot(link[0, 2], link[1, 2]) <= nearly else 0.0


def solved(question: Question, which: Indices, threads: int | None) -> Tile:
    """Return the tile of voxels by their numbers."""
    grid = question.grid
    ask = grid.turns[:: grid.rolls] if question.rolls_by_last else grid.turns
    each = max(1, AT_ONCE // len(ask))
    reached, count = [], []
    for first in range(0, len(which), each):
        some = which[first : first + each]
        answer = _by_last_joint if question.rolls_by_last else _directly
        hit, many = answer(question, grid.poses(some, ask), threads)
        reached.append(hit.reshape(len(some), -1))
        count.append(many.reshape(len(some), -1).sum(1))
    return Tile(np.packbits(np.concatenate(reached), axis=1), np.concatenate(count).astype(np.int64))


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


def _directly(question: Question, T: Array, threads: int | None) -> tuple[Bools, Indices]:
    """Return of poses (N, 4, 4) which are reached inside the limits (N,), and by how many solutions (N,)."""
    _, _, inside, special = _rows(question.plan, T, threads)
    count = inside.sum(1)
    reached = count > 0
    # a self-motion may pass through the limits where none of its representatives lies there
    for i in np.flatnonzero(~reached & special):
        one = verbs.ik(question.plan, T[i])
        count[i] = len(one.q)
        reached[i] = len(one.q) > 0 or any(len(motion.inside) for motion in one.self_motions)
    return reached, count


def _by_last_joint(question: Question, T: Array, threads: int | None) -> tuple[Bools, Indices]:
    """Return the same of all rolls (N * rolls,) from one roll a direction: the last joint turns along, limits kept."""
    plan, rolls = question.plan, question.grid.rolls
    q, valid, _, special = _rows(plan, T, threads)
    joints = plan.chain.joints
    others = plan.limits.copy()
    others[-1] = -np.inf, np.inf
    _, inside = joints.inside_limits(q, others)
    inside &= valid
    lower, upper = plan.limits[-1]
    if upper - lower >= TURN:
        count = np.repeat(inside.sum(1)[:, None], rolls, axis=1)
    else:
        turn = question.sense * TURN * np.arange(rolls) / rolls
        last = wrapped(q[:, None, :, -1] + turn[:, None])[..., None]
        _, ok = LAST.inside_limits(last, plan.limits[-1:])
        count = (ok & inside[:, None]).sum(2)
    reached = count > 0
    which = np.flatnonzero(special)
    if len(which):
        rolled = T[which][:, None] @ rotation_z(TURN * np.arange(rolls) / rolls)
        hit, many = _directly(question, rolled.reshape(-1, 4, 4), threads)
        reached[which], count[which] = hit.reshape(-1, rolls), many.reshape(-1, rolls)
    return reached.reshape(-1), count.reshape(-1)


def reached_exactly(plan: Plan, T: Array) -> Bools:
    """Return which poses (N, 4, 4) are reached inside the limits, each solved."""
    alone = Question(plan, Grid(np.zeros(3), 1.0, (1, 1, 1), np.eye(3)[None], 1), False)
    return _directly(alone, T, None)[0] if len(T) else np.zeros(0, bool)


def shares(plan: Plan, T: Array, places: Array) -> Array:
    """Return the share (k,) of poses T (N, 4, 4) that is reached from each place (k, 4, 4) of the base."""
    return np.array([reached_exactly(plan, np.ascontiguousarray(inverse(B) @ T)).mean() for B in places])
