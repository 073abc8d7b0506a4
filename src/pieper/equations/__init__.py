"""Equations of an arm that a person can read, each with the numbers that check it."""

from __future__ import annotations

import copy
from typing import TYPE_CHECKING

from pieper.description.slid import with_short_rows

if TYPE_CHECKING:
    from pieper.description.dh import Description
    from pieper.equations.arm import Arm
    from pieper.equations.forward import ForwardEquations
    from pieper.equations.inverse import InverseEquations
    from pieper.equations.jacobian import JacobianEquations
    from pieper.equations.singularities import SingularityEquations

__all__ = ["Symbolic"]


class Symbolic:
    """What `arm.symbolic` is: equations of one arm, made on demand and kept as long as it.

    Args:
        arm: The arm, such as a `pieper.Arm`.
    """

    def __init__(self, arm: Arm) -> None:
        short = with_short_rows(arm.description)
        if short is not arm.description:
            arm = copy.copy(arm)
            arm.description = short
        self._arm = arm
        self._forward: dict[tuple[str, str, str], ForwardEquations] = {}
        self._jacobian: dict[tuple[str, str], JacobianEquations] = {}
        self._singularities: dict[str, SingularityEquations] = {}
        self._inverse: dict[tuple[str | None, str], InverseEquations] = {}

    @property
    def table(self) -> Description:
        """The DH table that equations are written by: the arm's own, or one that does not lead far outside the arm."""
        return self._arm.description

    def fk(self, *, lengths: str = "symbols", angles: str = "theta", letters: str = "noap") -> ForwardEquations:
        """Return forward kinematics as equations.

        Args:
            lengths: "symbols" or "numbers".
            angles: "theta" (angles of the DH table) or "q" (the maker's joint coordinates).
            letters: "noap" (Paul) or "r" (r11 .. r33, Craig): the entries of the pose on the page.
        """
        key = lengths, angles, letters
        if key not in self._forward:
            from pieper.equations.forward import ForwardEquations

            arm = self._arm
            self._forward[key] = ForwardEquations(
                arm.description, fk=arm.fk, lengths=lengths, angles=angles, letters=letters
            )
        return self._forward[key]

    def jacobian(self, *, lengths: str = "symbols", angles: str = "theta") -> JacobianEquations:
        """Return the geometric Jacobian as equations; the options are those of `fk`."""
        if (lengths, angles) not in self._jacobian:
            from pieper.equations.jacobian import JacobianEquations

            made = JacobianEquations(self.fk(lengths=lengths, angles=angles), jacobian=self._arm.jacobian)
            self._jacobian[lengths, angles] = made
        return self._jacobian[lengths, angles]

    def singularities(self, *, task: str | None = None) -> SingularityEquations:
        """Return the factored determinant and the singular configurations.

        Args:
            task: "pose", "position" or "position+axis"; the plan's task when left out.
        """
        self._arm.description.not_linked("its singularities are not written as formulas")
        task = task or self._task()
        if task not in self._singularities:
            from pieper.equations.singularities import SingularityEquations

            arm = self._arm
            made = SingularityEquations(self.jacobian(), numeric=arm.jacobian, frames=arm.frames, task=task)
            self._singularities[task] = made
        return self._singularities[task]

    def _task(self) -> str:
        """The task that the solver takes; of an arm that it has no plan for the whole pose."""
        from pieper.errors import PlanError

        try:
            return self._arm.plan.task
        except PlanError:
            return "pose"

    def ik(self, *, task: str | None = None, letters: str = "noap") -> InverseEquations:
        """Return the derivation of the inverse, or what is true of an arm without a closed form.

        Args:
            task: "pose", "position" or "position+axis"; the plan's task when left out.
            letters: "noap" (Paul) or "r" (r11 .. r33, Craig): the entries of the pose on the page.
        """
        self._arm.description.not_linked("its inverse is not written as formulas")
        if (task, letters) not in self._inverse:
            from pieper.equations.inverse import InverseEquations

            self._inverse[task, letters] = InverseEquations(self._arm, task=task, letters=letters)
        return self._inverse[task, letters]
