"""A motion within jerk limits: the fastest one without them, evened out in time, and slowed down where it must be."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import comb

import numpy as np

from pieper import _kernel
from pieper.errors import InputError
from pieper.kinematics.arrays import Array, Indices
from pieper.motion.curve import JointCurve
from pieper.motion.in_time import binding, profile_of, sampled
from pieper.motion.motion import Motion
from pieper.motion.profile import Profile
from pieper.motion.ratios import Ratios, joint_kinds, limits_of_tool
from pieper.motion.timed_path import TimedPath
from pieper.tolerances import JERK_GAIN, ONE_MOMENT, TAKEN_BACK

#: Degree of a joint's speed on a piece: q' of degree 2 in s, s of degree 3 in time, times ds/dt of degree 2.
DEGREE = 8
#: Windows that are tried, as parts of the longest time a joint needs to reach its acceleration.
WINDOWS = (1.0, 1.4, 2.0, 2.8)
#: Rounds in which the path is slowed down where the evened motion passes a limit.
ROUNDS = 10
#: Bounds are taken back by this part of what was passed.
BACK = 0.5


@dataclass(frozen=True, eq=False)
class _Tried:
    duration: float
    factor: float
    profile: Profile


def smooth_motion(timed: TimedPath, curve: JointCurve, rate: float) -> Motion:
    """Return a motion within speeds, accelerations and jerks, at rest at both ends.

    The fastest profile without jerk limits is averaged over a window of time: its steps of acceleration become ramps.
    What passes a limit then is slowed down where it does, round by round, and what is left by the same factor
    everywhere; of several windows the one with the shortest motion is taken. The result is within all limits, proved on
    each piece by Bernstein coefficients; that no motion is faster is not claimed.

    Raises:
        InputError: A limit of the tool's acceleration besides the jerk, which is not planned.
    """
    if timed.limits.tool_acceleration is not None:
        raise InputError(
            "limits of the tool's acceleration and of the joints' jerk at once are not planned; leave one out.",
            given=timed.limits.tool_acceleration,
        )
    jerk = timed.bound.jerk
    assert jerk is not None
    ramp = float((timed.bound.acceleration / jerk).max())
    best = _best_window(timed, curve, ramp)
    profile, factor = best.profile, best.factor
    while True:
        profile, ratios = peaks(timed, curve, profile.slower(factor))
        if ratios.margin <= 1:
            break
        factor = float(ratios.stretch().max()) * (1 + TAKEN_BACK)
    t, q, dq, ddq, dddq, s = sampled(curve, profile, rate)
    ends = np.array([0.0, profile.duration])
    tight = tuple(binding(profile.t, ratios))
    return Motion(
        t,
        q,
        dq,
        ddq,
        ends,
        ends,
        dddq,
        s,
        tight,
        ratios.margin,
        deviation=curve.between_points(),
        limits=timed.limits,
        description=timed.description,
    )


def _best_window(timed: TimedPath, curve: JointCurve, ramp: float) -> _Tried:
    """Return the best of the windows, gone through from the second one on towards what is shorter."""
    best = _at_window(timed, curve, WINDOWS[1] * ramp)
    for parts in (WINDOWS[2:], WINDOWS[:1]):
        before = best
        for part in parts:
            found = _at_window(timed, curve, part * ramp)
            if found.duration >= best.duration:
                break
            best = found
        if best is not before:
            break
    return best


def _at_window(timed: TimedPath, curve: JointCurve, window: float) -> _Tried:
    """Return the best of some rounds at one window."""
    best: _Tried | None = None
    easing = np.ones(len(timed.share))
    for _ in range(ROUNDS):
        x, _, _, _ = replace(timed, easing=easing).run()
        even = averaged(profile_of(timed.curve.s, x), window)
        profile, ratios = peaks(timed, curve, even, proved=False)
        need = ratios.stretch()
        factor = max(float(need.max()), 1.0)
        found = _Tried(profile.duration * factor, factor, profile)
        if best is None or found.duration < best.duration * (1 - JERK_GAIN):
            best = found
        else:
            break
        if factor <= 1 + JERK_GAIN:
            break
        # where the evened motion is too fast the profile under the window is taken back
        over = np.flatnonzero(need > 1)
        s = timed.curve.s
        first = np.searchsorted(s, even.place(np.maximum(profile.t[over] - window, 0.0))) - 1
        last = np.searchsorted(s, np.append(profile.c[1:, 0], s[-1])[over])
        easing = easing / _largest_over(np.maximum(first, 0), np.maximum(last, 1), need[over], len(easing)) ** BACK
    assert best is not None
    return best


def _largest_over(first: Indices, last: Indices, values: Array, count: int) -> Array:
    """Return for each of `count` cells the largest of the values (m,), above one, whose cells [first, last) hold it.

    Both ends ascend, so that the values over a cell stand in a row.
    """
    cell = np.arange(count)
    begin, end = np.searchsorted(last, cell, side="right"), np.searchsorted(first, cell, side="right")
    over = end > begin
    out = np.ones(count)
    pairs = np.stack([begin[over], end[over]], 1).ravel()
    out[over] = np.maximum.reduceat(np.append(values, 1.0), pairs)[::2] if len(pairs) else 1.0
    return out


def averaged(profile: Profile, window: float) -> Profile:
    """Return the profile averaged over the window of time before each moment; it lasts longer by the window.

    Its pieces are cubic where the given ones are quadratic: ds/dt becomes (s(t) - s(t - window)) / window, and so on.
    """
    return Profile(*_kernel.evened(profile.t, profile.c, window, ONE_MOMENT))


def _bernstein() -> Array:
    """Return the matrix from values at DEGREE + 1 even places to Bernstein coefficients."""
    u = np.linspace(0, 1, DEGREE + 1)[:, None]
    k = np.arange(DEGREE + 1)
    binomial = np.array([comb(DEGREE, i) for i in k])
    return np.asarray(np.linalg.inv(binomial * u**k * (1 - u) ** (DEGREE - k)), float)


_COEFFICIENTS, _NONE = _bernstein(), np.zeros((0, 0))


def peaks(timed: TimedPath, curve: JointCurve, profile: Profile, *, proved: bool = True) -> tuple[Profile, Ratios]:
    """Return a profile split where the curve's pieces meet, and bounds of what it uses of every limit on its pieces.

    Where they need not be `proved` the largest of three values is taken instead: enough for a search.
    """
    bound = timed.bound
    assert bound.jerk is not None
    t, c, values, fastest = _kernel.jerk_ratios(
        s=curve.s,
        d1=curve.d1,
        d2=curve.d2,
        d3=curve.d3,
        t=profile.t,
        c=profile.c,
        speed=bound.speed,
        acceleration=bound.acceleration,
        jerk=bound.jerk,
        grid=timed.curve.s,
        share=timed.share,
        coefficients=_COEFFICIENTS if proved else _NONE,
        moment=ONE_MOMENT,
    )
    split, kinds = Profile(t, c), joint_kinds(timed.names, "speed", "acceleration", "jerk")
    if timed.tool is None or not limits_of_tool(timed):
        return split, Ratios(kinds, values)
    first, last = timed.curve.piece(c[:, 0]), timed.curve.piece(np.append(c[1:, 0], 1.0))
    speeds = [("tool speed", timed.tool.point, timed.tool.point_strays, timed.tool_speed)]
    if timed.limits.turn_speed is not None:
        speeds.append(("turn speed", timed.tool.turn, timed.tool.turn_strays, timed.limits.turn_speed * timed.share))
    rows: list[Array] = []
    for _, value, strays, most in speeds:
        size = np.linalg.norm(value, axis=1)
        top = np.maximum(size[:-1], size[1:]) + strays
        ratio = np.maximum.reduceat(np.append(top / most, 0.0), np.stack([first, last + 1], 1).ravel())[::2]
        rows.append(ratio * fastest)
    return split, Ratios((*kinds, *((name, None) for name, *_ in speeds)), np.vstack([values, *rows]))
