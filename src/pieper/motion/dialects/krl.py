"""KUKA KRL: axis values for joint moves, poses for lines and circles, status and turn for joint moves to poses."""

from __future__ import annotations

import re

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.kinematics.spoken import pose, read_pose
from pieper.motion.dialects.dialect import Dialect, Script, Target, fixed, named, numbers
from pieper.motion.dialects.manner import NUMBER, Happenings, Manner, without_comments
from pieper.motion.dialects.reserved import KRL
from pieper.motion.dialects.target import Words
from pieper.motion.instructions import Events, FrameChange, Happening, Move, ToolChange

_AXES = ("A1", "A2", "A3", "A4", "A5", "A6")
_POSE = ("X", "Y", "Z", "A", "B", "C")


_EVENTS = Events(
    wait=lambda seconds: f"WAIT SEC {fixed(seconds, 3)}",
    output=lambda port, value: f"$OUT[{port}]={'TRUE' if value else 'FALSE'}",
    gripper=lambda value: f"; gripper {value:g}",
)


def write(script: Script) -> str:
    """Return the text of a source file."""
    body = [f"$TOOL={{{_place(script.description.tool)}}}", "$BASE=$NULLFRAME"]
    for item, now in script.steps():
        if isinstance(item, ToolChange):
            body.append(f"$TOOL={{{_place(now.tool)}}}")
        elif isinstance(item, FrameChange):
            body.append(f"$BASE={{{_place(now.frame)}}}" if now.frame_number else "$BASE=$NULLFRAME")
        else:
            body += _move(script, item) if isinstance(item, Move) else [_EVENTS.said(item)]
    lines = ["&ACCESS RVP", f"DEF {script.name}()", *script.head(";"), "BAS(#INITMOV,0)", *body, "END", ""]
    return "\n".join(lines)


def _move(script: Script, move: Move) -> list[str]:
    out: list[str] = []
    if move.blend:
        out.append(f"$APO.CDIS={fixed(move.blend * 1e3, 3)}")
    if move.kind == "move_j":
        share = 100 if move.speed is None else max(1, round(100 * move.speed))
        out.append(f"BAS(#VEL_PTP,{share})")
        target = f"{{{_words(_AXES, script.degrees(move.q))}}}"
        if script.cartesian:
            said = script.configuration(move.q, "kuka")
            target = f"{{{_place(move.T)},S {said.words[0]},T {said.turns[0]}}}"
        out.append(f"PTP {target}{' C_DIS' if move.blend else ''}")
        return out
    out.append(f"$VEL.CP={fixed(script.line_speed(move), 5)}")
    way = f"CIRC {{{_place(move.via)}}},{{{_place(move.T)}}}" if move.via is not None else f"LIN {{{_place(move.T)}}}"
    out.append(way + (" C_DIS" if move.blend else ""))
    return out


def _place(T: Array) -> str:
    return _words(_POSE, read_pose(T, "abc", degrees=True, mm=True))


def _words(names: tuple[str, ...], values: list[float] | tuple[float, ...]) -> str:
    return ",".join(f"{name} {numbers([value], 5)}" for name, value in zip(names, values, strict=True))


def read(text: str) -> list[Target]:
    """Return the targets of a source file, in the order of its moves."""
    text = without_comments(text, r";.*")
    out: list[Target] = []
    tool: Array | None = None
    frame: Array | None = None
    for m in re.finditer(r"^\s*(PTP|LIN|CIRC|\$TOOL=|\$BASE=)\s*(.*)$", text, re.M):
        if m[1] == "$TOOL=":
            tool = _read_pose(m[2])
            continue
        if m[1] == "$BASE=":
            frame = _read_pose(m[2])
            continue
        braces = re.findall(r"\{([^}]*)\}", m[2])
        axes = named(braces[0], _AXES) if m[1] == "PTP" else None
        if axes is not None:
            out.append(Target("move_j", q=np.radians(axes), place=m.start(1)).under(tool, frame))
            continue
        places = [_read_pose(brace) for brace in braces]
        if m[1] == "CIRC":
            out.append(Target("move_c", T=places[1], via=places[0], place=m.start(1)).under(tool, frame))
        else:
            kind = "move_j" if m[1] == "PTP" else "move_l"
            said = named(braces[0], ("S", "T"))
            words = None if said is None else Words("kuka", (str(int(said[0])),), (int(said[1]),))
            out.append(Target(kind, T=places[0], words=words, place=m.start(1)).under(tool, frame))
    return out


_HAPPENINGS = Happenings(
    wait=rf"WAIT SEC ({NUMBER})", output=r"\$OUT\[(?P<port>\d+)\]=(?:(?P<on>TRUE)|FALSE)", comment=";"
)


def _said(line: str, state: dict[str, float]) -> Manner | Happening | None:
    for name, setting in (("share", r"BAS\(#VEL_PTP, ?(\d+)\)"), ("line", rf"\$VEL\.CP=({NUMBER})")):
        if m := re.match(setting, line):
            state[name] = float(m[1])
    if m := re.match(rf"\$APO\.CDIS=({NUMBER})", line):
        state["blend"] = float(m[1]) / 1e3
    if m := re.match(r"(PTP|LIN|CIRC)\b", line):
        # a corner that is cut by another measure than the distance has no radius
        blend = 0.0 if " C_" not in line else state.get("blend") if " C_DIS" in line else None
        share = state.get("share")
        return Manner((None if share is None else share / 100) if m[1] == "PTP" else state.get("line"), blend=blend)
    return _HAPPENINGS.read(line)


def _read_pose(brace: str) -> Array | None:
    values = named(brace, _POSE)
    return None if values is None else pose(*values[:3], abc=values[3:], degrees=True, mm=True)


def _braces(names: tuple[str, ...], more: str = "") -> str:
    """Return the pattern of an aggregate of all these names."""
    return r"\{" + ",".join(rf"\s*{name} {NUMBER}" for name in names) + more + r"\}"


_APPROACH = r"(?: C_PTP| C_DIS| C_VEL| C_ORI)*(?: *;.*)?"
_LINES = (
    r"[;&].*",
    r"DEF \w+\( *\)|END|BAS\(#\w+, ?\d+\)",
    rf"\$TOOL={_braces(_POSE)}|\$BASE=(?:\$NULLFRAME|{_braces(_POSE)})",
    rf"\$APO\.\w+={NUMBER}|\$VEL\.\w+={NUMBER}|\$OUT\[\d+\]=(?:TRUE|FALSE)|WAIT SEC {NUMBER}",
    rf"PTP (?:{_braces(_AXES)}|{_braces(_POSE, r'(?:,S -?[0-9]+,T -?[0-9]+)?')}){_APPROACH}",
    rf"LIN {_braces(_POSE)}{_APPROACH}|CIRC {_braces(_POSE)}, ?{_braces(_POSE)}{_APPROACH}",
)
DIALECT = Dialect("krl", (".src",), "kuka", 24, write, read, _LINES, _said, KRL)
