"""Poses that another plan of the same arm solves: far away ones, and those that leave a snapped arm in doubt.

Slides carry poses so far away that the arm's own links are nothing beside it. Solutions lie as near each other there as
the links are short beside the pose, and every elimination by the links' length drowns in rounding; a gantry whose
lengths are the errors of a calibration has no other poses. So such a pose is solved by a plan that counts its distance
as the arm's length: what is nearly special at that distance is solved as such.

An arm that is nearly special is solved as the special one, its rows refined and counted. Where that one is singular, or
nearly, it may have a whole curve of solutions for a few of the arm as described: then this is solved as it is.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

import numpy as np

from pieper.errors import PlanError
from pieper.kinematics.arrays import Array, Bits, Bools, Indices
from pieper.kinematics.pose import inverse
from pieper.solver.batch import SolutionBatch
from pieper.solver.beyond import DOUBTS
from pieper.solver.plan.plan import Plan
from pieper.solver.plan.prepared import made_once
from pieper.solver.results import Solutions
from pieper.solver.rows import Flag, Rows
from pieper.tolerances import FAR_OUT

_UNCERTAIN = int(Flag.UNCERTAIN)


def one_by_other_plan(
    plan: Plan, T: Array, flag: int, solve: Callable[[Plan, Array], Solutions]
) -> tuple[Solutions, ...]:
    """Return what there is at a marked pose (4, 4), or one without rows, by another plan; nothing where it has none."""
    far = goes_far(plan) and not _clearly_near(plan, T)
    other = _seen_from(plan, float(_decades(plan, T[None])[0])) if far else None
    if other is None and flag & _UNCERTAIN:
        other = plan.described
    return () if other is None else (solve(other, T).told_by(plan),)


def rows_by_other_plans(
    plan: Plan, poses: Array, rows: Rows, status: Bits, solve: Callable[[Plan, Array], SolutionBatch]
) -> Bools:
    """Write what other plans say of poses (N, 4, 4), where rows are marked or none, into rows and status.

    Returns:
        (N,) which poses have no other plan, and are as they were.
    """
    own = np.ones(len(poses), bool)
    for other, index in _others(plan, poses, rows):
        many = solve(other, np.ascontiguousarray(poses[index]))
        found, status[index] = many.found, many.status
        slots = min(rows.q.shape[1], found.q.shape[1])
        for mine, theirs in ((rows.q, found.q), (rows.valid, found.valid), (rows.inside, found.inside)):
            mine[index] = 0
            mine[index, :slots] = theirs[:, :slots]
        rows.flags[index] = found.flags
        own[index] = False
    return own


def _others(plan: Plan, poses: Array, rows: Rows) -> Iterator[tuple[Plan, Indices]]:
    """Yield the other plans that poses are solved by, and which these are: no pose twice."""
    uncertain = (rows.flags & _UNCERTAIN) > 0 if plan.snapped else np.zeros(len(poses), bool)
    if goes_far(plan):
        asked = np.flatnonzero(((rows.flags & DOUBTS) > 0) | ~rows.valid.any(1))
        decades = _decades(plan, poses[asked])
        for decade in np.unique(decades[decades > 0]).tolist():
            index, other = asked[decades == decade], _seen_from(plan, decade)
            if other is not None:
                uncertain[index] = False
                yield other, index
    if uncertain.any() and plan.described is not None:
        yield plan.described, np.flatnonzero(uncertain)


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
