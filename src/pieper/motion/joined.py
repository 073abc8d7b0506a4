"""The pieces of a program put together: runs one after the other as one motion, and what happens between them."""

from __future__ import annotations

import numpy as np

from pieper import arguments
from pieper.kinematics.arrays import Array
from pieper.motion.instructions import Gripper, Instruction, Output
from pieper.motion.motion import Motion, Tight
from pieper.motion.runs import Run


def take(run: Run, now: float, pieces: list[Motion], remarks: list[str]) -> float:
    """Put a run behind the pieces before it and return when it ends, s."""
    pieces.append(run.motion)
    remarks += run.remarks
    return now + run.motion.duration


def event(time: float, item: Instruction) -> tuple[float, str, object]:
    """Return an output or the gripper as an event of a motion."""
    if isinstance(item, Output):
        return time, "output", (item.port, item.value)
    assert isinstance(item, Gripper)
    return time, "gripper", item.value


def together(pieces: list[Motion], events: list[tuple[float, str, object]], remarks: list[str]) -> Motion:
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


def positive(value: object, what: str, unit: str, most: float = np.inf) -> float:
    """Return a positive number that was given, or say what it must be."""
    return arguments.number(value, what, unit, above=0.0, most=most)


def radius(value: object) -> float:
    """Return the radius of a blend, m, or say what it must be."""
    return arguments.number(value, "blend", "a radius, m", least=0.0)
