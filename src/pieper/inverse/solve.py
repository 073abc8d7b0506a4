"""From a plan and a pose to Solutions: the door of the inverse wing."""

from __future__ import annotations

import numpy as np

from pieper.errors import PlanError


def ik(plan, T, redundancy):
    """Return Solutions of one pose."""
    raise PlanError("inverse kinematics is not built yet")


def ik_many(plan, Ts, threads, redundancy):
    """Return a SolutionBatch."""
    raise PlanError("inverse kinematics is not built yet")
