"""What the families that hide one joint's angle need of the general solver."""

from __future__ import annotations

from typing import cast

from pieper import _kernel
from pieper.errors import PlanError
from pieper.kinematics.chain import Chain
from pieper.solver.families import general


def general_model(chain: Chain) -> _kernel.General | None:
    """Return the general solver's model of an arm, or None where it has no way to solve it."""
    try:
        return cast(_kernel.General, general.prepare(chain).geometry)
    except PlanError:
        return None
