"""A program in sentences: a line an instruction, and what its motion keeps."""

from __future__ import annotations

from collections.abc import Sequence

from pieper.kinematics.spoken import read_pose
from pieper.motion.instructions import Events, FrameChange, Instruction, Move, ToolChange
from pieper.motion.motion import Motion
from pieper.words_by_number import plural

_WORDS = {"move_j": "joints to", "move_l": "line to", "move_c": "circle to", "move_s": "spline to"}
_EVENTS = Events(
    wait=lambda seconds: f"wait {seconds:g} s",
    output=lambda port, value: f"output {port} {'on' if value else 'off'}",
    gripper=lambda value: f"gripper {value:g}",
)


def told(name: str, instructions: Sequence[Instruction], motion: Motion, strays: float) -> str:
    """Return a program of an arm as sentences.

    Args:
        name: The arm's.
        instructions: In order.
        motion: All of it in time.
        strays: How far lines, circles and splines are left, m.
    """
    count = sum(isinstance(item, Move) for item in instructions)
    lines = [f"{plural(count, 'move')} of {name}, {motion.duration:z.3f} s in all."]
    number = 0
    for item in instructions:
        if isinstance(item, Move):
            number += 1
            x, y, z = (round(float(v) * 1e3, 1) + 0.0 for v in item.T[:3, 3])
            corner = f", blend {item.blend * 1e3:g} mm" if item.blend else ""
            lines.append(f"{number}. {_WORDS[item.kind]} x {x:z.1f}, y {y:z.1f}, z {z:z.1f} mm{corner}")
        elif isinstance(item, (ToolChange, FrameChange)):
            what = "tool" if isinstance(item, ToolChange) else "targets in the frame"
            x, y, z, roll, pitch, yaw = (f"{v:z.1f}" for v in read_pose(item.T, "rpy", degrees=True, mm=True))
            lines.append(f"   {what} at x {x}, y {y}, z {z} mm, roll {roll}, pitch {pitch}, yaw {yaw} deg")
        else:
            lines.append("   " + _EVENTS.said(item))
    kept = f"lines, circles and splines are kept to {strays * 1e6:.2g} um"
    lines.append(f"The largest value over its limit is {motion.margin:z.6f}; {kept}.")
    return "\n".join([*lines, *motion.remarks])
