"""What a program is made of: moves to targets, waits, outputs, the gripper, changes of the tool and the work frame."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from pieper.kinematics.arrays import Array


@dataclass(frozen=True, eq=False)
class Move:
    """A move to a target.

    Attributes:
        kind: "move_j" (joints in proportion), "move_l" (straight line), "move_c" (circle) or "move_s" (spline).
        q: (n,) posture at the target, rad or m.
        T: (4, 4) pose of the target, base to tool, m.
        speed: Part of the joints' speed limits for move_j; the tool's speed for the others, m/s. None: the limits' own.
        blend: Radius round the target within which the corner is cut, m; 0 stops there.
        via: (4, 4) pose on the way of a circle, or None.
        q_via: (n,) posture there, or None.
        through: (k, 4, 4) poses a spline goes through, the last one T, or None.
    """

    kind: str
    q: Array
    T: Array
    speed: float | None = None
    blend: float = 0.0
    via: Array | None = None
    q_via: Array | None = None
    through: Array | None = None


@dataclass(frozen=True)
class Wait:
    """A rest, s."""

    seconds: float


@dataclass(frozen=True)
class Output:
    """A digital output set to a value."""

    port: int
    value: bool


@dataclass(frozen=True)
class Gripper:
    """The gripper set to a value: 0 open to 1 closed."""

    value: float


@dataclass(frozen=True, eq=False)
class ToolChange:
    """Another tool (4, 4), in the last frame of the arm's table, m, from here on."""

    T: Array


@dataclass(frozen=True, eq=False)
class FrameChange:
    """Another work frame (4, 4), in the base, m, in which targets are said from here on."""

    T: Array


Happening = Wait | Output | Gripper
Instruction = Move | Happening | ToolChange | FrameChange


@dataclass(frozen=True)
class Events:
    """How a language says what is no move.

    Attributes:
        wait: Takes a rest's seconds.
        output: Takes a port and its value.
        gripper: Takes the gripper's value.
    """

    wait: Callable[[float], str]
    output: Callable[[int, bool], str]
    gripper: Callable[[float], str]

    def said(self, item: Happening) -> str:
        """Return an instruction as it is said."""
        if isinstance(item, Wait):
            return self.wait(item.seconds)
        return self.output(item.port, item.value) if isinstance(item, Output) else self.gripper(item.value)
