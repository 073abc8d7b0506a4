"""The part of Arm that plans along paths with something left free: arcs of a pose and routes; it delegates."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from pieper.at_scale import AtScale
from pieper.description import change
from pieper.description.fold import chain_of
from pieper.errors import InputError, PlanError
from pieper.kinematics.arrays import Array, ArrayLike
from pieper.kinematics.pose import PoseLike, checked_pose
from pieper.solver.plan.classify import make_plan
from pieper.solver.plan.plan import Plan

if TYPE_CHECKING:
    from pieper.collision.scene import Scene
    from pieper.motion.route.arcs import Arc
    from pieper.motion.route.freedom import Freedom
    from pieper.motion.route.keep import Keep
    from pieper.motion.route.result import Route


class AlongPaths(AtScale):
    """What an arm does along paths that leave something free; `pieper.Arm` has it all."""

    def plan_for(self, task: str | None) -> Plan:
        """How the arm is solved for a task."""
        raise NotImplementedError

    def _joints(self, q: ArrayLike | str, what: str = "q") -> ArrayLike:
        raise NotImplementedError

    def route(
        self,
        path: PoseLike,
        free: Freedom | None = None,
        start: ArrayLike | str | None = None,
        end: ArrayLike | str | None = None,
        cost: str = "motion",
        clearance: float = 0.0,
        singularity: float = 0.0,
        turn_rate: float | None = None,
        scene: Scene | None = None,
    ) -> Route:
        """Find the cheapest continuous route along poses, or say why there is none; see docs/routes.md.

        Args:
            path: (N, 4, 4) poses, m; between two of them lies the line of `pieper.line`.
            free: What of the tool's orientation does not matter, a `pieper.Freedom`; None for nothing.
            start: (n,) posture to begin with, on the first pose; any where left out.
            end: (n,) posture to end with.
            cost: "motion", the sum of squared joint steps, or "time", the sum of the largest joint steps.
            clearance: Distance to keep to the scene and to the arm itself, m; needs a scene.
            singularity: Least ratio of the Jacobian's singular values, smallest over largest, in [0, 1).
            turn_rate: Largest change of the turn, rad per metre that the tool's point travels.
            scene: What stands around the arm, a `pieper.Scene`.

        Returns:
            The Route; a path without one is never an exception.

        Raises:
            InputError: What was given is impossible; the message says what, what is allowed, and the cure.
            PlanError: The arm's joints are coupled in parts of turns, or it cannot tilt its tool.
        """
        from pieper.motion.route.freedom import checked_freedom
        from pieper.motion.route.route import route

        said = checked_freedom(free)
        return route(
            self.plan,
            *self._plans_of(said),
            path,
            free=said,
            start=None if start is None else self._joints(start, "start"),
            end=None if end is None else self._joints(end, "end"),
            cost=cost,
            turn_rate=turn_rate,
            keep=self._keep(clearance, singularity, scene),
        )

    def arcs(self, T: PoseLike, free: Freedom | None = None) -> tuple[Arc, ...]:
        """Return every feasible interval of the turn at a pose: .branch, .winding, .lo, .hi, .ends.

        Args:
            T: (4, 4), base to tool.
            free: What is free, without a cone; None for the turn all the way round.

        Raises:
            InputError: T is not a pose, or the freedom has a cone.
            PlanError: There is not exactly one coordinate to choose.
        """
        from pieper.motion.route.arcs import arcs_at
        from pieper.motion.route.freedom import Freedom, checked_freedom
        from pieper.motion.route.setting import setting

        said = Freedom() if free is None else checked_freedom(free)
        if said.cone > 0:
            raise InputError(
                f"arcs are intervals of the turn alone; leave out the cone of {np.degrees(said.cone):.4g} degrees.",
                given=said.cone,
            )
        pose = checked_pose(T)
        world = setting(*self._plans_of(said), said, pose[None], np.zeros(1))
        if world.spare != 1:
            words = "its own joints decide the turn, and arm.ik has every solution there is"
            if world.spare > 1:
                words = f"{world.spare} are left to choose; hold joints with arm.with_joints_locked"
            elif self.plan.task != "position" and not said.turns:
                words = "nothing is left to choose; say a turn that is free"
            raise PlanError(
                f"arcs are intervals of one coordinate that is free to choose; of {self.plan.name} {words}."
            )
        return arcs_at(world, world.path[0])

    def _plans_of(self, free: Freedom) -> tuple[Plan, Plan]:
        """Return the plan of the arm with the axis meant as its tool's z, and that of what a freedom leaves."""
        from pieper.motion.route.setting import limits_of_axes, with_turn_limits

        self.description.not_linked(
            "routes are planned for arms of which every axis has a joint",
            "`arm.follow` takes such an arm, and holds the tool as the path says.",
        )
        if not free.turns and free.cone == 0 and free.interval == (0.0, 0.0):
            return self.plan, self.plan
        if self.plan.task == "position":
            # the arm's own task leaves the whole orientation: there is nothing that could be freer
            return self.plan, self.plan
        if free.axis == "z" and self.plan.uncoupled is None:
            return self.plan, with_turn_limits(self.plan_for("position+axis"), free)
        turned = self.description
        if free.axis != "z":
            turned = change.with_tool(turned, turned.tool @ free.to_z)
        chain = chain_of(turned)
        own = make_plan(chain, turned, task=None)
        # of coupled joints the axes are solved, with the limits of those that one joint moves alone
        axes = replace(turned, coupling=None, limits=limits_of_axes(chain.coupling, turned.limits))
        return own, with_turn_limits(make_plan(chain.uncoupled, axes, task="position+axis"), free)

    def _keep(self, clearance: float, singularity: float, scene: Scene | None) -> Keep:
        from pieper.collision import levers
        from pieper.collision.scene import Scene
        from pieper.motion.route.keep import Keep, checked_number

        room = checked_number(clearance, "clearance", "m")
        ratio = checked_number(singularity, "singularity", "a ratio of singular values", 1.0)
        if scene is None:
            if room > 0:
                raise InputError(
                    "a clearance needs a scene to keep clear of; say scene=pieper.Scene([...]).", given=room
                )
            return Keep(singularity=ratio)
        if not isinstance(scene, Scene):
            raise InputError(f"scene must be a pieper.Scene, got {type(scene).__name__}.", given=repr(scene))

        def away(q: Array) -> Array:
            return np.asarray(self.distance(q, scene), float)

        def is_clear(q: Array) -> bool:
            return self.clear(q, scene, room).verdict.name == "CLEAR"

        def nearest(q: Array) -> str:
            return " and ".join(self.distance(q, scene).pair)

        def at_most(q: Array, radius: Array) -> Array:
            return levers.at_most(self.collision_model(scene), q, radius)

        return Keep(ratio, room, away, is_clear, nearest, at_most)
