"""Self-motions on which two joints about one line turn against one another, where a joint between has brought them so.

A pose that has a posture with the joint between exactly there holds a straight line of joint vectors: no slice along
another joint meets it, and a curve that crosses it passes in one point. So the joint is held there, one of the two at
zero, and the arm that is left, shorter by two, is solved for the pose.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable
from weakref import WeakKeyDictionary

import numpy as np

from pieper.errors import PlanError
from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.chain import Chain
from pieper.kinematics.joints import TURN
from pieper.kinematics.newton import missed, newton, scaled_jacobian, size_of
from pieper.solver.plan.holding import without
from pieper.solver.plan.plan import Plan
from pieper.solver.results import Solutions
from pieper.solver.singular.meetings import Meeting, all_put_in_line, meetings
from pieper.solver.singular.self_motion import SelfMotion
from pieper.tolerances import CLOSES, COAXIAL_HOLDS, ROUNDING, SAME_VOUCHED

#: Newton steps that take a row of the shorter arm to rounding, the line's own joints standing still.
STEPS = 6
#: Where, on the way to a point of a surface, it is asked whether the pose is held.
PLACES = np.array([0.21, 0.5, 0.77])


#: The shorter arms of each plan, as long as the plan is held.
_SHORTER: WeakKeyDictionary[Plan, tuple[tuple[Meeting, Plan], ...]] = WeakKeyDictionary()


def lines(plan: Plan, T: Array, one: Callable[[Plan, Array], Solutions]) -> list[tuple[Array, Array]]:
    """Return a point (n,) of each such line that a pose (4, 4) holds, and the line's direction (n,).

    Args:
        plan: A plan with redundancy.
        T: The pose.
        one: Solves one pose of an arm.
    """
    full = plan.exact.full
    out: list[tuple[Array, Array]] = []
    if full.coupling is not None:
        return out
    for at, shorter in _shorter(plan):
        joints = at.between, at.between + 1
        way = _way(full, at)
        rest = shorter.exact.full
        kept = [j for j in range(full.n) if j not in joints]
        for row in _points(one(shorter, T)):
            q = np.zeros(full.n)
            q[kept], q[at.between] = newton(rest, row, T, steps=STEPS), at.value
            if missed(full, q, T) < COAXIAL_HOLDS * size_of(full, T):
                out.append((q, way))
    return out


def lines_through(chain: Chain, T: Array, rows: Array) -> list[tuple[Array, Array]]:
    """Return the same of rows (m, n) that all but stand on such a line.

    Where solutions merge several times over, what solves the shorter arm may not know that it is there.
    """
    out: list[tuple[Array, Array]] = []
    for at in meetings(chain):
        put, there = all_put_in_line(chain, at, rows, T)
        put = put[there]
        out += [(q, _way(chain, at)) for q in put[missed(chain, put, T) < COAXIAL_HOLDS * size_of(chain, T)]]
    return out


def _way(chain: Chain, at: Meeting) -> Array:
    """Return the direction (n,) of the line where two joints turn against one another."""
    way = np.zeros(chain.n)
    way[[at.between - 1, at.between + 1]] = np.sqrt(0.5), -at.sense * np.sqrt(0.5)
    return way


def _shorter(plan: Plan) -> tuple[tuple[Meeting, Plan], ...]:
    """Return where joints come into one line, and the arms that are left with the joint between held there."""
    if plan not in _SHORTER:
        found: list[tuple[Meeting, Plan]] = []
        for at in meetings(plan.exact.full):
            try:
                found.append((at, without(plan, (at.between, at.between + 1), (at.value, 0.0))))
            except PlanError:
                continue  # what is left reaches nothing by itself
        _SHORTER[plan] = tuple(found)
    return _SHORTER[plan]


def _points(found: Solutions) -> Array:
    """Return the solutions (m, k) of a pose, a point of each of its self-motions among them."""
    points = [motion.full_representative[None] for motion in found.self_motions]
    return np.concatenate([found.all_q, *points])


def joined(motion: SelfMotion, seeds: Array) -> Bools:
    """Return which of the seeds (m, n) lie where a surface's joints about one line lead from its first sample.

    What turns about axes in one line is a plane in joint space. Where solutions merge on it, seeds lie beside it.
    """
    return within_plane(motion, seeds)[1]


def within_plane(motion: SelfMotion, seeds: Array) -> tuple[Array, Bools]:
    """Return seeds (m, n) moved into the plane of a surface's first sample, and which lie there and hold the pose."""
    out = np.zeros(len(seeds), bool)
    if motion.dimension < 2 or not len(seeds):
        return seeds, out
    chain, start = motion.chain, motion.samples[0]
    ways_there = plane(chain, start)
    turning = np.flatnonzero(np.abs(ways_there).max(0, initial=0.0))
    turns = np.zeros((3 ** len(turning), chain.n))
    turns[:, turning] = list(itertools.product((0.0, -TURN, TURN), repeat=len(turning)))
    ways = chain.joints.difference(seeds, start)[:, None] + turns
    along = (ways @ ways_there.T) @ ways_there
    across = np.linalg.norm(ways - along, axis=-1)
    best = np.argmin(across, axis=1)
    near = np.flatnonzero(across[np.arange(len(seeds)), best] < SAME_VOUCHED)
    moved = start + along[np.arange(len(seeds)), best]
    between = start + PLACES[:, None, None] * (moved[near] - start)
    beside = moved[near] + (ways[near, best[near]] - along[near, best[near]]) / 2
    out[near] = (missed(chain, np.concatenate([between, beside[None]]), motion.T) < CLOSES).all(0)
    return moved, out


def plane(chain: Chain, q: Array) -> Array:
    """Return orthonormal ways (k, n) in which turning joints about one line turn against each other at q (n,)."""
    columns = scaled_jacobian(chain, q).T
    ways = np.zeros((0, chain.n))
    left = [int(j) for j in np.flatnonzero(~chain.prismatic)]
    while left:
        first, *others = left
        same = {j: s for j in others for s in (1.0, -1.0) if np.linalg.norm(columns[j] - s * columns[first]) < ROUNDING}
        for j, sense in same.items():
            way = np.zeros((1, chain.n))
            way[0, first], way[0, j] = 1.0, -sense
            ways = np.concatenate([ways, way])
        left = [j for j in others if j not in same]
    return np.linalg.qr(ways.T)[0].T
