"""The posture inside the limits that comes nearest to a pose the arm cannot take: position first, then orientation."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from pieper import arguments
from pieper.errors import InputError
from pieper.kinematics.arrays import Array, ArrayLike, Indices
from pieper.kinematics.bounded import nearer
from pieper.kinematics.chain import Chain
from pieper.kinematics.forward import fk
from pieper.kinematics.newton import scaled_jacobian, settled, shortest
from pieper.solver.plan.plan import Plan
from pieper.solver.plan.six_joints import sample_joints, with_task_joints
from pieper.solver.redundant.box import descended
from pieper.solver.results import Closest, Solutions
from pieper.tolerances import (
    ALIKE_NEAR,
    ALIKE_PLACE,
    ALIKE_TURN,
    CLOSEST_BACK,
    CLOSEST_STAGES,
    NEWTON_DONE,
    PULLED_RANK,
    REACHED_PLACE,
    SAME_DESCENT,
)

#: Postures looked at first; the best of them are where descents begin. The answer bounds the distance from above.
LOOKED_AT = 512
#: As many begin for the pose, and for the position alone; beside the best as many more, spread evenly over all.
STARTS, SPREAD = 20, 8
#: So many more, and their steps, where the position is not reached and fewer than this part agree how near it is.
MORE, FEW_STEPS, AGREED = 128, 5, 0.75
#: Postures at the best position that keep to it until the end, whatever the orientation would have.
KEPT_IN_PLACE = 6
#: The best of all that are led away from the position and back.
LED_BACK = 2
#: As many that may be alike are looked at for one that is kept.
ALIKE = 3
#: Steps onto the position alone, from where a turn counted next to nothing.
LAST_STEPS = 8


def closest_to(plan: Plan, sols: Solutions) -> Closest:
    """Return the posture that comes nearest to the pose of some solutions; the first of them where there are any."""
    if len(sols.q):
        metres, radians = sols.residual[0]
        return Closest(sols.q[0], float(metres), float(radians), fk(plan.chain, sols.q[0]))
    seeds = np.clip(sols.all_q, plan.limits[:, 0], plan.limits[:, 1])
    return closest(plan, sols.T, seeds=seeds)


def closest(plan: Plan, T: Array, *, weights: ArrayLike | None = None, seeds: Array | None = None) -> Closest:
    """Return the posture inside the limits that comes nearest to a pose, by what the task asks for.

    Newton's method from many postures, joints held at the limits they meet. Some weigh orientation at first and less
    and less of it; others go for the position alone, and those that come nearest keep their place to the end.

    Args:
        plan: How the arm is solved, and for which task.
        T: (4, 4).
        weights: (2,) what a metre and a radian count, whose squares are added up; None for position first, to rounding,
            and then orientation.
        seeds: (k, n) further postures to begin at.

    Raises:
        InputError: The weights are not two finite numbers, or negative, or both zero.
    """
    turning = plan.task != "position"
    chain = plan.exact.full if turning else plan.chain
    hill = _Hill(chain, plan.full_limits if turning else plan.limits, T)
    given = np.empty((0, plan.n)) if seeds is None else seeds
    given = np.pad(given, ((0, 0), (0, chain.n - plan.n)))
    if weights is not None:
        by = _weighed(plan, weights)
        q, left = hill.down(np.vstack([hill.starts(by), given]), by, sum(steps for _, steps, _ in CLOSEST_STAGES))
        q = q[np.argsort(left)[:1]]
    else:
        q = _at_place(hill, given)
        q = hill.onto_place(_turned(hill, given, q) if turning else q)
        if turning:
            q = np.vstack([q, hill.onto_place(_turned_back(hill, q))])
    value, angle = hill.distances(q)
    alike = np.flatnonzero(value <= value.min() + ALIKE_NEAR)
    own = q[alike[np.argmin(angle[alike])] if turning else np.argmin(value), : plan.n]
    miss = plan.residual(own, T)
    return Closest(own, float(miss[0]), float(miss[1]), fk(plan.chain, own))


def _weighed(plan: Plan, weights: ArrayLike) -> float:
    """Return what a turn counts beside a length of the arm; infinite for turns alone."""
    try:
        given = np.asarray(weights, float)
    except (TypeError, ValueError):
        given = np.zeros(0)
    if given.shape != (2,) or not np.isfinite(given).all() or (given < 0).any() or not given.any():
        raise InputError(
            f"weights must be two numbers of at least 0, not both 0: what a metre and a radian count; got "
            f"{arguments.kind_of(weights)}.",
            given=weights,
        )
    metre, radian = float(given[0]) * plan.chain.length, float(given[1]) * (plan.task != "position")
    return (radian / metre) ** 2 if metre else np.inf


@dataclass(frozen=True, slots=True)
class _Hill:
    """What is descended: how far a chain is from a pose (4, 4) inside limits (n, 2)."""

    chain: Chain
    limits: Array
    T: Array

    def starts(self, turn: float, spread: int = 0) -> Array:
        """Return postures (k, n) that are good where a turn counts so much, and some spread evenly over the others."""
        q, there = _looked_at(self.chain, self.limits.tobytes())
        order = np.argsort(_cost(*_distances(self.chain, there, self.T), turn), kind="stable")
        others = order[STARTS :: max((LOOKED_AT - STARTS) // spread, 1)][:spread] if spread else order[:0]
        return q[np.concatenate([order[:STARTS], others])]

    def otherwise(self, count: int) -> Array:
        """Return where Gauss's and Newton's steps to the position lead from postures (count, n) spread evenly.

        They crawl where a position is out of reach, but come into narrower valleys than steps of second order.
        """
        free, limits = _of_any_turn(self.chain, self.limits.tobytes())
        q = _looked_at(free, limits.tobytes())[0][:count]
        poses = np.broadcast_to(self.T, (count, 4, 4))
        return descended(free, q, poses, *limits.T)[0][:, : self.chain.n]

    def down(self, q: Array, turn: float, steps: int) -> tuple[Array, Array]:
        """Return where descents from q (k, n) lead, and what is left (k,)."""
        return nearer(self.chain, q, self.T, self.limits, np.full(len(q), turn), steps)

    def distances(self, q: Array) -> tuple[Array, Array]:
        """Return how far postures (k, n) are from the pose (k,), per length, and how far turned (k,), rad."""
        return _distances(self.chain, self.chain.native.fk(q), self.T)

    def best(self, q: Array, turn: float, count: int) -> Array:
        """Return the nearest of q (k, n) where a turn counts so much, of postures that are alike the first."""
        q = q[np.argsort(_cost(*self.distances(q), turn), kind="stable")[: ALIKE * count]]
        gap = np.abs(q[:, None] - q) / self.chain.joints.unit
        again = np.tril(gap.max(-1) < SAME_DESCENT, -1).any(1)
        return q[~again][:count]

    def onto_place(self, q: Array) -> Array:
        """Return postures (k, n) moved to where the position is met to rounding, or missed least."""
        q, _ = self.down(q, 0.0, LAST_STEPS)
        value, _ = self.distances(q)
        some = np.flatnonzero((value > NEWTON_DONE) & (value < ALIKE_TURN))
        if not len(some):
            return q
        start, (lower, upper) = q[some], self.limits.T
        held = (start <= lower) | (start >= upper)

        def miss(at: Array, _index: Indices) -> Array:
            return (self.T[:3, 3] - self.chain.native.fk(at)[:, :3, 3]) / self.chain.length

        def slope(at: Array, index: Indices) -> Array:
            return np.where(held[index, None], 0.0, scaled_jacobian(self.chain, at)[:, :3])

        unit, step = self.chain.joints.unit, shortest(PULLED_RANK)
        exact, _ = settled(miss, slope, start, unit, steps=LAST_STEPS, longest=ALIKE_TURN, step=step)
        exact = np.clip(exact, lower, upper)
        better = self.distances(exact)[0] < value[some]
        q[some[better]] = exact[better]
        return q


def _cost(value: Array, angle: Array, turn: float) -> Array:
    return value**2 / 2 + turn * (1 - np.cos(angle)) if np.isfinite(turn) else angle


def _at_place(hill: _Hill, given: Array) -> Array:
    """Return postures (k, n) whose position is nearest of all that are found."""
    _, steps, keep = CLOSEST_STAGES[0]
    starts = hill.starts(0.0, SPREAD)
    q, left = hill.down(np.vstack([starts[::2], given]), 0.0, steps)
    if np.sum(left < REACHED_PLACE) < KEPT_IN_PLACE:
        others, more = hill.down(starts[1::2], 0.0, steps)
        q, left = np.vstack([q, others]), np.concatenate([left, more])
    way: Array = np.sqrt(2 * left)
    agree = np.count_nonzero(way < way.min() + ALIKE_PLACE) / len(way)
    q = hill.best(q, 0.0, keep)
    if left.min() > REACHED_PLACE and agree < AGREED and hill.chain.coupling is None:
        # nearer than nought there is none; of a position out of reach the nearest place may draw few descents
        q = np.vstack([q, hill.best(hill.down(hill.otherwise(MORE), 0.0, FEW_STEPS)[0], 0.0, keep)])
    return hill.down(q, 0.0, 2 * steps)[0]


def _turned(hill: _Hill, given: Array, at_place: Array) -> Array:
    """Return postures (k, n), the best by orientation that are found at the nearest position among them."""
    (turn, steps, keep), *later = CLOSEST_STAGES
    least = later[-1][0]
    q, _ = hill.down(np.vstack([hill.starts(turn), given]), turn, steps)
    q = np.vstack([hill.best(q, later[0][0], keep), at_place])
    in_place = hill.best(at_place, least, KEPT_IN_PLACE)
    for turn, steps, keep in later:
        q = hill.best(hill.down(q, turn, steps)[0], least, keep)
        # where a turn counts for more, what is in the best place may be drawn to another
        if turn == later[0][0]:
            q = np.vstack([q, in_place])
    return np.vstack([q, hill.best(at_place, 0.0, 1)])


def _turned_back(hill: _Hill, q: Array) -> Array:
    """Return the best of postures (k, n) led away from the position a little and back, as orientation would have it.

    Along a curved valley between limits a descent may take hundreds of steps; from where it is wider it takes few.
    """
    q = hill.best(q, CLOSEST_STAGES[-1][0], LED_BACK)
    for turn, steps in CLOSEST_BACK:
        q, _ = hill.down(q, turn, steps)
    return q


def _distances(chain: Chain, there: Array, T: Array) -> tuple[Array, Array]:
    """Return how far tools (k, 4, 4) are from the pose (k,), per length, and how far turned (k,), rad."""
    gap = there - T
    # of two rotations the chord is 2 sqrt(2) times the sine of half the angle
    chord = np.einsum("kij,kij->k", gap[:, :3, :3], gap[:, :3, :3])
    way = np.sqrt(np.einsum("ki,ki->k", gap[:, :3, 3], gap[:, :3, 3]))
    return way / chain.length, 2 * np.arcsin(np.sqrt(np.minimum(chord / 8, 1.0)))


@lru_cache(maxsize=64)
def _of_any_turn(chain: Chain, limited: bytes) -> tuple[Chain, Array]:
    """Return a chain with three more turns at its tool, so that the position alone counts, and limits (n + 3, 2)."""
    limits = np.vstack([np.frombuffer(limited).reshape(-1, 2), np.tile([-np.inf, np.inf], (3, 1))])
    return with_task_joints(chain, "position"), limits


@lru_cache(maxsize=64)
def _looked_at(chain: Chain, limited: bytes) -> tuple[Array, Array]:
    """Return postures (k, n) spread evenly over the limits, else over a turn, or two lengths; and their poses."""
    limits = np.frombuffer(limited).reshape(-1, 2)
    reach = np.where(chain.prismatic, chain.length, np.pi)
    low, high = np.isfinite(limits[:, 0]), np.isfinite(limits[:, 1])
    lower = np.where(low, limits[:, 0], np.where(high, limits[:, 1] - 2 * reach, -reach))
    upper = np.where(high, limits[:, 1], lower + 2 * reach)
    q = lower + (upper - lower) * (sample_joints(chain, LOOKED_AT, seed=5) / reach + 1) / 2
    return q, chain.native.fk(q)
