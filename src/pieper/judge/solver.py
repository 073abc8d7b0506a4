"""The library's own solver, asked for the other solutions of a pose: all that the judge takes from what it judges."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import numpy as np

from pieper.description.dh import Description
from pieper.description.fold import chain_of
from pieper.solver import verbs
from pieper.solver.plan.classify import make_plan
from pieper.solver.plan.plan import Plan
from pieper.solver.results import Status


class Solver:
    """Every solution of a pose of one arm.

    Args:
        plan_for: task (None for the arm's default) -> how the arm is solved for it.
    """

    def __init__(self, plan_for: Callable[[str | None], Plan]) -> None:
        self._plan_for = plan_for

    @classmethod
    def of(cls, description: Description) -> Solver:
        """A solver that plans a described arm when it is first asked."""
        return cls(cache(lambda task: make_plan(chain_of(description), description, task=task)))

    def endless(self, T: np.ndarray, task: str | None = None) -> bool:
        """Whether a pose (4, 4), in m, has a whole curve of solutions."""
        return verbs.ik(self._plan_for(task), T, None).status == Status.REDUNDANT

    def most(self, task: str | None = None) -> int:
        """The largest number of solutions that a pose of this arm can have."""
        return self._plan_for(task).count.most

    def solutions(self, T: np.ndarray, task: str | None = None) -> np.ndarray:
        """Return all joint vectors (m, n), rad or m, of a pose (4, 4), before limits.

        Raises:
            PieperError: The arm is beyond the solver, or the pose or the task is none.
        """
        return np.asarray(verbs.ik(self._plan_for(task), T, None).all_q)
