"""The native solver behind one six-joint chain, and what it says of a batch of poses."""

from __future__ import annotations

import numpy as np

from pieper import _kernel
from pieper.inverse.families.spec import KernelSpec
from pieper.kinematics.chain import Chain
from pieper.tolerances import LIMIT_SLACK, ROTATION_ACCEPTED, ROTATION_EXACT


class SixJointSolver:
    """A prepared kernel with limits.

    Args:
        chain: The six-joint chain.
        spec: Its prepared kernel.
        limits: (6, 2), rad or m.
    """

    __slots__ = ("chain", "many", "one", "spec")

    def __init__(self, chain: Chain, spec: KernelSpec, limits: np.ndarray) -> None:
        self.chain = chain
        self.spec = spec
        native = _kernel.Solver(
            spec.kind,
            chain.n,
            spec.max_solutions,
            np.ascontiguousarray(spec.params, np.float64),
            np.ascontiguousarray(spec.iparams, np.int32),
            np.ascontiguousarray(limits[:, 0]),
            np.ascontiguousarray(limits[:, 1]),
            np.ascontiguousarray(chain.prismatic, bool),
            LIMIT_SLACK,
            ROTATION_ACCEPTED,
            ROTATION_EXACT,
        )
        self.one = native.one
        self.many = native.many

    def all_rows(self, T: np.ndarray) -> np.ndarray:
        """Return the solutions (m, 6) of all poses T (N, 4, 4) in one heap."""
        q, valid, _, _ = self.many(np.ascontiguousarray(T), 1)
        return q[valid]
