"""Self-motions that are known in closed form, and those along a straight line of joint space among them."""

from __future__ import annotations

from dataclasses import dataclass

from pieper.kinematics.arrays import Array
from pieper.kinematics.chain import Chain
from pieper.solver.singular.self_motion import SelfMotion


@dataclass(frozen=True, eq=False, repr=False)
class KnownMotion(SelfMotion):
    """A self-motion whose points follow from one of them, and no curve need be walked; see SelfMotion.

    Attributes:
        through: (n,) a joint vector on it.
    """

    chain: Chain
    T: Array
    limits: Array
    names: tuple[str, ...]
    shown: int
    through: Array


class StraightMotion(KnownMotion):
    """A line: what lies at no distance lies on it."""

    def _contains(self, q: Array, tolerance: float) -> bool:
        return float(self.distances(q[None])[0]) <= tolerance
