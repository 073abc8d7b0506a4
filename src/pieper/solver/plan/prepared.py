"""Native solvers of six-joint chains with joints locked at values, each made once and kept with its plan."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

import numpy as np

from pieper.errors import PlanError
from pieper.kinematics.arrays import Array
from pieper.kinematics.chain import Chain
from pieper.kinematics.geometry import look
from pieper.solver.families import choose
from pieper.solver.native import SixJointSolver, without_far_ends
from pieper.tolerances import GEOMETRY_EXACT

Key = TypeVar("Key")
Made = TypeVar("Made")
#: Six joints without limits, (6, 2).
UNLIMITED = np.tile([-np.inf, np.inf], (6, 1))


def solver_of(chain: Chain) -> SixJointSolver:
    """Return the native solver of a six-joint chain without limits; raises PlanError where no family takes it."""
    six, ends = without_far_ends(chain)
    _, spec = choose(six, look(six, GEOMETRY_EXACT))
    return SixJointSolver(six, spec, UNLIMITED, ends)


def made_once(kept: dict[Key, Made | PlanError], key: Key, make: Callable[[], Made], most: int | None = None) -> Made:
    """Return what is kept under a key, made where it is asked for first; a refusal is kept and raised again.

    The oldest is forgotten when there are more than `most`.
    """
    if key not in kept:
        if most is not None and len(kept) >= most:
            del kept[next(iter(kept))]
        try:
            kept[key] = make()
        except PlanError as refused:
            kept[key] = refused.with_traceback(None)
    found = kept[key]
    if isinstance(found, PlanError):
        raise PlanError(str(found), **found.data)
    return found


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
        return made_once(self._made, values, lambda: solver_of(self._six(np.array(values))), self._most)
