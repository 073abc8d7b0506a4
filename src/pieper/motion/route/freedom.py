"""What a path leaves free: the turn about an axis of the tool, and a tilt of that axis within a cone."""

from __future__ import annotations

import enum
from dataclasses import dataclass

import numpy as np

from pieper import arguments
from pieper.errors import InputError
from pieper.kinematics.arrays import Array
from pieper.kinematics.joints import TURN
from pieper.kinematics.pose import rotation_about
from pieper.tolerances import WHOLE_TURN

#: What `turn` may be beside an interval.
FREE = "free"
#: Columns of an orientation, by name.
_AXES = {"x": 0, "y": 1, "z": 2}


class Verdict(enum.Enum):
    """What is known of a route; the value is a sentence."""

    FOUND = "a continuous route inside the limits was found and looked at between its points"
    IMPOSSIBLE = "nothing that can be reached leads to the end, and what closes it is told"
    UNCERTAIN = "no route was found, and none could be ruled out"


@dataclass(frozen=True)
class Freedom:
    """What of the tool's orientation does not matter.

    Args:
        turn: "free", or an interval (lo, hi) of the turn about the axis, rad; (0, 0) holds it. Within a cone it is the
            last of R_path Rx(a) Ry(b) Rz(turn), z the axis meant: about the axis as it leans.
        cone: By how much the axis may tilt away from where the pose has it, rad.
        axis: The axis of the tool that is meant: "x", "y" or "z".

    Raises:
        InputError: An interval the wrong way round or over a turn, a cone of 90 degrees or more, an unknown axis.
    """

    turn: str | tuple[float, float] = FREE
    cone: float = 0.0
    axis: str = "z"

    def __post_init__(self) -> None:
        arguments.word(self.axis, "axis, the tool's,", _AXES)
        object.__setattr__(self, "cone", _cone(self.cone))
        if isinstance(self.turn, str):
            if self.turn != FREE:
                raise InputError(
                    f'turn must be "free" or an interval (lo, hi), rad, got {self.turn!r}.', given=self.turn
                )
        else:
            object.__setattr__(self, "turn", _interval(self.turn))

    @property
    def interval(self) -> tuple[float, float]:
        """The turn's interval, rad; infinite where it is free."""
        return (-np.inf, np.inf) if isinstance(self.turn, str) else self.turn

    @property
    def turns(self) -> bool:
        """Whether the turn is free to change at all."""
        low, high = self.interval
        return high > low

    @property
    def to_z(self) -> Array:
        """(4, 4) what leads from the tool's frame to one whose z axis is the axis meant."""
        T = np.eye(4)
        if self.axis == "x":
            T[:3, :3] = rotation_about(np.array([0.0, 1.0, 0.0]), np.pi / 2)
        elif self.axis == "y":
            T[:3, :3] = rotation_about(np.array([1.0, 0.0, 0.0]), -np.pi / 2)
        return np.round(T)

    def turned(self, T: Array, turn: Array) -> Array:
        """Return poses T (..., 4, 4) turned by angles (...) about the axis, rad; without the cone."""
        turn = np.asarray(turn, float)
        R = np.zeros((*turn.shape, 4, 4))
        R[..., 3, 3] = 1.0
        R[..., :3, :3] = rotation_about(np.eye(3)[_AXES[self.axis]], turn)
        return T @ R


def _cone(value: object) -> float:
    if isinstance(value, float) and 0.0 <= value < np.pi / 2:
        return value
    cone = arguments.number(value, "cone", "rad", least=0.0)
    if cone >= np.pi / 2:
        raise InputError(f"cone must be less than 90 degrees, rad, got {cone:g}; pi / 180 is a degree.", given=cone)
    return cone


def _interval(value: object) -> tuple[float, float]:
    try:
        low, high = (float(v) for v in value)  # type: ignore[union-attr]
    except (TypeError, ValueError):
        raise InputError(
            f'turn must be "free" or an interval (lo, hi), rad, got {arguments.kind_of(value)}.', given=repr(value)
        ) from None
    if not (np.isfinite(low) and np.isfinite(high)):
        raise InputError(f'turn must be finite, got ({low:g}, {high:g}); turn="free" has no ends.', given=(low, high))
    if low > high:
        raise InputError(
            f"turn must have its lower end first, got ({low:g}, {high:g}); did you mean ({high:g}, {low:g})?",
            given=(low, high),
        )
    if high - low > TURN + WHOLE_TURN:
        raise InputError(
            f'turn spans {np.degrees(high - low):.6g} degrees, at most 360 are told apart; turn="free" has no ends.',
            given=(low, high),
        )
    return low, high


#: What a route has when nothing is said: the pose as it is.
HELD = Freedom(turn=(0.0, 0.0))


def checked_freedom(free: object) -> Freedom:
    """Return what is free, or say that it is none."""
    if free is None:
        return HELD
    if not isinstance(free, Freedom):
        raise InputError(f"free must be a pieper.Freedom, got {type(free).__name__}.", given=repr(free))
    return free
