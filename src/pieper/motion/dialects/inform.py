"""Yaskawa INFORM: poses with RCONF; joint values are pulses there, which need the arm's gears."""

from __future__ import annotations

import re
from collections.abc import Callable

import numpy as np

from pieper.errors import InputError
from pieper.kinematics.arrays import Array
from pieper.kinematics.pose import inverse, pose_error
from pieper.kinematics.spoken import pose, read_pose
from pieper.motion.dialects.dialect import Dialect, Script, Setup, Target, fixed, found, listed, numbers
from pieper.motion.dialects.manner import NUMBER, Happenings, Manner
from pieper.motion.dialects.target import Words
from pieper.motion.instructions import Events, FrameChange, Happening, Move, ToolChange
from pieper.tolerances import SAME_TOOL_IN_FILE

#: A comment has no more characters.
_COMMENT = 32


#: A move, an element of the variable, a tool set by it, and a frame made of three points.
_LINE = (
    r"^(?:(MOVJ|MOVL|MOVC)\s+(C\d+)|SETE P000 \((?P<element>\d)\) (?P<value>-?\d+)"
    r"|SETTOOL TL#\((?P<tool>\d+)\)|MFRAME UF#\((?P<frame>\d+)\) (?P<corners>C.*))"
)
#: Parts of a millimetre and of a degree in which a position variable counts.
_PARTS = (1000, 1000, 1000, 10000, 10000, 10000)
#: Points of which a work frame is made, m: far apart, so that their rounding turns it by next to nothing.
_CORNERS = ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
_EVENTS = Events(
    wait=lambda seconds: f"TIMER T={fixed(seconds, 2)}",
    output=lambda port, value: f"DOUT OT#({port}) {'ON' if value else 'OFF'}",
    gripper=lambda value: f"' gripper {value:g}",
)


def write(script: Script) -> str:
    """Return the text of a job. Positions of one RCONF stand together under it."""
    positions: list[str] = []
    lines: list[str] = []
    now = Setup(script.description.tool, np.eye(4))
    last: list[str] = []

    def place(q: Array, T: Array, frame: int | None = None) -> str:
        said = script.configuration(q, "yaskawa")
        stands = now.frame_number if frame is None else frame
        words = [f"///TOOL {now.tool_number - 1}"]
        words += [f"///USER {stands}", "///POSTYPE USER"] if stands else ["///POSTYPE ROBOT"]
        words += ["///RECTAN", f"///RCONF {','.join([*said.words, *(str(t) for t in said.turns), '0', '0'])}"]
        if words != last:
            positions.extend(words)
            last[:] = words
        index = sum(line.startswith("C") for line in positions)
        values = read_pose(T, "yaskawa", degrees=True, mm=True)
        positions.append(f"C{index:05d}={numbers(values[:3], 4, ',')},{numbers(values[3:], 5, ',')}")
        return f"C{index:05d}"

    q = script.start
    for item, now in script.steps():
        if isinstance(item, ToolChange):
            lines += _tool(now) if now.tool_number > 1 else []
        elif isinstance(item, FrameChange):
            # a frame is made of its origin, a point on its x axis and one on the side of its y axis
            corners = [now.frame @ pose(*p) for p in _CORNERS] if now.frame_number else []
            made = [place(q, T, 0) for T in corners]
            lines += [f"MFRAME UF#({now.frame_number}) {' '.join(made)}"] if made else []
        elif isinstance(item, Move):
            if item.via is not None:
                start = _last(lines) or place(q, _seen(script, now, q))
                lines += _begun(lines, start, script.line_speed(item))
            lines += _move(script, item, place)
            q = item.q
        else:
            lines.append(_EVENTS.said(item))
    count = sum(line.startswith("C") for line in positions)
    head = ["/JOB", f"//NAME {script.name.upper()}", "//POS", f"///NPOS {count},0,0,0,0,0"]
    head += [*positions, "//INST", "///ATTR SC,RW,RJ", "///GROUP1 RB1", "NOP"]
    return "\n".join([*head, *script.head("'", _COMMENT), *lines, "END", ""])


def _last(lines: list[str]) -> str:
    """Return where the arm was last sent, "" where the tool or the frame was changed since."""
    last = next((line for line in reversed(lines) if line.startswith(("MOV", "SET", "MFRAME"))), "")
    return last.split()[1] if last.startswith("MOV") else ""


def _begun(lines: list[str], start: str, speed: float) -> list[str]:
    """Return what stands before the via and the end of an arc: its beginning, as a MOVC of its own.

    Behind another arc a MOVL to where the arm is parts the two.
    """
    said = f"V={fixed(speed * 1e3, 1)}"
    moves = [line for line in lines if line.startswith("MOV")]
    parted = [f"MOVL {start} {said} PL=0"] if moves and moves[-1].startswith("MOVC") else []
    return [*parted, f"MOVC {start} {said}"]


def _seen(script: Script, now: Setup, q: Array) -> Array:
    """Return the pose of the tool that holds, seen from the work frame that holds, at a posture."""
    flange = script.plan.chain.native.fk(q) @ inverse(script.description.tool)
    return inverse(now.frame) @ flange @ now.tool


def _tool(now: Setup) -> list[str]:
    """Return lines that set a tool by way of a position variable, in um and 1e-4 degrees."""
    values = read_pose(now.tool, "yaskawa", degrees=True, mm=True)
    whole = [round(v * parts) for v, parts in zip(values, _PARTS, strict=True)]
    return [*(f"SETE P000 ({k}) {v}" for k, v in enumerate(whole, 1)), f"SETTOOL TL#({now.tool_number - 1}) P000"]


def _move(script: Script, move: Move, place: Callable[[Array, Array], str]) -> list[str]:
    # PL is a level of positioning, not a radius
    stop = f" PL={min(8, 1 + round(move.blend * 100))}" if move.blend else " PL=0"
    if move.kind == "move_j":
        share = 100.0 if move.speed is None else 100 * move.speed
        return [f"MOVJ {place(move.q, move.T)} VJ={fixed(share, 2)}{stop}"]
    speed = f"V={fixed(script.line_speed(move) * 1e3, 1)}"
    if move.via is not None and move.q_via is not None:
        return [f"MOVC {place(move.q_via, move.via)} {speed}", f"MOVC {place(move.q, move.T)} {speed}{stop}"]
    return [f"MOVL {place(move.q, move.T)} {speed}{stop}"]


def read(text: str) -> list[Target]:
    """Return the targets of a job, in the order of its moves.

    An arc is three MOVC: where it begins, which is gone to in a straight line from anywhere else (as the first of all
    it is where the arm stands), its via and its end.

    Raises:
        InputError: MOVC in a row that are not three.
    """
    places: dict[str, Array] = {}
    stands: dict[str, tuple[int, int]] = {}
    words: dict[str, Words] = {}
    tool, user = 0, 0
    rconf: Words | None = None
    header = r"^(C\d+)=(.*)$|^///TOOL (\d+)|^///USER (\d+)|^///POSTYPE ROBOT|^///RCONF (?P<rconf>.*)$"
    for m in re.finditer(header, text, re.M):
        if m[1]:
            v = found(m[2], 6)
            places[m[1]], stands[m[1]] = pose(*v[:3], yaskawa=v[3:], degrees=True, mm=True), (tool, user)
            if rconf is not None:
                words[m[1]] = rconf
        elif m[3]:
            tool = int(m[3])
        elif m["rconf"]:
            flip, lower, rear, *turns = (int(v) for v in found(m["rconf"], 6))
            rconf = Words("yaskawa", (str(flip), str(lower), str(rear)), (turns[0], turns[1], turns[2]))
        else:
            user = int(m[4] or 0)
    tools: dict[int, Array] = {}
    frames: dict[int, Array] = {}
    variable = [0.0] * 6
    out: list[Target] = []
    arc: list[str] = []
    for m in re.finditer(_LINE, text, re.M):
        if m["element"]:
            k = int(m["element"]) - 1
            variable[k] = float(m["value"]) / _PARTS[k]
            continue
        if m["tool"]:
            tools[int(m["tool"])] = pose(*variable[:3], yaskawa=variable[3:], degrees=True, mm=True)
            continue
        if m["frame"]:
            frames[int(m["frame"])] = _frame([places[name] for name in m["corners"].split()])
            continue
        tool, user = stands[m[2]]
        under = tools.get(tool), frames[user] if user else None
        T = places[m[2]]
        if m[1] != "MOVC":
            _whole(arc)
            if not _again(out, m[1], T, under):
                kind = "move_j" if m[1] == "MOVJ" else "move_l"
                out.append(Target(kind, T=T, words=words.get(m[2]), place=m.start()).under(*under))
            continue
        arc.append(m[2])
        if len(arc) == 1 and out and not _at(out, T, under):
            out.append(Target("move_l", T=T, words=words.get(m[2]), place=m.start()).under(*under))
        elif len(arc) == 3:
            said = words.get(m[2])
            out.append(Target("move_c", T=T, via=places[arc[1]], words=said, place=m.start()).under(*under))
            arc = []
    _whole(arc)
    return out


_HAPPENINGS = Happenings(
    wait=rf"TIMER T=({NUMBER})", output=r"DOUT OT#\((?P<port>\d+)\) (?:(?P<on>ON)|OFF)", comment="'"
)


def _said(line: str, state: dict[str, float]) -> Manner | Happening | None:
    del state
    if m := re.match(rf"MOV([JLC]) C\d+ (?:VJ|V)=({NUMBER})(?: PL=(\d))?", line):
        # a level of positioning is no radius; PL=0 stops
        return Manner(float(m[2]) / (100 if m[1] == "J" else 1e3), blend=0.0 if m[3] in (None, "0") else None)
    return _HAPPENINGS.read(line)


def _at(out: list[Target], T: Array, under: tuple[Array | None, Array | None]) -> bool:
    """Whether the last target is a pose, as exactly as files say it."""
    wanted = Target("", T=T).under(*under).T
    last = out[-1].T if out else None
    return last is not None and wanted is not None and bool((pose_error(last, wanted) < SAME_TOOL_IN_FILE).all())


def _again(out: list[Target], word: str, T: Array, under: tuple[Array | None, Array | None]) -> bool:
    """Whether a MOVL leads from the end of an arc to itself: it parts two arcs."""
    return word == "MOVL" and bool(out) and out[-1].kind == "move_c" and _at(out, T, under)


def _whole(arc: list[str]) -> None:
    """Say what is wrong with an arc that ends before its third point."""
    if arc:
        raise InputError(
            f"an arc of INFORM is three MOVC in a row, its beginning, a point on the way and its end; {', '.join(arc)} "
            "are not three. Write its beginning as a MOVC too, and part two arcs by a MOVL to where they meet.",
            given=tuple(arc),
        )


def _frame(corners: list[Array]) -> Array:
    origin, x, y = (T[:3, 3] for T in corners)
    a = (x - origin) / np.linalg.norm(x - origin)
    c = np.cross(a, y - origin)
    c = c / np.linalg.norm(c)
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = np.stack([a, np.cross(c, a), c], -1), origin
    return T


_LINES = (
    r"'.*",
    r"/JOB|//(?:NAME|POS|INST).*|///(?:NPOS|TOOL|USER|RECTAN|RCONF|DATE|ATTR|GROUP1|COMM|FRAME).*",
    r"///POSTYPE (?:ROBOT|USER)|NOP|END",
    rf"C\d+={listed(6)}",
    rf"MOVJ C\d+ VJ={NUMBER}(?: PL=\d)?|MOV[LC] C\d+ V={NUMBER}(?: PL=\d)?",
    rf"TIMER T={NUMBER}|DOUT OT#\(\d+\) (?:ON|OFF)",
    r"SETE P000 \([1-6]\) -?\d+|SETTOOL TL#\(\d+\) P000|MFRAME UF#\(\d+\) C\d+ C\d+ C\d+",
)
DIALECT = Dialect("inform", (".jbi",), "yaskawa", 32, write, read, _LINES, _said)
