"""What the families that hide one joint's angle hand to their kernels (kernels/hidden_angle.hpp)."""

from __future__ import annotations

import numpy as np

from pieper.errors import PlanError
from pieper.kinematics.chain import Chain
from pieper.solver.families import general


def with_head(chain: Chain, *arms: np.ndarray, backward: bool = False, spare: np.ndarray | None = None) -> np.ndarray:
    """Return a kernel's numbers: its head, its arms, and the general solver's model for what is not clear.

    Args:
        chain: The chain that is solved, already reversed where `backward`.
        arms: The family's own numbers, once for each way in which it sees the arm, best first.
        backward: Whether the chain stands for the reversed arm.
        spare: The general solver's model of the arm (`general_model`); None leaves unclear poses uncertain.
    """
    flags = [float(backward), float(spare is None), float(len(arms))]
    head = [[chain.length], np.ravel(chain.links), chain.prismatic.astype(float), flags]
    return np.concatenate([*head, *arms, np.zeros(0) if spare is None else spare])


def general_model(chain: Chain) -> np.ndarray | None:
    """Return the general solver's numbers for an arm, or None where it has no way to solve it."""
    try:
        return general.prepare(chain).params
    except PlanError:
        return None
