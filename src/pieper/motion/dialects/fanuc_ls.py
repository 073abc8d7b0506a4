"""FANUC LS: positions in joint values, or as poses with CONFIG."""

from __future__ import annotations

import re
from collections.abc import Callable

import numpy as np

from pieper.errors import InputError
from pieper.kinematics.arrays import Array
from pieper.kinematics.spoken import pose, read_pose
from pieper.motion.dialects.dialect import Dialect, Script, Setup, Target, fixed, known_one, named
from pieper.motion.dialects.manner import NUMBER, Happenings, Manner
from pieper.motion.dialects.target import Words
from pieper.motion.instructions import Events, FrameChange, Happening, Move, ToolChange

_JOINTS = ("J1", "J2", "J3", "J4", "J5", "J6")
_POSE = ("X", "Y", "Z", "W", "P", "R")
#: FANUC counts J3 from the level, whatever J2 does; robot files count joint 3 from the lower arm.
_COUPLED = "J3 = joint 3 - joint 2"
#: The position register through which tools and frames are set.
_REGISTER = 99
#: A remark has no more characters.
_REMARK = 32


#: A move, an element of a register, a tool or frame set by one, and one taken.
_LINE = (
    r"^\s*\d+:\s*(?:([JLC])\s+P\[(\d+)[^\]]*\](?:\s*P\[(\d+)[^\]]*\])?"
    rf"|PR\[{_REGISTER},(?P<element>\d)\]=\(?(?P<value>{NUMBER})\)?"
    r"|(?P<setting>UTOOL|UFRAME)\[(?P<number>\d+)\]=PR|(?P<taking>UTOOL|UFRAME)_NUM=(?P<taken>\d+))"
)
_EVENTS = Events(
    wait=lambda seconds: f"WAIT {seconds:z6.2f}(sec)",
    output=lambda port, value: f"DO[{port}]={'ON' if value else 'OFF'}",
    gripper=lambda value: f"! gripper {value:g}",
)


def write(script: Script) -> str:
    """Return the text of a program."""
    lines: list[str] = []
    places: list[str] = []
    coupled = "fanuc" in script.description.manufacturer.lower() and not script.cartesian

    now = Setup(script.description.tool, np.eye(4))

    def place(q: Array, T: Array) -> int:
        index = len(places) + 1
        places.append(_place(script, index, q, T, coupled, now))
        return index

    for line in script.head("!", _REMARK):
        lines.append(line)
    if coupled:
        lines.append(f"! {_COUPLED}")
    for item, now in script.steps():
        if isinstance(item, ToolChange):
            lines += _set("UTOOL", now.tool_number, now.tool) if now.tool_number > 1 else []
            lines.append(f"UTOOL_NUM={now.tool_number}")
        elif isinstance(item, FrameChange):
            lines += _set("UFRAME", now.frame_number, now.frame) if now.frame_number else []
            lines.append(f"UFRAME_NUM={now.frame_number}")
        else:
            lines += _move(script, item, place) if isinstance(item, Move) else [_EVENTS.said(item)]
    text = [f"/PROG  {script.name.upper()}", "/ATTR", 'COMMENT = "pieper";', "DEFAULT_GROUP = 1,*,*,*,*;", "/MN"]
    text += [f"{number:4d}:{line}    ;" for number, line in enumerate(lines, 1)]
    return "\n".join([*text, "/POS", *places, "/END", ""])


def _move(script: Script, move: Move, place: Callable[[Array, Array], int]) -> list[str]:
    # a percentage of the corner, not a radius: the controller rounds by speed
    stop = f"CNT{min(100, max(1, round(move.blend * 1e3)))}" if move.blend else "FINE"
    if move.kind == "move_j":
        share = 100 if move.speed is None else max(1, round(100 * move.speed))
        return [f"J P[{place(move.q, move.T)}] {share}% {stop}"]
    speed = f"{fixed(script.line_speed(move) * 1e3, 1)}mm/sec {stop}"
    if move.via is not None and move.q_via is not None:
        via = place(move.q_via, move.via)
        return [f"C P[{via}] P[{place(move.q, move.T)}] {speed}"]
    return [f"L P[{place(move.q, move.T)}] {speed}"]


def _set(what: str, number: int, T: Array) -> list[str]:
    """Return lines that set a tool or a frame by way of a position register."""
    values = [fixed(v, 5) for v in read_pose(T, "wpr", degrees=True, mm=True)]
    said = [f"({v})" if v.startswith("-") else v for v in values]
    return [*(f"PR[{_REGISTER},{k}]={v}" for k, v in enumerate(said, 1)), f"{what}[{number}]=PR[{_REGISTER}]"]


def _place(script: Script, index: int, q: Array, T: Array, coupled: bool, now: Setup) -> str:
    stands = f"UF : {now.frame_number}, UT : {now.tool_number}"
    if not script.cartesian:
        values = script.degrees(q)
        if coupled:
            values[2] -= values[1]
        said = ",\n  ".join(f"{n}= {fixed(v, 5)} deg" for n, v in zip(_JOINTS, values, strict=True))
        return f"P[{index}]{{\n  GP1:\n  {stands},\n  {said}\n}};"
    words = script.configuration(q, "fanuc")
    config = f"'{' '.join(words.words)}, {', '.join(str(t) for t in words.turns)}'"
    values = read_pose(T, "wpr", degrees=True, mm=True)
    units = ["mm"] * 3 + ["deg"] * 3
    said = ",\n  ".join(f"{n}= {fixed(v, 5)} {u}" for n, v, u in zip(_POSE, values, units, strict=True))
    return f"P[{index}]{{\n  GP1:\n  {stands}, CONFIG : {config},\n  {said}\n}};"


def read(text: str) -> list[Target]:
    """Return the targets of a program, in the order of its moves."""
    coupled = _COUPLED in text
    places: dict[int, tuple[Array | None, Array | None]] = {}
    words: dict[int, Words] = {}
    for m in re.finditer(r"P\[(\d+)[^\]]*\]\s*\{(.*?)\}", text, re.S):
        joints, values = named(m[2], _JOINTS), named(re.sub(r"CONFIG.*?'.*?'", "", m[2]), _POSE)
        if joints is not None:
            if coupled:
                joints[2] += joints[1]
            places[int(m[1])] = np.radians(joints), None
        elif values is not None:
            places[int(m[1])] = None, pose(*values[:3], wpr=values[3:], degrees=True, mm=True)
            if config := re.search(r"CONFIG\s*:\s*'([^']*)'", m[2]):
                words[int(m[1])] = _words(config[1])
    out: list[Target] = []
    register = [0.0] * 6
    tools: dict[int, Array] = {}
    frames: dict[int, Array] = {}
    under: tuple[Array | None, Array | None] = None, None
    for m in re.finditer(_LINE, text, re.M):
        if m["element"]:
            register[int(m["element"]) - 1] = float(m["value"])
            continue
        if m["setting"]:
            made = pose(*register[:3], wpr=register[3:], degrees=True, mm=True)
            (tools if m["setting"] == "UTOOL" else frames)[int(m["number"])] = made
            continue
        if m["taking"]:
            k = int(m["taken"])
            # the arm's own tool is number 1, the base is frame 0
            if m["taking"] == "UTOOL":
                under = tools.get(k) if k < 2 else known_one("tool", k, tools), under[1]
            else:
                under = under[0], known_one("frame", k, frames) if k else None
            continue
        kind = {"J": "move_j", "L": "move_l", "C": "move_c"}[m[1]]
        if m[3]:
            q_via, via = places[int(m[2])]
            q, T = places[int(m[3])]
            said = words.get(int(m[3]))
            out.append(Target(kind, q, T, via, q_via, words=said, place=m.start(1)).under(*under))
        else:
            said = words.get(int(m[2]))
            out.append(Target(kind, *places[int(m[2])], words=said, place=m.start(1)).under(*under))
    return out


def _words(config: str) -> Words:
    """Return what stands in a CONFIG, or say that it is not read."""
    m = re.fullmatch(r"\s*([NF])\s*([UD])\s*([TB])\s*,\s*(-?\d+)\s*,\s*(-?\d+)\s*,\s*(-?\d+)\s*", config)
    if m is None:
        raise InputError(
            f"CONFIG {config!r} is not read: it is N or F, U or D, T or B, and the turns of J1, J4 and J6, such as "
            "'N U T, 0, 0, 0'.",
            given=config,
        )
    return Words("fanuc", (m[1], m[2], m[3]), (int(m[4]), int(m[5]), int(m[6])))


_HAPPENINGS = Happenings(
    wait=rf"WAIT +({NUMBER})\(sec\)", output=r"DO\[(?P<port>\d+)\]=(?:(?P<on>ON)|OFF)", comment="!"
)


def _said(line: str, state: dict[str, float]) -> Manner | Happening | None:
    del state
    line = re.sub(r"^\d+: *|\s*;$", "", line)
    if m := re.match(rf"([JLC]) P\[.*\] ({NUMBER})(?:%|mm/sec) (FINE|CNT\d+)$", line):
        # CNT rounds by speed: no radius
        return Manner(float(m[2]) / (100 if m[1] == "J" else 1e3), blend=0.0 if m[3] == "FINE" else None)
    return _HAPPENINGS.read(line)


_STOP = r"(?:FINE|CNT\d+)"
_TAKEN = r"P\[\d+(?:: ?[^\]]*)?\]"
_INSTRUCTIONS = (
    r"!.*",
    rf"J {_TAKEN} {NUMBER}% {_STOP}|L {_TAKEN} {NUMBER}mm/sec {_STOP}|C {_TAKEN} {_TAKEN} {NUMBER}mm/sec {_STOP}",
    rf"PR\[{_REGISTER},[1-6]\]=(?:{NUMBER}|\({NUMBER}\))|U(?:TOOL|FRAME)\[\d+\]=PR\[{_REGISTER}\]",
    rf"U(?:TOOL|FRAME)_NUM=\d+|WAIT +{NUMBER}\(sec\)|DO\[\d+\]=(?:ON|OFF)",
)
_LINES = (
    r"/(?:PROG|ATTR|MN|POS|END).*|[A-Z_]+\s*=\s*[^;:]*;",
    rf"\d+: *(?:{'|'.join(_INSTRUCTIONS)})? *;",
    r"P\[\d+(?:: ?[^\]]*)?\] *\{|GP1:|\};",
    rf"UF : \d+, UT : \d+,(?: *CONFIG : '[^']*',)?|[A-Z]\d? *= *{NUMBER} (?:mm|deg),?",
)
DIALECT = Dialect("fanuc-ls", (".ls",), "fanuc", 36, write, read, _LINES, _said)
