"""A motion within jerk limits: the fastest one without them, evened out in time, and slowed down where it must be."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import comb

import numpy as np

from pieper.errors import InputError
from pieper.kinematics.arrays import Array
from pieper.motion.curve import JointCurve
from pieper.motion.in_time import binding, profile_of, sampled
from pieper.motion.motion import Motion
from pieper.motion.profile import Profile
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
    ratios: list[tuple[str, str | None, Array]]


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
    best: _Tried | None = None
    for part in WINDOWS:
        found = _at_window(timed, curve, part * ramp)
        if best is None or found.duration < best.duration:
            best = found
    assert best is not None
    profile, ratios = best.profile, best.ratios
    factor = best.factor
    while True:
        profile = profile.slower(factor)
        profile, ratios = peaks(timed, curve, profile)
        margin = max(float(r.max()) for _, _, r in ratios)
        if margin <= 1:
            break
        factor = margin * (1 + TAKEN_BACK)
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
        margin,
        deviation=curve.between_points(),
        limits=timed.limits,
        description=timed.description,
    )


def _at_window(timed: TimedPath, curve: JointCurve, window: float) -> _Tried:
    """Return the best of some rounds at one window."""
    best: _Tried | None = None
    easing = np.ones(len(timed.share))
    for _ in range(ROUNDS):
        slowed = replace(timed, easing=easing)
        x, _, _, _ = slowed.run()
        even = averaged(profile_of(timed.curve.s, x), window)
        profile, ratios = peaks(timed, curve, even, proved=False)
        need = _need(ratios)
        factor = float(need.max())
        found = _Tried(profile.duration * max(factor, 1.0), max(factor, 1.0), profile, ratios)
        if best is None or found.duration < best.duration * (1 - JERK_GAIN):
            best = found
        else:
            break
        if factor <= 1 + JERK_GAIN:
            break
        # where the evened motion is too fast the profile under the window is taken back
        worst = np.ones(len(easing))
        first = np.searchsorted(timed.curve.s, even.at(np.maximum(profile.t[:-1] - window, 0))[0]) - 1
        last = np.searchsorted(timed.curve.s, profile.at(profile.t[1:])[0])
        low = np.clip(first, 0, len(easing) - 1)
        high = np.clip(last, 1, len(easing))
        over = np.flatnonzero(need > 1)
        for i, k, most in zip(low[over], high[over], need[over], strict=True):
            np.maximum(worst[i:k], most, out=worst[i:k])
        easing = easing / worst**BACK
    assert best is not None
    return best


def _need(ratios: list[tuple[str, str | None, Array]]) -> Array:
    """Return by how much time must stretch on each piece (k,)."""
    power = {"acceleration": 1 / 2, "jerk": 1 / 3}
    return np.max([r ** power.get(name, 1.0) for name, _, r in ratios], axis=0)


def averaged(profile: Profile, window: float) -> Profile:
    """Return the profile averaged over the window of time before each moment; it lasts longer by the window.

    Its pieces are cubic where the given ones are quadratic: ds/dt becomes (s(t) - s(t - window)) / window, and so on.
    """
    T, w = profile.duration, window
    t = np.union1d(profile.t, profile.t + w)
    t = t[np.append(True, np.diff(t) > ONE_MOMENT * (T + w))]
    t[-1] = T + w
    begun = profile.t
    s, v, a, j = profile.c.T
    h = np.diff(profile.t)
    area = np.concatenate([[0.0], np.cumsum(h * (s + h * (v / 2 + h * (a / 6 + h * j / 24))))])
    end = float(profile.at(np.array([T]))[0][0])

    def at(time: Array) -> tuple[Array, Array, Array, Array]:
        inner = np.asarray(np.clip(time, 0.0, T), float)
        i = np.clip(np.searchsorted(begun, inner, side="right") - 1, 0, len(h) - 1)
        tau = inner - begun[i]
        tau = np.asarray(tau, float)
        whole = area[i] + tau * (s[i] + tau * (v[i] / 2 + tau * (a[i] / 6 + tau * j[i] / 24)))
        inside = (time >= 0) & (time < T)
        place = np.where(time < 0, 0.0, np.where(time >= T, end, s[i] + tau * (v[i] + tau * a[i] / 2)))
        rate = np.where(inside, v[i] + tau * a[i], 0.0)
        return whole + end * np.maximum(time - T, 0.0), place, rate, np.where(inside, a[i], 0.0)

    begins = t[:-1]
    now, before = at(begins), at(begins - w)
    # the bend on a piece is that of its middle: at its ends two pieces meet
    middle = (t[1:] + t[:-1]) / 2
    bend = (at(middle)[3] - at(middle - w)[3]) / w
    c = np.stack([(now[k] - before[k]) / w for k in range(3)] + [bend], 1)
    return Profile(t, c)


def _bernstein() -> Array:
    """Return the matrix from values at DEGREE + 1 even places to Bernstein coefficients."""
    u = np.linspace(0, 1, DEGREE + 1)[:, None]
    k = np.arange(DEGREE + 1)
    binomial = np.array([comb(DEGREE, i) for i in k])
    return np.asarray(np.linalg.inv(binomial * u**k * (1 - u) ** (DEGREE - k)), float)


_COEFFICIENTS = _bernstein()


def peaks(
    timed: TimedPath, curve: JointCurve, profile: Profile, *, proved: bool = True
) -> tuple[Profile, list[tuple[str, str | None, Array]]]:
    """Return a profile split where the curve's pieces meet, and bounds of every limit's ratio (k,) on its pieces.

    Where they need not be `proved` the largest of three values is taken instead: enough for a search.
    """
    t = np.union1d(profile.t, crossings(profile, curve.s[1:-1]))
    t = t[np.append(True, np.diff(t) > ONE_MOMENT * profile.duration)]
    t[-1] = profile.duration
    s, v, a, j = profile.at(t[:-1])
    split = Profile(t, np.stack([s, v, a, j], 1))
    h = np.diff(t)
    tau = h[:, None] * np.linspace(0, 1, DEGREE + 1 if proved else 3)
    half = tau.shape[1] // 2
    places = s[:, None] + tau * (v[:, None] + tau * (a[:, None] / 2 + tau * j[:, None] / 6))
    rate = v[:, None] + tau * (a[:, None] + tau * j[:, None] / 2)
    bend = a[:, None] + tau * j[:, None]
    # each piece has one piece of the curve, that of its middle, and is looked at beyond its ends if rounding wants it
    i = curve.piece(places[:, half])
    r = (places - curve.s[i][:, None])[..., None]
    d1, d2, d3 = (x[i][:, None] for x in (curve.d1, curve.d2, curve.d3))
    q2 = d2 + r * d3
    q1 = d1 + r * (d2 + r * d3 / 2)
    rate, bend, sharp = rate[..., None], bend[..., None], j[:, None, None]
    rates = _most(q1 * rate)
    bends = _most(q2 * rate**2 + q1 * bend)
    jerks = _most(d3 * rate**3 + 3 * q2 * rate * bend + q1 * sharp)
    jerk = timed.bound.jerk
    assert jerk is not None
    cell = timed.curve.piece(places[:, half])
    share = timed.share[cell]
    ratios: list[tuple[str, str | None, Array]] = []
    for k, name in enumerate(timed.names):
        ratios.append(("speed", name, rates[:, k] / (timed.bound.speed[k] * share)))
        ratios.append(("acceleration", name, bends[:, k] / timed.bound.acceleration[k]))
        ratios.append(("jerk", name, jerks[:, k] / jerk[k]))
    if timed.tool is not None:
        fastest = _most(rate)[:, 0]
        first, last = timed.curve.piece(places[:, 0]), timed.curve.piece(places[:, -1])
        speeds = [("tool speed", timed.tool.point, timed.tool.point_strays, timed.tool_speed)]
        if timed.limits.turn_speed is not None:
            speeds.append(
                ("turn speed", timed.tool.turn, timed.tool.turn_strays, timed.limits.turn_speed * timed.share)
            )
        for name, value, strays, most in speeds:
            size = np.linalg.norm(value, axis=1)
            top = np.maximum(size[:-1], size[1:]) + strays
            ratio = np.maximum.reduceat(np.append(top / most, 0.0), np.stack([first, last + 1], 1).ravel())[::2]
            ratios.append((name, None, ratio * fastest))
    return split, ratios


def _most(values: Array) -> Array:
    """Return bounds (k, n) of |polynomials| given at DEGREE + 1 even places; at fewer, the largest."""
    if values.shape[1] <= DEGREE:
        return np.abs(values).max(1)
    return np.abs(_COEFFICIENTS @ values).max(1)


def crossings(profile: Profile, s: Array) -> Array:
    """Return the times (m,) at which a profile that never goes back passes s (m,)."""
    starts = np.append(profile.c[:, 0], profile.at(np.array([profile.duration]))[0][0])
    i = np.clip(np.searchsorted(starts, s, side="right") - 1, 0, len(profile.c) - 1)
    low, high = np.zeros(len(s)), profile.t[i + 1] - profile.t[i]
    start, v, a, j = profile.c[i].T
    for _ in range(50):
        middle = (low + high) / 2
        below = start + middle * (v + middle * (a / 2 + middle * j / 6)) < s
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    return profile.t[i] + (low + high) / 2
