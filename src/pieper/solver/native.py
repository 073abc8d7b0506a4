"""The native solver behind one six-joint chain, and what it says of a batch of poses."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from pieper import _kernel
from pieper.kinematics.arrays import Array, Bits, Bools, Indices, Slots
from pieper.kinematics.chain import Chain
from pieper.kinematics.pose import inverse
from pieper.solver.families.family import KernelSpec
from pieper.solver.rows import Rows

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


#: A self-motion as the kernel tells it: a line of joint space as a joint vector (6,) on it, its two joints and their
#: sense; a linkage as a joint vector, its joints (4,), axes (4, 3), places in the plane (4,) complex or None, senses
#: (4,), which joint leads, from where to where (rad from the joint vector), and its course; one that was followed as
#: points (k, 6) and whether it closes.
SelfMotionSaid = (
    tuple[Array, bool]
    | tuple[Array, tuple[int, int], float]
    | tuple[Array, Indices, Array, Array | None, Array, int, float, float, int]
)


@dataclass(frozen=True, eq=False, slots=True)
class Read:
    """What the kernel read off the axes of a singular pose's rows.

    Args:
        q: (m, 6) rows in order, rad or m.
        inside: (m,) whether they are inside the limits.
        flag: Bits of `Flag`.
        singular: (m,) which of them lie on a singularity.
        branches: (m,) how many branches merge in each.
        self_motion: (m,) which self-motion a row stands for, or -1.
        self_motions: Those.
    """

    q: Array
    inside: Bools
    flag: int
    singular: Bools
    branches: Indices
    self_motion: Indices
    self_motions: list[SelfMotionSaid]


class SixJointSolver:
    """A prepared kernel with limits.

    Args:
        chain: The six-joint chain.
        spec: Its prepared kernel.
        limits: (6, 2), rad or m.
        ends: What poses are multiplied with, as `without_far_ends` says.
    """

    __slots__ = ("chain", "ends", "into", "limits", "look", "many", "one", "reach", "spec")

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
        self.look: _kernel.CarefulLook | None = _look(native, chain, limits, spec)
        self.one: Callable[[Any], tuple[Array, Slots, Bools, int]] = native.one
        self.many: Callable[[Array, int], tuple[Array, Bools, Bools, Bits]] = native.many
        self.into: Callable[..., Any] = native.into
        #: Voxels times orientations at once; None where base or tool are taken off poses.
        self.reach: Callable[..., Any] | None = native.reach if ends is None else None
        if ends is not None:
            self.one = partial(_one_between, native, *ends)
            self.many = partial(_many_between, native, *ends)
            self.into = partial(_into_between, native, *ends)

    def read(self, T: Array, q: Array, flag: int) -> Read | None:
        """Return what there is at a singular pose; None where that cannot be read off.

        Args:
            T: (4, 4), as it was given.
            q: (m, 6) what `one` returned.
            flag: The same.
        """
        if self.look is None:
            return None
        pose = T if self.ends is None else self.ends[0] @ np.asarray(T, float) @ self.ends[1]
        found = self.look.one(pose, q, flag)
        return None if found is None else Read(*found)

    def read_into(self, T: Array, index: Indices, rows: Rows) -> Bits:
        """Write what there is at the poses of T (N, 4, 4) that index (k,) names into rows.

        Returns:
            (k,) 0 where that cannot be read off, 2 where a self-motion is among it, else 1.
        """
        if self.look is None:
            return np.zeros(len(index), np.uint8)
        poses = T if self.ends is None else np.ascontiguousarray(self.ends[0] @ T @ self.ends[1])
        return self.look.into(poses, index, rows.q, rows.valid, rows.inside, rows.flags)

    def __reduce__(self) -> tuple[Any, ...]:
        return SixJointSolver, (self.chain, self.spec, self.limits, self.ends)

    def all_rows(self, T: np.ndarray) -> np.ndarray:
        """Return the solutions (m, 6) of all poses T (N, 4, 4) in one heap."""
        q, valid, _, _ = self.many(np.ascontiguousarray(T), 1)
        return q[valid]


def _look(native: _kernel.Solver, chain: Chain, limits: Array, spec: KernelSpec) -> _kernel.CarefulLook | None:
    """Return the look at singular poses of six joints."""
    if chain.n != 6:
        return None
    return _kernel.CarefulLook(
        native, chain.plain, lower=limits[:, 0], upper=limits[:, 1], closed_form=spec.closed_form
    )
