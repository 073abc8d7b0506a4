"""Self-motions that no closed form gives: followed step by step, and kept as the points that were met."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from pieper.kinematics.arrays import Array
from pieper.kinematics.chain import Chain
from pieper.solver.singular.self_motion import SelfMotion


@dataclass(frozen=True, eq=False, repr=False)
class TracedMotion(SelfMotion):
    """A self-motion that was followed step by step; see SelfMotion for its attributes."""

    chain: Chain
    T: Array
    traced: Array
    closed: bool
    dimension: int
    limits: Array
    names: tuple[str, ...]
    shown: int

    @cached_property
    def samples(self) -> Array:
        """(k, n) the points that were followed."""
        return self.traced
