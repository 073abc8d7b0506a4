"""The fastest motion along a joint path within limits, certified on the whole continuous curve."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from pieper.kinematics.arrays import Array, ArrayLike
from pieper.motion.constant_speed import checked_sections, highest, refused, section_grid
from pieper.motion.curve import JointCurve
from pieper.motion.even_jerk import even_motion
from pieper.motion.in_time import binding, profile_of, sampled
from pieper.motion.jerk import smooth_motion
from pieper.motion.limits import Limits
from pieper.motion.motion import Motion
from pieper.motion.ratios import Ratios, peak_ratios
from pieper.motion.straight import straight_motion
from pieper.motion.timed_path import JointPath, Planned, TimedPath, timed_path
from pieper.tolerances import EVEN_SPEED, LIMIT_SLACK, TAKEN_BACK

#: Rounds in which pieces are eased whose bounds pass a limit.
ROUNDS = 8


def time_law(
    path: JointPath | ArrayLike,
    limits: Limits,
    *,
    constant_speed: Sequence[tuple[float, float, float]] = (),
    rate: float = 500.0,
    arm: Planned | None = None,
) -> Motion:
    """Return the fastest motion along a path, at rest at both ends.

    The path is the cubic spline through the points, twice continuously differentiable in s, which is uniform for points
    and their own for a track or a route; `motion.deviation` says how far it strays from the straight joint lines
    between them. Its parameter runs with a constant second derivative on each of 1000 cells or more; speed and
    acceleration are kept on all of each cell, not at its ends alone.

    Args:
        path: A route or a track that reaches its end, or joint points (N, n), rad or m.
        limits: What to keep. With a jerk the motion is within all limits, but not proved to be the fastest one.
        constant_speed: Sections (s0, s1, v) of constant speed v of the tool's point, m/s.
        rate: Samples a second; the end is always a sample.
        arm: Whose tool it is, where the path is points alone.

    Returns:
        The Motion; its margin is the largest value over its limit on the continuous curve, at most 1.

    Raises:
        InputError: Fewer than two points, repeated ones, numbers that are not finite, limits for another arm; a section
            that cannot be: the message says where, because of which joint, and the speed that would do.

    Source:
        Pham and Pham (2018), A new approach to time-optimal path parameterization based on reachability analysis; the
        rows that hold on all of a cell are this package's.
    """
    asked = checked_sections(constant_speed)
    timed, curve = timed_path(path, limits, arm, at=[s for section in asked for s in section[:2]])
    if not asked:
        return _told_outside(fastest_motion(timed, curve, rate), timed, curve)
    if limits.jerk is not None:
        return _told_outside(even_motion(timed, curve, asked, rate), timed, curve)
    timed, wanted = section_grid(timed, curve, asked)
    found = fastest_certified(timed, wanted)
    # a motion ends at rest, whatever speed is wanted there
    if found is None or asked[-1][1] >= 1:
        raise refused(asked, lambda section: highest(timed, section))
    return _told_outside(_motion_of(timed, *found, curve.between_points(), rate), timed, curve)


def fastest_motion(timed: TimedPath, curve: JointCurve, rate: float) -> Motion:
    """Return the fastest motion along a curve: in closed form on a straight line, with a jerk by `smooth_motion`."""
    straight = straight_motion(timed, curve, rate)
    if straight is not None:
        return straight
    if timed.limits.jerk is not None:
        return smooth_motion(timed, curve, rate)
    found = fastest_certified(timed)
    assert found is not None  # what has no section can stand still anywhere
    return _motion_of(timed, *found, curve.between_points(), rate)


def fastest_certified(timed: TimedPath, wanted: Array | None = None) -> tuple[Array, Ratios] | None:
    """Return the fastest profile x (k + 1,) that keeps its limits on all of each piece, and what it uses of them.

    Where the bounds of the tool between the grid's points pass a limit, those pieces alone are eased. None where what
    is wanted cannot be had; without sections what is left after some rounds is slowed as a whole.
    """
    rounds = 0
    while True:
        x, _, done, _ = timed.run(wanted)
        if not done:
            return None
        ratios = peak_ratios(timed, x)
        if ratios.margin <= 1 + EVEN_SPEED:
            return x, ratios
        rounds += 1
        if rounds == ROUNDS:
            return (x, ratios) if wanted is None else None
        timed = replace(timed, easing=timed.eased / np.maximum(ratios.stretch(), 1.0))


def _told_outside(motion: Motion, timed: TimedPath, curve: JointCurve) -> Motion:
    """Return the motion with a remark for each joint that the curve between the points carries beyond its limits."""
    if timed.plan is None:
        return motion
    said: list[str] = []
    for j, (low, high) in enumerate(timed.plan.limits):
        beyond = np.maximum(motion.q[:, j] - high, low - motion.q[:, j])
        k = int(np.argmax(beyond))
        if beyond[k] > LIMIT_SLACK:
            unit, scale = ("mm", 1e3) if timed.plan.prismatic[j] else ("deg", np.degrees(1.0))
            asked = curve.points[:, j]
            why = (
                "the points themselves are. Give points inside, a whole turn away where that helps."
                if max(asked.max() - high, low - asked.min()) > LIMIT_SLACK
                else "the curve through the points swings out there. Give more points, or keep them farther inside."
            )
            said.append(
                f"{timed.names[j]} is {beyond[k] * scale:.3g} {unit} beyond its limits at {motion.t[k]:.3g} s: {why}"
            )
    return replace(motion, remarks=(*motion.remarks, *said)) if said else motion


def _motion_of(timed: TimedPath, x: Array, ratios: Ratios, deviation: float, rate: float) -> Motion:
    """Return the motion of a profile x (k + 1,), slowed down where it passes a limit."""
    while ratios.margin > 1:
        factor = float(ratios.stretch().max()) * (1 + TAKEN_BACK)
        x, ratios = x / factor**2, ratios.slower(factor)
    profile = profile_of(timed.curve.s, x)
    tight = binding(profile.t, ratios)
    return timed.motion(sampled(timed.curve, profile, rate), tight, ratios.margin, profile.duration, deviation)
