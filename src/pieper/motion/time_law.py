"""The fastest motion along a joint path within limits, certified on the whole continuous curve."""

from __future__ import annotations

from collections.abc import Sequence

from pieper.errors import InputError
from pieper.kinematics.arrays import ArrayLike
from pieper.motion.constant_speed import checked_sections, section_grid, why_not
from pieper.motion.from_profile import motion_of
from pieper.motion.limits import Limits
from pieper.motion.motion import Motion
from pieper.motion.timed_path import JointPath, Planned, timed_path


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
    if limits.jerk is not None:
        from pieper.motion.jerk import smooth_motion

        if asked:
            raise InputError("a section of constant speed and a jerk limit at once are not planned; leave one out.")
        return smooth_motion(timed, curve, rate)
    wanted = None
    if asked:
        timed, wanted = section_grid(timed, curve, asked)
    x, _, done, _ = timed.run(wanted)
    if not done:
        raise why_not(timed, asked)
    return motion_of(timed, x, curve.between_points(), rate)
