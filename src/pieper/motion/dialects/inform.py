"""Yaskawa INFORM: poses with RCONF; joint values are pulses there, which need the arm's gears."""

from __future__ import annotations

import re
from collections.abc import Callable

from pieper.kinematics.arrays import Array
from pieper.kinematics.spoken import pose, read_pose
from pieper.motion.dialects.configuration import configuration
from pieper.motion.dialects.dialect import USUAL_SPEED, Dialect, Script, Target, fixed, found, numbers
from pieper.motion.instructions import Events, Move

#: A comment has no more characters.
_COMMENT = 32


_EVENTS = Events(
    wait=lambda seconds: f"TIMER T={fixed(seconds, 2)}",
    output=lambda port, value: f"DOUT OT#({port}) {'ON' if value else 'OFF'}",
    gripper=lambda value: f"' gripper {value:g}",
)


def write(script: Script) -> str:
    """Return the text of a job. Positions of one RCONF stand together under it."""
    positions: list[str] = []
    lines: list[str] = []
    last = ""

    def place(q: Array, T: Array) -> str:
        nonlocal last
        said = configuration(script.plan, q, "yaskawa")
        words = f"///RCONF {','.join([*said.words, *(str(t) for t in said.turns), '0', '0'])}"
        if words != last:
            positions.append(words)
            last = words
        index = sum(line.startswith("C") for line in positions)
        values = read_pose(T, "yaskawa", degrees=True, mm=True)
        positions.append(f"C{index:05d}={numbers(values[:3], 4, ',')},{numbers(values[3:], 5, ',')}")
        return f"C{index:05d}"

    for item in script.instructions:
        lines += _move(item, place) if isinstance(item, Move) else [_EVENTS.said(item)]
    count = sum(line.startswith("C") for line in positions)
    head = ["/JOB", f"//NAME {script.name.upper()}", "//POS", f"///NPOS {count},0,0,0,0,0", "///TOOL 0"]
    head += ["///POSTYPE ROBOT", "///RECTAN", *positions, "//INST", "///ATTR SC,RW,RJ", "///GROUP1 RB1", "NOP"]
    return "\n".join([*head, *script.head("'", _COMMENT), *lines, "END", ""])


def _move(move: Move, place: Callable[[Array, Array], str]) -> list[str]:
    # PL is a level of positioning, not a radius
    stop = f" PL={min(8, 1 + round(move.blend * 100))}" if move.blend else " PL=0"
    if move.kind == "move_j":
        share = 100.0 if move.speed is None else 100 * move.speed
        return [f"MOVJ {place(move.q, move.T)} VJ={fixed(share, 2)}{stop}"]
    speed = f"V={fixed(USUAL_SPEED if move.speed is None else move.speed * 1e3, 1)}"
    if move.via is not None and move.q_via is not None:
        return [f"MOVC {place(move.q_via, move.via)} {speed}", f"MOVC {place(move.q, move.T)} {speed}{stop}"]
    return [f"MOVL {place(move.q, move.T)} {speed}{stop}"]


def read(text: str) -> list[Target]:
    """Return the targets of a job, in the order of its moves; two MOVC in a row are one circle."""
    places: dict[str, Array] = {}
    for m in re.finditer(r"^(C\d+)=(.*)$", text, re.M):
        v = found(m[2], 6)
        places[m[1]] = pose(*v[:3], yaskawa=v[3:], degrees=True, mm=True)
    out: list[Target] = []
    via: Array | None = None
    for m in re.finditer(r"^(MOVJ|MOVL|MOVC)\s+(C\d+)", text, re.M):
        if m[1] == "MOVC" and via is None:
            via = places[m[2]]
        elif m[1] == "MOVC":
            out.append(Target("move_c", T=places[m[2]], via=via))
            via = None
        else:
            out.append(Target("move_j" if m[1] == "MOVJ" else "move_l", T=places[m[2]]))
    return out


DIALECT = Dialect("inform", (".jbi",), "yaskawa", 32, write, read)
