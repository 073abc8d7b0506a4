"""The careful look in closed form: what is free at each row of a closed-form kernel is read off the row's axes.

A row whose Jacobian has one null direction is a point of a self-motion where the joints of that direction are a linkage
(loop.py), and a merged root where the pose is left to second order. Everything else, which is rare (two directions at
once, linkages of five and six joints, curves that cross), is left to `examine`.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.kinematics.chain import Chain
from pieper.kinematics.geometry import axes_at
from pieper.kinematics.newton import missed, newton, scaled_jacobian
from pieper.solver.singular.examined import Examined, told
from pieper.solver.singular.in_one_line import LineMotion
from pieper.solver.singular.linkage_motion import LinkageMotion
from pieper.solver.singular.loop import FourBar, four_bar, line_gap
from pieper.solver.singular.merged_roots import BLUR, ROUNDING, SAME, branches_at, distinct_roots
from pieper.solver.singular.near_curve import onto
from pieper.solver.singular.self_motion import SelfMotion
from pieper.tolerances import (
    CLEAR_FOLD,
    IN_ONE_LINE,
    LOOP_MOVES,
    NEARLY_IN_LINE,
    NEXT_TO_LINKAGE,
    ON_CURVE,
    ONE_WAY_FREE,
    SAME_SOLUTION,
    SINGULAR_EXAMINED,
    UNNOTICED,
)

#: Relative singular values below which kernels may give one point for two solutions beside a self-motion.
ROOTS_APART = 1e-11
#: Solutions beside a self-motion are known to rounding over the singular value: nearer than this they are one (rad).
SAME_ALONG = 0.03
#: What they may miss the pose by (per length; rad), and Newton steps on the way.
HOLDS_TO_ROUNDING, SLOW_STEPS = 1e-14, 40
#: Said of an isolated solution next to a self-motion.
BESIDE = 1


@dataclass(frozen=True, eq=False)
class Asked:
    """Whose rows are looked at.

    Args:
        chain: Six joints, a task's virtual ones included.
        T: (4, 4).
        limits: (6, 2).
        names: Of the joints.
        shown: How many are the arm's own.
    """

    chain: Chain
    T: Array
    limits: Array
    names: tuple[str, ...]
    shown: int


def from_axes(asked: Asked, rows: Array) -> Examined | None:
    """Return all there is at a pose of which a closed-form kernel gave rows (m, 6); None where that cannot be read off.

    Rows of a pose come in an even number, self-motions and double roots counted twice: another number is not believed.
    """
    chain = asked.chain
    if not len(rows):
        return None
    J = scaled_jacobian(chain, rows)
    left, s, Vt = np.linalg.svd(J)
    size = s[:, 0]
    poor = s[:, 5] <= SINGULAR_EXAMINED * size
    if (s[poor, 4] <= ONE_WAY_FREE * size[poor]).any():
        return None
    motions: list[SelfMotion] = []
    alone: list[Array] = []
    multiplicity: list[int] = []
    axes, points = axes_at(chain, rows)
    for k in np.flatnonzero(poor):
        if any(_holds(motion, rows[k]) for motion in motions):
            continue
        null = Vt[k, 5]
        said = _free(asked, rows[k], axes[k], points[k], null, s[k])
        if said is None:
            return None
        if isinstance(said, SelfMotion):
            motions.append(said)
            continue
        count = 1 if said == BESIDE else _merged(J[k], null, left[k, :, 5], float(s[k, 5]))
        if not count:
            # too flat to be told by its second order: what a step along it misses tells
            count = branches_at(chain, rows[k], asked.T)
            if _held_aside(asked, rows[k], null):
                return None
        if said == BESIDE and s[k, 5] < ROOTS_APART * size[k]:
            if np.count_nonzero(np.abs(null) > LOOP_MOVES) > 2:
                return None
            for q in _settled(asked, rows[k], null):
                if not any(chain.joints.apart(q, other) < SAME_ALONG for other in alone):
                    alone.append(q)
                    multiplicity.append(1)
            continue
        alone.append(rows[k])
        multiplicity.append(count)
    if len(alone) > 1:
        gaps = chain.joints.apart(np.array(alone)[:, None], np.array(alone)[None]) + 9 * np.eye(len(alone))
        if gaps.min() < BLUR:
            alone = distinct_roots(chain, alone, asked.T)
            multiplicity = [branches_at(chain, q, asked.T) for q in alone]
    isolated = rows[~poor]
    if len(isolated) > 1:
        isolated = isolated[chain.joints.distinct(isolated, SAME_SOLUTION)]
    if (len(isolated) + sum(multiplicity)) % 2:
        return None
    return told(chain, list(isolated), alone, multiplicity, motions)


def _settled(asked: Asked, q: Array, null: Array) -> Array:
    """Return the solutions (m, n) beside a self-motion all but in place: kernels give one point of such a line.

    What is missed along the line changes sign twice in a turn. Newton's method from four points of it ends at both.
    """
    chain = asked.chain
    starts = q + np.array([0.0, 0.5, 1.0, 1.5])[:, None] * np.pi * np.sqrt(2) * null * chain.joints.unit
    there = newton(chain, starts, asked.T, steps=SLOW_STEPS, cutoff=1e-15)
    miss = missed(chain, there, asked.T)
    there = there[np.argsort(miss, kind="stable")][: np.count_nonzero(miss < HOLDS_TO_ROUNDING)]
    there = there[chain.joints.distinct(there, SAME_ALONG)]
    return there if len(there) == 2 else q[None]


def _holds(motion: SelfMotion, q: Array) -> bool:
    return motion.holds(q, 1e-9) if isinstance(motion, LinkageMotion) else motion.distance(q) < 1e-9


def _free(asked: Asked, q: Array, z: Array, o: Array, null: Array, s: Array) -> SelfMotion | int | None:
    """Return the self-motion through a row (n,), BESIDE if it is an isolated solution next to one, else 0.

    None where a linkage is met that cannot be read off.
    """
    chain = asked.chain
    rounding = IN_ONE_LINE * (1 + np.abs(o).max() / chain.length)
    order = np.argsort(-np.abs(null))
    pair = np.sort(order[:2])
    i, j = int(pair[0]), int(pair[1])
    if np.abs(null[order[2]]) < LOOP_MOVES and not chain.prismatic[pair].any():
        gap = line_gap(z, o, i, j, chain.length)
        if gap <= rounding:
            given = asked.chain, asked.T, asked.limits, asked.names, asked.shown
            return LineMotion(*given, through=q, pair=(i, j), sense=1.0 if z[i] @ z[j] > 0 else -1.0)
    else:
        found = four_bar(chain, z, o, null)
        if found is None:
            return 0
        linkage, gap = found
        if gap <= rounding:
            return _linkage(asked, q, linkage)
    if gap > NEXT_TO_LINKAGE:
        return 0
    # joints outside the linkage may make up for what it misses, or move it by so much unnoticed: a second look tells
    return BESIDE if s[5] > NEARLY_IN_LINE * gap and gap * s[4] > UNNOTICED * s[0] else 0


def _linkage(asked: Asked, q: Array, linkage: FourBar) -> LinkageMotion | None:
    whole: LinkageMotion | None = None
    for lead in range(4):
        span = linkage.range(lead)
        if span is None:
            return None
        round_ = span[1] - span[0] >= 2 * np.pi - 1e-12
        across = float(np.sin(-linkage.sides(lead)[1].phase))
        if round_ and abs(across) < 1e-9:
            return None
        if whole is None or (round_ and not whole.side):
            whole = LinkageMotion(
                asked.chain,
                asked.T,
                asked.limits,
                asked.names,
                asked.shown,
                through=q,
                linkage=linkage,
                lead=lead,
                span=span,
                side=float(np.sign(across)) if round_ else 0.0,
            )
    if whole is None or missed(asked.chain, whole.points(np.linspace(0, 1, 7)), asked.T).max() > 10 * ON_CURVE:
        return None
    return whole


def _merged(J: Array, null: Array, left: Array, sigma: float) -> int:
    """Return how many branches merge, by what the null direction misses to second order; 0 where that is too little.

    The product of exponentials along a null direction v departs from one by the brackets of the joints' twists,
    sum over i < j of v_i v_j [x_i, x_j] t^2 / 2.
    """
    linear, turn = (J * null)[:3], (J * null)[3:]
    # sums of the twists before each joint
    before = np.cumsum(np.concatenate([np.zeros((6, 1)), (J * null)[:, :-1]], 1), axis=1)
    first = np.cross(before[3:], linear, axis=0) - np.cross(turn, before[:3], axis=0)
    bracket = np.concatenate([first.sum(1), np.cross(before[3:], turn, axis=0).sum(1)])
    bend = float(left @ bracket) / 2
    if abs(bend) < CLEAR_FOLD:
        return 0
    blur = min(np.sqrt(ROUNDING / abs(bend)), ROUNDING / max(sigma, 1e-300))
    return 2 if sigma / abs(bend) < max(SAME, 3 * blur) else 1


def _held_aside(asked: Asked, q: Array, null: Array) -> bool:
    """Whether the pose can be held a little way along the null direction, all but exactly."""
    step = 0.05 * null * asked.chain.joints.unit
    there = onto(asked.chain, np.stack([q + step, q - step]), asked.T, 5)
    return bool(np.abs(there.miss).min() < 10 * ON_CURVE)
