"""What holds a pose of a redundant arm in several degrees of freedom: all of it as one, shown by lines on it."""

from __future__ import annotations

import itertools
from dataclasses import dataclass, fields
from functools import cached_property

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.kinematics.newton import missed, newton
from pieper.solver.redundant.bounded_motion import BoundedMotion
from pieper.solver.redundant.box import descended
from pieper.tolerances import CLOSES, CURVE_RANK

#: Values of each of a task's virtual joints (rad) from which they are brought to a posture that is asked about.
VIRTUAL_STARTS = (0.0, 2.1, -2.1)
#: Newton steps from a posture onto the pose.
ONTO = 12


@dataclass(frozen=True, eq=False, repr=False)
class Surface(BoundedMotion):
    """Every posture that holds a pose of a redundant arm, where these have several degrees of freedom.

    Its pieces are not told apart: of several degrees of freedom no list of lines says which hang together. Samples,
    intervals and points are those of one line on it, inside the limits where any is.

    Attributes:
        lines: The other lines that were followed.
    """

    lines: tuple[BoundedMotion, ...] = ()

    @cached_property
    def free(self) -> tuple[int, ...]:
        """Joints (0-based) that move along any of the lines."""
        return tuple(sorted({*super().free, *(joint for line in self.lines for joint in line.free)}))

    def __str__(self) -> str:
        moving = [self.names[j] for j in self.free]
        return f"{', '.join(moving) or 'no joint of the arm'} move together with {self.dimension} degrees of freedom"

    def _contains(self, q: Array, tolerance: float) -> bool:
        held = self._virtual_brought(q)
        on = newton(self.chain, held, self.T, steps=ONTO, cutoff=CURVE_RANK)
        return bool(missed(self.chain, on, self.T) < CLOSES and np.linalg.norm(self.gaps(q, on)) <= tolerance)

    def _virtual_brought(self, q: Array) -> Array:
        """Return q (n,) with the task's virtual joints where the pose is missed least."""
        virtual = np.arange(self.chain.n) >= self.shown
        if not virtual.any():
            return q
        starts = np.tile(q, (len(VIRTUAL_STARTS) ** int(virtual.sum()), 1))
        starts[:, virtual] = list(itertools.product(VIRTUAL_STARTS, repeat=int(virtual.sum())))
        turn = np.where(virtual, 2 * np.pi, 0.0)
        poses = np.broadcast_to(self.T, (len(starts), 4, 4))
        there, off = descended(self.chain, starts, poses, starts - turn, starts + turn)
        return there[int(np.argmin(off))]

    def _nearest(self, q_now: Array, weights: Array) -> Array | None:
        near = [super()._nearest(q_now, weights), *(line.nearest(q_now, weights) for line in self.lines)]
        found = np.array([point for point in near if point is not None]).reshape(-1, self.shown)
        if not len(found):
            return None
        return found[int(np.argmin(self.chain.joints.first(self.shown).straight(found, q_now[: self.shown], weights)))]


def as_one(lines: tuple[BoundedMotion, ...]) -> tuple[BoundedMotion, ...]:
    """Return lines on what holds a pose in several degrees of freedom as the one thing they are."""
    if not lines:
        return ()
    shown = next((line for line in lines if line.inside), lines[0])
    told = {entry.name: getattr(shown, entry.name) for entry in fields(shown)}
    told["dimension"] = max(line.dimension for line in lines)
    return (Surface(**told, lines=tuple(line for line in lines if line is not shown)),)
