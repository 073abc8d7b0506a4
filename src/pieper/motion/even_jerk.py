"""Sections of constant tool speed within jerk limits: one speed of the parameter stays one where it is evened out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.motion.constant_speed import Fastest, Section, apart_or_one, refused, section_grid
from pieper.motion.curve import JointCurve
from pieper.motion.in_time import binding, profile_of, sampled
from pieper.motion.jerk import averaged, first_power, levelled, mean_around, peaks, too_fast
from pieper.motion.motion import Motion, Tight
from pieper.motion.profile import Profile
from pieper.motion.ratios import Ratios
from pieper.motion.timed_path import TimedPath, on_grid
from pieper.motion.tool_way import ToolWay, tool_way
from pieper.tolerances import EASED_MORE, JERK_GAIN, SPEED_LOWERED

#: Windows are tried at powers of two this far apart, from so far above the one that fits the path to so far below.
STEP, ABOVE, BELOW = 0.5, 2.0, 6.0
#: Windows in a row that make the motion no shorter, after which no further one is tried.
WORSE = 3
#: Rounds in which what lies beside the sections is eased, and by what part more in each, so that they come to an end.
ROUNDS, FIRMER = 16, 0.15
#: What is too slow is taken up by this part a round.
TAKEN_UP = 0.3
#: Halvings by which the highest speed is looked for: to a thousandth of it.
HALVINGS = 10


@dataclass(frozen=True, eq=False)
class _Asked:
    """Sections on a path by its tool's way: where each begins and ends, and how fast the parameter is to run there."""

    timed: TimedPath
    way: ToolWay
    speeds: tuple[float, ...]

    def wanted(self, window: float) -> Array | None:
        """Return x (k + 1,) that is held where a window that reaches a section is; None for no room."""
        s = self.timed.curve.s
        out = np.full(len(s), np.nan)
        for (a, b), speed in zip(self.way.sections, self.speeds, strict=True):
            first = int(np.searchsorted(s, a - speed * window / 2, side="right")) - 1
            last = int(np.searchsorted(s, b + speed * window / 2))
            if first <= 0 or last >= len(s) - 1 or not np.isnan(out[first : last + 1]).all():
                return None
            out[first : last + 1] = speed**2
        return out


def even_motion(timed: TimedPath, curve: JointCurve, sections: Sequence[Section], rate: float) -> Motion:
    """Return a motion within speeds, accelerations and jerks that has the tool's speeds asked for in sections.

    In sections the path is taken by the way that the tool goes. The fastest profile that runs evenly half a window of
    time longer to either side is averaged over that window: it then runs evenly in the section. Beside the sections it
    is eased where a limit is passed, round by round, at several windows; the result is proved piece by piece as any
    with a jerk.
    That nothing is faster is not claimed, nor that what is refused cannot be.

    Raises:
        InputError: No window was found; with the highest speed that one was found for.
    """
    asked = _asked(timed, curve, sections)
    found = _found(asked)
    if found is None and len(asked.speeds) == 1:
        s0, s1, v = sections[0][0], *sections[-1][1:]
        best = fastest_with_jerk(timed, curve, (s0, s1, v))
        if best < v:
            raise refused([(s0, s1, v)], lambda _: best)
        # what is found for a higher speed can be slowed
        found = _found(replace(asked, speeds=(best / asked.way.metres,)))
        found = None if found is None else peaks(asked.timed, asked.way.curve, found[0].slower(best / v))
    if found is None:
        raise refused(sections, lambda section: fastest_with_jerk(timed, curve, section))
    profile, ratios = found
    t, q, dq, ddq, dddq, along = sampled(asked.way.curve, profile, rate)
    ends = np.array([0.0, profile.duration])
    return Motion(
        t,
        q,
        dq,
        ddq,
        ends,
        ends,
        dddq,
        asked.way.own(along),
        _tight(asked.way, profile, ratios),
        ratios.margin,
        deviation=curve.between_points(),
        limits=timed.limits,
        description=timed.description,
    )


def _tight(way: ToolWay, profile: Profile, ratios: Ratios) -> tuple[Tight, ...]:
    """Return what binds when: in sections the speed of the tool that is asked for, beside them what is aimed at."""
    places, found = profile.place(profile.t), binding(profile.t, ratios, 2 * EASED_MORE)
    out: list[Tight] = []
    for a, b in way.sections:
        first, last = (float(t) for t in np.interp([a, b], places, profile.t))
        out.append(Tight(first, last, "given speed", None))
        found = [
            Tight(max(begin, one.start), min(end, one.end), one.limit, one.joint)
            for one in found
            for begin, end in ((0.0, first), (last, profile.duration))
            if max(begin, one.start) < min(end, one.end)
        ]
    return tuple(sorted([*out, *found], key=lambda one: one.start))


def fastest_with_jerk(timed: TimedPath, curve: JointCurve, section: Section) -> Fastest:
    """Return the highest constant speed in a section that was found, to a thousandth, and what forbids more."""
    s0, s1, _ = section
    asked = _asked(timed, curve, [(s0, s1, 1.0)])
    s = asked.timed.curve.s
    (a, b), unit = asked.way.sections[0], asked.speeds[0]
    # one speed all along: of its pieces in the section the one that is nearest to a limit
    steady = Profile(s / unit, np.stack([s[:-1], np.full(len(s) - 1, unit), *np.zeros((2, len(s) - 1))], 1))
    split, ratios = peaks(asked.timed, asked.way.curve, steady)
    inside = (split.middles > a) & (split.middles < b)
    values = ratios.values[:, inside] ** (1 / ratios.powers[:, None])
    row, column = np.unravel_index(int(values.argmax()), values.shape)
    limit, joint = ratios.kinds[row]
    most = 1 / float(values[row, column]) * (1 - SPEED_LOWERED)
    place = float(asked.way.own(split.middles[inside][column : column + 1])[0])

    def can(v: float) -> bool:
        return _found(replace(asked, speeds=(unit * v,))) is not None

    if s0 <= 0 or s1 >= 1:
        return Fastest.of(0.0, 0.0 if s0 <= 0 else 1.0, "run-up" if s0 <= 0 else "run-out", None)
    if can(most):
        return Fastest.of(most, place, limit, joint)
    low, high = 0.0, most
    for _ in range(HALVINGS):
        v = (low + high) / 2
        low, high = (v, high) if can(v) else (low, v)
    shorter = "run-up" if s0 <= 1 - s1 else "run-out"
    return Fastest.of(low, s0 if shorter == "run-up" else s1, shorter, None)


def _asked(timed: TimedPath, curve: JointCurve, sections: Sequence[Section]) -> _Asked:
    section_grid(timed, curve, sections)  # refuses what cannot be a section
    sections = apart_or_one(sections)
    way = tool_way(timed.chain, curve, [section[:2] for section in sections])
    there = on_grid(way.curve, timed.limits, timed.names, timed.plan)
    return _Asked(there, way, tuple(v / way.metres for _, _, v in sections))


def _found(asked: _Asked) -> tuple[Profile, Ratios] | None:
    """Return the shortest motion that some window leads to, proved, and what it uses of every limit."""
    best: tuple[Profile, Ratios] | None = None
    power, worse = first_power(asked.timed) + ABOVE, 0
    lowest = power - ABOVE - BELOW
    while power >= lowest and worse < WORSE:
        one = _at_window(asked, 2.0**power)
        power -= STEP
        if one is not None and (best is None or one[0].duration < best[0].duration):
            best, worse = one, 0
        elif best is not None:
            worse += 1
    return best


def _at_window(asked: _Asked, window: float) -> tuple[Profile, Ratios] | None:
    wanted = asked.wanted(window)
    if wanted is None:
        return None
    timed, curve, s = asked.timed, asked.way.curve, asked.timed.curve.s
    assert timed.bound.jerk is not None
    reached = np.minimum(timed.bound.acceleration, timed.bound.jerk * window)
    held = ~np.isnan(wanted[1:]) & ~np.isnan(wanted[:-1])
    eased, best, last = np.zeros(len(s) - 1), None, np.inf
    bound = replace(timed.bound, acceleration=reached)
    for k in range(ROUNDS):
        x, _, done, _ = replace(timed, bound=bound, easing=np.exp(eased)).run(wanted)
        if not done:
            break
        x = np.where(np.isnan(wanted), levelled(profile_of(s, x).t, x, window), x)
        raw = profile_of(s, x)
        even = averaged(raw, window)
        profile, ratios = peaks(timed, curve, even, proved=False)
        need = ratios.stretch()
        if need.max() <= 1 and (best is None or profile.duration < best[0].duration):
            proved = peaks(timed, curve, even)
            best = proved if proved[1].margin <= 1 else best
        if best is not None and abs(profile.duration / last - 1) < JERK_GAIN:
            break
        last = profile.duration
        over = too_fast(s, even, profile, need, window) + EASED_MORE
        changed = mean_around(raw.t, np.where(over > 0, (1 + FIRMER * k) * over, TAKEN_UP * over), window)
        eased = np.where(held, 0.0, eased - (changed[1:] + changed[:-1]) / 2)
    return best
