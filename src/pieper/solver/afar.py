"""Poses that slides carry so far away that the arm's own links are nothing beside it.

Solutions lie as near each other there as the links are short beside the pose, and every elimination by the links'
length drowns in rounding; a gantry whose lengths are the errors of a calibration has no other poses. So such a pose
is solved by a plan that counts its distance as the arm's length: what is nearly special at that distance is solved
as such.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from pieper.errors import PlanError
from pieper.kinematics.arrays import Array, Bits, Bools
from pieper.kinematics.pose import inverse
from pieper.solver.batch import SolutionBatch
from pieper.solver.beyond import DOUBTS
from pieper.solver.plan.plan import Plan
from pieper.solver.plan.prepared import made_once
from pieper.solver.results import Solutions
from pieper.solver.rows import Rows
from pieper.tolerances import FAR_OUT


def one_from_afar(plan: Plan, T: Array, solve: Callable[[Plan, Array], Solutions]) -> tuple[Solutions, ...]:
    """Return what there is at a marked pose (4, 4), or one without rows, that is far away; nothing where it is near."""
    if not goes_far(plan) or _clearly_near(plan, T):
        return ()
    other = _seen_from(plan, float(_decades(plan, T[None])[0]))
    return () if other is None else (solve(other, T).told_by(plan),)


def rows_from_afar(
    plan: Plan, poses: Array, rows: Rows, status: Bits, solve: Callable[[Plan, Array], SolutionBatch]
) -> Bools:
    """Write what there is at poses (N, 4, 4) that are far away into rows and status, where rows are marked or none.

    Returns:
        (N,) which poses are near, and as they were.
    """
    near = np.ones(len(poses), bool)
    if not goes_far(plan):
        return near
    asked = np.flatnonzero(((rows.flags & DOUBTS) > 0) | ~rows.valid.any(1))
    decades = _decades(plan, poses[asked])
    for decade in np.unique(decades[decades > 0]).tolist():
        other = _seen_from(plan, decade)
        if other is None:
            continue
        index = asked[decades == decade]
        many = solve(other, np.ascontiguousarray(poses[index]))
        found, status[index] = many.found, many.status
        slots = min(rows.q.shape[1], found.q.shape[1])
        for mine, theirs in ((rows.q, found.q), (rows.valid, found.valid), (rows.inside, found.inside)):
            mine[index] = 0
            mine[index, :slots] = theirs[:, :slots]
        rows.flags[index] = found.flags
        near[index] = False
    return near


def goes_far(plan: Plan) -> bool:
    """Whether a plan's poses may lie any distance away: its six joints are the arm's own, and one of them slides."""
    sliding = bool(plan.chain.prismatic.any()) and not plan.chain.scale
    return sliding and plan.reduction.trivial and plan.uncoupled is None


def _clearly_near(plan: Plan, T: Array) -> bool:
    """Whether a pose is near wherever base and tool stand: in few microseconds, of which most calls take no more."""
    links = plan.chain.links
    ends = math.dist((0, 0, 0), links[0, :3, 3]) + math.dist((0, 0, 0), links[-1, :3, 3])
    return math.dist((0, 0, 0), T[:3, 3]) + ends <= FAR_OUT * plan.chain.length


def _decades(plan: Plan, T: Array) -> Array:
    """Return the powers of ten (N,) nearest to the distances of poses T, base and tool taken off, m; 0 if near."""
    links = plan.chain.links
    away = np.linalg.norm((inverse(links[0]) @ T @ inverse(links[-1]))[:, :3, 3], axis=1)
    far = away > FAR_OUT * plan.chain.length
    return np.where(far, 10.0 ** np.round(np.log10(np.where(far, away, 1.0))), 0.0)


def _seen_from(plan: Plan, decade: float) -> Plan | None:
    """Return the plan for poses about a power of ten of metres away; None where they are near, or it has none."""
    if not decade:
        return None
    try:
        return made_once(plan.seen_from, decade, lambda: plan.from_afar(plan, decade))
    except PlanError:
        return None  # so far away joints of the arm do the same
