"""A cell: an arm on a positioner, a rail that carries it or a turntable that turns what it works at, as one chain."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, NoReturn

import numpy as np

from pieper.arm import Arm
from pieper.errors import InputError
from pieper.kinematics.arrays import Array, ArrayLike
from pieper.kinematics.pose import PoseLike, inverse, rotation_about, transform
from pieper.tolerances import TINY
from pieper.words_by_number import plural

if TYPE_CHECKING:
    from pieper.collision.bodies import Bodies
    from pieper.collision.distance import Distance
    from pieper.collision.profile import Profile
    from pieper.collision.scene import Scene
    from pieper.collision.swept import Swept
    from pieper.motion.route.arcs import Arc
    from pieper.motion.route.freedom import Freedom
    from pieper.motion.route.result import Route
    from pieper.motion.track import Track
    from pieper.solver.batch import SolutionBatch
    from pieper.solver.results import Solutions

RAIL, TABLE = "rail", "table"


class Cell:
    """An arm and one external axis, which comes first in every joint vector (n + 1,).

    With a rail the arm is carried along a direction, and poses are in the frame it stands in when the rail is at zero.
    With a turntable the arm stands still, and poses are in a frame that turns with the table and is the arm's base
    frame when the table is at zero: what is welded on the table is said once, as it lies on it.

    Args:
        arm: The arm, of joints that are not coupled.
        rail: (3,) direction in which the rail carries the arm, base frame.
        turntable: (point (3,), axis (3,)) of the table, base frame, m; it turns about the axis by the right hand.
        limits: (lo, hi) of the external axis, m or rad; None for none.

    Raises:
        InputError: Both or none of rail and turntable, a direction of no length, limits that are none, coupled joints.
    """

    def __init__(
        self,
        arm: Arm,
        *,
        rail: ArrayLike | None = None,
        turntable: tuple[ArrayLike, ArrayLike] | None = None,
        limits: Sequence[float] | None = None,
    ) -> None:
        if not isinstance(arm, Arm):
            raise InputError(f"a cell needs an arm, got {type(arm).__name__}.", given=repr(arm))
        if (rail is None) == (turntable is None):
            raise InputError("a cell has a rail or a turntable, one of them; say rail= or turntable=.")
        if arm.chain.coupling is not None:
            raise InputError(f"{arm.name} has coupled joints; a cell is made of joints that move by themselves.")
        if turntable is not None:
            try:
                point, axis = turntable
            except (TypeError, ValueError):
                raise InputError(
                    f"turntable must be (point, axis), got {turntable!r}.", given=repr(turntable)
                ) from None
            self._point, self._axis = _vector(point, "the turntable's point"), _unit(axis, "the turntable's axis")
            # seen from what lies on the table the arm turns the other way
            first = -self._axis
        else:
            self._point, self._axis = np.zeros(3), _unit(rail, "rail")
            first = self._axis
        self.arm = arm
        self.kind = RAIL if turntable is None else TABLE
        chain = arm.chain
        names = (self.kind if self.kind not in arm.joint_names else f"external {self.kind}", *arm.joint_names)
        both = [_limits(limits), *([None if not np.isfinite(v) else float(v) for v in pair] for pair in arm.limits)]
        self.whole = Arm.from_axes(
            np.vstack([first, chain.axes]),
            np.vstack([self._point, chain.points]),
            chain.home,
            joint_types=("P" if self.kind == RAIL else "R") + "".join("P" if p else "R" for p in chain.prismatic),
            limits=both,
            name=f"{arm.name} with a {'rail' if self.kind == RAIL else 'turntable'}",
            joint_names=names,
        )

    def __repr__(self) -> str:
        return f"<Cell: {self.whole.name}, {plural(self.n, 'joint')}>"

    def __getattr__(self, name: str) -> NoReturn:
        if not name.startswith("_") and name in dir(Arm):
            raise AttributeError(
                f"a Cell has no {name!r}: cell.whole is all of it as one arm, the {self.kind} its first joint, and "
                f"cell.arm the arm alone; say cell.whole.{name} or cell.arm.{name}.",
                name=name,
                obj=self,
            )
        raise AttributeError(f"a Cell has no {name!r}.", name=name, obj=self)

    @property
    def n(self) -> int:
        """Number of joints, the external one first."""
        return self.whole.n

    @property
    def joint_names(self) -> tuple[str, ...]:
        """Names of the joints, the external one first."""
        return self.whole.joint_names

    @property
    def limits(self) -> Array:
        """(n, 2) limits of the joints, the external one first, rad or m."""
        return self.whole.limits

    def fk(self, q: ArrayLike) -> Array:
        """Return the poses (..., 4, 4) of the tool at q (..., n): in the rail's frame, or in that of the table."""
        return self.whole.fk(q)

    def jacobian(self, q: ArrayLike) -> Array:
        """Return the Jacobian (..., 6, n) of the tool's point at q (..., n), in the frame of the poses."""
        return self.whole.jacobian(q)

    def ik(self, T: PoseLike, **said: Any) -> Solutions:
        """Return all joint vectors of a pose (4, 4); `said` is what `Arm.ik` takes."""
        return self._solid(said).ik(T, **said)

    def ik_many(self, Ts: PoseLike, **said: Any) -> SolutionBatch:
        """Return the joint vectors of poses (N, 4, 4); `said` is what `Arm.ik_many` takes."""
        return self.whole.ik_many(Ts, **said)

    def follow(self, path: PoseLike, *, start: ArrayLike | None = None) -> Track:
        """Follow poses (N, 4, 4) from a posture (n,) as `Arm.follow` does, the external axis moving along."""
        return self.whole.follow(path, start=start)

    def route(self, path: PoseLike, **said: Any) -> Route:
        """Return the best route along poses (N, 4, 4), external axis and all; `said` is what `Arm.route` takes."""
        return self._solid(said).route(path, **said)

    def arcs(self, T: PoseLike, free: Freedom | None = None) -> tuple[Arc, ...]:
        """Return every feasible interval of what is free at a pose (4, 4), as `Arm.arcs` does."""
        return self.whole.arcs(T, free)

    @property
    def bodies(self) -> Bodies:
        """The arm's bodies, each on the link that carries it; see `Arm.bodies`."""
        return self._embodied.bodies

    def distance(self, q: ArrayLike, scene: Scene | None = None) -> Distance:
        """Return how far the arm is from touching itself or a scene at q (..., n), m, as `Arm.distance` does.

        The scene stands where poses are said: beside the rail, or on the turntable and turning with it. What stands
        beside a turntable is kept from by the arm alone: `cell.arm.distance(q[..., 1:], scene)`.
        """
        return self._embodied.distance(q, scene)

    def clear(
        self, q_path: ArrayLike, scene: Scene | None = None, margin: float = 0.0, *, gap: float | None = None
    ) -> Swept:
        """Prove that a path (N, n) keeps the arm clear of itself and a scene, as `Arm.clear` does; see `distance`."""
        return self._embodied.clear(q_path, scene, margin, gap=gap)

    def clearance(self, q_path: ArrayLike, scene: Scene | None = None, margin: float = 0.0) -> Profile:
        """Return what a path (N, n) keeps away all along, as `Arm.clearance` does; see `distance`."""
        return self._embodied.clearance(q_path, scene, margin)

    def _solid(self, said: dict[str, Any]) -> Arm:
        """Return the whole arm, with the bodies of the arm it is made of where a scene is said."""
        return self.whole if said.get("scene") is None else self._embodied

    @cached_property
    def _embodied(self) -> Arm:
        """The whole arm with the bodies of the arm it is made of, each where it was, one joint further on."""
        zero = np.zeros(self.n)
        # frames: base, after each joint, tool; of the whole arm the external axis carries what was the base
        there = inverse(self.whole.frames(zero)[1:]) @ self.arm.frames(zero[1:])
        own = self.arm.bodies
        bodies = tuple(body.moved(there[body.on], body.on + 1) for body in own)
        allowed = tuple(tuple(sorted(pair)) for pair in own.allowed if len(pair) == 2)
        return Arm(replace(self.whole.description, bodies=bodies, allowed=allowed))

    def work(self, external: float) -> Array:
        """Return the pose (4, 4) of what lies on the table, base frame, at a value of the external axis, rad."""
        if self.kind == RAIL:
            return np.eye(4)
        R = np.asarray(rotation_about(self._axis, np.asarray(float(external))), np.float64)
        return np.asarray(transform(R, self._point - R @ self._point), np.float64)

    def on_table(self, T: PoseLike, external: float = 0.0) -> Array:
        """Return poses (..., 4, 4) of the base frame as they are on the table at a value of the external axis, rad."""
        return inverse(self.work(external)) @ np.asarray(T, np.float64)


def _vector(value: ArrayLike, what: str) -> Array:
    try:
        v = np.asarray(value, np.float64)
    except (TypeError, ValueError):
        raise InputError(f"{what} must be three numbers, got {value!r}.", given=repr(value)) from None
    if v.shape != (3,) or not np.isfinite(v).all():
        raise InputError(f"{what} must be three finite numbers, got {value!r}.", given=repr(value))
    return v


def _unit(value: ArrayLike | None, what: str) -> Array:
    v = _vector(() if value is None else value, what)
    size = float(np.linalg.norm(v))
    if size < TINY:
        raise InputError(f"{what} must have a direction, got a vector of no length.", given=repr(value))
    return v / size


def _limits(limits: Sequence[float] | None) -> list[float | None] | None:
    if limits is None:
        return None
    try:
        low, high = (float(v) for v in limits)
    except (TypeError, ValueError):
        raise InputError(f"limits must be (lo, hi), m or rad, got {limits!r}.", given=repr(limits)) from None
    if np.isnan(low) or np.isnan(high):
        raise InputError(
            f"limits must be two numbers, m or rad, infinite for none, got ({low:g}, {high:g}).", given=limits
        )
    if not low < high:
        raise InputError(f"limits must have the lower end first, got ({low:g}, {high:g}).", given=(low, high))
    return [low, high]
