"""The posture inside the limits that comes nearest to a pose the arm cannot take: position first, then orientation."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np

from pieper import _kernel, arguments
from pieper.errors import InputError
from pieper.kinematics.arrays import Array, ArrayLike, Indices
from pieper.kinematics.bounded import as_axes, by_axes, nearer
from pieper.kinematics.chain import Chain
from pieper.kinematics.forward import fk
from pieper.kinematics.newton import pose_difference, scaled_jacobian, settled, shortest
from pieper.solver.kernel_rows import kernel_rows
from pieper.solver.plan.plan import Plan
from pieper.solver.plan.six_joints import sample_joints
from pieper.solver.results import Closest, Solutions
from pieper.tolerances import (
    ALIKE_NEAR,
    ALIKE_PLACE,
    ALIKE_TURN,
    CLOSEST_BACK,
    CLOSEST_CRAWL,
    CLOSEST_STAGES,
    COUNTED_IN_RADIANS,
    HALF_A_TURN,
    LAST_BITS,
    MOST_OPEN,
    MOST_TYPED,
    NEWTON_DONE,
    PULLED_RANK,
    REACHED_PLACE,
    SAME_DESCENT,
    TINY,
    TURN_FOR_PLACE,
)

#: Arms of fewer joints are short: none of their solutions is known where a pose has none.
JOINTS = 6
#: Postures looked at first; the best of them are where descents begin. The answer bounds the distance from above.
LOOKED_AT = 512
#: As many begin for the position alone, beside the best as many more, spread evenly over all; and for the pose.
STARTS, SPREAD, TURNED = 20, 8, 8
#: For the pose of a short arm: a pose that was made with it may lie in any narrow valley.
TURNED_SHORT = 128
#: Where the position is not reached and fewer than this part agree how near it is, so many more crawl towards it so
#: many steps; of them so many go on with steps of second order.
MORE, MORE_STEPS, MORE_KEPT, FEW_STEPS, AGREED = 128, 8, 64, 5, 0.75
#: Postures at the best position that keep to it until the end, whatever the orientation would have.
KEPT_IN_PLACE = 6
#: The best of all that are led away from the position and back.
LED_BACK = 2
#: As many that may be alike are looked at for one that is kept.
ALIKE = 3
#: Steps onto the position alone, from where a turn counted next to nothing.
LAST_STEPS = 8
#: Most steps until the best of all rests, for each weight of a turn.
REST_STEPS = 200
#: Weights of a turn's chord that are tried until it counts as its angle does.
IN_RADIANS = 40
#: The postures looked at of each plan and their poses, as long as the plan is held.
_LOOKED_AT: WeakKeyDictionary[Plan, tuple[Array, Array]] = WeakKeyDictionary()


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
        weights: (2,) what a metre and a radian count, times what is missed of each, squared and added up; None for
            position first, to rounding, and then orientation.
        seeds: (k, n) further postures to begin at.

    Raises:
        InputError: The weights are not two finite numbers, or negative, or both zero.
    """
    turning = plan.task != "position"
    chain = plan.exact.full if turning else plan.chain
    limits = plan.full_limits if turning else plan.limits
    if plan not in _LOOKED_AT:
        _LOOKED_AT[plan] = _looked_at(chain, limits)
    hill = _Hill(chain, limits, T, *_LOOKED_AT[plan])
    seeds = np.vstack([_almost(plan, T), np.zeros((0, plan.n)) if seeds is None else seeds])
    given = np.zeros((len(seeds), chain.n))
    given[:, : plan.n] = seeds
    if weights is not None:
        by = _weighed(weights, chain.length, turning)
        start = np.vstack([hill.starts(by), given])
        q = hill.in_radians(start, by)
        q = q[np.argmin(_cost(*hill.distances(q), by))][None]
        value, angle = hill.distances(q)
    else:
        q, value, angle = hill.onto_place(hill.found(given, turning))
        if turning and angle.min() > ALIKE_TURN:
            # along what the position leaves free a turn may fall so slowly that few steps end before its least
            best = _nearest_of(value, angle)
            q, value, angle = hill.onto_place(np.vstack([q, hill.at_rest(q[best : best + 1])]))
    if weights is None and turning and value.min() < ALIKE_NEAR and angle.min() < ALIKE_TURN:
        # where two postures are about to be one, what rounding lets the position be leaves the turn open by its root
        near = q[(value < ALIKE_NEAR) & (angle < ALIKE_TURN)]
        q = np.vstack([q, hill.onto_pose(near)])
        value, angle = hill.distances(q)
    own = q[_nearest_of(value, angle, typed(T)[1] / chain.length) if turning else np.argmin(value), : plan.n]
    miss = plan.residual(own, T)
    return Closest(own, float(miss[0]), float(miss[1]), fk(plan.chain, own))


def _almost(plan: Plan, T: Array) -> Array:
    """Return postures (k, n) inside the limits from which a short arm misses the pose by little, as by typed decimals.

    It is solved as an arm of six joints, of which those that it has not must stay at zero: here nearly. Of coupled
    joints the axes are solved so.
    """
    solved = plan if plan.uncoupled is None else plan.uncoupled
    if not solved.reduction.fill or solved.redundancy:
        return np.zeros((0, plan.n))
    found = kernel_rows(solved, T[None], np.zeros((1, 0)), 1)
    q = found.q[found.valid][:, : solved.n]
    if plan.uncoupled is not None:
        q = plan.chain.joints.wrapped(plan.chain.numbers(q))
    return np.clip(plan.chain.joints.inside_limits(q, plan.limits)[0], plan.limits[:, 0], plan.limits[:, 1])


def typed(T: Array) -> tuple[int, float]:
    """Return the decimals (m) a position was typed with, a pose's (4, 4), and by how much (m) they leave it open."""
    place = T[:3, 3]
    for digits in range(MOST_TYPED):
        if np.abs(np.round(place, digits) - place).max() <= LAST_BITS * np.abs(place).max():
            return digits, float(np.sqrt(3.0) / 2 * 10.0**-digits)
    return MOST_TYPED, 0.0


def _nearest_of(value: Array, angle: Array, open_by: float = 0.0) -> int:
    """Return which posture is turned least of those that come nearest, to rounding.

    Typed decimals leave a position open by something; within that a turn that is far less is worth a place that is
    missed: rounding must not decide that the arm stands the other way round.
    """
    alike = np.flatnonzero(value <= value.min() + ALIKE_NEAR)
    nearest = int(alike[np.argmin(angle[alike])])
    loss, gain = value - value[nearest], angle[nearest] - angle
    worth = (value <= min(open_by, MOST_OPEN)) & (gain > TURN_FOR_PLACE * loss)
    return int(np.argmin(np.where(worth, angle, np.inf))) if worth.any() else nearest


def _weighed(weights: ArrayLike, length: float, turning: bool) -> float:
    """Return what a turn counts beside the length of the chain that is moved; infinite for turns alone."""
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
    metre, radian = float(given[0]) * length, float(given[1]) * turning
    return (radian / metre) ** 2 if metre else np.inf


@dataclass(frozen=True, slots=True)
class _Hill:
    """What is descended: how far a chain is from a pose (4, 4) inside limits (n, 2), and postures to begin from."""

    chain: Chain
    limits: Array
    T: Array
    looked: Array
    there: Array

    def starts(self, turn: float) -> Array:
        """Return postures (k, n) that are good where a turn counts so much."""
        order = np.argsort(_cost(*_distances(self.chain, self.there, self.T), turn), kind="stable")
        if self.chain.n >= JOINTS or not np.isfinite(turn):
            return self.looked[order[:STARTS]]
        weight, steps, _ = CLOSEST_STAGES[0]
        some = self.looked[order[:TURNED_SHORT]]
        down = nearer(self.chain, some, self.T, self.limits, np.full(len(some), weight * turn), steps)[0]
        return down[np.argsort(_cost(*self.distances(down), turn), kind="stable")[:STARTS]]

    def in_radians(self, q: Array, turn: float) -> Array:
        """Return postures (k, n) that are least, each near by, where a turn counts so much: as the square of its angle.

        Descents are of twice the square of the sine of half the angle, smooth at half a turn. Its slope is the other's
        where it counts angle / sin(angle) times as much. The more it counts the smaller the angle is that is left, and
        so the smaller that factor, which is why there is one such weight, and it lies between two.
        """
        steps = sum(steps for _, steps, _ in CLOSEST_STAGES)

        def least(q: Array, counts: Array) -> tuple[Array, Array]:
            q = nearer(self.chain, q, self.T, self.limits, counts, steps)[0]
            angle = self.distances(q)[1]
            return q, turn / np.maximum(np.sinc(angle / np.pi), HALF_A_TURN) - counts

        low = np.full(len(q), turn)
        if turn == 0 or not np.isfinite(turn):
            return nearer(self.chain, q, self.T, self.limits, low, steps)[0]
        q, over = least(q, low)
        high, under = low + over, np.full(len(q), -np.inf)
        for step in range(IN_RADIANS):
            # the first time at the upper end; then where the line between the two crosses zero, or in the middle
            line = low + (high - low) * over / np.maximum(over - under, TINY) if step % 3 else (low + high) / 2
            at = high if step == 0 else line
            q, more = least(q, at)
            above = more > 0
            low, over = np.where(above, at, low), np.where(above, more, over)
            high, under = np.where(above, high, at), np.where(above, under, more)
            if np.all(np.abs(more) <= COUNTED_IN_RADIANS * turn):
                break
        return q

    def found(self, given: Array, turning: bool) -> Array:
        """Return postures (k, n) of which one comes nearest, its position to a few steps; `given` (m, n) begin too."""
        coupling, limits = by_axes(self.chain, self.limits)
        return _kernel.closest(
            self.chain.plain,
            coupling=coupling,
            lower=limits[:, 0],
            upper=limits[:, 1],
            q=as_axes(self.chain, self.looked),
            poses=self.there,
            seeds=as_axes(self.chain, given),
            T=self.T,
            turning=turning,
            stages=CLOSEST_STAGES,
            back=CLOSEST_BACK,
            starts=STARTS,
            spread=SPREAD,
            turned=TURNED_SHORT if self.chain.n < JOINTS else TURNED,
            more=MORE,
            more_kept=MORE_KEPT,
            few_steps=FEW_STEPS,
            in_place=KEPT_IN_PLACE,
            led_back=LED_BACK,
            alike=ALIKE,
            last_steps=LAST_STEPS,
            near=(REACHED_PLACE, ALIKE_PLACE, AGREED, SAME_DESCENT),
            crawl=(MORE_STEPS, *CLOSEST_CRAWL, REACHED_PLACE),
        )[:, : self.chain.n]

    def at_rest(self, q: Array) -> Array:
        """Return postures (k, n) from which steps that weigh orientation less and less lead no further."""
        for weight, _, _ in CLOSEST_BACK:
            q = nearer(self.chain, q, self.T, self.limits, np.full(len(q), weight), REST_STEPS)[0]
        return q

    def distances(self, q: Array) -> tuple[Array, Array]:
        """Return how far postures (k, n) are from the pose (k,), per length, and how far turned (k,), rad."""
        return _distances(self.chain, self.chain.native.fk(q), self.T)

    def onto_place(self, q: Array) -> tuple[Array, Array, Array]:
        """Return postures (k, n) moved to where the position is met to rounding, and their `distances`."""
        value, angle = self.distances(q)
        some = np.flatnonzero((value > NEWTON_DONE) & (value < ALIKE_TURN))
        if not len(some):
            return q, value, angle
        start, (lower, upper) = q[some], self.limits.T
        held = (start <= lower) | (start >= upper)

        def miss(at: Array, _index: Indices) -> Array:
            return (self.T[:3, 3] - self.chain.native.fk(at)[:, :3, 3]) / self.chain.length

        def slope(at: Array, index: Indices) -> Array:
            return np.where(held[index, None], 0.0, scaled_jacobian(self.chain, at)[:, :3])

        exact = np.clip(self._newton(miss, slope, start), lower, upper)
        better = self.distances(exact)[0] < value[some]
        q[some[better]] = exact[better]
        return q, *self.distances(q)

    def onto_pose(self, q: Array) -> Array:
        """Return postures (k, n) moved to where what is missed of the whole pose is least."""
        lower, upper = self.limits.T
        held = (q <= lower) | (q >= upper)

        def miss(at: Array, _index: Indices) -> Array:
            return pose_difference(self.chain, at, self.T)

        def slope(at: Array, index: Indices) -> Array:
            return np.where(held[index, None], 0.0, scaled_jacobian(self.chain, at))

        return np.clip(self._newton(miss, slope, q), lower, upper)

    def _newton(
        self, miss: Callable[[Array, Indices], Array], slope: Callable[[Array, Indices], Array], q: Array
    ) -> Array:
        unit, step = self.chain.joints.unit, shortest(PULLED_RANK)
        return settled(miss, slope, q, unit, steps=LAST_STEPS, longest=ALIKE_TURN, step=step)[0]


def _cost(value: Array, angle: Array, turn: float) -> Array:
    return value**2 + turn * angle**2 if np.isfinite(turn) else angle


def _distances(chain: Chain, there: Array, T: Array) -> tuple[Array, Array]:
    """Return how far tools (k, 4, 4) are from the pose (k,), per length, and how far turned (k,), rad."""
    gap = there - T
    # of two rotations the chord is 2 sqrt(2) times the sine of half the angle
    chord = np.einsum("kij,kij->k", gap[:, :3, :3], gap[:, :3, :3])
    way = np.sqrt(np.einsum("ki,ki->k", gap[:, :3, 3], gap[:, :3, 3]))
    return way / chain.length, 2 * np.arcsin(np.sqrt(np.minimum(chord / 8, 1.0)))


def _looked_at(chain: Chain, limits: Array) -> tuple[Array, Array]:
    """Return postures (k, n) spread evenly over the limits, else over a turn, or two lengths; and their poses."""
    reach = np.where(chain.prismatic, chain.length, np.pi)
    low, high = np.isfinite(limits[:, 0]), np.isfinite(limits[:, 1])
    lower = np.where(low, limits[:, 0], np.where(high, limits[:, 1] - 2 * reach, -reach))
    upper = np.where(high, limits[:, 1], lower + 2 * reach)
    q = lower + (upper - lower) * (sample_joints(chain, LOOKED_AT, seed=5) / reach + 1) / 2
    return q, chain.native.fk(q)
