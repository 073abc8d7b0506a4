"""What equations, figures and reports need of an arm; `pieper.Arm` has it all, and so may anything else."""

from __future__ import annotations

from typing import Any, Protocol

from pieper.description.dh import Description
from pieper.kinematics.arrays import Array
from pieper.kinematics.chain import Chain
from pieper.solver.batch import SolutionBatch
from pieper.solver.plan.plan import Plan
from pieper.solver.results import Solutions


class Arm(Protocol):
    """An arm as the rooms below the facade see it; shapes and units are those of `pieper.Arm`."""

    description: Description
    chain: Chain

    @property
    def n(self) -> int:
        """Number of joints."""
        ...

    @property
    def name(self) -> str:
        """The arm's name."""
        ...

    @property
    def joint_names(self) -> tuple[str, ...]:
        """One name a joint."""
        ...

    @property
    def joint_types(self) -> str:
        """One letter a joint: R or P."""
        ...

    @property
    def limits(self) -> Array:
        """(n, 2) limits."""
        ...

    @property
    def base(self) -> Array:
        """(4, 4) base."""
        ...

    @property
    def tool(self) -> Array:
        """(4, 4) tool."""
        ...

    @property
    def plan(self) -> Plan:
        """How the arm is solved for its default task; raises `PlanError`."""
        ...

    def plan_for(self, task: str | None, /) -> Plan:
        """How the arm is solved for a task; raises `PlanError`."""
        ...

    def fk(self, q: Any, /) -> Array:
        """Poses (..., 4, 4) of q (..., n)."""
        ...

    def frames(self, q: Any, /) -> Array:
        """Frames (..., n + 2, 4, 4) of q (..., n)."""
        ...

    def jacobian(self, q: Any, /) -> Array:
        """Jacobians (..., 6, n) of q (..., n)."""
        ...

    def ik(self, T: Any, /, *, redundancy: Any = None) -> Solutions:
        """Every solution of a pose."""
        ...

    def ik_many(self, T: Any, /) -> SolutionBatch:
        """Every solution of many poses."""
        ...
