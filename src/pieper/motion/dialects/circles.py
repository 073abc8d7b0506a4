"""Circles as controllers take them: in pieces of less than half a turn, each with a via in its middle."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.motion.circle import circle, round_of
from pieper.motion.instructions import Instruction, Move
from pieper.motion.segments import Segment

#: No piece of a circle goes farther round, rad: makers refuse, or advise against, one instruction for half a turn and
#: more, and some take it for the arc on the other side.
MOST_ROUND = np.radians(170.0)
#: Radius of the blend where one piece goes over into the next, at most (m), and as a part of a piece's chord. The way
#: goes on there with its own tangent: the blend keeps the controller from stopping, and cuts next to nothing.
PASSED, OF_CHORD = 0.01, 0.1


def in_pieces(instructions: Sequence[Instruction], ways: Sequence[Segment]) -> tuple[Instruction, ...]:
    """Return instructions whose circles go less than half a turn each; `ways` (one a move) say where the joints are."""
    out: list[Instruction] = []
    each = iter(ways)
    for item in instructions:
        way = next(each) if isinstance(item, Move) else None
        if way is not None and way.move.via is not None:
            out += _pieces(way)
        else:
            out.append(item)
    return tuple(out)


def _pieces(way: Segment) -> list[Move]:
    move = way.move
    assert move.via is not None
    arc = round_of(way.T0, move.via, move.T)
    count = int(np.ceil(arc.angle / MOST_ROUND))
    if count < 2:
        return [move]
    s: Array = np.linspace(0.0, 1.0, 2 * count + 1)[1:-1]
    poses: Array = circle(way.T0, move.via, move.T, s)
    joints = way.curve.at(s)[0]
    chord = 2 * float(np.linalg.norm(arc.spoke)) * np.sin(arc.angle / count / 2)
    passed = min(PASSED, OF_CHORD * chord)
    out: list[Move] = []
    for k in range(count):
        last = k + 1 == count
        via, end = 2 * k, 2 * k + 1
        out.append(
            replace(
                move,
                via=poses[via],
                q_via=joints[via],
                T=move.T if last else poses[end],
                q=move.q if last else joints[end],
                blend=move.blend if last else passed,
            )
        )
    return out
