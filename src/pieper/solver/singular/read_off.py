"""What the kernel says of a singular pose, read off the axes of its rows or followed, put into Python's objects.

`CarefulLook` (kernels/singular/) says of each row whether two of its axes are one line or four are a linkage, which
rows are merged roots, and which row stands for each self-motion. Where two directions are free at once, or courses
cross, it reads the whole fibre of the closed form's group of three joints. Of arms that are solved by elimination it
asks poses beside, and follows the curves that nearly hold the pose. What it does not tell (surfaces, linkages of five
and six joints, self-motions that cross where nothing is in closed form) is left to `examine`.
"""

from __future__ import annotations

from functools import partial

import numpy as np

from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.chain import Chain
from pieper.kinematics.newton import singular_values
from pieper.solver.native import Read, SelfMotionSaid
from pieper.solver.plan.plan import Plan
from pieper.solver.rows import Flag
from pieper.solver.singular.at_limits import at_limits
from pieper.solver.singular.examine import side_steps
from pieper.solver.singular.examined import Examined
from pieper.solver.singular.in_one_line import LineMotion
from pieper.solver.singular.linkage_motion import LinkageMotion
from pieper.solver.singular.merged_roots import null_direction
from pieper.solver.singular.self_motion import SelfMotion
from pieper.solver.singular.traced_motion import TracedMotion
from pieper.tolerances import BESIDE_A_FOLD, NEAR_A_FOLD, SINGULAR_EXAMINED

#: Rows of one fold, where the arm holds every pose in a second posture too (shoulder turned half round, elbow over).
ROWS_OF_A_FOLD = 4


def examined(plan: Plan, T: Array, read: Read) -> Examined:
    """Return what was read off at a pose T (4, 4) of an arm that is its own six-joint chain; curves when asked for."""
    directions = partial(_directions, plan.chain, read.q, read.singular)
    motions = partial(_motions, plan, T, read.self_motions) if read.self_motions else ()
    return Examined(read.q, read.self_motion, read.branches, directions, motions)


def crowded(plan: Plan, T: Array, q: Array) -> bool:
    """Whether rows (m, 6) of an arm that is solved by elimination stand at more than one fold at once, and may be few.

    Which of them a solution of a pose beside follows from is not told then: they lie nearer to each other than to it.
    Where no pose close beside has more solutions than there are rows, these are believed; and where no pose can.
    """
    if plan.spec.closed_form or not ROWS_OF_A_FOLD < len(q) < plan.max_solutions:
        return False
    s = singular_values(plan.chain, q)
    weak = s[:, -1] / s[:, 0]
    if ((weak > SINGULAR_EXAMINED) & (weak < NEAR_A_FOLD)).sum() <= ROWS_OF_A_FOLD:
        return False
    beside = np.concatenate([side_steps(plan.chain, T, (size,)) for size in BESIDE_A_FOLD])
    _, valid, _, flags = plan.solver.many(np.ascontiguousarray(beside), 1)
    return bool((flags & Flag.UNCERTAIN).any() or valid.sum(1).max() > len(q))


def _directions(chain: Chain, q: Array, singular: Bools) -> Array:
    out = np.zeros(q.shape)
    for k in np.flatnonzero(singular):
        out[k] = null_direction(chain, q[k])
    return out


def _motions(plan: Plan, T: Array, said: list[SelfMotionSaid]) -> tuple[SelfMotion, ...]:
    return tuple(_told(plan, T, one) for one in said)


def _told(plan: Plan, T: Array, said: SelfMotionSaid) -> SelfMotion:
    whose = plan.chain, T, plan.limits, plan.names, plan.n
    if len(said) == 2:
        points, closed = said
        return at_limits(TracedMotion(plan.chain, T, points, closed, 1, plan.limits, plan.names, plan.n))
    if len(said) == 3:
        through, pair, sense = said
        return LineMotion(*whose, through=through, pair=pair, sense=sense)
    return LinkageMotion(*whose, through=said[0], linkage=said[1:])
