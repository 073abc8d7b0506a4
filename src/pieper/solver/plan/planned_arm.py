"""What wings that write, compare and calibrate arms need of one; `pieper.Arm` has it all."""

from __future__ import annotations

from typing import Protocol

from pieper.description.dh import Description
from pieper.kinematics.chain import Chain
from pieper.solver.plan.plan import Plan


class NominalArm(Protocol):
    """An arm as it is described."""

    description: Description
    chain: Chain


class PlannedArm(NominalArm, Protocol):
    """An arm and how it is solved."""

    @property
    def plan(self) -> Plan:
        """How the arm is solved; raises `PlanError`."""
        ...
