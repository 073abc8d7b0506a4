"""Where the self-motions of a pose meet the joints' limits: each joint held at each of its limits, the others solved.

What lies inside the limits of a self-motion is bounded by such points. They come from the same kernels as any other
solution, one prepared arm a joint and limit: nothing is sliced, stepped along or overlooked.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np

from pieper.errors import PlanError
from pieper.kinematics.arrays import Array, Bools, Indices
from pieper.kinematics.joints import TURN
from pieper.kinematics.newton import missed, newton
from pieper.solver.arm_rows import full_rows
from pieper.solver.plan.holding import holding
from pieper.solver.plan.plan import Plan
from pieper.tolerances import CLOSES, LIMIT_SLACK

#: Newton steps that take a kernel's row to rounding while the joints at their stops stand still.
STEPS = 6


@dataclass(frozen=True, eq=False, slots=True)
class Stops:
    """Points of poses at which as many joints as the arm has to spare stand at limits.

    Args:
        q: (M, n) points, the task's virtual joints included, whole turns as the limits want them.
        pose: (M,) index of the pose each belongs to.
        inside: (M,) whether the other joints are inside their limits.
    """

    q: Array
    pose: Indices
    inside: Bools


def stops(plan: Plan, T: Array, threads: int = 1, *, every_turn: bool = False) -> Stops:
    """Return every point of poses T (N, 4, 4) with the spare joints at limits.

    Args:
        plan: A plan with redundancy.
        T: The poses.
        threads: For the kernels.
        every_turn: Whether the limits of joints that can turn all the way round count too: they bound no posture, but
            what whole turns it can be reached with.
    """
    full, limits = plan.exact.full, plan.full_limits
    parts, poses = [np.zeros((0, full.n))], [np.zeros(0, np.int64)]
    for joints in itertools.combinations(_bounded(plan, every_turn), len(plan.redundancy)):
        try:
            held = holding(plan, joints)
        except PlanError:
            continue  # the pose alone decides one of them: no self-motion meets its limit but by lying on it
        for values in itertools.product(*(_ends(plan, joint) for joint in joints)):
            found = _solved(held, T, np.array(values), threads)
            if found is not None:
                parts.append(found[0])
                poses.append(found[1])
    q, pose = np.concatenate(parts), np.concatenate(poses)
    q, inside = full.joints.inside_limits(q, limits)
    return Stops(q, pose, inside)


def _bounded(plan: Plan, every_turn: bool) -> list[int]:
    limits, prismatic = plan.full_limits, plan.exact.full.prismatic
    width = limits[:, 1] - limits[:, 0]
    has = np.isfinite(limits).any(1) & (prismatic | every_turn | (width < TURN - 2 * LIMIT_SLACK))
    return [int(j) for j in np.flatnonzero(has)]


def _ends(plan: Plan, joint: int) -> list[float]:
    lower, upper = plan.full_limits[joint]
    ends = [float(v) for v in (lower, upper) if np.isfinite(v)]
    if len(ends) < 2 or plan.exact.full.prismatic[joint]:
        return ends
    turns = (upper - lower) / TURN
    return ends[:1] if abs(turns - round(turns)) * TURN < LIMIT_SLACK else ends


def _solved(held: Plan, T: Array, values: Array, threads: int) -> tuple[Array, Indices] | None:
    """Return rows (m, n) and their poses (m,) with the held joints at values (k,); None where no family takes that."""
    try:
        found = full_rows(held, T, np.tile(values, (len(T), 1)), threads)
    except PlanError:
        return None  # held there, two axes coincide: what is left reaches no open set of poses
    pose, row = np.nonzero(found.valid)
    q = found.q[pose, row]
    rest = held.exact.with_locked(values)
    kept = held.exact.kept
    q[:, kept] = newton(rest, q[:, kept], T[pose], steps=STEPS)
    good = missed(held.exact.full, q, T[pose]) < CLOSES
    return q[good], pose[good]
