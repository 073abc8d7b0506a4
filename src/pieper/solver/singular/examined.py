"""All there is at one pose: isolated solutions, merged roots and one representative of each self-motion, in order."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from pieper.kinematics.arrays import Array, Indices
from pieper.kinematics.chain import Chain
from pieper.solver.singular.merged_roots import null_direction
from pieper.solver.singular.self_motion import SelfMotion


@dataclass(frozen=True, eq=False)
class Examined:
    """All there is at one pose.

    Args:
        q: (m, n) isolated solutions and one representative a self-motion, as far as a pose of a batch has slots.
        self_motion: (m,) index of the self-motion each row represents, or -1.
        multiplicity: (m,) branches that merge in the row.
        directions: What `direction` is, or what works it out.
        motions: The curves, or what makes them.
    """

    q: Array
    self_motion: Indices
    multiplicity: Indices
    directions: Array | Callable[[], Array]
    motions: tuple[SelfMotion, ...] | Callable[[], tuple[SelfMotion, ...]]

    @cached_property
    def self_motions(self) -> tuple[SelfMotion, ...]:
        """The curves."""
        return self.motions() if callable(self.motions) else self.motions

    @cached_property
    def direction(self) -> Array:
        """(m, n) unit null direction of a row on a singularity, along which branches merge or the arm moves by itself.

        Zeros for the other rows.
        """
        return self.directions() if callable(self.directions) else self.directions

    def within(self, most: int) -> Examined:
        """Return the same with so many rows at the most: self-motions without a point inside the limits lose theirs.

        Isolated solutions are no more than the slots a pose has; only where self-motions are many, as the lines that
        show a surface are, one may be left without a row.
        """
        over = len(self.q) - most
        if over <= 0:
            return self
        inside = np.array([bool(motion.inside) for motion in self.self_motions] or [False])
        cost = np.where(self.self_motion < 0, 0, np.where(inside[self.self_motion], 1, 2))
        keep = np.sort(np.argsort(cost, kind="stable")[:most])
        return replace(
            self,
            q=self.q[keep],
            self_motion=self.self_motion[keep],
            multiplicity=self.multiplicity[keep],
            directions=self.direction[keep],
        )


def told(
    chain: Chain,
    isolated: Sequence[Array],
    singular: Sequence[Array],
    multiplicity: Sequence[int],
    motions: Sequence[SelfMotion],
) -> Examined:
    """Put together what was found, rows in the order of their joint values.

    Args:
        chain: The arm.
        isolated: Solutions with a well-conditioned Jacobian.
        singular: Isolated solutions without.
        multiplicity: How many branches merge in each of the latter.
        motions: The self-motions.
    """
    rows = [*isolated, *singular, *(motion.full_representative for motion in motions)]
    plain = len(isolated)
    direction = np.zeros((len(rows), chain.n))
    for k in range(plain, len(rows)):
        direction[k] = null_direction(chain, rows[k])
    of = np.full(len(rows), -1)
    of[plain + len(singular) :] = np.arange(len(motions))
    count = np.ones(len(rows), np.int64)
    count[plain : plain + len(singular)] = multiplicity
    q = chain.joints.wrapped(np.array(rows).reshape(-1, chain.n))
    order = np.lexsort(np.round(q, 6).T[::-1]) if len(q) else np.zeros(0, int)
    return Examined(q[order], of[order], count[order], direction[order], tuple(motions))
