"""The posture inside the limits that comes nearest to a pose the arm cannot take: position first, then orientation."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from pieper import arguments
from pieper.errors import InputError
from pieper.kinematics.arrays import Array, ArrayLike
from pieper.kinematics.bounded import nearer
from pieper.kinematics.chain import Chain
from pieper.kinematics.forward import fk
from pieper.solver.plan.plan import Plan
from pieper.solver.plan.six_joints import sample_joints
from pieper.solver.results import Closest, Solutions
from pieper.tolerances import ALIKE_NEAR, CLOSEST_STAGES

#: Postures looked at first; the best of them are where the descent begins. The answer bounds the distance from above.
LOOKED_AT, STARTS = 512, 40
#: Half of the postures go for the position from the first.
POSITION = 0.03


def closest_to(plan: Plan, sols: Solutions) -> Closest:
    """Return the posture that comes nearest to the pose of some solutions; the first of them where there are any."""
    if len(sols.q):
        metres, radians = sols.residual[0]
        return Closest(sols.q[0], float(metres), float(radians), fk(plan.chain, sols.q[0]))
    seeds = np.clip(sols.all_q, plan.limits[:, 0], plan.limits[:, 1])
    return closest(plan, sols.T, seeds=seeds)


def closest(plan: Plan, T: Array, *, weights: ArrayLike | None = None, seeds: Array | None = None) -> Closest:
    """Return the posture inside the limits that comes nearest to a pose, by what the task asks for.

    Newton's method from many postures, joints held at the limits they meet; first with orientation, then without.

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
    limits = plan.full_limits if turning else plan.limits
    stages = _stages(plan, weights)
    q, there = _looked_at(chain, limits.tobytes())
    value, angle = _distances(chain, there, T)
    chosen: list[int] = []
    for turning_first in (stages[0][0], min(stages[0][0], POSITION)):
        cost = value**2 / 2 + turning_first * (1 - np.cos(angle)) if np.isfinite(turning_first) else angle
        nearest = np.argsort(cost, kind="stable")[:STARTS].tolist()
        chosen += [k for k in nearest if k not in chosen][: STARTS // 2]
    q = q[chosen]
    if seeds is not None and len(seeds):
        q = np.vstack([q, np.pad(seeds, ((0, 0), (0, chain.n - plan.n)))])
    for stage, (turn, steps, keep) in enumerate(stages):
        by = np.full(len(q), turn)
        if stage == 0 and len(stages) > 1:
            by[1::4], by[3::4] = np.minimum(turn, POSITION), 0.0
        q, left = nearer(chain, q, T, limits, by, steps)
        value, angle = _distances(chain, chain.native.fk(q), T)
        later = stages[min(stage + 1, len(stages) - 1)][0]
        order = left if len(stages) == 1 else value**2 / 2 + later * (1 - np.cos(angle))
        kept = np.argsort(order, kind="stable")[:keep]
        if (
            weights is None
        ):  # where the position can be met at all, that is where the nearest is, however the tool turns
            placed = np.lexsort((angle * turning, np.round(value / ALIKE_NEAR)))[: keep // 3]
            kept = np.concatenate([kept, placed[~np.isin(placed, kept)]])
        q, value, angle = q[kept], value[kept], angle[kept]
    best = 0 if weights is not None else int(np.lexsort((angle * turning, np.round(value / ALIKE_NEAR)))[0])
    own = q[best, : plan.n]
    miss = plan.residual(own, T)
    return Closest(own, float(miss[0]), float(miss[1]), fk(plan.chain, own))


def _stages(plan: Plan, weights: ArrayLike | None) -> list[tuple[float, int, int]]:
    """Return what a turn counts beside a length of the arm, stage by stage, the steps, and how many are kept."""
    turning = plan.task != "position"
    if weights is None:
        return [(turn * turning, steps, keep) for turn, steps, keep in CLOSEST_STAGES]
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
    metre, radian = float(given[0]) * plan.chain.length, float(given[1]) * turning
    return [((radian / metre) ** 2 if metre else np.inf, sum(steps for _, steps, _ in CLOSEST_STAGES), 1)]


def _distances(chain: Chain, there: Array, T: Array) -> tuple[Array, Array]:
    """Return how far tools (k, 4, 4) are from the pose (k,), per length, and how far turned (k,), rad."""
    gap = there - T
    # of two rotations the chord is 2 sqrt(2) times the sine of half the angle
    chord = np.einsum("kij,kij->k", gap[:, :3, :3], gap[:, :3, :3])
    way = np.sqrt(np.einsum("ki,ki->k", gap[:, :3, 3], gap[:, :3, 3]))
    return way / chain.length, 2 * np.arcsin(np.sqrt(np.minimum(chord / 8, 1.0)))


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
