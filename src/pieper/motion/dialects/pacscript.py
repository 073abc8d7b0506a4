"""Denso PacScript: joint values for joint moves, poses with a figure for lines and circles."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.kinematics.spoken import pose, read_pose
from pieper.motion.dialects.dialect import Dialect, Script, Target, fixed, found, known_one, listed, numbers
from pieper.motion.dialects.manner import NUMBER, Happenings, Manner, without_comments
from pieper.motion.dialects.reserved import PACSCRIPT
from pieper.motion.dialects.target import Words
from pieper.motion.instructions import Events, FrameChange, Happening, Move, ToolChange

_EVENTS = Events(
    wait=lambda seconds: f"Delay {round(seconds * 1e3)}",
    output=lambda port, value: f"{'Set' if value else 'Reset'} IO[{port}]",
    gripper=lambda value: f"' gripper {value:g}",
)


def write(script: Script) -> str:
    """Return the text of a program."""
    tools, frames = script.setups()
    # number 1 is the arm's own tool, which is set on the controller
    body = [f"Tool {k}, {_six(T)}" for k, T in tools.items() if k > 1]
    body += [f"Work {k}, {_six(T)}" for k, T in frames.items()]
    for item, now in script.steps():
        if isinstance(item, ToolChange):
            body.append(f"ChangeTool {now.tool_number}")
        elif isinstance(item, FrameChange):
            body.append(f"ChangeWork {now.frame_number}")
        else:
            body.append(_move(script, item) if isinstance(item, Move) else _EVENTS.said(item))
    lines = [*script.head("'"), f"Sub {script.name}", "  TakeArm Keep = 0", *("  " + line for line in body)]
    return "\n".join([*lines, "  GiveArm", "End Sub", ""])


def _move(script: Script, move: Move) -> str:
    stop = f"@{fixed(move.blend * 1e3, 3)}" if move.blend else "@0"
    if move.kind == "move_j":
        share = 100.0 if move.speed is None else 100 * move.speed
        target = f"J({numbers(script.degrees(move.q), 5, ', ')})"
        if script.cartesian:
            target = _place(script, move.T, move.q)
        return f"Move P, {stop} {target}, Speed = {fixed(share, 1)}"
    said = f" ' {fixed(script.line_speed(move) * 1e3, 1)} mm/s"
    target = _place(script, move.T, move.q)
    if move.via is not None and move.q_via is not None:
        return f"Move C, {_place(script, move.via, move.q_via)}, {stop} {target}{said}"
    return f"Move L, {stop} {target}{said}"


def _place(script: Script, T: Array, q: Array) -> str:
    figure = script.configuration(q, "denso").words[0]
    return f"{_six(T)[:-1]}, {figure})"


def _six(T: Array) -> str:
    values = read_pose(T, "rpy", degrees=True, mm=True)
    return f"P({numbers(values[:3], 4, ', ')}, {numbers(values[3:], 5, ', ')})"


def read(text: str) -> list[Target]:
    """Return the targets of a program, in the order of its moves."""
    text = without_comments(text, r"'.*")
    out: list[Target] = []
    known: dict[str, dict[int, Array]] = {"Tool": {}, "Work": {}}
    taken: dict[str, Array | None] = {"Tool": None, "Work": None}
    line = r"^\s*(?:Move\s+([PLC])\s*,(.*)|(Tool|Work)\s+(\d+)\s*,\s*P\(([^)]*)\)|Change(Tool|Work)\s+(\d+))\s*$"
    for m in re.finditer(line, text, re.M | re.I):
        if m[3]:
            v = found(m[5], 6)
            known[m[3].capitalize()][int(m[4])] = pose(*v[:3], rpy=v[3:], degrees=True, mm=True)
            continue
        if m[6]:
            what, k = m[6].capitalize(), int(m[7])
            # the arm's own tool is number 1, the base is work 0
            own = k == 0 or (what == "Tool" and k == 1)
            taken[what] = known[what].get(k) if own else known_one(what, k, known[what])
            continue
        under = taken["Tool"], taken["Work"]
        said = [(mark, found(v, 7)) for mark, v in re.findall(r"\b([PJ])\(([^)]*)\)", m[2])]
        kind = {"P": "move_j", "L": "move_l", "C": "move_c"}[m[1].upper()]
        places = [
            (np.radians(v), None) if mark == "J" else (None, pose(*v[:3], rpy=v[3:6], degrees=True, mm=True))
            for mark, v in said
        ]
        words = _words(said[-1][1]) if said[-1][0] == "P" else None
        target = Target(kind, *places[-1], words=words, place=m.start(1))
        if kind == "move_c":
            target = replace(target, via=places[0][1], q_via=places[0][0])
        out.append(target.under(*under))
    return out


def _words(v: list[float]) -> Words | None:
    """Return what the figure behind the six numbers of a pose says; None where it has none or leaves it open (-1)."""
    if len(v) < 7 or v[6] < 0:
        return None
    figure = int(v[6])
    return Words("denso", (str(figure),), (figure >> 4 & 1, figure >> 3 & 1))


_HAPPENINGS = Happenings(
    wait=rf"Delay ({NUMBER})", output=r"(?:(?P<on>Set)|Reset) IO\[(?P<port>\d+)\]", comment="'", second=1e3
)


def _said(line: str, state: dict[str, float]) -> Manner | Happening | None:
    del state
    if m := re.match(r"Move ([PLC]),", line):
        stop, share = re.search(rf"@({NUMBER})", line), re.search(rf"Speed = ({NUMBER})", line)
        said = share if m[1] == "P" else re.search(rf"' ({NUMBER}) mm/s$", line)
        speed = None if said is None else float(said[1]) / (100 if m[1] == "P" else 1e3)
        return Manner(speed, blend=None if stop is None else float(stop[1]) / 1e3)
    return _HAPPENINGS.read(line)


_PLACE = rf"(?:J\({listed(6)}\)|P\({listed(6)}(?:, ?-?\d+)?\))"
_LINES = (
    r"'.*",
    r"Sub \w+|End Sub|TakeArm Keep = \d|GiveArm|Delay \d+|(?:Set|Reset) IO\[\d+\]",
    rf"(?:Tool|Work) \d+, P\({listed(6)}\)|Change(?:Tool|Work) \d+",
    rf"Move [PL], @{NUMBER} {_PLACE}(?:, Speed = {NUMBER})?(?: *'.*)?",
    rf"Move C, {_PLACE}, @{NUMBER} {_PLACE}(?: *'.*)?",
)
DIALECT = Dialect("pacscript", (".pcs",), "denso", 64, write, read, _LINES, _said, PACSCRIPT)
