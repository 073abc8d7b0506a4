"""Points of a pose met from anywhere: by descent from postures spread evenly, and by Newton steps from near ones."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array, Indices
from pieper.kinematics.chain import Chain
from pieper.kinematics.joints import TURN, short_way
from pieper.kinematics.newton import (
    damped,
    downhill,
    missed,
    newton_and_miss,
    null_space,
    pose_difference,
    scaled_jacobian,
    settled,
)
from pieper.solver.plan.plan import Plan
from pieper.solver.plan.six_joints import sample_joints
from pieper.tolerances import (
    ALL_BUT_HELD,
    APPROACH_DAMPING,
    APPROACH_LEAST_DAMPING,
    CLOSES,
    ROUND_A_REST,
    SAME_REST,
)

#: How often a posture is tried in a free approach to a pose.
PULL_STEPS = 40
#: Newton's steps from where a descent has rested near the pose: beside a singular posture each halves what is left.
LAST_STEPS = 40
#: In how many directions one looks around such a place, and around how many places.
ROUND, MOST_RESTS = 12, 8


def pulled(chain: Chain, q: Array, T: Array, steps: int) -> Array:
    """Return joint vectors (k, n) after so many shortest Newton steps towards poses T (k, 4, 4), each bounded."""

    def miss(at: Array, index: Indices) -> Array:
        return pose_difference(chain, at, T[index])

    def slope(at: Array, index: Indices) -> Array:
        return scaled_jacobian(chain, at)

    return settled(miss, slope, q, chain.joints.unit, steps=steps, longest=0.2, step=damped(APPROACH_LEAST_DAMPING))[0]


def from_anywhere(plan: Plan, T: Array, starts: int) -> list[Array]:
    """Return for each of poses T (N, 4, 4) points (m, n) of it found from anywhere.

    The distance to the pose is minimised (Levenberg-Marquardt) from so many postures, always the same ones. Where a
    curve of solutions is about to appear or has just appeared, that distance has a minimum to which a neighbourhood of
    ordinary size leads. Beside a singular posture a descent rests there before it arrives, and it is looked around.
    """
    full = plan.exact.full
    q = np.tile(sample_joints(full, starts, seed=7), (len(T), 1))
    poses = np.repeat(T, starts, axis=0)
    q, _ = downhill(
        full,
        q,
        poses,
        steps=PULL_STEPS,
        weights=np.ones(6),
        damping=APPROACH_DAMPING,
        relative=lambda J, square: square,
    )
    return [held_or_beside(full, rows, pose) for rows, pose in zip(q.reshape(len(T), starts, full.n), T, strict=True)]


def held_or_beside(chain: Chain, q: Array, T: Array) -> Array:
    """Return joint vectors (m, n) that hold the pose where descents ended at q (k, n), or all but did.

    Beside a singular posture they are slow, and where they rest nearly on the pose it is looked around.
    """
    away = missed(chain, q, T)
    near = (away >= CLOSES) & (away < ALL_BUT_HELD)
    moved, off = newton_and_miss(chain, q[near], np.tile(T, (int(near.sum()), 1, 1)), steps=LAST_STEPS)
    rests = moved[np.argsort(off, kind="stable")][np.count_nonzero(off < CLOSES) :]
    rests = rests[chain.joints.distinct(rests, SAME_REST)[:MOST_RESTS]]
    found = np.concatenate([q[away < CLOSES], moved[off < CLOSES], *(beside_rest(chain, rest, T) for rest in rests)])
    return np.where(chain.prismatic, found, short_way(found))


def beside_rest(chain: Chain, q: Array, T: Array) -> Array:
    """Return solutions (k, n) of a pose (4, 4) around a posture (n,) at which a descent rests and nearly holds it.

    There the way that is missed bends back: what holds the pose, a small self-motion or one that passes closely, lies
    to the side of it along the two weakest directions, as far as the root of what is missed.
    """
    weakest = null_space(chain, q)[1][-2:]
    around = np.linspace(0, TURN, ROUND, endpoint=False)
    ways = np.stack([np.cos(around), np.sin(around)], 1) @ weakest
    starts = q + (np.array(ROUND_A_REST)[:, None, None] * ways).reshape(-1, chain.n) * chain.joints.unit
    rows, off = newton_and_miss(chain, starts, np.tile(T, (len(starts), 1, 1)), steps=LAST_STEPS)
    return rows[off <= CLOSES]
