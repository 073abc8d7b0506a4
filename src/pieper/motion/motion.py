"""A timed motion: joint curves over time, what binds them, and what happens on the way."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from pieper.errors import InputError
from pieper.kinematics.arrays import Array

#: More samples than this are asked for by mistake (a rate in the wrong unit), not on purpose.
MAX_SAMPLES = 10_000_000


@dataclass(frozen=True)
class Tight:
    """A stretch of a motion on which one limit binds.

    Attributes:
        start: When it begins, s.
        end: When it ends, s.
        limit: Which: "speed", "acceleration", "jerk", "tool speed", "tool acceleration", "turn speed" or "given speed".
        joint: Name of the joint, or None for the tool.
    """

    start: float
    end: float
    limit: str
    joint: str | None

    def __str__(self) -> str:
        whose = f"{self.limit} of {self.joint}" if self.joint else self.limit
        return f"{self.start:.3f} to {self.end:.3f} s: {whose}"


@dataclass(frozen=True, eq=False, repr=False)
class Motion:
    """Joint curves over time.

    Attributes:
        t: (k,) time, s.
        q: (k, n) joint positions, rad or m.
        dq: (k, n) joint rates, rad/s or m/s.
        ddq: (k, n) joint accelerations, rad/s^2 or m/s^2.
        arrivals: (legs + 1,) when each posture is reached; the first is 0, s.
        departures: (legs + 1,) when each posture is left again; the last is the end of its hold, s.
        dddq: (k, n) joint jerks, rad/s^3 or m/s^3.
        s: (k,) path parameter, 0 to 1.
        tight: Which limit binds when, in order of time.
        margin: The largest value over its limit on the whole continuous curve, at most 1; 0 where no limits were given.
        events: (time, kind, value) of what happens on the way, in order of time.
        remarks: What was done differently from what was asked, in sentences.
        deviation: How far the curve strays from the straight joint lines between the points it goes through (rad, or
            m of a slide); 0 for moves that are straight.
    """

    t: Array
    q: Array
    dq: Array
    ddq: Array
    arrivals: Array
    departures: Array
    dddq: Array = field(default_factory=lambda: np.zeros((0, 0)))
    s: Array = field(default_factory=lambda: np.zeros(0))
    tight: tuple[Tight, ...] = ()
    margin: float = 0.0
    events: tuple[tuple[float, str, object], ...] = ()
    remarks: tuple[str, ...] = ()
    deviation: float = 0.0

    @property
    def duration(self) -> float:
        """Total time, s."""
        return float(self.t[-1])

    def at(self, time: float) -> int:
        """Return the index of the sample nearest to a time, s."""
        return int(np.argmin(np.abs(self.t - time)))

    def __repr__(self) -> str:
        return f"<Motion: {self.duration:.4g} s, {self.q.shape[1]} joints, {len(self.t):,} samples>"


def sample_times(duration: float, rate: float) -> Array:
    """Return times (k,) from 0 to a duration, s, at a rate (samples a second); the end is always one.

    Raises:
        InputError: The rate is not positive, or there would be more than `MAX_SAMPLES`.
    """
    try:
        each = float(rate)
    except (TypeError, ValueError):
        raise InputError(f"rate must be a number of samples a second, got {rate!r}.", given=rate) from None
    if not (np.isfinite(each) and each > 0):
        raise InputError(f"rate must be finite and positive, samples a second, got {each:g}.", given=each)
    if duration * each > MAX_SAMPLES:
        raise InputError(
            f"{duration:g} s at {each:g} samples a second would be {duration * each:.3g} samples; at most "
            f"{MAX_SAMPLES:,} are made.",
            samples=duration * each,
        )
    t = np.arange(int(np.floor(duration * each)) + 1) / each
    # a last sample that differs from the end by rounding only is the end
    if len(t) > 1 and duration - t[-1] <= 1e-6 / each:
        t = t[:-1]
    return np.append(t, duration)
