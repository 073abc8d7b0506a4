"""One way to read data of a calibration."""

from __future__ import annotations

from dataclasses import dataclass

from pieper.calibration.measurements import Measurements
from pieper.kinematics.arrays import Array


@dataclass(frozen=True, eq=False)
class Reading:
    """One way to read the data.

    Args:
        words: What would be wrong with them.
        cure: What to do about it.
        q: (N, n) joint vectors.
        data: Measurements.
        facts: Attributes of the error.
        freedom: How much better it must be than others, having numbers of its own to fit.
        units_alone: Whether it changes nothing but units: the cure holds then whatever else is wrong.
    """

    words: str
    cure: str
    q: Array
    data: Measurements
    facts: dict[str, object]
    freedom: float = 1.0
    units_alone: bool = False
