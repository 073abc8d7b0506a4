"""One run of a program: moves that are passed without a stop, as one timed motion."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.motion.blend import Blend, blend, blended_points
from pieper.motion.curve import JointCurve
from pieper.motion.limits import Limits
from pieper.motion.motion import Motion
from pieper.motion.segments import Segment
from pieper.motion.time_law import fastest_motion
from pieper.motion.timed_path import on_grid
from pieper.solver.plan.plan import Plan


@dataclass(frozen=True, eq=False)
class Run:
    """Moves between two stops.

    Attributes:
        motion: Their motion, s from 0 to 1 over all of them.
        passed: When each move's target is passed, s; the last one is the end.
        remarks: What is not as asked.
    """

    motion: Motion
    passed: list[float]
    remarks: list[str]


def runs(plan: Plan, limits: Limits, moves: list[tuple[int, Segment]], rate: float) -> list[Run]:
    """Return the runs of numbered moves between two waits: a corner that is not blended ends one."""
    out: list[Run] = []
    group: list[tuple[int, Segment]] = []
    corners: list[Blend] = []
    remarks: list[str] = []
    for k, (number, way) in enumerate(moves):
        group.append((number, way))
        last = k + 1 == len(moves)
        corner, remark = None, None
        if way.move.blend > 0 and not last:
            corner, remark = blend(plan.chain, way, moves[k + 1][1], number)
        elif way.move.blend > 0:
            remark = f"The arm rests after move {number}: its blend is left out."
        if remark:
            remarks.append(remark)
        if corner is not None:
            corners.append(corner)
            continue
        motion, passed = _timed(plan, limits, [w for _, w in group], corners, rate)
        out.append(Run(motion, passed, remarks))
        group, corners, remarks = [], [], []
    return out


def _timed(
    plan: Plan, limits: Limits, ways: list[Segment], corners: list[Blend], rate: float
) -> tuple[Motion, list[float]]:
    curve, owner, middles = _joined(plan, ways, corners)
    share = np.array([_share(ways[i]) for i in owner])
    speed = np.array([_tool_speed(ways[i]) for i in owner])
    timed = on_grid(curve, limits, plan.names, plan, share=share, tool_speed=speed)
    motion = fastest_motion(timed, curve, rate)
    return motion, [*np.interp(middles, motion.s, motion.t).tolist(), motion.duration]


def _share(way: Segment) -> float:
    return way.move.speed if way.move.kind == "move_j" and way.move.speed is not None else 1.0


def _tool_speed(way: Segment) -> float:
    return way.move.speed if way.move.kind != "move_j" and way.move.speed is not None else np.inf


def _joined(plan: Plan, ways: list[Segment], corners: list[Blend]) -> tuple[JointCurve, list[int], list[float]]:
    """Return one curve through ways with their corners cut, whose move each piece belongs to, and s of the corners."""
    points: list[Array] = []
    owner: list[int] = []
    middle_at: list[int] = []
    begins = 0.0
    for k, way in enumerate(ways):
        ends = corners[k].leaves if k < len(corners) else 1.0
        own = way.curve.s
        inner = own[(own > begins) & (own < ends)]
        # a point that nearly is an end is that end
        inner = inner[(inner - begins > 0.1 * own[1]) & (ends - inner > 0.1 * own[1])]
        # of a way that both its corners cut at its half nothing is left but that point
        left = ends - begins > 0.1 * own[1]
        s = np.concatenate([[begins], inner, [ends]]) if left else np.array([begins])
        q = way.curve.at(s)[0]
        if k + 1 == len(ways):
            q[-1] = way.move.q
        points.append(q if k == 0 else q[1:])
        owner += [k] * (len(q) - 1)
        if k < len(corners):
            cut = blended_points(way.curve, ways[k + 1].curve, corners[k])
            middle_at.append(len(owner) + len(cut) // 2)
            points.append(cut[1:])
            owner += [k] * (len(cut) // 2) + [k + 1] * (len(cut) - 1 - len(cut) // 2)
            begins = corners[k].meets
    q = np.vstack(points)
    length = np.linalg.norm(np.diff(q, axis=0) / plan.chain.joints.unit, axis=1)
    if len(ways) == 1:
        s = ways[0].curve.s
    else:
        s = np.concatenate([[0.0], np.cumsum(length)]) / length.sum()
    s[-1] = 1.0
    return JointCurve.through(s, q), owner, [float(s[i]) for i in middle_at]
