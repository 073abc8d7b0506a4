"""A move from posture to posture on the straight joint line, all joints together, in closed form."""

from __future__ import annotations

import numpy as np

from pieper.errors import InputError
from pieper.kinematics.arrays import Array, ArrayLike
from pieper.motion.limits import Limits
from pieper.motion.motion import Motion, Tight, sample_times
from pieper.motion.profile import Profile, phases, rest_to_rest
from pieper.tolerances import LIMIT_KEPT, TOP_REACHED
from pieper.words_by_number import plural


def joint_move(q0: ArrayLike, q1: ArrayLike, limits: Limits, *, rate: float = 500.0) -> Motion:
    """Return the fastest move from q0 to q1 at rest at both ends, on the straight joint line.

    All joints begin and end together and keep one proportion (they are synchronised in phase). The profile is a
    trapezoid of speed, or seven segments where a jerk is given; one joint's limit binds at any time but for pauses
    between.

    Args:
        q0: (n,) first posture, rad or m.
        q1: (n,) last posture, rad or m; equal to q0 gives a motion of no duration.
        limits: Speeds, accelerations and jerks; limits of the tool are for `time_law`.
        rate: Samples a second; the end is always a sample.

    Raises:
        InputError: Not two joint vectors, limits for another number of joints, or limits of the tool.
    """
    start, way = _two(q0, q1)
    if limits.of_the_tool:
        raise InputError("a joint move in closed form knows the joints' limits alone; time_law keeps the tool's too.")
    profile, binding = straight_profile(way, limits)
    if profile is None:
        zeros = np.zeros((1, len(way)))
        return Motion(
            np.zeros(1), start[None], zeros, zeros, np.zeros(2), np.zeros(2), zeros, np.ones(1), limits=limits
        )
    t = sample_times(profile.duration, rate)
    s, v, a, j = (x[:, None] for x in profile.at(t))
    q = np.where(s >= 1, start + way, start + way * s)
    q[-1] = start + way
    ends = np.array([0.0, profile.duration])
    tight = tuple(tight_pieces(profile, binding))
    s[-1] = 1.0
    margin = margin_of_line(way, profile, limits)
    return Motion(t, q, way * v, way * a, ends, ends, way * j, s[:, 0], tight, margin, limits=limits)


def joint_move_time(q0: ArrayLike, q1: ArrayLike, limits: Limits) -> Array:
    """Return how long moves from q0 (..., n) to q1 (..., n) take, (...), s; see `joint_move`."""
    way = np.abs(np.asarray(q1, float) - np.asarray(q0, float))
    bound = limits.of(way.shape[-1])
    with np.errstate(divide="ignore"):
        least = [(row / way).min(-1) for row in (bound.speed, bound.acceleration)]
        sharpest = None if bound.jerk is None else (bound.jerk / way).min(-1)
    rest = np.isinf(least[0])
    speed, acceleration = (np.where(rest, 1.0, value) for value in least)
    jerk = None if sharpest is None else np.where(rest, 1.0, sharpest)
    _, Ta, Tv = phases(speed, acceleration, jerk)
    return np.where(rest, 0.0, 2 * Ta + Tv)


def straight_profile(
    way: Array, limits: Limits, names: tuple[str, ...] | None = None, share: float = 1.0
) -> tuple[Profile | None, list[str]]:
    """Return the profile of a straight way (n,), None where it has no length, and which joint binds each derivative.

    Args:
        way: (n,) difference of postures, rad or m.
        limits: The limits.
        names: Joint names.
        share: Part of the speed limit that is used.
    """
    bound = limits.of(len(way), names)
    size = np.abs(way)
    if not size.any():
        return None, []
    names = names or tuple(f"joint {j + 1}" for j in range(len(way)))
    rows = [bound.speed * share, bound.acceleration, *([bound.jerk] if bound.jerk is not None else [])]
    with np.errstate(divide="ignore"):
        ratios = [row / size for row in rows]
    least = [float(r.min()) * (1 - LIMIT_KEPT) for r in ratios]
    profile = rest_to_rest(least[0], least[1], least[2] if len(least) > 2 else None)
    passed = margin_of_line(way, profile, limits, share)
    if passed > 1:
        # phases of very different lengths leave more rounding than was allowed for
        profile = profile.slower(passed * (1 + LIMIT_KEPT))
    return profile, [names[int(np.argmin(r))] for r in ratios]


def margin_of_line(way: Array, profile: Profile, limits: Limits, share: float = 1.0) -> float:
    """Return the largest value over its limit of a straight way under a profile: its peaks lie where pieces meet.

    `share` is the part of the speed limit that is used.
    """
    bound = limits.of(len(way))
    length = np.diff(profile.t)
    speeds = np.concatenate(
        [profile.c[:, 1], profile.c[:, 1] + length * (profile.c[:, 2] + length * profile.c[:, 3] / 2)]
    )
    bends = np.concatenate([profile.c[:, 2], profile.c[:, 2] + length * profile.c[:, 3]])
    peaks = [(np.abs(speeds).max(), bound.speed * share), (np.abs(bends).max(), bound.acceleration)]
    if bound.jerk is not None:
        peaks.append((np.abs(profile.c[:, 3]).max(), bound.jerk))
    return float(max((np.abs(way) * peak / limit).max() for peak, limit in peaks))


def tight_pieces(profile: Profile, binding: list[str]) -> list[Tight]:
    """Return which joint's limit binds on each piece."""
    out: list[Tight] = []
    top = np.abs(profile.c[:, 1]).max()
    for i, (_, v, a, j) in enumerate(profile.c):
        level = 2 if j else 1 if a else 0
        if level == 0 and v < top * (1 - TOP_REACHED):
            continue
        name = ("speed", "acceleration", "jerk")[level]
        out.append(Tight(float(profile.t[i]), float(profile.t[i + 1]), name, binding[level]))
    return out


def _two(q0: ArrayLike, q1: ArrayLike) -> tuple[Array, Array]:
    pair: list[Array] = []
    for q, what in ((q0, "q0"), (q1, "q1")):
        try:
            array = np.array(q, dtype=float)
        except (TypeError, ValueError):
            raise InputError(f"{what} must be a joint vector (n,), got {type(q).__name__}.", given=q) from None
        if array.ndim != 1 or not array.size:
            raise InputError(f"{what} must be one joint vector (n,), got shape {array.shape}.", given=array.shape)
        if not np.isfinite(array).all():
            index = int(np.argmin(np.isfinite(array)))
            raise InputError(f"{what} must be finite, got {array[index]} at joint {index + 1}.", joint=index + 1)
        pair.append(array)
    if len(pair[0]) != len(pair[1]):
        raise InputError(
            f"q0 has {plural(len(pair[0]), 'joint')} and q1 has {len(pair[1])}.", given=(len(pair[0]), len(pair[1]))
        )
    return pair[0], pair[1] - pair[0]
