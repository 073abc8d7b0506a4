"""What was asked for of the spare coordinates: values, or an arm angle, by number or by name, or nothing."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np

from pieper.errors import InputError
from pieper.kinematics.arm_angle import ArmAngle
from pieper.kinematics.arrays import Array, ArrayLike, Bools
from pieper.kinematics.forward import checked_joints
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
        values: (N, k) of the redundant coordinates; their defaults where something else was asked for, or nothing.
        angles: (N,) arm angles, rad, where these were asked for, and of what.
        angle: The arm angle they are values of.
        free: Whether nobody chose: any value will do that has an answer.
    """

    values: Array
    angles: Array | None
    angle: ArmAngle | None
    free: bool


#: Nothing can be asked for of an arm that is its own six-joint chain.
NOTHING = Choice(np.zeros((0, 0)), None, None, True)


def choice(plan: Plan, redundancy: Redundancy, count: int) -> Choice:
    """Return what was asked for, one row a pose.

    Raises:
        InputError: The plan has no such coordinate, or the value is impossible.
    """
    if plan.direct:
        if redundancy is not None:
            raise InputError(f"{plan.name} has no redundant coordinate for the task {plan.task!r}.", given=redundancy)
        return NOTHING
    if isinstance(redundancy, Mapping) and ARM_ANGLE in redundancy:
        if len(redundancy) > 1:
            raise InputError(f"give either the {ARM_ANGLE} or the redundant joint, not both.", given=redundancy)
        angles = _arm_angles(redundancy[ARM_ANGLE], redundancy, count, _the_arm_angle(plan, given=redundancy))
        return Choice(np.tile(plan.defaults, (count, 1)), *angles, False)
    return Choice(_values(plan, redundancy, count), None, None, redundancy is None)


def read_arm_angle(plan: Plan, q: ArrayLike) -> tuple[Array, Bools]:
    """Return the arm angles of joint vectors; see `Arm.arm_angle`."""
    return _the_arm_angle(plan).of(checked_joints(q, plan.n))


def _the_arm_angle(plan: Plan, **data: Any) -> ArmAngle:
    if plan.arm_angle is None:
        raise InputError(f"{plan.name} has no {ARM_ANGLE}: {plan.no_arm_angle}.", **data)
    return plan.arm_angle


def _finite(given: Any) -> Array | None:
    """Return an array of finite numbers, or None where they are none."""
    try:
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


def _values(plan: Plan, redundancy: Redundancy, count: int) -> Array:
    """Return the values (count, k) of the redundant coordinates: a number, one a coordinate, one a pose, or by name."""
    names = plan.redundancy
    if redundancy is None:
        return np.tile(plan.defaults, (count, 1))
    if not names:
        raise InputError(f"{plan.name} has no redundant coordinate for the task {plan.task!r}.", given=redundancy)
    if isinstance(redundancy, Mapping):
        unknown = [name for name in redundancy if name not in names]
        if unknown:
            raise InputError(
                f"{unknown[0]!r} is no redundant coordinate of this plan; they are {', '.join(plan.choices)}.",
                given=redundancy,
            )
        redundancy = [redundancy.get(name, plan.defaults[i]) for i, name in enumerate(names)]
    values = _finite(redundancy)
    if values is None:
        raise InputError(f"redundancy must be finite numbers, got {redundancy!r}.", given=redundancy)
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
