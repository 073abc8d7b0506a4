"""What figures and reports need of an arm: what the equations need, and the equations themselves."""

from __future__ import annotations

from typing import Protocol

from pieper.equations import Symbolic
from pieper.equations.arm import Arm as SolvedArm


class Arm(SolvedArm, Protocol):
    """An arm as pages see it; `pieper.Arm` has it all."""

    @property
    def symbolic(self) -> Symbolic:
        """The arm's equations."""
        ...
