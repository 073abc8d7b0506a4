"""Targets of a file put into a program, with the speeds, blends and happenings that the file says."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Protocol

import numpy as np

from pieper.description.dh import Description
from pieper.errors import InputError
from pieper.kinematics.arrays import Array, ArrayLike
from pieper.kinematics.forward import fk
from pieper.kinematics.pose import PoseLike
from pieper.motion.chosen import check_arrived, meant
from pieper.motion.dialects.named_joints import order_of
from pieper.motion.dialects.target import Target
from pieper.motion.instructions import Gripper, Happening, Output
from pieper.motion.limits import Limits
from pieper.solver.plan.plan import Plan
from pieper.tolerances import SAME_SOLUTION


class Taker(Protocol):
    """What takes targets: a program."""

    plan: Plan
    description: Description
    limits: Limits
    work: Array

    def move_j(self, target: ArrayLike | str, *, speed: float | None = None, blend: float = 0.0) -> object:
        """Move all joints."""
        ...

    def move_l(self, T: ArrayLike, *, speed: float | None = None, blend: float = 0.0) -> object:
        """Move on a line."""
        ...

    def move_c(self, via: PoseLike | None, T: PoseLike, *, speed: float | None = None, blend: float = 0.0) -> object:
        """Move on a circle."""
        ...

    def tool(self, T: PoseLike | str) -> object:
        """Change the tool."""
        ...

    def wait(self, seconds: float) -> object:
        """Rest."""
        ...

    def output(self, port: int, value: bool) -> object:
        """Set an output."""
        ...

    def gripper(self, value: float) -> object:
        """Set the gripper."""
        ...


def take(program: Taker, targets: Sequence[Target], now: Callable[[], Array]) -> None:
    """Append targets to a program: each with its tool, its speed and blend, and what happens before it.

    Args:
        program: Moves, waits, outputs and changes of the tool are added to it.
        targets: What `read_program` gave.
        now: Returns the posture (n,) the arm is in after what was added.

    Raises:
        InputError: A target without a place, or with configuration words of another maker.
        NoSolutionError: A line of it cannot be followed, or nothing has the words of a target.
    """
    own = program.description.tool
    tool = own
    for number, target in enumerate(targets, 1):
        for item in target.before:
            _happen(program, item)
        # none that is set is the arm's own
        if not target.means_tool(tool) and not (target.tool is None and tool is own):
            tool = own if target.tool is None else target.tool
            program.tool(tool)
        _move(program, target, number, now)
        for item in target.after:
            _happen(program, item)


def _happen(program: Taker, item: Happening) -> None:
    if isinstance(item, Output):
        program.output(item.port, item.value)
    elif isinstance(item, Gripper):
        program.gripper(item.value)
    elif item.seconds > 0:
        program.wait(item.seconds)


def _move(program: Taker, target: Target, number: int, now: Callable[[], Array]) -> None:
    if target.kind == "stay":
        return
    q = target.q
    if q is not None and target.joints:
        q = q[order_of(target.joints, program.plan.names, program.plan.name)]
    where, blend = target.T if q is None else q, target.blend or 0.0
    if where is None:
        raise InputError(f"target {number} of the file has no place.", given=number)
    if target.kind == "point" and np.abs(np.asarray(where) - now()).max(initial=0.0) < SAME_SOLUTION:
        return  # where a motion in time rests, its points repeat
    if target.kind in ("move_j", "point") or (target.kind == "move_c" and target.T is None and target.q_via is None):
        if target.q is None and (target.words is not None or target.near is not None):
            where = meant(program.plan, program.description.manufacturer, program.work @ where, target, number, now())
        program.move_j(where, speed=_share(program, target), blend=blend)
        return
    chain = program.plan.chain
    T = fk(chain, where) if target.T is None else target.T
    speed = target.speed or None
    if target.kind == "move_l":
        program.move_l(T, speed=speed, blend=blend)
    else:
        via = fk(chain, target.q_via) if target.via is None and target.q_via is not None else target.via
        program.move_c(via, T, speed=speed, blend=blend)
    check_arrived(program.plan, program.description.manufacturer, target, number, now())


def _share(program: Taker, target: Target) -> float | None:
    """Return what part of the limits a joint move runs at, the whole at most; None where the file does not say it."""
    said = target.speed
    if target.joint_speed is not None:
        said = target.joint_speed / float(program.limits.of(program.plan.n, program.plan.names).speed.min())
    return min(said, 1.0) if said else None
