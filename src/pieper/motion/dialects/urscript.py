"""Universal Robots' URScript: joint values for every move, or poses."""

from __future__ import annotations

import re

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.kinematics.spoken import pose, read_pose
from pieper.motion.dialects.dialect import Dialect, Script, Setup, Target, fixed, found, listed, numbers
from pieper.motion.dialects.manner import NUMBER, Happenings, Manner, without_comments
from pieper.motion.dialects.reserved import URSCRIPT
from pieper.motion.instructions import Events, FrameChange, Happening, Move, ToolChange

#: Acceleration of the tool that is written where none is limited, m/s^2: the language's own default.
_TOOL_ACCELERATION = 1.2


_EVENTS = Events(
    wait=lambda seconds: f"sleep({fixed(seconds, 3)})",
    output=lambda port, value: f"set_standard_digital_out({port}, {value})",
    gripper=lambda value: f"# gripper {value:g}",
)


def write(script: Script) -> str:
    """Return the text of a script with one function and its call."""
    bound = script.limits.of(script.plan.n, script.plan.names)
    tool = script.limits.tool_acceleration or _TOOL_ACCELERATION
    body = [f"set_tcp({_pose(script.description.tool)})"]
    for k, T in script.setups()[1].items():
        body.append(f"frame_{k} = {_pose(T)}")
    for item, now in script.steps():
        if isinstance(item, ToolChange):
            body.append(f"set_tcp({_pose(now.tool)})")
        elif isinstance(item, FrameChange):
            body.append(f"# targets in {_frame(now) or 'the base'}")
        elif not isinstance(item, Move):
            body.append(_EVENTS.said(item))
        elif item.kind == "move_j":
            v = float(bound.speed.min()) * (1.0 if item.speed is None else item.speed)
            a = float(bound.acceleration.min())
            target = _near(item.T, item.q, _frame(now)) if script.cartesian else _joints(item.q)
            body.append(f"movej({target}, a={fixed(a, 4)}, v={fixed(v, 4)}, r={fixed(item.blend, 5)})")
        else:
            said = f"a={fixed(tool, 4)}, v={fixed(script.line_speed(item), 4)}, r={fixed(item.blend, 5)})"
            target = _pose(item.T, _frame(now)) if script.cartesian else _joints(item.q)
            if item.via is not None and item.q_via is not None:
                via = _pose(item.via, _frame(now)) if script.cartesian else _joints(item.q_via)
                body.append(f"movec({via}, {target}, {said}")
            else:
                body.append(f"movel({target}, {said}")
    lines = [
        f"def {script.name}():",
        *("  " + line for line in script.head("#", shares=False)),
        *("  " + line for line in body),
    ]
    return "\n".join([*lines, "end", f"{script.name}()", ""])


def _joints(q: Array) -> str:
    return f"[{numbers([float(v) for v in q], 8, ', ')}]"


def _frame(now: Setup) -> str:
    return f"frame_{now.frame_number}" if now.frame_number else ""


def _pose(T: Array, frame: str = "") -> str:
    """Return a pose; one that stands in a frame is moved into the base, for the language has no active frame."""
    said = f"p[{numbers(read_pose(T, 'rotvec'), 8, ', ')}]"
    return f"pose_trans({frame}, {said})" if frame else said


def _near(T: Array, q: Array, frame: str) -> str:
    return f"get_inverse_kin({_pose(T, frame)}, qnear={_joints(q)})"


def read(text: str) -> list[Target]:
    """Return the targets of a script, in the order of its moves."""
    text = without_comments(text, r"#.*")
    out: list[Target] = []
    frames: dict[str, Array] = {}
    tool: Array | None = None
    for m in re.finditer(r"\b(movej|movel|movec|set_tcp|frame_\d+ =)\s*\(?(.*?)\)?$", text, re.M):
        if not m[1].startswith("move"):
            here = _place("p", found(m[2], 6))[1]
            if m[1] == "set_tcp":
                tool = here
            elif here is not None:
                frames[m[1].split()[0]] = here
            continue
        frame = re.search(r"pose_trans\((\w+)", m[2])
        under = tool, None if frame is None else frames[frame[1]]
        said = re.findall(r"(p?)\[([^\]]*)\]", m[2])
        values = [(mark, found(numbers_, 6)) for mark, numbers_ in said]
        kind = {"movej": "move_j", "movel": "move_l", "movec": "move_c"}[m[1]]
        places = [_place(mark, v) for mark, v in values]
        if kind == "move_c":
            (q_via, via), (q, T) = places[:2]
            out.append(Target(kind, q, T, via, q_via, place=m.start()).under(*under))
        else:
            near = places[1][0] if len(places) > 1 else None
            out.append(Target(kind, *places[0], near=near, place=m.start()).under(*under))
    return out


def _place(mark: str, v: list[float]) -> tuple[Array | None, Array | None]:
    return (None, pose(*v[:3], rotvec=v[3:])) if mark else (np.array(v), None)


_HAPPENINGS = Happenings(
    wait=rf"sleep\(({NUMBER})\)",
    output=r"set_standard_digital_out\((?P<port>\d+), (?:(?P<on>True)|False)\)",
    comment="#",
)


def _said(line: str, state: dict[str, float]) -> Manner | Happening | None:
    del state
    if m := re.match(r"(movej|movel|movec)\(", line):
        said = {name: float(value) for name, value in re.findall(rf"\b([vrt])=({NUMBER})", line)}
        v, r = said.get("v"), said.get("r")
        return Manner(blend=r, joint_speed=v) if m[1] == "movej" else Manner(speed=v, blend=r)
    return _HAPPENINGS.read(line)


_POSE = rf"(?:p\[{listed(6)}\]|pose_trans\(frame_\d+, p\[{listed(6)}\]\))"
_TARGET = rf"(?:\[{listed(6)}\]|{_POSE}|get_inverse_kin\({_POSE}, qnear=\[{listed(6)}\]\))"
_WORD = r"[A-Za-z]\w*"
_LINES = (
    r"#.*",
    rf"def {_WORD}\(\):|end|{_WORD}\(\)",
    rf"set_tcp\(p\[{listed(6)}\]\)|frame_\d+ = p\[{listed(6)}\]",
    rf"(?:movej|movel)\({_TARGET}(?:, [avrt]={NUMBER})*\)",
    rf"movec\({_TARGET}, {_TARGET}(?:, [avr]={NUMBER})*\)",
    rf"sleep\({NUMBER}\)|set_standard_digital_out\(\d+, (?:True|False)\)",
)
DIALECT = Dialect(
    "urscript", (".script", ".urscript"), "ur", 64, write, read, _LINES, _said, URSCRIPT, exact_words=True
)
