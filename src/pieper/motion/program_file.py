"""A program as a file of its own (TOML): degrees and millimetres, a step a move, its limits; read and written."""

from __future__ import annotations

import os
import tomllib
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, cast

import numpy as np

from pieper import arguments
from pieper.document.writing import write_whole
from pieper.errors import InputError, PieperError
from pieper.kinematics.arrays import Array
from pieper.kinematics.pose import inverse
from pieper.kinematics.spoken import pose, read_pose
from pieper.motion.instructions import FrameChange, Instruction, Move, Output, ToolChange, Wait
from pieper.motion.limits import HELD_JOINT, Limits
from pieper.motion.program import Program, ProgramArm

#: Decimals of degrees, millimetres and seconds.
DECIMALS = 11

_KINDS = ("move_j", "move_l", "move_c", "move_s", "wait", "output", "gripper", "tool", "frame")
_BESIDE = {
    "move_j": {"speed", "blend"},
    "move_l": {"speed", "blend"},
    "move_c": {"via", "speed", "blend"},
    "move_s": {"speed", "blend"},
}
_JOINT_LIMITS = ("speed", "acceleration", "jerk")
_TOOL_LIMITS = ("tool_speed", "tool_acceleration", "turn_speed")
#: What the numbers of [limits] are in a file.
_UNITS = {
    "speed": "deg/s, mm/s of a slide",
    "acceleration": "deg/s^2, mm/s^2 of a slide",
    "jerk": "deg/s^3, mm/s^3 of a slide",
    "tool_speed": "mm/s",
    "tool_acceleration": "mm/s^2",
    "turn_speed": "deg/s",
}


def save_program(program: Program, path: str | os.PathLike[str]) -> Path:
    """Write a program as TOML, whole or not at all; `load_program` reads it back.

    Joint values and angles in degrees, lengths in mm, poses as x y z roll pitch yaw; speeds of move_j as a part of the
    limits, of the others in mm/s.

    Raises:
        InputError: Another ending than .toml, or a place that cannot be written.
    """
    path = arguments.file_ending(path, (".toml", ""), "a program that pieper reads back")
    lines = [f"# pieper program of {program.plan.name}: degrees, millimetres, seconds", f'arm = "{program.plan.name}"']
    lines += [f"start = {_row(_joints_out(program, program.start))}", "", "[limits]"]
    scale = np.where(program.plan.prismatic, 1e3, 180 / np.pi)
    for name in _JOINT_LIMITS:
        value = getattr(program.limits, name)
        if value is not None:
            lines.append(f"{name} = {_row(np.broadcast_to(value, (program.plan.n,)) * scale)}")
    for name in _TOOL_LIMITS:
        value = getattr(program.limits, name)
        if value is not None:
            lines.append(f"{name} = {_number(value * (180 / np.pi if name == 'turn_speed' else 1e3))}")
    frame = np.eye(4)
    for item in program.instructions:
        if isinstance(item, FrameChange):
            frame = item.T
        lines += ["", "[[step]]", *_step(program, item, inverse(frame))]
    return write_whole(path, "\n".join([*lines, ""]))


def load_program(arm: ProgramArm, path: str | os.PathLike[str]) -> Program:
    """Read a program that `save_program` wrote, or one written by hand in the same form.

    Raises:
        InputError: No such file, no TOML, or a step that is none; the message names file, step and field.
        NoSolutionError: A line of it cannot be followed.
    """
    file = arguments.file(path)
    try:
        data = tomllib.loads(file.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise InputError(f"cannot read {file.name}: {arguments.cause(error)}.", path=path) from None
    unknown = sorted(set(data) - {"arm", "start", "limits", "step"})
    if unknown:
        raise InputError(
            f"{file.name}: {unknown[0]!r} is no field of a program; there are arm, start, limits and step.",
            given=unknown,
        )
    meant = data.get("arm", arm.plan.name)
    if meant != arm.plan.name:
        raise InputError(f"{file.name} is a program of {meant}, not of {arm.plan.name}.", given=meant)
    scale = np.where(arm.plan.prismatic, 0.001, np.pi / 180)
    limits = _limits(data.get("limits"), scale, arm, file.name)
    start = data.get("start")
    begin = (
        start if start is None or isinstance(start, str) else _vector(start, arm.plan.n, f"{file.name}: start") * scale
    )
    with _told_of(file.name):
        program = Program(arm, limits, start=begin)
    steps = data.get("step", [])
    if not isinstance(steps, list):
        raise InputError(f"{file.name}: steps are written as [[step]].", given=type(steps).__name__)
    for number, step in enumerate(cast("list[Any]", steps), 1):
        where = f"{file.name}, step {number}"
        with _told_of(where):
            _add(program, step, scale, where)
    return program


@contextmanager
def _told_of(where: str) -> Generator[None]:
    """Say of what is refused inside where in a file it stands."""
    try:
        yield
    except PieperError as error:
        text = str(error)
        data = cast("dict[str, Any]", error.data)
        raise type(error)(text if text.startswith(where) else f"{where}: {text}", **data) from None


def _add(program: Program, said: Any, scale: Array, where: str) -> None:
    step: dict[str, Any] = cast("dict[str, Any]", said) if isinstance(said, dict) else {}
    kinds = [k for k in _KINDS if k in step]
    if len(kinds) != 1:
        raise InputError(f"{where}: say one of {', '.join(_KINDS)}.", given=kinds)
    kind = kinds[0]
    allowed = _BESIDE.get(kind, set[str]())
    unknown = sorted(set(step) - {kind} - allowed)
    if unknown:
        words = ", ".join(sorted(allowed)) or "nothing else"
        raise InputError(f"{where}: {unknown[0]!r} is no field beside {kind}; allowed is {words}.", given=unknown)
    value = step[kind]
    if kind == "wait":
        program.wait(value)
    elif kind == "gripper":
        program.gripper(value)
    elif kind == "tool":
        program.tool(value if isinstance(value, str) else _pose(value, f"{where}: tool"))
    elif kind == "frame":
        program.frame(_pose(value, f"{where}: frame"))
    elif kind == "output":
        pair = _list(value, f"{where}: output is [port, true] or [port, false]")
        if len(pair) != 2 or not isinstance(pair[1], bool):
            raise InputError(f"{where}: output is [port, true] or [port, false].", given=value)
        program.output(pair[0], pair[1])
    else:
        _move(program, kind, step, scale, where)


def _move(program: Program, kind: str, step: dict[str, Any], scale: Array, where: str) -> None:
    value, speed = step[kind], step.get("speed")
    blend = 0.001 * arguments.number(step.get("blend", 0.0), f"{where}: blend", "a radius, mm", least=0.0)
    if kind == "move_j":
        target = value if isinstance(value, str) else _vector(value, program.plan.n, f"{where}: move_j") * scale
        program.move_j(target, speed=speed, blend=blend)
        return
    v = None if speed is None else 0.001 * arguments.number(speed, f"{where}: speed", "mm/s", above=0.0)
    if kind == "move_l":
        program.move_l(_pose(value, f"{where}: move_l"), speed=v, blend=blend)
    elif kind == "move_c":
        if "via" not in step:
            raise InputError(f"{where}: move_c needs via, a pose on the circle.", given=step)
        via = _pose(step["via"], f"{where}: via")
        program.move_c(via, _pose(value, f"{where}: move_c"), speed=v, blend=blend)
    else:
        rows = [
            _pose(row, f"{where}: pose {k}")
            for k, row in enumerate(_list(value, f"{where}: move_s is a list of poses"), 1)
        ]
        program.move_s(np.array(rows), speed=v, blend=blend)


def _list(value: Any, what: str) -> list[Any]:
    if not isinstance(value, list):
        raise InputError(f"{what}.", given=value)
    return cast("list[Any]", value)


def _limits(said: Any, scale: Array, arm: ProgramArm, name: str) -> Limits:
    if not isinstance(said, dict):
        raise InputError(f"{name} has no [limits]: say speed and acceleration, degrees and mm a second.", given=said)
    given = cast("dict[str, Any]", said)
    unknown = sorted(set(given) - {*_JOINT_LIMITS, *_TOOL_LIMITS})
    if unknown:
        raise InputError(
            f"{name}: {unknown[0]!r} is no limit; there are {', '.join((*_JOINT_LIMITS, *_TOOL_LIMITS))}.",
            given=unknown,
        )
    out: dict[str, Any] = {}
    for key, value in given.items():
        unit = _UNITS[key]
        if key not in _JOINT_LIMITS:
            read = arguments.number(value, f"{name}: {key}", f"{unit} (left out for none)", above=0.0)
            out[key] = read * (np.pi / 180 if key == "turn_speed" else 0.001)
            continue
        many = cast("list[Any]", value) if isinstance(value, list) else [value] * len(scale)
        row = _vector(many, len(scale), f"{name}: {key}")
        for joint, number in zip(arm.plan.names, row.tolist(), strict=True):
            if number <= 0:
                which = f" of {joint}" if isinstance(value, list) else ""
                cure = "leave it out for none" if key == "jerk" else HELD_JOINT
                raise InputError(
                    f"{name}: {key}{which} must be more than zero, {unit}, got {number:g}; {cure}.", given=row
                )
        out[key] = row * scale
    missing = [key for key in ("speed", "acceleration") if key not in given]
    if missing:
        said = f"say one number for all joints or one a joint, {_UNITS[missing[0]]}"
        raise InputError(f"{name}: [limits] has no {missing[0]}: {said}.", missing=missing)
    return Limits(**out)


def _vector(value: Any, count: int, what: str) -> Array:
    try:
        row = np.array(value, dtype=float)
    except (TypeError, ValueError):
        row = np.array(np.nan)
    if row.shape != (count,) or not np.isfinite(row).all():
        raise InputError(f"{what} must be {count} numbers, got {value!r}.", given=value)
    return row


def _pose(value: Any, what: str) -> Array:
    x, y, z, roll, pitch, yaw = _vector(value, 6, f"{what} (x y z in mm, roll pitch yaw in degrees)").tolist()
    return pose(x, y, z, rpy=(roll, pitch, yaw), degrees=True, mm=True)


def _step(program: Program, item: Instruction, seen: Array) -> list[str]:
    """Return the lines of a step; `seen` (4, 4) moves a pose of the base into the work frame."""
    if isinstance(item, (ToolChange, FrameChange)):
        return [f"{'tool' if isinstance(item, ToolChange) else 'frame'} = {_row(_pose_out(item.T))}"]
    if isinstance(item, Wait):
        return [f"wait = {_number(item.seconds)}"]
    if isinstance(item, Output):
        return [f"output = [{item.port}, {str(item.value).lower()}]"]
    if not isinstance(item, Move):
        return [f"gripper = {_number(item.value)}"]
    if item.kind == "move_j":
        lines = [f"move_j = {_row(_joints_out(program, item.q))}"]
    elif item.through is not None:
        lines = [f"move_s = [{', '.join(_row(_pose_out(seen @ T)) for T in item.through)}]"]
    else:
        lines = [f"{item.kind} = {_row(_pose_out(seen @ item.T))}"]
    if item.via is not None:
        lines.append(f"via = {_row(_pose_out(seen @ item.via))}")
    if item.speed is not None:
        lines.append(f"speed = {_number(item.speed * (1.0 if item.kind == 'move_j' else 1e3))}")
    if item.blend:
        lines.append(f"blend = {_number(item.blend * 1e3)}")
    return lines


def _joints_out(program: Program, q: Array) -> Array:
    return np.where(program.plan.prismatic, q * 1e3, np.degrees(q))


def _pose_out(T: Array) -> Array:
    return np.array(read_pose(T, "rpy", degrees=True, mm=True))


def _number(value: float) -> str:
    """Return a number as it is written: rounding noise of degrees and millimetres is left out."""
    return repr(round(float(value), DECIMALS) + 0.0)


def _row(values: Array) -> str:
    return f"[{', '.join(_number(v) for v in values)}]"
