"""The part of Arm that goes beyond one pose: bodies and clearance, reach maps, calibration, code; it delegates."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self
from weakref import WeakKeyDictionary

import numpy as np

from pieper.description.dh import Description
from pieper.kinematics.arrays import Array, ArrayLike, Indices
from pieper.kinematics.chain import Chain
from pieper.kinematics.pose import PoseLike
from pieper.solver.plan.plan import Plan

if TYPE_CHECKING:
    from concurrent.futures import Executor

    from pieper.calibration.fit import Fit
    from pieper.collision.bodies import Bodies, Said
    from pieper.collision.distance import Distance
    from pieper.collision.model import Model
    from pieper.collision.profile import Profile
    from pieper.collision.scene import Scene
    from pieper.collision.swept import Swept
    from pieper.description.visuals import Visuals
    from pieper.maps.aspects import Aspects
    from pieper.maps.reach_map import ReachMap
    from pieper.motion.motion import Motion
    from pieper.motion.timed_path import JointPath
    from pieper.verify.comparison import Comparison

#: How an arm with a linkage is calibrated.
_BY_AXES = "Calibrate arm.uncoupled(), whose joints are the axes, at q @ arm.coupling.T."


class AtScale:
    """What an arm does at scale; `pieper.Arm` has it all."""

    description: Description
    chain: Chain
    _models: WeakKeyDictionary[Scene, Model]
    _snap: float | None

    def __init__(self, description: Description, *, snap: float | None = None) -> None:
        raise NotImplementedError

    @property
    def plan(self) -> Plan:
        """How the arm is solved for its default task."""
        raise NotImplementedError

    def plan_for(self, task: str | None) -> Plan:
        """Return how the arm is solved for a task; its own where none is said."""
        raise NotImplementedError

    def __getstate__(self) -> dict[str, Any]:
        """What pickle keeps: all but the models of scenes, which are made again."""
        return {key: value for key, value in self.__dict__.items() if key != "_models"}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state, _models=WeakKeyDictionary())

    @cached_property
    def extent(self) -> tuple[list[float], float]:
        """Where the arm stands, and how far it reaches at most, m."""
        base, *links = self.chain.links[:, :3, 3]
        reach = np.linalg.norm(links, axis=1).sum() + np.abs(self.description.limits[self.chain.prismatic]).sum()
        return base.tolist(), float(reach)

    def _joints(self, q: ArrayLike | str, what: str = "q") -> ArrayLike:
        raise NotImplementedError

    @cached_property
    def bodies(self) -> Bodies:
        """What the arm is made of: from its file where that has bodies, guessed from its table where not.

        `bodies.explain()` says which, and which pairs may touch; see docs/collision.md.
        """
        from pieper.collision.bodies import bodies_of

        return bodies_of(self.description)

    @cached_property
    def visuals(self) -> Visuals:
        """What the URDF or MJCF that the arm was read from says of its looks; empty for any other arm."""
        from pieper.description.visuals import visuals_of

        return visuals_of(self.description)

    def with_bodies(
        self, where: Mapping[str, Said], *, allowed: Sequence[tuple[str, str]] = (), instead: bool = False
    ) -> Self:
        """Return the arm with bodies added: "base", a joint's name (the link it moves) or "tool" -> shapes there.

        A tool, and what a gripper holds, are bodies on "tool".

        Args:
            where: Place -> one shape or several; frames are those of `frames`.
            allowed: Pairs of names that may touch beside neighbours.
            instead: Whether they take the place of all bodies the arm had.

        Raises:
            InputError: No such place, something that is no shape, a name that is taken.
        """
        from pieper.collision.bodies import with_bodies

        said = with_bodies(self.description, where, allowed=allowed, instead=instead)
        return type(self)(said, snap=self._snap)

    def distance(self, q: ArrayLike | str, scene: Scene | None = None) -> Distance:
        """Return how far the arm is from touching itself or a scene, (...,) m, of joint vectors q (..., n).

        Negative where bodies overlap; `.pair`, `.points` and `.gradient` say which, where, and how it changes.

        Raises:
            InputError: q has the wrong shape or is not finite, or the scene names a body the arm has not.
        """
        from pieper.collision.distance import distance

        return distance(self.collision_model(scene), self._joints(q))

    def clear(
        self,
        q_path: JointPath | Motion | ArrayLike | str,
        scene: Scene | None = None,
        margin: float = 0.0,
        *,
        gap: float | None = None,
    ) -> Swept:
        """Prove that a path keeps the arm clear of itself and a scene, or say where it does not.

        Args:
            q_path: (N, n) joint vectors, a route, a track or a motion (its samples), between whose points every joint
                moves evenly; one posture is a path too.
            scene: What stands around the arm; None for the arm alone.
            margin: Distance to keep, m.
            gap: How near to the margin may remain undecided, m; 1e-6 when left out.

        Raises:
            InputError: No path, one that does not reach its end, or more than ten million points; a margin that is no
                length.
        """
        from pieper.collision.swept import clear
        from pieper.motion.timed_path import joint_points
        from pieper.tolerances import CLEARANCE_GAP

        said = q_path if isinstance(q_path, str) else joint_points(q_path)
        model, path = self.collision_model(scene), self._joints(said, "the path")
        return clear(model, path, margin, gap=CLEARANCE_GAP if gap is None else gap)

    def clearance(
        self, q_path: ArrayLike | JointPath | Motion, scene: Scene | None = None, margin: float = 0.0
    ) -> Profile:
        """Return what a path keeps away all along: distances, and what is proved between them; see `clearance_figure`.

        Args:
            q_path: As of `clear`.
            scene: What stands around the arm; None for the arm alone.
            margin: Distance to keep, m.

        Raises:
            InputError: As of `clear`.
        """
        from pieper.collision.profile import profile
        from pieper.motion.timed_path import joint_points

        said = q_path if isinstance(q_path, str) else joint_points(q_path)
        model, path = self.collision_model(scene), self._joints(said, "the path")
        return profile(model, path, margin)

    def collision_model(self, scene: Scene | None) -> Model:
        """Return what must keep apart, as distances are computed of it; made once a scene."""
        from pieper.collision.doubtful import remark_doubtful_scene
        from pieper.collision.model import model_of
        from pieper.collision.scene import EMPTY, Scene
        from pieper.errors import InputError

        around = EMPTY if scene is None else scene
        if not isinstance(around, Scene):
            raise InputError(f"the scene must be a pieper.Scene, got {type(around).__name__}.", given=scene)
        if around not in self._models:
            model = self._models[around] = model_of(self.description, self.chain, self.bodies, around)
            remark_doubtful_scene(model, *self.extent, self.description.name)
        return self._models[around]

    def calibrate(
        self,
        q: ArrayLike,
        measured: PoseLike | None,
        *,
        kind: str = "pose",
        sigma: Sequence[float] | float | None = None,
        hold: Sequence[str] = (),
        joint_terms: Sequence[str] = (),
        loss: str = "linear",
        holdout: float = 0.25,
    ) -> Fit:
        """Fit the arm to what was measured, and judge it on poses that were held out; see docs/calibration.md.

        Args:
            q: (N, n) joint vectors, rad or m.
            measured: Kind "pose": (N, 4, 4) in the base frame; "position": (N, 3), m; "distance": (N,) from one unknown
                fixed point, m; "plane": (N,) heights over one unknown plane, m, None for touching it.
            kind: What was measured.
            sigma: Noise (m, rad) of one number; estimated from what is left when not said.
            hold: Joints, "tool", or single numbers (`fit.parameters.names`) that stay nominal.
            joint_terms: Any of "gain", "coupling", "harmonic": what joints do beside their geometry.
            loss: "linear", or "huber" against outliers, which are named and left out.
            holdout: Part of the poses, evenly spread, that only judges.

        Raises:
            InputError: Too few or identical poses, or data in degrees, millimetres, another frame, with a joint's
                sense wrong or rows out of step: the message says which.
        """
        from pieper.calibration.calibrate import calibrate

        self.description.not_linked("it is calibrated axis by axis", _BY_AXES)
        return calibrate(
            self,
            q,
            measured,
            kind=kind,
            sigma=sigma,
            hold=hold,
            joint_terms=joint_terms,
            loss=loss,
            holdout=holdout,
            make=type(self),
        )

    def choose_poses(
        self, k: int, candidates: ArrayLike, *, kind: str = "pose", sigma: Sequence[float] | None = None
    ) -> Indices:
        """Choose k of joint vectors (N, n) whose measurements together say most about the arm; returns rows (k,)."""
        from pieper.calibration.choose import choose_poses

        self.description.not_linked("it is calibrated axis by axis", _BY_AXES)
        return choose_poses(self, k, candidates, kind=kind, sigma=sigma)

    def code(self, language: str, path: str | os.PathLike[str], name: str = "arm") -> Path:
        """Write the arm's solver in another language, to be used without pieper; see docs/code.md.

        Args:
            language: "c", "c++", "python" (NumPy alone), "matlab" (and Octave), "javascript", "jax" or "wasm".
            path: The file; written whole or not at all. A .mjs is a module, any other JavaScript a script; for wasm
                a .mjs holds the code within. MATLAB wants a file a function: a folder, or a .m they stand beside.
            name: What the functions begin with: NAME_ik, NAME_fk (ik, fk in Python and JavaScript).

        Raises:
            InputError: An unknown language, or a name that is no word.
            PlanError: The arm has no closed form that can be written down; the message says why.
        """
        from pieper.code.write import write

        return write(self, language, path, name)

    def reach_map(
        self,
        box: Sequence[Sequence[float]],
        step: float,
        orientations: Sequence[int] | ArrayLike = (128, 16),
        symmetry: str = "auto",
        store: str | os.PathLike[str] | None = None,
        executor: Executor | None = None,
        progress: Callable[[int, int], None] | None = None,
        measure: bool = False,
        scene: Scene | None = None,
        task: str | None = None,
    ) -> ReachMap:
        """Fill a box with answers: where the tool gets inside the limits, in which orientations; see docs/maps.md.

        Args:
            box: ((x0, x1), (y0, y1), (z0, z1)), m, base frame.
            step: Side of a voxel, m.
            orientations: (directions of the tool's z axis, rolls about it), or rotations (k, 3, 3).
            symmetry: "auto" uses that the first joint turns voxels into each other and the last one rolls the tool,
                where they do, limits kept, and says so; "none" solves all.
            store: A folder that keeps finished tiles: asked again, the same map goes on where it stopped.
            executor: Any `concurrent.futures` executor, dask.distributed's among them; all cores of this machine
                without one.
            progress: Told after each tile how many of how many are done.
            measure: Also keep manipulability, distance to limits, aspects and nearness to singular of each voxel.
            scene: What stands around the arm: only solutions count that touch neither it nor the arm itself; an empty
                scene for the arm alone. Without it collisions do not count.
            task: "pose", "position" or "position+axis". None: the arm's own, but where an arm of fewer than six joints
                is asked in sampled directions, which it cannot hold, what it can; `explain` says which.

        Raises:
            InputError: A box or step that is none or in millimetres, a store of another map, a map too large to hold.
        """
        from pieper.maps.reach_map import reach_map, task_of_samples

        around = None
        if scene is not None:
            from pieper.maps.around import Around

            around = Around(self.description, self.chain, self.bodies, self.collision_model(scene).scene)
        plan = task_of_samples(self.plan_for, task, orientations)
        return reach_map(plan, box, step, orientations, symmetry, store, executor, progress, measure, around)

    def aspects(self, q: ArrayLike | str) -> Aspects:
        """Return sign (...,) of the Jacobian's determinant and its smallest singular value, at joint vectors (..., n).

        Two postures of different sign have a singular one on every way between them; `.smallest` is 0 there.
        """
        from pieper.maps.aspects import aspects

        return aspects(self.plan, self._joints(q))

    def verify(self, toolbox: str, *, poses: int = 100, seed: int = 0) -> Comparison:
        """Compare the arm with what an independent toolbox makes of it; see docs/verify.md.

        Args:
            toolbox: "roboticstoolbox", "pinocchio" or "mujoco", each an extra of its name.
            poses: How many random postures; inverse solutions are compared at a quarter of them.
            seed: Of the random numbers.

        Raises:
            InputError: The toolbox is not known, not installed, or cannot read the arm.
        """
        from pieper.verify.comparison import compare

        return compare(self, toolbox, poses=poses, seed=seed)

    def base_places(self, Ts: PoseLike, x: ArrayLike, y: ArrayLike, z: ArrayLike, yaw: ArrayLike) -> Array:
        """Return the share (nx, ny, nz, nyaw) of poses Ts (N, 4, 4) reached from each base at x, y, z, m, yaw, rad.

        Poses are in the world; the base stands upright, and the arm's own base pose counts from there.
        """
        from pieper.maps.reach_map import base_places

        return base_places(self.plan, Ts, x, y, z, yaw)
