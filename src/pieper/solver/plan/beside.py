"""Arms a little off one whose own eliminations all vanish: what they have at a pose leads to all that this one has."""

from __future__ import annotations

import numpy as np

from pieper.errors import PlanError
from pieper.kinematics.chain import Chain
from pieper.kinematics.pose import rotation_about, transform
from pieper.solver.native import SixJointSolver
from pieper.solver.plan.prepared import solver_of
from pieper.tolerances import ARM_BESIDE

#: How many such arms are made; of each pose as many must be certain as vouch for a pose (`singular/careful.py`).
ARMS = 8


def arms_beside(chain: Chain) -> tuple[SixJointSolver, ...]:
    """Return solvers of six-joint chains whose inner links are turned and moved a little, the same ones every time."""
    rng, made = np.random.default_rng(31), list[SixJointSolver]()
    for _ in range(ARMS):
        links = chain.links.copy()
        for k in range(1, len(links) - 1):
            way, step = rng.standard_normal((2, 3))
            axis = way / np.linalg.norm(way)
            links[k] = links[k] @ transform(rotation_about(axis, ARM_BESIDE), ARM_BESIDE * chain.length * step)
        try:
            made.append(solver_of(Chain.of(links, chain.prismatic.copy(), scale=chain.scale)))
        except PlanError:
            continue
    return tuple(made)
