"""ABB RAPID: joint targets for joint moves, robtargets with confdata for lines and circles."""

from __future__ import annotations

import re

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.kinematics.spoken import pose, read_pose
from pieper.motion.dialects.dialect import Dialect, Script, Target, fixed, found, known_one, numbers
from pieper.motion.dialects.manner import NUMBER, Happenings, Manner, without_comments
from pieper.motion.dialects.reserved import RAPID
from pieper.motion.dialects.target import Words
from pieper.motion.instructions import Events, FrameChange, Happening, Move, ToolChange

#: Speed of the tool's point that leaves a joint move its full speed, m/s: the language's own `vmax` for most arms.
_FULL_SPEED = 7.0
_NO_AXES = "[9E9,9E9,9E9,9E9,9E9,9E9]"


_EVENTS = Events(
    wait=lambda seconds: f"WaitTime {fixed(seconds, 3)};",
    output=lambda port, value: f"SetDO do{port},{int(value)};",
    gripper=lambda value: f"! gripper {value:g}",
)


def write(script: Script) -> str:
    """Return the text of a module."""
    data: list[str] = []
    body: list[str] = []
    number = 0
    for item, now in script.steps():
        if isinstance(item, Move):
            number += 1
            data += _data(script, number, item)
            tool = _tool(now.tool_number)
            if now.frame_number and (item.kind != "move_j" or script.cartesian):
                tool += f"\\WObj:=wPieper{now.frame_number}"
            zone = f"zp{number}" if item.blend else "fine"
            if item.kind == "move_j" and not script.cartesian:
                body.append(f"MoveAbsJ jp{number},vp{number},{zone},{tool};")
            elif item.kind == "move_c":
                body.append(f"MoveC pv{number},p{number},vp{number},{zone},{tool};")
            else:
                body.append(f"{'MoveJ' if item.kind == 'move_j' else 'MoveL'} p{number},vp{number},{zone},{tool};")
        elif not isinstance(item, (ToolChange, FrameChange)):
            body.append(_EVENTS.said(item))
    lines = [f"MODULE {script.name}", *("  " + line for line in script.head("!"))]
    tools, frames = script.setups()
    lines += [
        f"  PERS tooldata {_tool(k)}:=[TRUE,{_frame(T)},[1,[0,0,1],[1,0,0,0],0,0,0]];"
        for k, T in {1: script.description.tool, **tools}.items()
    ]
    none = _frame(np.eye(4))
    lines += [f'  PERS wobjdata wPieper{k}:=[FALSE,TRUE,"",{_frame(T)},{none}];' for k, T in frames.items()]
    lines += [f"  {line}" for line in data]
    lines += [f"  PROC {'main' if script.name.lower() != 'main' else 'run'}()"]
    # singular lines and configurations that the words leave open are the controller's to refuse
    lines += [f"    {line}" for line in body]
    return "\n".join([*lines, "  ENDPROC", "ENDMODULE", ""])


def _tool(number: int) -> str:
    return f"tPieper{number if number > 1 else ''}"


def _data(script: Script, number: int, move: Move) -> list[str]:
    out: list[str] = []
    if move.kind == "move_j" and not script.cartesian:
        axes = numbers(script.degrees(move.q), 5, ",")
        out.append(f"CONST jointtarget jp{number}:=[[{axes}],{_NO_AXES}];")
    else:
        out.append(f"CONST robtarget p{number}:={_robtarget(script, move.T, move.q)};")
    if move.via is not None and move.q_via is not None:
        out.append(f"CONST robtarget pv{number}:={_robtarget(script, move.via, move.q_via)};")
    speed = script.line_speed(move) if move.kind != "move_j" else _FULL_SPEED * (move.speed or 1.0)
    out.append(f"CONST speeddata vp{number}:=[{fixed(speed * 1e3, 3)},500,5000,1000];")
    if move.blend:
        r = move.blend * 1e3
        out.append(
            f"CONST zonedata zp{number}:=[FALSE,{numbers([r, 1.5 * r, 1.5 * r, 0.15 * r, 1.5 * r, 0.15 * r], 3, ',')}];"
        )
    return out


def _robtarget(script: Script, T: Array, q: Array) -> str:
    said = script.configuration(q, "abb")
    words = ",".join(str(turn) for turn in said.turns)
    return f"[{_position(T)},[{words},{said.words[0]}],{_NO_AXES}]"


def _position(T: Array) -> str:
    x, y, z, *quaternion = read_pose(T, "quat_wxyz", mm=True)
    return f"[{numbers([x, y, z], 4, ',')}],[{numbers(quaternion, 9, ',')}]"


def _frame(T: Array) -> str:
    return f"[{_position(T)}]"


def read(text: str) -> list[Target]:
    """Return the targets of a module, in the order of its moves."""
    text = without_comments(text, r"!.*")
    joints = {m[1]: np.radians(found(m[2], 6)) for m in re.finditer(r"jointtarget\s+(\w+)\s*:=\s*(\[[^;]*)", text)}
    poses: dict[str, Array] = {}
    words: dict[str, Words] = {}
    for m in re.finditer(r"robtarget\s+(\w+)\s*:=\s*(\[[^;]*)", text):
        *v, cf1, cf4, cf6, cfx = found(m[2], 11)
        poses[m[1]] = pose(*v[:3], quat_wxyz=v[3:], mm=True)
        words[m[1]] = Words("abb", (str(int(cfx)),), (int(cf1), int(cf4), int(cf6)))
    tools: dict[str, Array] = {}
    frames: dict[str, Array] = {}
    for m in re.finditer(r"(tooldata|wobjdata)\s+(\w+)\s*:=\s*(\[[^;]*)", text):
        v = found(re.sub(r'"[^"]*"', "", m[3]), 7)
        (tools if m[1] == "tooldata" else frames)[m[2]] = pose(*v[:3], quat_wxyz=v[3:], mm=True)
    out: list[Target] = []
    for m in re.finditer(r"\b(MoveAbsJ|MoveJ|MoveL|MoveC)\s+([^;]*);", text):
        args = [a.strip() for a in m[2].split(",")]
        tool, _, frame = args[-1].partition("\\WObj:=")
        own = tool in ("tool0", "")
        under = None if own else known_one("tool", tool, tools), known_one("frame", frame, frames) if frame else None
        if m[1] == "MoveAbsJ":
            out.append(Target("move_j", q=joints[args[0]], place=m.start()).under(*under))
        elif m[1] == "MoveC":
            via, end = args[:2]
            target = Target("move_c", T=poses[end], via=poses[via], words=words[end], place=m.start())
            out.append(target.under(*under))
        else:
            kind = "move_j" if m[1] == "MoveJ" else "move_l"
            out.append(Target(kind, T=poses[args[0]], words=words[args[0]], place=m.start()).under(*under))
    return out


_HAPPENINGS = Happenings(wait=rf"WaitTime ({NUMBER});", output=r"SetDO do(?P<port>\d+),(?:(?P<on>1)|0);", comment="!")


def _said(line: str, state: dict[str, float]) -> Manner | Happening | None:
    if m := re.match(rf"CONST speeddata (\w+)\s*:=\s*\[({NUMBER})", line):
        state[m[1]] = float(m[2]) / 1e3
    if m := re.match(rf"CONST zonedata (\w+)\s*:=\s*\[FALSE,\s*({NUMBER})", line):
        state[m[1]] = float(m[2]) / 1e3
    if m := re.match(r"(MoveAbsJ|MoveJ|MoveL|MoveC) ([^;]*);", line):
        *_, speed, zone, _ = (a.strip() for a in m[2].split(","))
        v = state.get(speed)
        if v is not None and m[1] in ("MoveAbsJ", "MoveJ"):
            v = v / _FULL_SPEED
        return Manner(v, blend=0.0 if zone == "fine" else state.get(zone))
    return _HAPPENINGS.read(line)


_WORD = r"[A-Za-z]\w*"
_LINES = (
    r"!.*",
    rf"MODULE {_WORD}|ENDMODULE|PROC {_WORD}\(\)|ENDPROC",
    rf"(?:PERS|CONST) (?:tooldata|wobjdata|jointtarget|robtarget|speeddata|zonedata) {_WORD}\s*:=\s*\[[^;]*\];",
    rf"(?:MoveAbsJ|MoveJ|MoveL) {_WORD},{_WORD},{_WORD},{_WORD}(?:\\WObj:={_WORD})?;",
    rf"MoveC {_WORD},{_WORD},{_WORD},{_WORD},{_WORD}(?:\\WObj:={_WORD})?;",
    rf"WaitTime {NUMBER};|SetDO {_WORD},[01];",
)
DIALECT = Dialect("rapid", (".mod", ".prg"), "abb", 32, write, read, _LINES, _said, RAPID)
