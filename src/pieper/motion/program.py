"""A program: moves, waits, outputs and the gripper in order; one timed motion, and files that controllers read."""

from __future__ import annotations

import operator
import os
from dataclasses import replace
from typing import Protocol

import numpy as np

from pieper.description.dh import Description
from pieper.description.posture import posture
from pieper.document.writing import write_whole
from pieper.errors import InputError, NoSolutionError
from pieper.kinematics.arrays import Array, ArrayLike
from pieper.kinematics.forward import checked_joints, fk
from pieper.kinematics.joints import inside
from pieper.kinematics.pose import checked_pose
from pieper.motion.circle import circle
from pieper.motion.instructions import Gripper, Instruction, Move, Output, Wait
from pieper.motion.limits import Limits
from pieper.motion.motion import Motion, Tight
from pieper.motion.runs import Run, runs
from pieper.motion.segments import Segment, segment
from pieper.solver import verbs
from pieper.solver.plan.plan import Plan
from pieper.words_by_number import plural


class ProgramArm(Protocol):
    """What a program needs of an arm."""

    @property
    def plan(self) -> Plan:
        """How it is solved."""
        ...

    @property
    def description(self) -> Description:
        """What it is."""
        ...


class Program:
    """Moves, waits, outputs and the gripper in order.

    Args:
        arm: The arm.
        limits: What its motion must keep.
        start: (n,) posture it begins in, rad or m, or the name of one; all joints at zero when left out.

    Raises:
        InputError: Limits for another arm, or a start that is no posture or outside the limits; the joint is named.
    """

    def __init__(self, arm: ProgramArm, limits: Limits, *, start: ArrayLike | str | None = None) -> None:
        self.plan, self.description, self.limits = arm.plan, arm.description, limits
        limits.of(self.plan.n, self.plan.names)
        q = np.zeros(self.plan.n) if start is None else self._posture(start, "start")
        self.start = q
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
        if isinstance(target, str) or np.shape(target) == (self.plan.n,):
            q = self._posture(target, f"target of move {self._number}")
        else:
            q = self._solution(checked_pose(target, f"target of move {self._number}"))
        share = None if speed is None else _number(speed, "speed", "a part of the joints' limits, at most 1", most=1.0)
        return self._add(Move("move_j", q, fk(self.plan.chain, q), share, _radius(blend)))

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
        pose = checked_pose(T, f"target of move {self._number}")
        return self._line("move_l", pose, None, speed, blend)

    def move_c(self, via: ArrayLike, T: ArrayLike, *, speed: float | None = None, blend: float = 0.0) -> Program:
        """Move the tool on a circle over the point of a pose to another pose; the orientation goes from end to end.

        Args:
            via: A pose (4, 4) on the circle; its orientation is not used.
            T: The target.
            speed: The tool's speed, m/s.
            blend: As in `move_j`.

        Raises:
            InputError: No poses, or points that make no circle.
            NoSolutionError: The circle cannot be followed.
        """
        over, pose = checked_pose(via, "via"), checked_pose(T, f"target of move {self._number}")
        circle(self._pose, over, pose, np.zeros(1))
        return self._line("move_c", pose, over, speed, blend)

    def wait(self, seconds: float) -> Program:
        """Rest for some seconds."""
        self.instructions.append(Wait(_number(seconds, "wait", "seconds")))
        return self

    def output(self, port: int, value: bool) -> Program:
        """Set a digital output; the arm does not stop for it."""
        try:
            number = -1 if isinstance(port, bool) else operator.index(port)
        except TypeError:
            number = -1
        if number < 0:
            raise InputError(f"an output's port must be a whole number from 0, got {port!r}.", given=port)
        self.instructions.append(Output(number, bool(value)))
        return self

    def gripper(self, value: float) -> Program:
        """Set the gripper, 0 open to 1 closed; the arm does not stop for it: write a wait where it must."""
        number = float(value)
        if not 0 <= number <= 1:
            raise InputError(f"the gripper goes from 0 (open) to 1 (closed), got {number:g}.", given=number)
        self.instructions.append(Gripper(number))
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
        if self._known is None or self._known[:2] != (len(self.instructions), rate):
            self._known = len(self.instructions), rate, self._motion(rate)
        return self._known[2]

    def _motion(self, rate: float) -> Motion:
        pieces: list[Motion] = []
        events: list[tuple[float, str, object]] = []
        remarks: list[str] = []
        now, number, k = 0.0, 0, 0
        items = self.instructions
        while k < len(items):
            item = items[k]
            if isinstance(item, Wait):
                pieces.append(self._rest(item.seconds, pieces))
                events.append((now, "wait", item.seconds))
                now += item.seconds
                k += 1
            elif isinstance(item, Move):
                end = k
                while end < len(items) and not isinstance(items[end], Wait):
                    end += 1
                ways = [
                    (number + i, self._segments[number + i - 1])
                    for i in range(1, 1 + sum(isinstance(x, Move) for x in items[k:end]))
                ]
                passed: list[float] = []
                for run in runs(self.plan, self.limits, ways, rate):
                    passed += [now + t for t in run.passed]
                    now = _take(run, now, pieces, remarks)
                at = -1
                for x in items[k:end]:
                    if isinstance(x, Move):
                        at += 1
                    else:
                        events.append(_event(passed[at], x))
                number += len(ways)
                k = end
            else:
                events.append(_event(now, item))
                k += 1
        if not pieces:
            pieces.append(self._rest(0.0, pieces))
        return _together(pieces, events, remarks)

    def explain(self) -> str:
        """Return the program as sentences: each move with its time, and what is not as asked."""
        known = self._known
        motion = known[2] if known is not None and known[0] == len(self.instructions) else self.motion()
        lines = [f"{len(self.moves)} moves of {self.plan.name}, {motion.duration:.3f} s in all."]
        words = {"move_j": "joints to", "move_l": "line to", "move_c": "circle to"}
        number = 0
        for item in self.instructions:
            if isinstance(item, Move):
                number += 1
                x, y, z = item.T[:3, 3] * 1e3
                corner = f", blend {item.blend * 1e3:g} mm" if item.blend else ""
                lines.append(f"{number}. {words[item.kind]} x {x:.1f}, y {y:.1f}, z {z:.1f} mm{corner}")
            elif isinstance(item, Wait):
                lines.append(f"   wait {item.seconds:g} s")
            elif isinstance(item, Output):
                lines.append(f"   output {item.port} {'on' if item.value else 'off'}")
            else:
                lines.append(f"   gripper {item.value:g}")
        strays = max((way.strays for way in self._segments), default=0.0)
        kept = f"lines and circles are kept to {strays * 1e6:.2g} um"
        lines.append(f"The largest value over its limit is {motion.margin:.6f}; {kept}.")
        return "\n".join([*lines, *motion.remarks])

    def write(
        self,
        path: str | os.PathLike[str],
        *,
        dialect: str,
        name: str | None = None,
        cartesian: bool = False,
        rate: float = 100.0,
    ) -> None:
        """Write the program for a controller, whole or not at all.

        Joint moves go to joint values, lines and circles to joint values where the language takes them and to poses
        with configuration words where not.

        Args:
            path: Where to.
            dialect: "rapid", "urscript", "krl", "fanuc-ls", "inform", "pacscript", "ros" or "csv".
            name: Its name; the file's without its ending when left out.
            cartesian: Whether all moves go to poses with the maker's configuration words.
            rate: Samples a second of "ros" and "csv".

        Raises:
            InputError: The dialect is unknown, the arm is of another maker, or the name is not one the maker takes.
        """
        from pieper.motion.dialects.dialect import Script
        from pieper.motion.dialects.files import text_of

        called = os.path.splitext(os.path.basename(path))[0] if name is None else name
        script = Script(
            called,
            tuple(self.instructions),
            self.plan,
            self.description,
            self.limits,
            self.start,
            cartesian,
            lambda: self.motion(rate=rate),
        )
        write_whole(path, text_of(script, dialect))

    @property
    def _number(self) -> int:
        return len(self._segments) + 1

    def _add(self, move: Move) -> Program:
        way = segment(self.plan, self._number, self._q, self._pose, move)
        self._segments.append(way)
        self.instructions.append(move)
        self._q, self._pose = move.q, move.T
        return self

    def _line(self, kind: str, T: Array, via: Array | None, speed: float | None, blend: float) -> Program:
        v = None if speed is None else _number(speed, "speed", "m/s")
        move = Move(kind, self._q, T, v, _radius(blend), via)
        way = segment(self.plan, self._number, self._q, self._pose, move)
        q, middle = way.curve.end, way.curve.at(np.array([0.5]))[0][0]
        if via is not None:
            # where the circle passes the via
            s = np.linspace(0, 1, 401)
            p = circle(self._pose, via, T, s)[:, :3, 3]
            middle = way.curve.at(s[[np.argmin(np.linalg.norm(p - via[:3, 3], axis=1))]])[0][0]
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
            low, high = self.plan.limits[j]
            name = self.plan.names[j]
            raise InputError(
                f"{what} is outside the limits: {name} is {joints[j]:.6g}, allowed is {low:.6g} to {high:.6g}.",
                joint=name,
            )
        return np.array(joints)

    def _solution(self, T: Array) -> Array:
        try:
            return verbs.ik(self.plan, T).nearest(self._q)
        except NoSolutionError as error:
            raise NoSolutionError(f"move {self._number} has no posture: {error}", move=self._number) from None

    def _rest(self, seconds: float, before: list[Motion]) -> Motion:
        q = before[-1].q[-1:] if before else self.start[None]
        t = np.array([0.0, seconds])
        zeros = np.zeros((2, self.plan.n))
        return Motion(t, np.repeat(q, 2, 0), zeros, zeros, t, t, zeros, np.zeros(2))


def _take(run: Run, now: float, pieces: list[Motion], remarks: list[str]) -> float:
    pieces.append(run.motion)
    remarks += run.remarks
    return now + run.motion.duration


def _event(time: float, item: Instruction) -> tuple[float, str, object]:
    if isinstance(item, Output):
        return time, "output", (item.port, item.value)
    assert isinstance(item, Gripper)
    return time, "gripper", item.value


def _together(pieces: list[Motion], events: list[tuple[float, str, object]], remarks: list[str]) -> Motion:
    """Return motions one after the other as one."""
    begins = np.concatenate([[0.0], np.cumsum([p.duration for p in pieces])])
    tight = [
        Tight(t.start + b, t.end + b, t.limit, t.joint) for p, b in zip(pieces, begins, strict=False) for t in p.tight
    ]

    def joined(name: str) -> Array:
        parts: list[Array] = []
        for i, p in enumerate(pieces):
            # where two meet, the sample is said once
            value = getattr(p, name)
            if name == "t":
                value = value + begins[i]
            elif name == "s":
                value = (value + i) / len(pieces)
            parts.append(value if i == 0 else value[1:])
        return np.concatenate(parts)

    t, q, dq, ddq, dddq, s = (joined(name) for name in ("t", "q", "dq", "ddq", "dddq", "s"))
    s[-1] = 1.0
    margin = max(p.margin for p in pieces)
    deviation = max(p.deviation for p in pieces)
    order = tuple(sorted(events, key=lambda event: event[0]))
    return Motion(t, q, dq, ddq, begins, begins, dddq, s, tuple(tight), margin, order, tuple(remarks), deviation)


def _number(value: object, what: str, unit: str, most: float = np.inf) -> float:
    try:
        number = float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError):
        raise InputError(f"{what} must be a number, {unit}, got {value!r}.", given=value) from None
    if not (np.isfinite(number) and 0 < number <= most):
        raise InputError(f"{what} must be more than zero, {unit}, got {number:g}.", given=number)
    return number


def _radius(value: object) -> float:
    try:
        number = float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError):
        raise InputError(f"blend must be a radius, m, got {value!r}.", given=value) from None
    if not (np.isfinite(number) and number >= 0):
        raise InputError(f"blend must be a radius of zero or more, m, got {number:g}.", given=number)
    return number
