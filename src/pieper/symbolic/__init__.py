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
        from pieper.symbolic.forward import ForwardEquations

        return ForwardEquations(self._arm.description, fk=self._arm.fk, lengths=lengths, angles=angles)
