"""The highest constant speed of the tool's point that a section of a path allows."""

from __future__ import annotations

from pieper.kinematics.arrays import ArrayLike
from pieper.motion.constant_speed import Fastest, checked_sections, highest, section_grid
from pieper.motion.even_jerk import fastest_with_jerk
from pieper.motion.limits import Limits
from pieper.motion.timed_path import JointPath, Planned, timed_path


def fastest_constant_speed(
    path: JointPath | ArrayLike, limits: Limits, s0: float, s1: float, *, arm: Planned | None = None
) -> Fastest:
    """Return the highest constant speed of the tool's point from s0 to s1, m/s, of a motion at rest at its ends.

    The run-up before s0 and the run-out after s1 count: a section that begins at 0 or ends at 1 has none and allows
    no speed at all. With a jerk it is the highest one, to a thousandth, that a motion was found for.

    Args:
        path: A route or a track that reaches its end, or joint points (N, n) with `arm`.
        limits: What to keep.
        s0: Where the section begins, 0 to 1.
        s1: Where it ends.
        arm: Whose tool it is, where the path is points alone.

    Returns:
        The speed; .s, .limit, .joint and .why say what forbids more. 0 where the tool stands still in the section.

    Raises:
        InputError: As in `time_law`.
    """
    (section,) = checked_sections([(s0, s1, 1.0)])
    timed, curve = timed_path(path, limits, arm, at=section[:2])
    if limits.jerk is not None:
        return fastest_with_jerk(timed, curve, section)
    timed, _ = section_grid(timed, curve, [section])
    return highest(timed, section)
