"""What a family of arms is: how it is recognised, made ready and told about; and what it hands to the native solver."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from pieper import _kernel
from pieper.kinematics.chain import Chain
from pieper.kinematics.geometry import Geometry
from pieper.tolerances import LIMIT_SLACK, ROTATION_ACCEPTED, ROTATION_EXACT


@dataclass(frozen=True, eq=False)
class KernelSpec:
    """A prepared kernel.

    Args:
        geometry: What the native kernel is told of the arm; its class names the kernel.
        info: What the preparation found (conditioning, ways left, ...).
        facts: What a reader of the plan may want to know of it, a sentence each.
        slot_labels: A posture label a slot, where slots have a fixed meaning; else None.
        closed_form: Whether it loses no solution next to a self-motion, so that its rows tell all that is there.
    """

    geometry: _kernel.Geometry
    info: dict[str, Any] = field(default_factory=dict[str, Any])
    facts: tuple[str, ...] = ()
    slot_labels: tuple[str, ...] | None = None
    closed_form: bool = False

    @property
    def max_solutions(self) -> int:
        """Slots a pose has; a slot keeps its meaning where the family says so."""
        return self.geometry.slots

    def solver(self, limits: npt.NDArray[np.float64], prismatic: npt.NDArray[np.bool_]) -> _kernel.Solver:
        """Return the native solver for limits (n, 2), rad or m, of joints of which some slide, (n,)."""
        return _kernel.Solver(
            self.geometry,
            lower=limits[:, 0],
            upper=limits[:, 1],
            prismatic=prismatic,
            slack=LIMIT_SLACK,
            accepted=ROTATION_ACCEPTED,
            exact=ROTATION_EXACT,
        )


@dataclass(frozen=True)
class Family:
    """A family of arms that one solver serves.

    Args:
        name: Its name in the plan, words joined by underscores.
        arrangement: What is special about its axes; completes "an arm with ...".
        words: How it is solved, a sentence or two for a reader.
        match: Takes a chain and its geometry, returns what it recognised or None.
        prepare: Takes the chain and the match, returns the prepared kernel; may raise PlanError.
        eliminating: Whether it eliminates joints: next to a self-motion the elimination is nearly singular and may
            hide solutions.
    """

    name: str
    arrangement: str
    words: str
    match: Callable[[Chain, Geometry], Any]
    prepare: Callable[[Chain, Any], KernelSpec]
    eliminating: bool = False
