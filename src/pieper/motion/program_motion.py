"""A program in time: its runs from stop to stop, one after the other, with what happens on the way."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.motion.instructions import FrameChange, Instruction, Move, ToolChange, Wait
from pieper.motion.joined import event, take, together
from pieper.motion.limits import Limits
from pieper.motion.motion import Motion, sample_times
from pieper.motion.runs import runs
from pieper.motion.segments import Segment


def motion_of_program(
    items: Sequence[Instruction], ways: Sequence[Segment], start: Array, limits: Limits, rate: float
) -> Motion:
    """Return instructions as one timed motion from a posture (n,); `ways` has one a move.

    An output or the gripper happens when the target of the move before is passed. A wait and a change of the tool stop.
    """
    pieces: list[Motion] = []
    events: list[tuple[float, str, object]] = []
    remarks: list[str] = []
    now, number, k = 0.0, 0, 0
    while k < len(items):
        item = items[k]
        if isinstance(item, Wait):
            pieces.append(_rest(item.seconds, pieces, start, rate))
            events.append((now, "wait", item.seconds))
            now += item.seconds
            k += 1
        elif isinstance(item, Move):
            end = k
            while end < len(items) and not isinstance(items[end], (Wait, ToolChange)):
                end += 1
            count = sum(isinstance(x, Move) for x in items[k:end])
            group = [(number + i, ways[number + i - 1]) for i in range(1, 1 + count)]
            passed: list[float] = []
            for run in runs(group[0][1].plan, limits, group, rate):
                passed += [now + t for t in run.passed]
                now = take(run, now, pieces, remarks)
            at = -1
            for x in items[k:end]:
                if isinstance(x, Move):
                    at += 1
                elif not isinstance(x, FrameChange):
                    events.append(event(passed[at], x))
            number += count
            k = end
        else:
            if not isinstance(item, (ToolChange, FrameChange)):
                events.append(event(now, item))
            k += 1
    if not pieces:
        pieces.append(_rest(0.0, pieces, start, rate))
    return together(pieces, events, remarks)


def _rest(seconds: float, before: list[Motion], start: Array, rate: float) -> Motion:
    q = before[-1].q[-1:] if before else start[None]
    t = sample_times(seconds, rate)
    zeros, ends = np.zeros((len(t), q.shape[1])), np.array([0.0, seconds])
    return Motion(t, np.repeat(q, len(t), 0), zeros, zeros, ends, ends, zeros, np.zeros(len(t)))
