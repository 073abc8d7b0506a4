"""A motion within jerk limits: the fastest one without them, evened out in time, and eased where it must be."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import partial
from math import comb

import numpy as np

from pieper import _kernel
from pieper.kinematics.arrays import Array, Indices
from pieper.motion.certificate import Felt, felt_at_ends, peaks_in_time
from pieper.motion.curve import JointCurve
from pieper.motion.in_time import binding, profile_of, sampled
from pieper.motion.motion import Motion
from pieper.motion.profile import Profile
from pieper.motion.ratios import Ratios, joint_kinds, limits_of_tool
from pieper.motion.straight import closed_form, is_even
from pieper.motion.timed_path import TimedPath
from pieper.motion.tool_bounds import ToolCurve, point_derivatives, turn_derivatives
from pieper.tolerances import BOUND_NEAR, JERK_GAIN, ONE_MOMENT, TAKEN_BACK

#: Degree of a joint's speed on a piece: q' of degree 2 in s, s of degree 3 in time, times ds/dt of degree 2.
DEGREE = 8
#: Windows are compared at powers of two to this part, s: the same whatever the limits.
STEP = 0.5
#: A window is begun with that is at most this part of the mean time between changes of the acceleration's sign.
OF_A_PHASE = 2 / 3
#: Rounds in which the speed along the path is eased at one window: while windows are compared, and at the best one.
ROUNDS_TO_COMPARE, ROUNDS = 3, 8
#: What is too slow is taken up by this part a round, what is too fast by the whole.
TAKEN_UP = 0.5


@dataclass(frozen=True, eq=False)
class _Tried:
    """What a window came to: how long it takes, once slowed by a factor everywhere, and what it was eased by."""

    duration: float
    factor: float
    profile: Profile
    eased: Array


def smooth_motion(timed: TimedPath, curve: JointCurve, rate: float) -> Motion:
    """Return a motion within speeds, accelerations and jerks, at rest at both ends.

    The fastest profile without jerk limits, within the accelerations that its jerks can reach in a window of time, is
    averaged over that window: its steps of acceleration become ramps. What passes a limit then is slowed down around
    where it does, what keeps them all by much is sped up, round by round, and what is left by the same factor
    everywhere; the window with the shortest motion is looked for. The result is within all limits, proved on each piece
    by Bernstein coefficients; that no motion is faster is not claimed.
    """
    best = _best_window(timed, curve)
    straight = closed_form(timed, curve) if is_even(curve) else None
    if straight is not None:
        # the tool's limits may leave it as it is
        profile, ratios = peaks(timed, curve, straight[0])
        factor = max(float(ratios.stretch().max()), 1.0)
        if profile.duration * factor < best.duration:
            best = _Tried(profile.duration * factor, factor, profile, best.eased)
    profile, ratios = peaks(timed, curve, best.profile.slower(best.factor))
    sped = False
    # what the search bounded by more than there is becomes faster, once: what rounding passes then is taken back alone
    while ratios.margin > 1 or (ratios.margin < 1 - BOUND_NEAR and not sped):
        sped |= ratios.margin < 1
        profile, ratios = peaks(timed, curve, profile.slower(float(ratios.stretch().max()) * (1 + TAKEN_BACK)))
    tight = binding(profile.t, ratios)
    return timed.motion(sampled(curve, profile, rate), tight, ratios.margin, profile.duration, curve.between_points())


def _best_window(timed: TimedPath, curve: JointCurve) -> _Tried:
    """Return the best of the windows: downhill over powers of two, then where a parabola through the lowest says."""
    tried: dict[float, _Tried] = {}

    def at(power: float) -> float:
        if power not in tried:
            tried[power] = _at_window(timed, curve, 2.0**power, ROUNDS_TO_COMPARE)
        return tried[power].duration

    best = first_power(timed)
    while at(best - STEP) < at(best):
        best -= STEP
    while at(best + STEP) < at(best):
        best += STEP
    below, here, above = (at(best + step) for step in (-STEP, 0.0, STEP))
    lowest = best + STEP / 2 * (below - above) / max(below - 2 * here + above, JERK_GAIN * here)
    found = _at_window(timed, curve, 2.0**lowest, ROUNDS, tried[best])
    return min(found, tried[best], key=lambda one: one.duration)


def first_power(timed: TimedPath) -> float:
    """Return the power of two of a window that fits between the changes of the acceleration's sign."""
    bound, s = timed.bound, timed.curve.s
    assert bound.jerk is not None
    # a window in which every acceleration is reached twice over does no more than a shorter one
    power = float(np.ceil(np.log2((bound.acceleration / bound.jerk).max()))) + 1
    while True:
        x = _under(timed, 2.0**power)
        signs = np.sign(np.diff(x))
        phases = 1 + np.count_nonzero(np.diff(signs[signs != 0]))
        if 2.0**power <= OF_A_PHASE * profile_of(s, x).duration / phases:
            return power
        power -= STEP


def _under(timed: TimedPath, window: float) -> Array:
    """Return x (k + 1,) of the fastest profile within the accelerations that the jerks reach in a window."""
    assert timed.bound.jerk is not None
    reached = np.minimum(timed.bound.acceleration, timed.bound.jerk * window)
    return replace(timed, bound=replace(timed.bound, acceleration=reached)).run()[0]


def levelled(t: Array, x: Array, length: float) -> Array:
    """Return values (k,) at times t with their peaks cut so low that each lasts a length of time.

    The acceleration then goes through zero for as long as that, and never from one end of its limits to the other.
    """
    length = min(length, t[-1] / 2)
    return np.minimum(x, np.maximum(_level(t, x, length), _level(-t[::-1], x[::-1], length)[::-1]))


def _level(t: Array, x: Array, length: float) -> Array:
    """Return for each t the largest of the least values over stretches of that length that begin at a t and hold it."""
    end = np.searchsorted(t, t[t <= t[-1] - length] + length, side="right")
    begin = np.arange(len(end))
    if not len(end):
        return x
    lowest = np.minimum.reduceat(np.append(x, np.inf), np.stack([begin, end], 1).ravel())[::2]
    # the stretches that hold a place are neighbours too
    place = np.arange(len(t))
    first = np.minimum(np.searchsorted(end, place, side="right"), len(begin) - 1)
    last = np.maximum(np.minimum(place + 1, len(begin)), first + 1)
    return np.maximum.reduceat(np.append(lowest, 0.0), np.stack([first, last], 1).ravel())[::2]


def _at_window(timed: TimedPath, curve: JointCurve, window: float, rounds: int, before: _Tried | None = None) -> _Tried:
    """Return the best of some rounds at one window, beginning with what another one was eased by."""
    s, x = timed.curve.s, _under(timed, window)
    x = levelled(profile_of(s, x).t, x, window)
    eased = np.zeros(len(s)) if before is None else before.eased
    best, last = None, np.inf
    for _ in range(rounds):
        raw = profile_of(s, x * np.exp(2 * eased))
        even = averaged(raw, window)
        profile, ratios = peaks(timed, curve, even, proved=False)
        need = ratios.stretch()
        factor = float(need.max())
        found = _Tried(profile.duration * factor, factor, profile, eased)
        if best is None or found.duration < best.duration:
            best = found
        if abs(found.duration / last - 1) < JERK_GAIN and factor < 1 + JERK_GAIN:
            break
        last = found.duration
        over = too_fast(s, even, profile, need, window)
        eased = eased - mean_around(raw.t, np.where(over > 0, over, TAKEN_UP * over), window)
    assert best is not None
    return best


def too_fast(s: Array, even: Profile, profile: Profile, need: Array, window: float) -> Array:
    """Return for each cell between s (k + 1,) the logarithm (k,) of how much slower what feels its speed must be.

    Args:
        s: The grid of what was averaged over the window.
        even: The average.
        profile: The same in pieces (m).
        need: (m,) by how much time must stretch on each of them.
        window: The window, s: half of it to either side feels the same speeds.
    """
    begins = even.place(np.maximum(profile.t[:-1] - 1.5 * window, 0.0))
    ends = even.place(np.minimum(profile.t[1:] + window / 2, even.duration))
    cells = _largest_over(np.searchsorted(s, begins) - 1, np.searchsorted(s, ends), need, len(s) - 1)
    return np.asarray(np.log(cells), np.float64)


def _largest_over(first: Indices, last: Indices, values: Array, count: int) -> Array:
    """Return for each of `count` cells the largest of the values (m,) whose cells [first, last) hold it.

    Both ends ascend, so that the values over a cell stand in a row; a cell that none holds has that of the next one.
    """
    cell = np.arange(count)
    begin, end = np.searchsorted(last, cell, side="right"), np.searchsorted(first, cell, side="right")
    begin = np.minimum(begin, len(values) - 1)
    pairs = np.stack([begin, np.maximum(end, begin + 1)], 1).ravel()
    return np.maximum.reduceat(np.append(values, 0.0), pairs)[::2]


def mean_around(t: Array, values: Array, window: float) -> Array:
    """Return the means (k + 1,) over a window of time around each t of values (k,) that hold between them."""
    area = np.concatenate([[0.0], np.cumsum(values * np.diff(t))])
    begin, end = np.maximum(t - window / 2, t[0]), np.minimum(t + window / 2, t[-1])
    return np.asarray((np.interp(end, t, area) - np.interp(begin, t, area)) / (end - begin), np.float64)


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

    Where they need not be `proved` the largest of three values of a joint is taken instead, and of the tool the values
    where pieces begin and end: enough for a search.
    """
    bound, tool = timed.bound, timed.tool if limits_of_tool(timed) else None
    assert bound.jerk is not None
    if tool is not None:
        # the tool is bounded on one cell of the grid at a time
        curve = timed.curve
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
    split, ratios = Profile(t, c), Ratios(joint_kinds(timed.names, "speed", "acceleration", "jerk"), values)
    if tool is None:
        return split, ratios
    cell = timed.curve.piece(split.middles)
    for name, felt, grid, allowed in _of_the_tool(timed, tool):
        if proved:
            # what uses less than another limit does need not be known better
            used = peaks_in_time(felt, cell, split, allowed[cell], float(ratios.stretch().max()) ** felt.power)
        else:
            used = _roughly(felt, grid, cell, split, fastest) / allowed[cell]
        ratios = Ratios((*ratios.kinds, (name, None)), np.vstack([ratios.values, used]))
    return split, ratios


def _of_the_tool(timed: TimedPath, tool: ToolCurve) -> Iterator[tuple[str, Felt, Array, Array]]:
    """Yield each limit of the tool by name, what feels it, f (k + 1, 3) on the grid, and what is allowed (k,) on it."""
    limits = timed.limits
    point = partial(point_derivatives, timed.chain, timed.curve)
    if np.isfinite(timed.tool_speed).any():
        yield "tool speed", Felt(point, 1, tool.third, tool.fourth), tool.point, timed.tool_speed
    if limits.turn_speed is not None:
        turn = partial(turn_derivatives, timed.chain, timed.curve)
        yield "turn speed", Felt(turn, 1, tool.turn_third, tool.turn_third), tool.turn, limits.turn_speed * timed.share
    if limits.tool_acceleration is not None:
        allowed = np.full(len(timed.share), limits.tool_acceleration)
        yield "tool acceleration", Felt(point, 2, tool.third, tool.fourth), tool.point, allowed


def _roughly(felt: Felt, grid: Array, cell: Indices, split: Profile, fastest: Array) -> Array:
    """Return about how large (m,) what is felt gets: of a speed the grid's values, times ds/dt at most (m,)."""
    if felt.power == 2:
        return felt_at_ends(felt, split)
    size = np.linalg.norm(grid, axis=1)
    return np.maximum(size[:-1], size[1:])[cell] * fastest
