"""Native solvers of six-joint chains with joints locked at values, each made once and kept with its plan."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from pieper.errors import PlanError
from pieper.kinematics.arrays import Array
from pieper.kinematics.chain import Chain
from pieper.kinematics.geometry import look
from pieper.solver.families import choose
from pieper.solver.native import SixJointSolver, without_far_ends
from pieper.tolerances import GEOMETRY_EXACT

#: Six joints without limits, (6, 2).
UNLIMITED = np.tile([-np.inf, np.inf], (6, 1))


def solver_of(chain: Chain) -> SixJointSolver:
    """Return the native solver of a six-joint chain without limits; raises PlanError where no family takes it."""
    six, ends = without_far_ends(chain)
    _, spec = choose(six, look(six, GEOMETRY_EXACT))
    return SixJointSolver(six, spec, UNLIMITED, ends)


class Prepared:
    """Solvers by the values of the locked joints; the oldest is forgotten when there are too many.

    Args:
        six: Makes the six-joint chain for values (k,).
        most: How many are kept.
    """

    def __init__(self, six: Callable[[Array], Chain], most: int) -> None:
        self._six, self._most = six, most
        self._made: dict[tuple[float, ...], SixJointSolver | PlanError] = {}

    def at(self, values: tuple[float, ...]) -> SixJointSolver:
        """Return the solver with the locked joints at values.

        Raises:
            PlanError: No family takes the chain.
        """
        if values not in self._made:
            if len(self._made) >= self._most:
                del self._made[next(iter(self._made))]
            try:
                self._made[values] = solver_of(self._six(np.array(values)))
            except PlanError as refused:
                self._made[values] = refused.with_traceback(None)
        found = self._made[values]
        if isinstance(found, PlanError):
            raise PlanError(str(found), **found.data)
        return found
