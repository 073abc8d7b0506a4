"""A program: moves, waits, outputs, gripper, tools and frames in order; one timed motion, and files for controllers."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from typing import Protocol, runtime_checkable

import numpy as np

from pieper import arguments
from pieper.description.dh import Description
from pieper.description.posture import posture
from pieper.document.writing import write_whole
from pieper.errors import InputError, NoSolutionError
from pieper.kinematics.arrays import Array, ArrayLike
from pieper.kinematics.forward import checked_joints, fk
from pieper.kinematics.joints import inside
from pieper.kinematics.pose import PoseLike, as_pose, checked_pose
from pieper.motion.circle import circle, round_of, via_about
from pieper.motion.dialects.target import Target
from pieper.motion.instructions import FrameChange, Gripper, Instruction, Move, Output, ToolChange, Wait
from pieper.motion.joined import positive, radius
from pieper.motion.limits import SAY_LIMITS, Limits
from pieper.motion.motion import Motion
from pieper.motion.path import checked_path
from pieper.motion.program_motion import motion_of_program
from pieper.motion.program_words import told
from pieper.motion.segments import Segment, segment
from pieper.motion.spline import spline
from pieper.motion.taken import take
from pieper.solver import verbs
from pieper.solver.plan.plan import Plan
from pieper.words_by_number import plural


@runtime_checkable
class ProgramArm(Protocol):
    """What a program needs of an arm."""

    def with_tool(self, tool: PoseLike | str) -> ProgramArm:
        """Return it with another tool."""
        ...

    @property
    def plan(self) -> Plan:
        """How it is solved."""
        ...

    @property
    def description(self) -> Description:
        """What it is."""
        ...


class Program:
    """Moves, waits, outputs, the gripper, changes of the tool and the work frame, in order.

    Args:
        arm: The arm.
        limits: What its motion must keep.
        start: (n,) posture it begins in, rad or m, or the name of one; all joints at zero when left out.

    Raises:
        InputError: Limits for another arm, or a start that is no posture or outside the limits; the joint is named.
    """

    def __init__(self, arm: ProgramArm, limits: Limits, *, start: ArrayLike | str | None = None) -> None:
        arguments.like(ProgramArm, arm, "arm", "a pieper.Arm (of a Cell: cell.whole)")
        arguments.a(Limits, limits, "limits", SAY_LIMITS)
        self.plan, self.description, self.limits = arm.plan, arm.description, limits
        self._arm = arm
        limits.of(self.plan.n, self.plan.names)
        q = np.zeros(self.plan.n) if start is None else self._posture(start, "start")
        self.start, self.work, self._tool = q, np.eye(4), arm.description.tool
        self.instructions: list[Instruction] = []
        self._q, self._pose = q, fk(self.plan.chain, q)
        self._segments: list[Segment] = []
        self._known: tuple[int, float, Motion] | None = None

    def __repr__(self) -> str:
        return f"<Program of {self.plan.name}: {plural(len(self.instructions), 'instruction')}>"

    def move_j(self, target: ArrayLike | str, *, speed: float | None = None, blend: float = 0.0) -> Program:
        """Move all joints in proportion to a posture (n,), or to the solution of a pose (4, 4) nearest to the last one.

        Args:
            target: Joint vector, a posture's name, or a pose.
            speed: Part of the joints' speed limits, above 0 to 1.
            blend: Radius within which the corner at the target is cut, m; 0 stops there.

        Raises:
            InputError: No posture or pose, outside the limits, or where the arm is already.
            NoSolutionError: The pose has no solution inside the limits.
        """
        target = target if isinstance(target, str) else as_pose(target)
        if isinstance(target, str) or arguments.numbers(target, f"target of move {self._number}").shape == (
            self.plan.n,
        ):
            q = self._posture(target, f"target of move {self._number}")
        else:
            q = self._solution(self._target(target))
        share = None if speed is None else positive(speed, "speed", "a part of the joints' limits", most=1.0)
        return self._add(Move("move_j", q, fk(self.plan.chain, q), share, radius(blend)))

    def move_l(self, T: ArrayLike, *, speed: float | None = None, blend: float = 0.0) -> Program:
        """Move the tool on a straight line to a pose (4, 4), turning it evenly about one axis.

        Args:
            T: The target, base to tool, m.
            speed: The tool's speed, m/s.
            blend: As in `move_j`.

        Raises:
            InputError: No pose, or the tool is there already.
            NoSolutionError: The line cannot be followed; the message says where and why.
        """
        pose = self._target(T)
        return self._line("move_l", pose, None, speed, blend)

    def move_c(
        self,
        via: PoseLike | None,
        T: PoseLike,
        *,
        centre: ArrayLike | None = None,
        the_long_way: bool = False,
        speed: float | None = None,
        blend: float = 0.0,
    ) -> Program:
        """Move the tool on a circle to a pose; the orientation goes from end to end.

        Args:
            via: A pose (4, 4) on the circle, whose orientation is not used; or None, and the centre is said.
            T: The target.
            centre: (3,) the circle's centre, m, instead of a via.
            the_long_way: With a centre: round the other side.
            speed: The tool's speed, m/s.
            blend: As in `move_j`.

        Raises:
            InputError: No poses, points that make no circle, a via and a centre, or a centre that is not equally far
                from both ends or in line with them.
            NoSolutionError: The circle cannot be followed.
        """
        pose = self._target(T)
        if via is not None and centre is None:
            over = self.work @ checked_pose(via, "via")
        elif via is None and centre is not None:
            over = via_about(self._pose, pose, self._point(centre), the_long_way=the_long_way)
        else:
            raise InputError("a circle needs a via or a centre: say one of both.", via=via, centre=centre)
        circle(self._pose, over, pose, np.zeros(1))
        return self._line("move_c", pose, over, speed, blend)

    def move_s(self, Ts: PoseLike, *, speed: float | None = None, blend: float = 0.0) -> Program:
        """Move the tool on a smooth curve through poses, the last one its target.

        The curve is twice continuously differentiable in position and orientation and goes through every pose.

        Args:
            Ts: (k, 4, 4) taught poses, two or more, m.
            speed: The tool's speed, m/s.
            blend: As in `move_j`.

        Raises:
            InputError: Fewer than two poses, or two equal ones in a row.
            NoSolutionError: The curve cannot be followed.
        """
        through = self.work @ checked_path(Ts)
        spline(self._pose, through, np.zeros(1))
        return self._line("move_s", through[-1], None, speed, blend, through)

    def tool(self, T: PoseLike | str) -> Program:
        """Take another tool from here on; the arm rests where it changes.

        Args:
            T: (4, 4) in the last frame of the arm's table, m, or the name of one of the arm's tools. What the targets
                that follow say is where this tool goes.

        Raises:
            InputError: No pose, or no tool of that name.
            PlanError: The arm cannot be solved with it.
        """
        # frames and tools are changed on the arm as it was given: a tool does not stand on the one before
        arm = self._arm.with_tool(T)
        if not np.array_equal(arm.description.tool, self._tool):
            self.plan, self._tool = arm.plan, arm.description.tool
            self._pose = fk(self.plan.chain, self._q)
            self.instructions.append(ToolChange(self._tool))
        return self

    def frame(self, T: PoseLike) -> Program:
        """Take the targets that follow as poses in a work frame (4, 4) in the base; `frame(numpy.eye(4))` ends that."""
        work = checked_pose(T, "frame")
        if not np.array_equal(work, self.work):
            self.work = work
            self.instructions.append(FrameChange(work))
        return self

    def call(self, other: Program, *, times: int = 1) -> Program:
        """Do what another program of the same arm does, so many times; its own start is not gone to.

        It is done with its own tools and in its own frames; those of this program hold again behind it.

        Raises:
            InputError: A program of another arm, or a count that is no whole number from 1.
            NoSolutionError: A line of it cannot be followed from where the arm is.
        """
        arguments.a(Program, other, "the program to call", "make one with pieper.Program(arm, limits)")
        if other.plan.n != self.plan.n or other.plan.name != self.plan.name:
            raise InputError(
                f"{other.plan.name}'s program cannot be called by {self.plan.name}'s.", given=other.plan.name
            )
        arguments.whole(times, "times", 1)
        items = list(other.instructions)
        kept = self._tool, self.work
        for _ in range(times):
            self.tool(other.description.tool).frame(np.eye(4))
            for item in items:
                self._repeat(item)
        return self.tool(kept[0]).frame(kept[1])

    def _repeat(self, item: Instruction) -> None:
        if isinstance(item, ToolChange):
            self.tool(item.T)
        elif isinstance(item, FrameChange):
            self.frame(item.T)
        elif not isinstance(item, Move):
            self.instructions.append(item)
        elif item.kind == "move_j":
            self.move_j(item.q, speed=item.speed, blend=item.blend)
        else:
            self._line(item.kind, item.T, item.via, item.speed, item.blend, item.through)

    def wait(self, seconds: float) -> Program:
        """Rest for some seconds."""
        self.instructions.append(Wait(positive(seconds, "wait", "seconds")))
        return self

    def output(self, port: int, value: bool) -> Program:
        """Set a digital output; the arm does not stop for it."""
        number = arguments.whole(port, "an output's port", 0)
        arguments.like((bool, int, float, np.bool_, np.number), value, "an output", "True or False")
        self.instructions.append(Output(number, bool(value)))
        return self

    def gripper(self, value: float) -> Program:
        """Set the gripper, 0 open to 1 closed; the arm does not stop for it: write a wait where it must."""
        number = arguments.number(value, "the gripper, 0 open to 1 closed,", least=0.0, most=1.0)
        self.instructions.append(Gripper(number))
        return self

    def take(self, targets: Sequence[Target]) -> Program:
        """Append targets of `pieper.read_program`: tools, postures, speeds, blends and events as their file says."""
        take(self, targets, lambda: self._q)
        return self

    @property
    def moves(self) -> list[Move]:
        """The moves alone, in order."""
        return [item for item in self.instructions if isinstance(item, Move)]

    def motion(self, *, rate: float = 500.0) -> Motion:
        """Return all of it as one timed motion with its events.

        An output or the gripper between two moves happens at the target of the move before: when it is reached, or
        where its corner is blended when the middle of the blend is passed. A wait stops.

        Args:
            rate: Samples a second.
        """
        arguments.number(rate, "rate", "samples a second", above=0.0)
        if self._known is None or self._known[:2] != (len(self.instructions), rate):
            whole = motion_of_program(self.instructions, self._segments, self.start, self.limits, rate)
            described = replace(whole, limits=self.limits, description=self.description)
            self._known = len(self.instructions), rate, described
        return self._known[2]

    def explain(self) -> str:
        """Return the program as sentences: each move with its time, and what is not as asked."""
        known = self._known
        motion = known[2] if known is not None and known[0] == len(self.instructions) else self.motion()
        strays = max((way.strays for way in self._segments), default=0.0)
        return told(self.plan.name, self.instructions, motion, strays)

    def write(
        self,
        path: str | os.PathLike[str],
        *,
        dialect: str | None = None,
        name: str | None = None,
        cartesian: bool = False,
        rate: float = 100.0,
    ) -> None:
        """Write the program for a controller, whole or not at all.

        Joint moves go to joint values, lines and circles to joint values where the language takes them and to poses
        with configuration words where not. A circle of half a turn or more is written as several shorter ones.

        Args:
            path: Where to.
            dialect: "rapid", "urscript", "krl", "fanuc-ls", "inform", "pacscript", "ros" or "csv"; by the
                file's ending when left out.
            name: Its name; the file's without its ending when left out.
            cartesian: Whether all moves go to poses with the maker's configuration words.
            rate: Samples a second of "ros" and "csv".

        Raises:
            InputError: The dialect is unknown, the arm is of another maker, or the name is not one the maker takes.
        """
        from pieper.motion.dialects.circles import in_pieces
        from pieper.motion.dialects.dialect import Script
        from pieper.motion.dialects.files import check_splines, dialect_of, text_of

        target = arguments.file(path)
        dialect = dialect_of(target) if dialect is None else dialect
        check_splines(self.moves, dialect)
        called = target.stem if name is None else arguments.text(name, "name")
        script = Script(
            called,
            in_pieces(self.instructions, self._segments),
            self.plan,
            self.description,
            self.limits,
            self.start,
            cartesian,
            lambda: self.motion(rate=rate),
        )
        write_whole(target, text_of(script, dialect))

    @property
    def _number(self) -> int:
        return len(self._segments) + 1

    def _add(self, move: Move) -> Program:
        way = segment(self.plan, self._number, self._q, self._pose, move)
        self._segments.append(way)
        self.instructions.append(move)
        self._q, self._pose = move.q, move.T
        return self

    def _target(self, T: PoseLike) -> Array:
        return self.work @ checked_pose(T, f"target of move {self._number}")

    def _point(self, p: ArrayLike) -> Array:
        point = arguments.numbers(p, "centre", "a point (3,), m")
        if point.shape != (3,) or not np.isfinite(point).all():
            raise InputError(f"centre must be a point (3,), m, got {p!r}.", given=p)
        return self.work[:3, :3] @ point + self.work[:3, 3]

    def _line(
        self, kind: str, T: Array, via: Array | None, speed: float | None, blend: float, through: Array | None = None
    ) -> Program:
        v = None if speed is None else positive(speed, "speed", "m/s")
        move = Move(kind, self._q, T, v, radius(blend), via, through=through)
        way = segment(self.plan, self._number, self._q, self._pose, move)
        q, middle = way.curve.end, way.curve.at(np.array([0.5]))[0][0]
        if via is not None:
            # where the circle passes the via
            middle = way.curve.at(np.array([round_of(self._pose, via, T).part(via[:3, 3])]))[0][0]
        move = replace(move, q=q, q_via=None if via is None else middle)
        self._segments.append(replace(way, move=move))
        self.instructions.append(move)
        # an arm that holds a part of a pose alone is where its joints are
        self._q, self._pose = q, T if self.plan.task == "pose" else fk(self.plan.chain, q)
        return self

    def _posture(self, q: ArrayLike | str, what: str) -> Array:
        if isinstance(q, str):
            q = posture(self.description, q, what)
        joints = checked_joints(q, self.plan.n, what, self.plan.prismatic)
        if joints.ndim != 1:
            raise InputError(
                f"{what} must be one joint vector ({self.plan.n},), got {joints.shape}.", given=joints.shape
            )
        outside = ~inside(joints, self.plan.limits)
        if outside.any():
            j = int(np.argmax(outside))
            scale, unit = (1e3, "mm") if self.plan.prismatic[j] else (180 / np.pi, "deg")
            low, high = self.plan.limits[j] * scale
            name = self.plan.names[j]
            raise InputError(
                f"{what} is outside the limits: {name} is at {joints[j] * scale:.6g} {unit}, allowed is {low:.6g} to "
                f"{high:.6g} {unit}.",
                joint=name,
            )
        return np.array(joints)

    def _solution(self, T: Array) -> Array:
        try:
            return verbs.ik(self.plan, T).nearest(self._q)
        except NoSolutionError as error:
            raise NoSolutionError(f"move {self._number} has no posture: {error}", move=self._number) from None
