"""One run of a program: moves that are passed without a stop, as one timed motion."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.motion.blend import Blend, blend, blended_points
from pieper.motion.curve import JointCurve
from pieper.motion.in_time import sampled
from pieper.motion.jerk import smooth_motion
from pieper.motion.joint_move import margin_of_line, straight_profile, tight_pieces
from pieper.motion.limits import Limits
from pieper.motion.motion import Motion
from pieper.motion.segments import Segment
from pieper.motion.time_law import motion_of
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
    first = ways[0].move
    if len(ways) == 1 and first.kind == "move_j" and not limits.of_the_tool:
        motion = _straight(plan, limits, ways[0], rate)
        return motion, [motion.duration]
    curve, owner, middles = _joined(plan, ways, corners)
    share = np.array([_share(ways[i]) for i in owner])
    speed = np.array([_tool_speed(ways[i]) for i in owner])
    timed = on_grid(curve, limits, plan.names, plan, share=share, tool_speed=speed)
    deviation = curve.between_points()
    if limits.jerk is None:
        x, _, _, _ = timed.run()
        motion = motion_of(timed, x, deviation, rate)
    else:
        motion = smooth_motion(timed, curve, rate)
    return motion, [*np.interp(middles, motion.s, motion.t).tolist(), motion.duration]


def _share(way: Segment) -> float:
    return way.move.speed if way.move.kind == "move_j" and way.move.speed is not None else 1.0


def _tool_speed(way: Segment) -> float:
    return way.move.speed if way.move.kind != "move_j" and way.move.speed is not None else np.inf


def _straight(plan: Plan, limits: Limits, way: Segment, rate: float) -> Motion:
    """Return a joint move by itself, in closed form."""
    start = way.curve.q[0]
    step = way.move.q - start
    share = _share(way)
    profile, names = straight_profile(step, limits, plan.names, share)
    assert profile is not None
    line = JointCurve(np.array([0.0, 1.0]), start[None], step[None], np.zeros((1, plan.n)), np.zeros((1, plan.n)))
    t, q, dq, ddq, dddq, s = sampled(line, profile, rate)
    q[-1] = way.move.q
    slower = replace(limits, speed=np.asarray(limits.speed) * share)
    ends = np.array([0.0, profile.duration])
    tight = tuple(tight_pieces(profile, names))
    return Motion(t, q, dq, ddq, ends, ends, dddq, s, tight, margin_of_line(step, profile, slower))


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
        s = np.concatenate([[begins], inner, [ends]])
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
