"""What a motion must keep: speeds, accelerations and jerks of the joints, speeds and accelerations of the tool."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import cast

import numpy as np

from pieper import arguments
from pieper.errors import InputError
from pieper.kinematics.arrays import Array, ArrayLike
from pieper.kinematics.meant import remark_fast
from pieper.tolerances import FAST_JOINT, FAST_TOOL, NO_LIMIT
from pieper.words_by_number import plural

#: What is said to somebody who gives something else.
SAY_LIMITS = "say pieper.Limits(speed=..., acceleration=...)"
#: What is said where a limit would hold a joint still.
HELD_JOINT = "a joint that is to stand still does so where the path does not move it"
_UNITS = {"speed": "rad/s or m/s", "acceleration": "rad/s^2 or m/s^2", "jerk": "rad/s^3 or m/s^3"}
_TOOL_UNITS = {"tool_speed": "m/s", "tool_acceleration": "m/s^2", "turn_speed": "rad/s"}


@dataclass(frozen=True, eq=False)
class Limits:
    """Limits of a motion, one number for all joints or one a joint.

    Attributes:
        speed: (n,) or one number, rad/s or m/s.
        acceleration: (n,) or one number, rad/s^2 or m/s^2.
        jerk: (n,) or one number, rad/s^3 or m/s^3; None where it does not matter.
        tool_speed: Largest speed of the tool's point, m/s.
        tool_acceleration: Largest acceleration of the tool's point, m/s^2.
        turn_speed: Largest speed at which the tool turns, whatever the axis, rad/s.

    Raises:
        InputError: A limit is missing, zero, negative or infinite, or a jerk comes without an acceleration; the
            message names the joint.
    """

    speed: ArrayLike | None = None
    acceleration: ArrayLike | None = None
    jerk: ArrayLike | None = None
    tool_speed: float | None = None
    tool_acceleration: float | None = None
    turn_speed: float | None = None

    def __post_init__(self) -> None:
        if self.jerk is not None and self.acceleration is None:
            raise InputError("a jerk was given without an acceleration; say acceleration= too.", given=self.jerk)
        for name in _UNITS:
            value = getattr(self, name)
            if value is None and name != "jerk":
                raise InputError(
                    f"{name} is missing: say one number for all joints or one a joint, {_UNITS[name]}.", missing=name
                )
            if value is not None:
                object.__setattr__(self, name, _positive(value, name))
        for name in _TOOL_UNITS:
            value = getattr(self, name)
            if value is not None:
                object.__setattr__(self, name, _positive_number(value, name))
        for name, most, small in (
            ("speed", FAST_JOINT, "in degrees a second"),
            ("turn_speed", FAST_JOINT, "in degrees a second"),
            ("tool_speed", FAST_TOOL, "in millimetres a second"),
        ):
            value = getattr(self, name)
            if value is not None:
                unit = _TOOL_UNITS.get(name, "rad/s, or m/s of a slide")
                remark_fast(value, name, unit, most, NO_LIMIT, small)

    def of(self, n: int, names: Sequence[str] | None = None) -> JointLimits:
        """Return the limits of n joints, one number a joint.

        Raises:
            InputError: There are limits for another number of joints; the message names the first one without.
        """
        found: dict[str, Array | None] = {}
        for name in _UNITS:
            value = getattr(self, name)
            if value is None:
                found[name] = None
                continue
            array = np.asarray(value, float)
            if array.ndim and len(array) != n:
                said = f"{len(array)} {'was' if len(array) == 1 else 'were'} given for {plural(n, 'joint')}"
                if len(array) < n:
                    first = names[len(array)] if names is not None else f"joint {len(array) + 1}"
                    said += f"; {first} has none"
                raise InputError(f"{name} needs one number for all joints or one a joint: {said}.", given=len(array))
            found[name] = np.array(np.broadcast_to(array, (n,)))
        speed, acceleration = found["speed"], found["acceleration"]
        assert speed is not None and acceleration is not None
        return JointLimits(speed, acceleration, found["jerk"])

    @property
    def of_the_tool(self) -> bool:
        """Whether the tool has limits of its own."""
        return not (self.tool_speed is None and self.tool_acceleration is None and self.turn_speed is None)


@dataclass(frozen=True, eq=False)
class JointLimits:
    """One number a joint (n,): speed, acceleration, and jerk or None."""

    speed: Array
    acceleration: Array
    jerk: Array | None


def _positive(value: object, what: str) -> Array:
    unit = _UNITS[what]
    if isinstance(value, (list, tuple)):
        for j, item in enumerate(cast("Sequence[object]", value)):
            if item is None:
                raise InputError(f"{what} of joint {j + 1} is missing; say how much, {unit}.", joint=j + 1)
    array: Array = np.array(arguments.numbers(value, what, f"one number or one a joint, {unit}"))
    if array.ndim > 1 or array.size == 0:
        raise InputError(f"{what} must be one number or one a joint, got shape {array.shape}.", given=array.shape)
    bad = ~(np.isfinite(array) & (array > 0))
    if bad.any():
        which = f" of joint {int(np.argmax(bad)) + 1}" if array.ndim else ""
        number = float(array[bad][0] if array.ndim else array)
        cure = "leave it out for none" if what == "jerk" else HELD_JOINT
        if not number <= 0:
            cure = "no limit is said by a large number" if np.isposinf(number) else "say how much"
        raise InputError(
            f"{what}{which} must be finite and more than zero, {unit}, got {number:g}; {cure}.",
            given=number,
            joint=int(np.argmax(bad)) + 1 if array.ndim else None,
        )
    array.setflags(write=False)
    return array


def _positive_number(value: object, what: str) -> float:
    return arguments.number(value, what, f"{_TOOL_UNITS[what]} (left out for none)", above=0.0)
