"""How much of each limit a motion uses on each of its pieces, and by how much time must stretch to keep them."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from pieper import _kernel
from pieper.kinematics.arrays import Array
from pieper.motion.certificate import tool_acceleration_peaks, vector_peaks
from pieper.motion.timed_path import TimedPath

#: With what power of the time a value falls that is no speed.
_POWERS = {"acceleration": 2, "tool acceleration": 2, "jerk": 3}
#: The powers, and what undoes them.
_ROOTS = ((1, np.asarray), (2, np.sqrt), (3, np.cbrt))


@dataclass(frozen=True, eq=False)
class Ratios:
    """Largest values over their limits.

    Attributes:
        kinds: Which limit of which joint (None for the tool), one a row.
        values: (r, k) on each piece.
    """

    kinds: tuple[tuple[str, str | None], ...]
    values: Array

    @property
    def margin(self) -> float:
        """The largest of all."""
        return float(self.values.max())

    @property
    def powers(self) -> Array:
        """(r,) with what power of the time each falls."""
        return np.array([_POWERS.get(limit, 1) for limit, _ in self.kinds], float)

    def stretch(self) -> Array:
        """Return by how much time must stretch on each piece (k,) for its limits to be kept."""
        powers = self.powers
        most: list[Array] = []
        for power, root in _ROOTS:
            rows = np.flatnonzero(powers == power)
            if len(rows):
                # rows that stand evenly apart are looked at where they are
                step = int(rows[1] - rows[0]) if len(rows) > 1 else 1
                even = bool((np.diff(rows) == step).all())
                mine = self.values[rows[0] : rows[-1] + 1 : step] if even else self.values[rows]
                most.append(np.asarray(root(mine.max(0)), np.float64))
        return np.maximum.reduce(most)

    def slower(self, factor: float) -> Ratios:
        """Return what is used when every time is multiplied by a factor."""
        return replace(self, values=self.values / factor ** self.powers[:, None])


def joint_kinds(names: tuple[str, ...], *limits: str) -> tuple[tuple[str, str | None], ...]:
    """Return the kinds of rows, joint by joint."""
    return tuple((limit, name) for name in names for limit in limits)


def peak_ratios(timed: TimedPath, x: Array) -> Ratios:
    """Return the largest values over their limits where x = (ds/dt)^2 (k + 1,) is linear on the pieces of a path.

    The joints' are exact, the tool's proven bounds.
    """
    curve, bound = timed.curve, timed.bound
    kinds = joint_kinds(timed.names, "speed", "acceleration")
    values = _kernel.peak_ratios(
        s=curve.s,
        d1=curve.d1,
        d2=curve.d2,
        d3=curve.d3,
        x=x,
        speed=bound.speed,
        acceleration=bound.acceleration,
        share=timed.share,
    )
    tool, limits = timed.tool, timed.limits
    if tool is None or not limits_of_tool(timed):
        return Ratios(kinds, values)
    more: list[tuple[str, Array]] = []
    if np.isfinite(timed.tool_speed).any():
        more.append(("tool speed", vector_peaks(tool.point, tool.point_strays, x) / timed.tool_speed))
    if limits.turn_speed is not None:
        most = limits.turn_speed * timed.share
        more.append(("turn speed", vector_peaks(tool.turn, tool.turn_strays, x) / most))
    if limits.tool_acceleration is not None:
        peaks = tool_acceleration_peaks(tool, timed.h, x)
        more.append(("tool acceleration", peaks / limits.tool_acceleration))
    return Ratios((*kinds, *((name, None) for name, _ in more)), np.vstack([values, *(row for _, row in more)]))


def limits_of_tool(timed: TimedPath) -> bool:
    """Whether anything of the tool is limited, on any piece."""
    return timed.limits.of_the_tool or bool(np.isfinite(timed.tool_speed).any())
