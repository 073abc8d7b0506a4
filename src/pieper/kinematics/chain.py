"""The chain of axes: constant links with a pure joint motion about or along z between them."""

from __future__ import annotations

from dataclasses import dataclass, field, fields
from functools import cached_property
from typing import Any

import numpy as np

from pieper import _kernel
from pieper.errors import InputError
from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.joints import JointSpace
from pieper.kinematics.pose import FLIP, inverse, rotation_z, translation
from pieper.kinematics.whole_turns import WholeTurns
from pieper.tolerances import LENGTHLESS, ROUNDING


@dataclass(frozen=True, eq=False)
class CoupledForward:
    """Forward kinematics of coupled joints: asked at q, answered by the chain at coupling @ q.

    Args:
        plain: Of the chain whose joints move by themselves.
        coupling: (axes, n).
    """

    plain: _kernel.Forward
    coupling: Array

    def fk(self, q: Array) -> Array:
        """Return poses (..., 4, 4)."""
        return self.plain.fk(q @ self.coupling.T)

    def frames(self, q: Array, base: Array) -> Array:
        """Return frames (..., n + 2, 4, 4)."""
        return self.plain.frames(q @ self.coupling.T, base)

    def jacobian(self, q: Array) -> Array:
        """Return Jacobians (..., 6, n) by the joints' own numbers."""
        return self.plain.jacobian(q @ self.coupling.T) @ self.coupling


@dataclass(frozen=True, eq=False)
class Chain:
    """T(q) = L0 Z(q1) L1 Z(q2) ... Z(qn) Ln, with Z a rotation about or a translation along the local z.

    Base, tool, DH convention and the maker's zero and sense are all folded into the links, so that every arm looks
    the same to what comes after.

    Args:
        links: (n + 1, 4, 4), m.
        sliding: (n,) bool, one an axis.
        frames_after: (n, 4, 4), what leads from the frame just after joint i to the DH frame i of the description.
        coupling: (n, n), None where no joint is coupled: the chain is at coupling @ q. Forward kinematics takes q;
            axes, points and home are those at zero either way. Where a linkage moves some axes it is (axes, n), with
            fewer joints than axes.
        own: (n,) the axis (0-based) of each joint.
        scale: The characteristic length is no less than this, m: for poses so far away that the links are nothing.
    """

    links: Array
    sliding: Bools
    frames_after: Array = field(repr=False)
    coupling: Array | None = None
    own: tuple[int, ...] = ()
    scale: float = 0.0

    @cached_property
    def prismatic(self) -> Bools:
        """(n,) bool, one a joint."""
        return self.sliding if len(self.own) in (0, len(self.sliding)) else self.sliding[list(self.own)]

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.prismatic)

    @property
    def axis_count(self) -> int:
        """Number of axes: more than joints where a linkage moves some."""
        return len(self.sliding)

    @property
    def linked(self) -> bool:
        """Whether a linkage moves axes that have no joint of their own."""
        return self.axis_count > self.n

    @cached_property
    def _joint_frames(self) -> Array:
        frames = np.empty((self.axis_count, 4, 4))
        frame = self.links[0]
        for i in range(self.axis_count):
            frames[i] = frame
            frame = frame @ self.links[i + 1]
        return frames

    @cached_property
    def axes(self) -> Array:
        """Unit joint axes (n, 3) in the world frame, all joints at zero."""
        return self._joint_frames[:, :3, 2].copy()

    @cached_property
    def points(self) -> Array:
        """A point (n, 3) on each joint axis in the world frame, all joints at zero, m."""
        return self._joint_frames[:, :3, 3].copy()

    @cached_property
    def home(self) -> Array:
        """The tool's pose (4, 4) with all joints at zero."""
        return self._joint_frames[-1] @ self.links[-1]

    @cached_property
    def native(self) -> _kernel.Forward | CoupledForward:
        """The native forward kinematics of this chain."""
        return self._coupled(self.plain)

    @cached_property
    def native_axes(self) -> _kernel.Forward | CoupledForward:
        """The native forward kinematics whose frames stand on the joint axes, z along them."""
        after = np.tile(np.eye(4), (self.axis_count, 1, 1))
        return self._coupled(_kernel.Forward(self.links, self.sliding, after, self.length))

    @cached_property
    def plain(self) -> _kernel.Forward:
        """The native chain whose joints move by themselves."""
        return _kernel.Forward(self.links, self.sliding, self.frames_after, self.length)

    def _coupled(self, plain: _kernel.Forward) -> _kernel.Forward | CoupledForward:
        return plain if self.coupling is None else CoupledForward(plain, self.coupling)

    def numbers(self, values: Array) -> Array:
        """Return the joint vectors (..., n) at which the joints' own axes have their part of values (..., axes)."""
        if self.coupling is None:
            return values
        own = list(self.own) or list(range(self.n))
        return np.asarray(np.linalg.solve(self.coupling[own], values[..., own, None])[..., 0], np.float64)

    @property
    def uncoupled(self) -> Chain:
        """The chain whose joints move by themselves; the same object where they do."""
        return self if self.coupling is None else Chain(self.links, self.sliding, self.frames_after, scale=self.scale)

    @cached_property
    def whole_turns(self) -> bool:
        """Whether whole turns of the joints are whole turns of the chain, and the other way round."""
        if self.coupling is None:
            return True
        if self.linked:
            return self._whole_turns_of_linkage(self.coupling)
        turning = ~self.prismatic
        for C in (self.coupling, np.linalg.inv(self.coupling)):
            part = C[np.ix_(turning, turning)]
            if np.abs(part - np.round(part)).max(initial=0.0) > ROUNDING or C[np.ix_(~turning, turning)].any():
                return False
        return True

    def _whole_turns_of_linkage(self, C: Array) -> bool:
        """Whether whole turns of the joints are whole turns of the axes, and those of their own axes theirs."""
        turning = ~self.prismatic
        own = C[list(self.own)]
        for part, slides in ((C, self.sliding), (np.linalg.inv(own), self.prismatic)):
            turns = part[np.ix_(~slides, turning)]
            if np.abs(turns - np.round(turns)).max(initial=0.0) > ROUNDING or part[np.ix_(slides, turning)].any():
                return False
        return True

    def __getstate__(self) -> dict[str, Any]:
        """What pickle keeps: the links; what was made of them is made again."""
        return {entry.name: getattr(self, entry.name) for entry in fields(self)}

    @cached_property
    def joints(self) -> JointSpace:
        """How its joint vectors are measured."""
        if self.coupling is None or self.linked or self.whole_turns:
            return JointSpace(self.prismatic, self.length)
        return JointSpace(self.prismatic, self.length, WholeTurns(self.coupling, self.prismatic))

    @cached_property
    def length(self) -> float:
        """Characteristic length, m: the common normals and offsets between the joint axes, added up; 1 if all vanish.

        Base and tool do not count: moving either must not change what is called near.
        """
        total = sum(float(np.linalg.norm(self.links[i][:3, 3])) for i in range(1, self.axis_count))
        # of a sine of pi as rounded some 1e-16 m may be left
        told = total if total > LENGTHLESS * float(np.abs(self.links[:, :3, 3]).max()) else 1.0
        return max(told, self.scale)

    @staticmethod
    def of(
        links: Array,
        sliding: Bools,
        frames_after: Array | None = None,
        coupling: Array | None = None,
        own: tuple[int, ...] = (),
        scale: float = 0.0,
    ) -> Chain:
        """Make a chain of links (n + 1, 4, 4) and kinds of axes (n,), frozen."""
        links = np.ascontiguousarray(links, float)
        sliding = np.ascontiguousarray(sliding, bool)
        if frames_after is None:
            frames_after = np.tile(np.eye(4), (len(sliding), 1, 1))
        for array in (links, sliding, frames_after):
            array.setflags(write=False)
        return Chain(links, sliding, frames_after, coupling, own, scale)

    def reversed(self) -> Chain:
        """Return the chain seen from the tool, joints last to first: its T is the inverse of this one's."""
        self._not_coupled()
        links = np.stack([FLIP @ inverse(link) @ FLIP for link in self.links[::-1]])
        links[0] = inverse(self.links[-1]) @ FLIP
        links[-1] = FLIP @ inverse(self.links[0])
        return Chain.of(links, self.prismatic[::-1].copy(), scale=self.scale)

    def _not_coupled(self) -> None:
        if self.coupling is not None:
            raise InputError("coupled joints cannot be taken apart: what one is told moves others.")

    def locked(self, joint: int, value: float) -> Chain:
        """Return the chain with one joint (0-based) held at a value, rad or m, and n - 1 joints left."""
        self._not_coupled()
        motion = translation(z=value) if self.prismatic[joint] else rotation_z(value)
        merged = self.links[joint] @ motion @ self.links[joint + 1]
        links = np.concatenate([self.links[:joint], merged[None], self.links[joint + 2 :]])
        return Chain.of(links, np.delete(self.prismatic, joint), scale=self.scale)

    def section(self, first: int, last: int) -> Chain:
        """Return joints first..last (0-based, inclusive) with their links, link 0 and the last one the identity."""
        self._not_coupled()
        links = self.links[first : last + 2].copy()
        links[0] = links[-1] = np.eye(4)
        return Chain.of(links, self.prismatic[first : last + 1].copy(), scale=self.scale)
