"""A plan with other joints held than it chose: any joint that moves along the self-motions can be the spare one."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from pieper.errors import PlanError
from pieper.kinematics.geometry import look
from pieper.solver.families import choose
from pieper.solver.families.family import KernelSpec
from pieper.solver.native import without_far_ends
from pieper.solver.plan import six_joints
from pieper.solver.plan.plan import MOST_LOCKED, Plan, as_it_is, as_near
from pieper.solver.plan.prepared import made_once
from pieper.solver.plan.unlike import unlike
from pieper.tolerances import GEOMETRY_EXACT

#: Values at which a joint is tried when its family is chosen: of no special kind, so that an arrangement that holds at
#: one of them holds at all, and more than one, since any of them may happen to be special.
TRIED = (0.3719, -0.7134, 1.1937)


def holding(plan: Plan, joints: tuple[int, ...]) -> Plan:
    """Return a plan for the same arm and task in which other joints are held; made once and kept with the plan.

    Args:
        plan: A plan with redundancy.
        joints: As many joints (0-based, the task's virtual ones included) as the plan has redundant coordinates.

    Raises:
        PlanError: The pose alone decides what these joints are, or no family takes the arm while they are held.
    """
    joints = tuple(sorted(joints))
    if joints == plan.reduction.locked:
        return plan
    return made_once(plan.held, joints, lambda: _made(plan, joints))


def _made(plan: Plan, joints: tuple[int, ...]) -> Plan:
    names = ", ".join(plan.full_names[joint] for joint in joints)
    reduction = six_joints.holding(plan.reduction, joints)
    if reduction is None:
        raise PlanError(f"{plan.name}: the pose alone decides {names}, which cannot be chosen.", joints=joints)
    family, spec = _family_of(reduction)
    limits = plan.full_limits[list(joints)]
    nearest = np.clip(np.zeros(len(limits)), limits[:, 0], limits[:, 1])
    middle = np.where(np.isfinite(limits).all(1), np.nan_to_num(limits).mean(1), nearest)
    most = max(spec.max_solutions, 16 if plan.snapped else 0)
    return replace(plan, reduction=reduction, defaults=middle, family=family, spec=spec, max_solutions=most)


def _family_of(reduction: six_joints.Reduction) -> tuple[str, KernelSpec]:
    """Return which family takes six joints where those that are held stand anywhere, and how it solves them.

    Raises:
        PlanError: None does.
    """
    refused = None
    for value in TRIED if reduction.locked else (0.0,):
        six, _ = without_far_ends(reduction.six(unlike(len(reduction.locked), value)))
        try:
            return choose(six, look(six, GEOMETRY_EXACT))
        except PlanError as error:
            refused = error
    raise refused or AssertionError("one value at least is tried")


def locked_at(plan: Plan, values: tuple[float, ...], joints: tuple[int, ...] | None = None) -> Plan:
    """Return a plan for the arm whose redundant coordinates stand at values: for the joints that are left, a pose.

    Its joints are the others, the task's virtual ones included. Made once and kept with the plan.

    Args:
        plan: A plan with redundancy.
        values: One a coordinate, or one of each of `joints`.
        joints: Which joints (0-based, virtual ones included) stand at values; the redundant coordinates if None.

    Raises:
        PlanError: No family takes what is left.
    """
    joints = plan.reduction.locked if joints is None else joints
    key = tuple(zip(joints, values, strict=True))
    return made_once(plan.locked, key, lambda: without(plan, joints, values), MOST_LOCKED)


def without(plan: Plan, joints: tuple[int, ...], values: tuple[float, ...]) -> Plan:
    """Return a plan for the arm with joints (0-based, virtual ones included) held at values: for what is left, a pose.

    Raises:
        PlanError: No family takes what is left.
    """
    kept = [joint for joint in range(plan.exact.full.n) if joint not in joints]
    chain = plan.exact.full
    for joint, value in sorted(zip(joints, values, strict=True), reverse=True):
        chain = chain.locked(joint, float(value))
    reduction = six_joints.reduce(chain, "pose")[0]
    family, spec = _family_of(reduction)
    names = plan.full_names
    return replace(
        plan,
        chain=chain,
        nominal=chain,
        geometry=look(chain, GEOMETRY_EXACT),
        limits=plan.full_limits[kept],
        names=tuple(names[joint] for joint in kept),
        task="pose",
        family=family,
        max_solutions=spec.max_solutions,
        reduction=reduction,
        spec=spec,
        rank=chain.n - len(reduction.locked),
        snapped=(),
        defaults=np.zeros(len(reduction.locked)),
        virtual_limits=None,
        special=as_it_is,  # its description is the whole arm's, of which a special arm would be made
        from_afar=as_near,
    )
