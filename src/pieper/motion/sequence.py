"""From posture to posture: quintic moves in time, sequences with holds, and tables that compare tool positions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pieper import arguments
from pieper.errors import InputError
from pieper.kinematics.arrays import Array
from pieper.motion.motion import MAX_SAMPLES, Motion
from pieper.tolerances import LAST_SAMPLE
from pieper.words_by_number import plural


def move(q0: Array, q1: Array, duration: float, *, rate: float = 100.0) -> Motion:
    """Return the move from posture q0 to q1, all joints together, at rest at both ends.

    Each joint follows the quintic q0 + (q1 - q0) (10 u^3 - 15 u^4 + 6 u^5), u = t / duration: rates and accelerations
    vanish at both ends. The largest rate is 15/8 of the mean one, the largest acceleration is
    10/sqrt(3) ``|q1 - q0|`` / duration^2.

    Args:
        q0: (n,) first posture, rad or m.
        q1: (n,) last posture, rad or m.
        duration: Time the move takes, s; positive.
        rate: Samples a second; the end of the move is always a sample.

    Returns:
        The Motion.

    Raises:
        InputError: Wrong shapes, numbers that are not finite, a duration or rate that is not positive.
    """
    return sequence([q0, q1], duration, 0.0, rate=rate)


def sequence(
    postures: Array | Sequence[Array], durations: Array | float, holds: Array | float = 0.0, *, rate: float = 100.0
) -> Motion:
    """Return the motion through postures, at rest in each of them.

    Every leg is a `move`; after it the arm holds the posture it has reached. There is no hold before the first leg.

    Args:
        postures: (m, n) joint vectors, m at least 2, rad or m.
        durations: Time of each leg (m - 1,), or one number for all, s; positive.
        holds: Time of rest after each leg (m - 1,), or one number for all, s; zero or more.
        rate: Samples a second. Arrivals and departures are always samples too, so spacing may be uneven there.

    Returns:
        The Motion.

    Raises:
        InputError: Wrong shapes, numbers that are not finite, times or a rate that are not positive, too many samples.
    """
    postures = _postures(postures)
    legs = len(postures) - 1
    durations = _times(durations, legs, "durations", zero_allowed=False)
    holds = _times(holds, legs, "holds", zero_allowed=True)
    rate = _times(rate, 1, "rate", zero_allowed=False)[0]
    ends = np.cumsum(durations + holds)
    if ends[-1] * rate > MAX_SAMPLES:
        raise InputError(
            f"{ends[-1]:g} s at {rate:g} samples a second would be {ends[-1] * rate:.3g} samples; "
            f"at most {MAX_SAMPLES:,} are made.",
            samples=ends[-1] * rate,
        )
    arrivals = np.concatenate([[0.0], ends - holds])
    departures = np.concatenate([[0.0], ends])
    regular = np.arange(int(np.floor(ends[-1] * rate)) + 1) / rate
    t = np.union1d(regular, np.concatenate([arrivals, departures]))
    # samples that differ by rounding only are one sample; the exact arrival or departure stays
    marks = np.concatenate([arrivals, departures])
    close = np.abs(t[:, None] - marks[None]).min(1)
    t = t[(close == 0.0) | (close > LAST_SAMPLE / rate)]
    leg = np.clip(np.searchsorted(departures, t, side="right") - 1, 0, legs - 1)
    u = np.clip((t - departures[leg]) / durations[leg], 0.0, 1.0)[:, None]
    u[t == arrivals[leg + 1]] = 1.0
    q0, step, time = postures[leg], (postures[1:] - postures[:-1])[leg], durations[leg][:, None]
    shape = u**3 * (10 - 15 * u + 6 * u**2)
    q = np.where(u == 1.0, postures[leg + 1], q0 + step * shape)
    dq = step * (30 * u**2 * (1 - u) ** 2) / time
    ddq = step * (60 * u * (1 - u) * (1 - 2 * u)) / time**2
    dddq = step * (60 - 360 * u * (1 - u)) / time**3 * (u < 1.0)
    return Motion(t, q, dq, ddq, arrivals, departures, dddq, (leg + shape[:, 0]) / legs)


@dataclass(frozen=True, eq=False)
class Comparison:
    """Tool positions from two sources, side by side.

    Attributes:
        names: One name a row.
        axes: Name of each column.
        reference: (k, m) positions taken as true, m.
        simulated: (k, m) positions to judge, m.
        absolute: (k, m) |simulated - reference|, m.
        relative: (k, m) the same in percent of |reference|; zero where `defined` is false.
        defined: (k, m) bool: a relative error of a reference value of zero is undefined.
    """

    names: tuple[str, ...]
    axes: tuple[str, ...]
    reference: Array
    simulated: Array
    absolute: Array
    relative: Array
    defined: Array

    @property
    def largest_absolute(self) -> Array:
        """(m,) largest absolute error of each axis, m."""
        return self.absolute.max(0)

    @property
    def largest_relative(self) -> Array:
        """(m,) largest relative error of each axis among the defined ones, percent."""
        return self.relative.max(0)

    def percent(self, row: int, axis: int, digits: int = 4) -> str:
        """Return a relative error as text, or "undefined"."""
        return f"{self.relative[row, axis]:z.{digits}f} %" if self.defined[row, axis] else "undefined"

    def table(self) -> list[list[str]]:
        """Return the comparison as rows of text, millimetres and percent, a heading first."""
        head = ["position"]
        for axis in self.axes:
            head += [f"{axis} reference, mm", f"{axis} simulated, mm", f"{axis} error, mm", f"{axis} error"]
        rows = [head]
        for i, name in enumerate(self.names):
            row = [name]
            for j in range(len(self.axes)):
                row += [f"{v[i, j] * 1e3:.4g}" for v in (self.reference, self.simulated, self.absolute)]
                row.append(self.percent(i, j))
            rows.append(row)
        return rows


def compare(
    reference: Array,
    simulated: Array,
    *,
    names: tuple[str, ...] | None = None,
    axes: tuple[str, ...] = ("X", "Y", "Z"),
) -> Comparison:
    """Compare reference and simulated tool positions, axis by axis.

    Args:
        reference: (k, m) positions taken as true, m; m is 3 unless other axes are named.
        simulated: (k, m) positions to judge, m.
        names: One name a row; P0, P1 ... when left out.
        axes: One name a column.

    Returns:
        The Comparison. The relative error of a reference value of exactly zero is undefined, and said to be.

    Raises:
        InputError: Shapes that differ, numbers that are not finite.
    """
    reference, simulated = _matrix(reference, "reference"), _matrix(simulated, "simulated")
    if reference.shape != simulated.shape or reference.shape[1] != len(axes):
        raise InputError(
            f"reference and simulated must both be (k, {len(axes)}), got {reference.shape} and {simulated.shape}.",
            reference=reference.shape,
            simulated=simulated.shape,
        )
    names = tuple(f"P{i}" for i in range(len(reference))) if names is None else tuple(names)
    if len(names) != len(reference):
        raise InputError(
            f"{plural(len(names), 'name was', 'names were')} given for {plural(len(reference), 'row')}.", given=names
        )
    absolute = np.abs(simulated - reference)
    defined = reference != 0
    relative = np.where(defined, 100 * absolute / np.where(defined, np.abs(reference), 1.0), 0.0)
    return Comparison(names, tuple(axes), reference, simulated, absolute, relative, defined)


def _matrix(values: object, what: str) -> Array:
    try:
        array = np.array(values, dtype=float)
    except (TypeError, ValueError):
        raise InputError(f"{what} must be rows of numbers, all of one length.", given=type(values)) from None
    if array.ndim != 2 or array.size == 0:
        raise InputError(
            f"{what} must be a table with at least one row and column, got shape {array.shape}.", given=array.shape
        )
    if not np.isfinite(array).all():
        index = tuple(int(i) for i in np.argwhere(~np.isfinite(array))[0])
        raise InputError(f"{what} must be finite, got {array[index]} at index {index}.", index=index)
    return array


def _postures(postures: object) -> Array:
    array = _matrix(postures, "postures")
    if len(array) < 2:
        raise InputError("a sequence needs at least 2 postures, where it begins and where it ends.", given=len(array))
    return array


def _times(values: object, count: int, what: str, *, zero_allowed: bool) -> Array:
    array = arguments.numbers(values, what)
    if array.ndim > 1 or (array.ndim == 1 and len(array) != count):
        raise InputError(
            f"{what} must be one number or {count}, one a leg, got shape {array.shape}.", given=array.shape
        )
    array = np.broadcast_to(array, (count,)).astype(float)
    good = np.isfinite(array) & ((array >= 0) if zero_allowed else (array > 0))
    if not good.all():
        least = "zero or more" if zero_allowed else "positive"
        raise InputError(f"{what} must be finite and {least}, got {array[~good][0]:g}.", given=array[~good][0])
    return array
