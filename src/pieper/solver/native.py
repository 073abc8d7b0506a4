"""The native solver behind one six-joint chain, and what it says of a batch of poses."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from pieper import _kernel
from pieper.kinematics.arrays import Array, Bits, Bools, Slots
from pieper.kinematics.chain import Chain
from pieper.kinematics.pose import inverse
from pieper.solver.families.family import KernelSpec

#: A base or a tool this many lengths of the arm away is taken off the poses before they are solved: beside it the
#: arm's own coordinates would drown in rounding.
FAR = 100.0


def without_far_ends(chain: Chain) -> tuple[Chain, tuple[np.ndarray, np.ndarray] | None]:
    """Return the chain that is to be solved, and what its poses T must be multiplied with: before, after (4, 4).

    None where base and tool are near, and the chain is returned as it is.
    """
    if max(np.linalg.norm(chain.links[i][:3, 3]) for i in (0, -1)) <= FAR * chain.length:
        return chain, None
    return chain.section(0, chain.n - 1), (inverse(chain.links[0]), inverse(chain.links[-1]))


def _one_between(native: _kernel.Solver, before: Array, after: Array, T: Any) -> tuple[Array, Slots, Bools, int]:
    return native.one(before @ np.asarray(T, float) @ after)


def _many_between(
    native: _kernel.Solver, before: Array, after: Array, T: Array, threads: int
) -> tuple[Array, Bools, Bools, Bits]:
    return native.many(np.ascontiguousarray(before @ T @ after), threads)


def _into_between(native: _kernel.Solver, before: Array, after: Array, T: Array, *rest: Any) -> None:
    native.into(np.ascontiguousarray(before @ T @ after), *rest)


class SixJointSolver:
    """A prepared kernel with limits.

    Args:
        chain: The six-joint chain.
        spec: Its prepared kernel.
        limits: (6, 2), rad or m.
        ends: What poses are multiplied with, as `without_far_ends` says.
    """

    __slots__ = ("chain", "ends", "into", "limits", "many", "one", "reach", "spec")

    def __init__(
        self,
        chain: Chain,
        spec: KernelSpec,
        limits: np.ndarray,
        ends: tuple[np.ndarray, np.ndarray] | None = None,
    ) -> None:
        self.chain = chain
        self.spec = spec
        self.limits = limits
        self.ends = ends
        native = spec.solver(limits, chain.prismatic)
        self.one: Callable[[Any], tuple[Array, Slots, Bools, int]] = native.one
        self.many: Callable[[Array, int], tuple[Array, Bools, Bools, Bits]] = native.many
        self.into: Callable[..., Any] = native.into
        #: Voxels times orientations at once; None where base or tool are taken off poses.
        self.reach: Callable[..., Any] | None = native.reach if ends is None else None
        if ends is not None:
            self.one = partial(_one_between, native, *ends)
            self.many = partial(_many_between, native, *ends)
            self.into = partial(_into_between, native, *ends)

    def __reduce__(self) -> tuple[Any, ...]:
        return SixJointSolver, (self.chain, self.spec, self.limits, self.ends)

    def all_rows(self, T: np.ndarray) -> np.ndarray:
        """Return the solutions (m, 6) of all poses T (N, 4, 4) in one heap."""
        q, valid, _, _ = self.many(np.ascontiguousarray(T), 1)
        return q[valid]
