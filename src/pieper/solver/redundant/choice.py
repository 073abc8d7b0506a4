"""What was asked for of the spare coordinates: values, or an arm angle, by number or by name, or nothing."""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, TypeAlias

import numpy as np

from pieper import arguments
from pieper.errors import InputError, PlanError
from pieper.kinematics.arm_angle import ArmAngle
from pieper.kinematics.arrays import Array, ArrayLike, Bools
from pieper.kinematics.forward import checked_joints
from pieper.solver.plan.holding import holding
from pieper.solver.plan.plan import Plan
from pieper.tolerances import LIMIT_SLACK
from pieper.words_by_number import plural

#: The name by which an arm angle is asked for.
ARM_ANGLE = "arm angle"

#: A value, one a coordinate, one such row a pose, or values by name.
Redundancy: TypeAlias = ArrayLike | Mapping[str, Any] | None


@dataclass(frozen=True, eq=False, slots=True)
class Choice:
    """What the spare coordinates are to be.

    Args:
        plan: The plan that holds the coordinates that were asked for.
        values: (N, k) of its redundant coordinates; their defaults where something else was asked for, or nothing.
        angles: (N,) arm angles, rad, where these were asked for, and of what.
        angle: The arm angle they are values of.
        free: Whether nobody chose: any value will do that has an answer.
        named: Which coordinates (0-based, of the plan's redundant ones) were chosen where others were left open, of
            which any value will do; else none.
    """

    plan: Plan
    values: Array
    angles: Array | None
    angle: ArmAngle | None
    free: bool
    named: tuple[int, ...] = ()

    @property
    def names(self) -> tuple[str, ...]:
        """Names of what was chosen where others were not."""
        return tuple(self.plan.redundancy[i] for i in self.named)

    def part(self, at: slice) -> Choice:
        """Return the same for some of the poses."""
        angles = None if self.angles is None else self.angles[at]
        return replace(self, values=self.values[at], angles=angles)


def nothing_chosen(redundancy: Redundancy) -> bool:
    """Whether no value was given: None, or no name."""
    return redundancy is None or (isinstance(redundancy, Mapping) and not redundancy)


def choice(plan: Plan, redundancy: Redundancy, count: int) -> Choice:
    """Return what was asked for, one row a pose.

    Raises:
        InputError: The plan has no such coordinate, or the value is impossible.
    """
    if nothing_chosen(redundancy):
        return Choice(plan, np.tile(plan.defaults, (count, 1)), None, None, True)
    if not plan.redundancy:
        raise InputError(
            f"{plan.name} has no redundant coordinate for the task {plan.task!r}: its joints are all needed.",
            given=redundancy,
        )
    if not isinstance(redundancy, Mapping):
        return Choice(plan, _values(plan, redundancy, redundancy, count), None, None, False)
    if ARM_ANGLE in redundancy:
        if len(redundancy) > 1:
            raise InputError(
                f"give either the {ARM_ANGLE} or {plural(len(redundancy) - 1, 'joint')}, not both: one more thing held "
                f"than {plan.name} has to spare.",
                given=redundancy,
            )
        angles = _arm_angles(redundancy[ARM_ANGLE], redundancy, count, _the_arm_angle(plan, given=redundancy))
        return Choice(plan, np.tile(plan.defaults, (count, 1)), *angles, False)
    return _by_name(plan, redundancy, count)


def _by_name(plan: Plan, redundancy: Mapping[str, Any], count: int) -> Choice:
    """Return the choice of coordinates given by name: any joints of the arm, or what the task leaves."""
    names, spare = plan.full_names, len(plan.redundancy)
    unknown = [name for name in redundancy if name not in names]
    if unknown:
        raise InputError(
            f"{unknown[0]!r} is no joint of {plan.name}, nor anything else that can be held; those are "
            f"{', '.join(plan.choices)}.",
            given=redundancy,
            allowed=plan.choices,
        )
    if len(redundancy) > spare:
        raise InputError(
            f"{plan.name} has {plural(spare, 'coordinate')} to spare for the task {plan.task!r}, got values for "
            f"{len(redundancy)}: {', '.join(redundancy)}. Leave out {len(redundancy) - spare}.",
            given=redundancy,
        )
    held = _holding(plan, tuple(names.index(name) for name in redundancy), redundancy)
    columns = [redundancy.get(name, held.defaults[i]) for i, name in enumerate(held.redundancy)]
    shapes = {np.shape(column) for column in columns} - {()}
    if shapes - {(1,), (count,)}:
        raise InputError(
            f"a value must be one number, or one a pose ({count}), got shape {max(shapes, key=len)}.", given=redundancy
        )
    values = [_finite(column) for column in columns]
    if any(value is None for value in values):
        raise InputError(f"redundancy must be finite numbers, got {arguments.kind_of(redundancy)}.", given=redundancy)
    rows = np.stack([np.broadcast_to(np.ravel(value), (count,)) for value in values if value is not None], -1)
    named = tuple(i for i, name in enumerate(held.redundancy) if name in redundancy) if len(redundancy) < spare else ()
    return Choice(held, _values(held, rows, redundancy, count), None, None, False, named)


def _holding(plan: Plan, joints: tuple[int, ...], redundancy: Mapping[str, Any]) -> Plan:
    """Return the plan in which these joints are held, and as many others beside them as the arm has to spare."""
    still = [plan.full_names[joint] for joint in joints if joint not in plan.movable]
    if still:
        raise InputError(
            f"{plan.name}: the pose alone decides {', '.join(still)}, which cannot be chosen. Choose "
            f"{', '.join(plan.choices)} instead.",
            given=redundancy,
            allowed=plan.choices,
        )
    spare = len(plan.redundancy) - len(joints)
    others = [j for j in (*plan.reduction.locked, *range(plan.reduction.full.n)) if j not in joints]
    for beside in itertools.combinations(dict.fromkeys(others), spare):
        try:
            return holding(plan, (*joints, *beside))
        except PlanError:
            continue
    together = " and ".join(plan.full_names[joint] for joint in joints)
    raise InputError(
        f"{plan.name}: {together} cannot be chosen together, since the pose decides how they move with each other."
        if len(joints) > 1
        else f"{plan.name}: no family takes the arm with {together} held. Choose {', '.join(plan.choices)} instead.",
        given=redundancy,
        allowed=plan.choices,
    )


def read_arm_angle(plan: Plan, q: ArrayLike) -> tuple[Array, Bools]:
    """Return the arm angles of joint vectors; see `Arm.arm_angle`."""
    return _the_arm_angle(plan).of(checked_joints(q, plan.n, prismatic=plan.prismatic))


def _the_arm_angle(plan: Plan, **data: Any) -> ArmAngle:
    if plan.arm_angle is None:
        raise InputError(f"{plan.name} has no {ARM_ANGLE}: {plan.no_arm_angle}.", **data)
    return plan.arm_angle


def _finite(given: Any) -> Array | None:
    """Return an array of finite numbers, or None where they are none."""
    try:
        if np.asarray(given).dtype == bool:  # yes and no are no angles
            return None
        numbers = np.asarray(given, float)
    except (TypeError, ValueError):
        return None
    return numbers if np.isfinite(numbers).all() else None


def _arm_angles(given: Any, redundancy: Any, count: int, angle: ArmAngle) -> tuple[Array, ArmAngle]:
    angles = _finite(given)
    if angles is None:
        raise InputError(f"the {ARM_ANGLE} must be a finite number, got {given!r}.", given=redundancy)
    if angles.shape not in ((), (1,), (count,)):
        raise InputError(
            f"the {ARM_ANGLE} must be one number, or one a pose, got shape {angles.shape}.", given=redundancy
        )
    return np.broadcast_to(angles, (count,)), angle


def _values(plan: Plan, given: Any, redundancy: Redundancy, count: int) -> Array:
    """Return the values (count, k) of the redundant coordinates: a number, one a coordinate, or one such row a pose."""
    names = plan.redundancy
    values = _finite(given)
    if values is None:
        raise InputError(f"redundancy must be finite numbers, got {arguments.kind_of(redundancy)}.", given=redundancy)
    k = len(names)
    if values.ndim == 0 and k == 1:
        values = np.full((count, 1), float(values))
    elif values.shape == (k,) and not (k == 1 and count == 1):
        values = np.tile(values, (count, 1))
    elif values.shape == (count,) and k == 1:
        values = values[:, None]
    if values.shape != (count, k):
        raise InputError(
            f"redundancy must give {plural(k, 'value')} ({', '.join(names)}), or one such row a pose, "
            f"got shape {values.shape}.",
            given=redundancy,
        )
    for j, (lower, upper) in enumerate(plan.redundancy_limits):
        outside = (values[:, j] < lower - LIMIT_SLACK) | (values[:, j] > upper + LIMIT_SLACK)
        if outside.any():
            raise InputError(
                f"redundancy value {values[outside, j][0]:g} of {names[j]} is outside its limits "
                f"{lower:g} to {upper:g}.",
                given=redundancy,
                joint=names[j],
            )
    return values
