"""A timed motion: joint curves over time, what binds them, and what happens on the way."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Protocol, runtime_checkable

import numpy as np

from pieper import arguments
from pieper.description.dh import Description
from pieper.document.columns import Column, Tabular, Units
from pieper.errors import InputError
from pieper.kinematics.arrays import Array, ArrayLike
from pieper.motion.limits import Limits
from pieper.tolerances import LAST_SAMPLE
from pieper.words_by_number import plural

#: More samples than this are asked for by mistake (a rate in the wrong unit), not on purpose.
MAX_SAMPLES = 10_000_000


@runtime_checkable
class Described(Protocol):
    """Whatever has a description: an arm."""

    @property
    def description(self) -> Description:
        """What it is."""
        ...


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
        return f"{self.start:z.3f} to {self.end:z.3f} s: {whose}"


@dataclass(frozen=True, eq=False, repr=False)
class Motion(Tabular):
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
        limits: What it keeps, where limits were given.
        description: The arm that moves, where it is known.
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
    limits: Limits | None = field(default=None, repr=False)
    description: Description | None = field(default=None, repr=False)

    def __repr__(self) -> str:
        """Say how long it is, of how many joints, and how near to its limits."""
        whose = f"{self.description.name}: " if self.description else ""
        near = f", at most {self.margin:.4g} of its limits" if self.limits is not None else ""
        return f"Motion({whose}{plural(self.q.shape[1], 'joint')}, {self.duration:.4g} s, {len(self.t)} samples{near})"

    def columns(self, *, degrees: bool = False, mm: bool = False) -> dict[str, Column]:
        """Return the samples as columns: t, s where there is one, joints, their rates, accelerations and jerks."""
        n, units = self.q.shape[1], Units(degrees, mm)
        known = self.description
        names = known.joint_names if known else tuple(f"joint_{i + 1}" for i in range(n))
        slides = np.array([kind == "P" for kind in known.joint_types]) if known else np.zeros(n, bool)
        found: dict[str, Column] = {"t_s": self.t}
        if len(self.s):
            found["s"] = self.s
        found |= units.joints(names, slides, self.q)
        for order, (what, values) in enumerate((("dq", self.dq), ("ddq", self.ddq), ("dddq", self.dddq)), 1):
            if len(values):
                found |= units.rates(what, names, slides, values, order)
        return found

    @property
    def duration(self) -> float:
        """Total time, s."""
        return float(self.t[-1])

    def at(self, time: float) -> int:
        """Return the index of the sample nearest to one time, s; `between` takes many."""
        time = arguments.number(time, "time", "s; between(times) takes many")
        return int(np.argmin(np.abs(self.t - time)))

    def between(self, times: ArrayLike) -> Array:
        """Return the postures (k, n) at times (k,), s: cubic between samples, held outside them."""
        asked = np.atleast_1d(arguments.numbers(times, "times", "finite numbers (k,), s"))
        if asked.ndim != 1 or not np.isfinite(asked).all():
            raise InputError(f"times must be finite numbers (k,), s, got {arguments.kind_of(times)}.", given=times)
        return hermite(self.t, self.q, self.dq, asked)

    def animate(
        self,
        path: str | os.PathLike[str],
        *,
        arm: Described | None = None,
        rate: float = 25.0,
        speed: float = 1.0,
        size: tuple[int, int] = (640, 480),
        view: tuple[float, float] = (22.0, -58.0),
        progress: Callable[[int, int], None] | None = None,
    ) -> Path:
        """Write the motion as a moving picture: .gif, .webp, .mp4, or .html, a page that plays it and can be turned.

        Args:
            path: Where to; the ending decides the format. The file appears whole or not at all.
            arm: Whose motion it is; left out where the motion knows (a program's, a track's, a route's).
            rate: Pictures a second.
            speed: 1 as it runs, 0.5 half as fast.
            size: Width and height, pixels; even numbers.
            view: Elevation and azimuth of the eye, deg.
            progress: Called with how many pictures are drawn and how many there will be.

        Returns:
            The path.

        Raises:
            InputError: An unknown ending, a motion of nobody knows which arm, a rate, speed or size that is not
                positive, or no encoder for .mp4.
        """
        from pieper.drawing.animation.animate import animate

        if arm is not None:
            arguments.like(Described, arm, "arm", "a pieper.Arm")
        if arm is not None and arm.description.n != self.q.shape[1]:
            raise InputError(
                f"{arm.description.name} has {plural(arm.description.n, 'joint')}, the motion has {self.q.shape[1]}.",
                given=arm.description.name,
            )
        description = self.description if arm is None else arm.description
        if description is None:
            raise InputError("the motion does not know its arm; say animate(path, arm=arm).", given=None)
        return animate(self, description, path, rate=rate, speed=speed, size=size, view=view, progress=progress)


def hermite(t: Array, q: Array, dq: Array, times: Array) -> Array:
    """Return the values (m, n) at times (m,) of the cubic that has values q and rates dq (k, n) at t (k,)."""
    if len(t) == 1:
        return np.repeat(q, len(times), 0)
    i = np.clip(np.searchsorted(t, times, side="right") - 1, 0, len(t) - 2)
    h = (t[i + 1] - t[i])[:, None]
    u = np.clip(np.divide((times - t[i])[:, None], h, out=np.zeros_like(h), where=h > 0), 0.0, 1.0)
    step = q[i + 1] - q[i]
    bend = u * (1 - u) * ((1 - u) * (dq[i] * h - step) - u * (dq[i + 1] * h - step))
    return q[i] + u * step + bend


def sample_times(duration: float, rate: float) -> Array:
    """Return times (k,) from 0 to a duration, s, at a rate (samples a second); the end is always one.

    Raises:
        InputError: The rate is not positive, or there would be more than `MAX_SAMPLES`.
    """
    try:
        each = float(rate)
    except (TypeError, ValueError):
        raise InputError(
            f"rate must be a number of samples a second, got {arguments.kind_of(rate)}.", given=rate
        ) from None
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
    if len(t) > 1 and duration - t[-1] <= LAST_SAMPLE / each:
        t = t[:-1]
    return np.append(t, duration)
