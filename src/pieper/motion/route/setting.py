"""A path and what it leaves free, as one chain: the arm's joints, the turn about the tool's axis, its tilt."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from pieper.errors import PlanError
from pieper.kinematics.arrays import Array, Bools, Indices
from pieper.kinematics.chain import Chain
from pieper.kinematics.newton import newton_and_miss
from pieper.kinematics.pose import inverse, rotation_about, rotation_x
from pieper.motion.path import shortest_turn
from pieper.motion.route.freedom import Freedom
from pieper.solver.plan.plan import Plan
from pieper.solver.plan.six_joints import appended, generic_rank, with_task_joints
from pieper.tolerances import CLOSES, CONE_KEPT, TINY

#: Orientations in which the two virtual joints of a tilt act, about y and then about x.
_TILTS = [
    (rotation_about(np.array([1.0, 0.0, 0.0]), -np.pi / 2), False),
    (rotation_about(np.array([0.0, 1.0, 0.0]), np.pi / 2), False),
]


@dataclass(frozen=True, eq=False)
class Setting:
    """What is solved along a path. Joint vectors x (..., m) are the arm's, then the turn, then the tilt (y, x).

    Attributes:
        plan: How the arm itself is solved.
        rows: The plan whose rows are asked at poses: of a full pose where the arm can turn its tool as it is told.
        curves: The plan whose spare coordinates are all that is free but a tilt.
        free: What is free.
        path: (N, 4, 4) poses, their z axis the one that is meant, m.
        asked: (N, 4, 4) the poses as they were given.
        s: (N,) parameters of the points.
    """

    plan: Plan
    rows: Plan
    curves: Plan
    free: Freedom
    path: Array
    asked: Array
    s: Array

    @property
    def n(self) -> int:
        """Joints of the arm."""
        return self.plan.n

    @cached_property
    def turns(self) -> bool:
        """Whether the turn is a coordinate of its own."""
        return self.curves.task == "position+axis"

    @cached_property
    def turn_on_grid(self) -> bool:
        """Whether the turn is chosen, and the arm solved for it; else the arm's own joints decide it."""
        return self.turns and self.rows is not self.curves

    @cached_property
    def carried(self) -> Plan:
        """The plan whose branches are carried: of the axes where the task that is left is not the arm's own."""
        own = not self.turns or self.turn_on_grid or self.plan.task == self.curves.task
        return self.plan if own else self.curves

    def carried_at(self, q: Array) -> Array:
        """Return joints (..., n) as the plan that is carried has them."""
        return q if self.carried is self.plan else self.axes_at(q)

    @cached_property
    def tilts(self) -> bool:
        """Whether the tool's axis is kept, and may tilt."""
        return self.free.cone > 0 and self.curves.task != "position"

    @cached_property
    def chain(self) -> Chain:
        """All coordinates as one chain; fk(x) is the pose of the path."""
        full = self.curves.exact.full
        if self.coupling is not None and full.coupling is None:
            block = np.eye(full.n)
            block[: self.n, : self.n] = self.coupling
            full = Chain.of(full.links, full.prismatic, coupling=block)
        return appended(full, _TILTS) if self.tilts else full

    @property
    def coupling(self) -> Array | None:
        """(n, n) of coupled joints: values of the axes = coupling @ joint values."""
        return self.plan.chain.coupling

    def joints_at(self, x: Array) -> Array:
        """Return coordinates (..., k >= n) of the axes as those of the joints, what stands behind them kept."""
        if self.coupling is None:
            return x
        out = x.copy()
        out[..., : self.n] = x[..., : self.n] @ np.linalg.inv(self.coupling).T
        return out

    def axes_at(self, x: Array) -> Array:
        """Return coordinates (..., k >= n) of the joints as those of the axes."""
        if self.coupling is None:
            return x
        out = x.copy()
        out[..., : self.n] = x[..., : self.n] @ self.coupling.T
        return out

    @cached_property
    def filled(self) -> Chain:
        """The same with virtual joints for what a short arm cannot do; they stand at zero."""
        fill = self.curves.exact.fill
        return appended(self.chain, fill) if fill and not self.tilts else self.chain

    @cached_property
    def m(self) -> int:
        """Number of coordinates."""
        return self.chain.n

    @cached_property
    def spare(self) -> int:
        """How many of the coordinates are free to choose at a pose."""
        # a tilt of an arm that leans its tool only as its joints decide is not two more
        return self.m - generic_rank(self.chain.uncoupled) if self.tilts else len(self.curves.redundancy)

    @property
    def thin(self) -> bool:
        """Whether the tool leans only as the arm's own joints decide: no even grid of turns and tilts is held."""
        return self.tilts and self.spare < len(self.curves.redundancy) + 2

    @cached_property
    def limits(self) -> Array:
        """(m, 2) of the joints, the turn and the tilt, rad or m."""
        tilt = [(-self.free.cone, self.free.cone)] * 2 if self.tilts else []
        full = np.vstack([self.plan.limits, self.curves.full_limits[self.n :]])
        return np.vstack([full, np.array(tilt).reshape(-1, 2)])

    @cached_property
    def weights(self) -> Array:
        """(m,) what the square of each coordinate counts as motion: joints by the arm's units, virtual ones nothing."""
        own = self.plan.chain.joints.unit**-2.0
        return np.concatenate([own, np.zeros(self.m - self.n)])

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Names of the coordinates."""
        names = tuple("turn" if name == "tool roll" else name for name in self.curves.full_names)
        return (*names, *(("tilt about y", "tilt about x") if self.tilts else ()))

    def turn_of(self, x: Array) -> Array:
        """Return the turn (...) about the tool's axis of x (..., m), rad; zero where it is none's choice."""
        return -x[..., self.n] if self.turns else np.zeros(x.shape[:-1])

    def whole(self, q: Array, T: Array) -> Array:
        """Return all coordinates (..., m) of joints q (..., n) at poses T: what the tool is turned and tilted by."""
        x = np.zeros((*q.shape[:-1], self.m))
        x[..., : self.n] = q
        if not self.turns:
            return x
        left = inverse(T) @ self.plan.chain.native.fk(q)
        turned, axis = left[..., :3, :3], left[..., :3, 2]
        if self.tilts:
            x[..., -2] = -np.arcsin(np.clip(axis[..., 0], -1, 1))
            x[..., -1] = np.arctan2(axis[..., 1], axis[..., 2])
            back = rotation_x(-x[..., -1])[..., :3, :3] @ rotation_about(np.array([0.0, 1.0, 0.0]), -x[..., -2])
            turned = np.swapaxes(back, -1, -2) @ turned
        # fk(x) turns on by the virtual joint: it undoes what the tool was turned by
        turn = turned[..., 1, 0] - turned[..., 0, 1], turned[..., 0, 0] + turned[..., 1, 1]
        x[..., self.n] = -np.arctan2(*turn)
        return x

    def tilt_of(self, x: Array) -> Array:
        """Return by how much the tool's axis is tilted (...), rad."""
        if not self.tilts:
            return np.zeros(x.shape[:-1])
        return np.arccos(np.clip(np.cos(x[..., -1]) * np.cos(x[..., -2]), -1.0, 1.0))

    def at(self, s: Array | float) -> Array:
        """Return the poses (..., 4, 4) at s (...); between points lies the straight line."""
        s = np.asarray(s, float)
        flat = s.reshape(-1)
        if len(self.s) < 2:
            return np.broadcast_to(self.path[0], (*s.shape, 4, 4))
        k = np.clip(np.searchsorted(self.s, flat, side="right") - 1, 0, len(self.s) - 2)
        part = (flat - self.s[k]) / (self.s[k + 1] - self.s[k])
        axis, angle = self._turns
        out = self.path[k] + part[:, None, None] * (self.path[k + 1] - self.path[k])
        out[:, :3, :3] = self.path[k, :3, :3] @ rotation_about(axis[k], part * angle[k])
        out[part == 0.0], out[part == 1.0] = self.path[k[part == 0.0]], self.path[k[part == 1.0] + 1]
        return out.reshape(*s.shape, 4, 4)

    def twists(self, s: Array) -> tuple[Array, Array]:
        """Return by what axis (k - 1, 3), in the tool's frame, and angle (k - 1,) the tool turns between places s (k,).

        No point of the path may lie between two of them.
        """
        if len(s) < 2:
            return np.zeros((0, 3)), np.zeros(0)
        k = np.clip(np.searchsorted(self.s, s[:-1], side="right") - 1, 0, len(self.s) - 2)
        axis, angle = self._turns
        return axis[k], angle[k] * np.diff(s) / (self.s[k + 1] - self.s[k])

    @cached_property
    def _turns(self) -> tuple[Array, Array]:
        """(N - 1, 3) axis and (N - 1,) angle by which the tool turns from point to point."""
        R = self.path[:, :3, :3]
        turn = shortest_turn(R[:-1], R[1:])
        angle = np.linalg.norm(turn, axis=1)
        return np.where(angle[:, None] > 0, turn / np.maximum(angle, TINY)[:, None], [0.0, 0.0, 1.0]), angle

    def on(self, x: Array, T: Array) -> tuple[Array, Bools]:
        """Return x (k, m) moved onto poses T (k, 4, 4) the shortest way, and whether that was reached."""
        moved, left = newton_and_miss(self.chain, x, T, steps=8)
        return moved, left < CLOSES

    @cached_property
    def bounded(self) -> Indices:
        """Coordinates that have a limit of their own; a tilt has one with the other."""
        return np.flatnonzero(np.isfinite(self.limits).any(1) & (np.arange(self.m) < self.m - 2 * self.tilts))

    def inside_cone(self, x: Array) -> Array:
        """Return by how much the tilt of x (..., m) is inside the cone, (...): rad near its edge, smooth within."""
        cone = self.free.cone * (1 - CONE_KEPT)
        return (np.cos(x[..., -1]) * np.cos(x[..., -2]) - np.cos(cone)) / np.sin(cone)


def setting(plan: Plan, curves: Plan, free: Freedom, path: Array, s: Array) -> Setting:
    """Return what is solved along a path.

    Args:
        plan: The arm's default plan.
        curves: The plan of the task that is left: "position+axis" with the axis as z where the turn is free.
        free: What is free.
        path: (N, 4, 4) as given.
        s: (N,).

    Raises:
        PlanError: The arm's joints are coupled in parts of turns, or it cannot tilt its tool.
    """
    if not plan.chain.whole_turns:
        raise PlanError(
            f"{plan.name} has joints coupled in parts of turns; routes are planned where whole turns of the joints are "
            "whole turns of the axes. `arm.follow` takes any coupling. Or plan the route of arm.uncoupled(), whose "
            "joints are the axes, without the limits of coupled joints, and take np.linalg.solve(arm.coupling, "
            "route.q.T).T."
        )
    if (
        free.cone > 0
        and curves.task != "position"
        and generic_rank(with_task_joints(plan.chain.uncoupled, "position")) < 6
    ):
        raise PlanError(f"{plan.name} cannot tilt its tool: leave out the cone.")
    z = free.to_z
    rows = curves
    if (
        curves.task == "position+axis"
        and plan.task == "pose"
        and plan.rank == generic_rank(curves.exact.full.uncoupled)
    ):
        rows = plan
    return Setting(plan, rows, curves, free, path @ z if curves is not plan else path, path, s)


def limits_of_axes(coupling: Array | None, limits: Array) -> Array:
    """Return what limits (n, 2) of joints say of single axes; an axis that several joints move has none."""
    if coupling is None:
        return limits
    alone = (coupling == np.eye(len(coupling))).all(1)
    return np.where(alone[:, None], limits, [-np.inf, np.inf])


def with_turn_limits(curves: Plan, free: Freedom) -> Plan:
    """Return the plan with the turn's interval as limits of its virtual joint."""
    low, high = free.interval
    return replace(curves, virtual_limits=np.array([[-high, -low]])) if np.isfinite(low) else curves
