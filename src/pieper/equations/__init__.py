"""Equations of an arm that a person can read, each with the numbers that check it."""

from __future__ import annotations

import functools

__all__ = ["Symbolic"]


class Symbolic:
    """What `arm.symbolic` is: equations of one arm, made on demand and kept.

    Args:
        arm: A `pieper.Arm`; its description, plan, fk and ik are used.
    """

    def __init__(self, arm):
        self._arm = arm

    @functools.cache  # noqa: B019 - lives and dies with the arm
    def fk(self, *, lengths: str = "symbols", angles: str = "theta"):
        """Forward kinematics as equations (`ForwardEquations`)."""
        from pieper.equations.forward import ForwardEquations

        return ForwardEquations(self._arm.description, fk=self._arm.fk, lengths=lengths, angles=angles)

    @functools.cache  # noqa: B019
    def jacobian(self, *, lengths: str = "symbols", angles: str = "theta"):
        """The geometric Jacobian as equations (`JacobianEquations`)."""
        from pieper.equations.jacobian import JacobianEquations

        return JacobianEquations(self.fk(lengths=lengths, angles=angles), jacobian=self._arm.jacobian)

    @functools.cache  # noqa: B019
    def singularities(self, *, task: str | None = None):
        """The factored determinant and the singular configurations (`SingularityEquations`).

        Args:
            task: "pose", "position" or "position+axis"; the plan's task when left out.
        """
        from pieper.equations.singularities import SingularityEquations

        task = task or getattr(self._arm.plan, "task", "pose")
        return SingularityEquations(self.jacobian(), numeric=self._arm.jacobian, frames=self._arm.frames, task=task)

    @functools.cache  # noqa: B019
    def ik(self, *, task: str | None = None):
        """The derivation of the inverse, or what is true of an arm without a closed form (`InverseEquations`)."""
        from pieper.equations.inverse import InverseEquations

        return InverseEquations(self._arm, task=task)
