"""A self-motion along a straight line of joint space, whose distances are exact."""

from __future__ import annotations

from pieper.kinematics.arrays import Array
from pieper.solver.singular.self_motion import SelfMotion


class StraightMotion(SelfMotion):
    """A line: what lies at no distance lies on it, and nothing need be walked."""

    def _contains(self, q: Array, tolerance: float) -> bool:
        return float(self.distances(q[None])[0]) <= tolerance
