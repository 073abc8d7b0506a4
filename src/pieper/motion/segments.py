"""A move's way through the joints: points close enough that the spline through them is the line or the circle."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper.errors import InputError, NoSolutionError
from pieper.kinematics.arrays import Array
from pieper.kinematics.forward import fk
from pieper.kinematics.pose import pose_error
from pieper.motion.circle import circle
from pieper.motion.curve import JointCurve
from pieper.motion.following import followed
from pieper.motion.instructions import Move
from pieper.motion.path import between
from pieper.motion.spline import spline
from pieper.solver.plan.plan import Plan
from pieper.tolerances import PROGRAM_FOLLOWS_ON, PROGRAM_STANDS, STRAYS

#: Points of a line or a circle, at first and at most.
POINTS, MOST_POINTS = 33, 2049
#: Points of a joint move, where it is joined with others.
STRAIGHT_POINTS = 17
_CURES = "What would let it pass was not looked for: following the same way by itself (arm.follow, pieper path) does."


@dataclass(frozen=True, eq=False)
class Segment:
    """The way of one move.

    Attributes:
        move: The move.
        curve: Its joint curve, s from 0 to 1.
        strays: How far the tool is from the line or circle asked for, at most, m; 0 for joint moves.
        T0: (4, 4) the pose it begins at.
        plan: How the arm is solved with the tool that it has then.
    """

    move: Move
    curve: JointCurve
    strays: float
    T0: Array
    plan: Plan


def segment(plan: Plan, number: int, q0: Array, T0: Array, move: Move) -> Segment:
    """Return the way of a move from posture q0 (n,) and pose T0 (4, 4).

    Raises:
        NoSolutionError: A line or a circle cannot be followed; the message says where and why.
        InputError: The move has no length.
    """
    if move.kind == "move_j":
        if np.array_equal(q0, move.q):
            raise InputError(f"move {number} has no length: the arm is there already. Leave it out.", move=number)
        s = np.linspace(0.0, 1.0, STRAIGHT_POINTS)
        return Segment(move, JointCurve.through(s, q0 + s[:, None] * (move.q - q0)), 0.0, T0, plan)
    if move.through is None and (_missed(plan, T0[None], move.T[None]) < PROGRAM_STANDS).all():
        raise InputError(f"move {number} has no length: the tool is there already. Leave it out.", move=number)
    points = POINTS
    while True:
        s = np.linspace(0.0, 1.0, points)
        track = followed(plan, _poses(T0, move, s), start=q0)
        if not track.complete:
            raise NoSolutionError(f"move {number} cannot be followed. {track.explain()}\n{_CURES}", move=number)
        if np.abs(plan.chain.joints.difference(track.q[0], q0)).max() > PROGRAM_FOLLOWS_ON:
            raise NoSolutionError(
                f"move {number} cannot begin: its line leaves the posture the arm is in at once.", move=number
            )
        curve = JointCurve.through(s, track.q)
        middle = (s[1:] + s[:-1]) / 2
        off = _missed(plan, fk(plan.chain, curve.at(middle)[0]), _poses(T0, move, middle))
        if off.max() <= STRAYS or points >= MOST_POINTS:
            return Segment(move, curve, float(off[:, 0].max()), T0, plan)
        points = 2 * points - 1


def _missed(plan: Plan, T: Array, wanted: Array) -> Array:
    """Return what poses (k, 4, 4) miss of what the arm's task asks for, (k, 2): m and rad."""
    off = pose_error(T, wanted)
    if plan.task == "position":
        off[:, 1] = 0.0
    elif plan.task == "position+axis":
        off[:, 1] = np.linalg.norm(T[:, :3, 2] - wanted[:, :3, 2], axis=1)
    return off


def _poses(T0: Array, move: Move, s: Array) -> Array:
    if move.through is not None:
        return spline(T0, move.through, s)
    return between(T0, move.T, s) if move.via is None else circle(T0, move.via, move.T, s)
