"""Arm: what a user holds. Its methods delegate; there is no mathematics here."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from functools import cached_property, partial
from typing import TYPE_CHECKING
from weakref import WeakKeyDictionary

import numpy as np

from pieper import arguments
from pieper.along_paths import AlongPaths
from pieper.description import change
from pieper.description.dh import DH, Description
from pieper.description.fold import chain_of
from pieper.description.posture import posture
from pieper.description.said import describe, remark_sizes
from pieper.kinematics import forward
from pieper.kinematics.arrays import Array, ArrayLike, Bools
from pieper.kinematics.meant import remark_far_away
from pieper.kinematics.pose import PoseLike, as_pose, checked_pose
from pieper.solver import verbs
from pieper.solver.batch import SolutionBatch
from pieper.solver.batches import PREVIOUS, Progress
from pieper.solver.plan.classify import make_plan
from pieper.solver.plan.plan import Plan
from pieper.solver.redundant.choice import Redundancy, read_arm_angle
from pieper.solver.results import Closest, Solutions, Status
from pieper.words_by_number import plural

if TYPE_CHECKING:
    from pieper.collision.scene import Scene
    from pieper.equations import Symbolic
    from pieper.motion.dialects.configuration import Configuration
    from pieper.motion.track import Track


class Arm(AlongPaths):
    """A serial arm, made by `pieper.load` or `Arm.from_dh`.

    Args:
        description: What is known of the arm.
        snap: Distances (m, per metre of arm) and angles (rad) below which axes count as parallel or meeting; the
            default takes only exact tables. Give about 1e-2 for a maker's drawing; the plan says what it snapped.
    """

    def __init__(self, description: Description, *, snap: float | None = None) -> None:
        if snap is not None:
            arguments.number(snap, "snap", "rad, and per length of the arm", least=0.0, below=0.5)
        self.description = description
        self.chain = chain_of(description)
        self._snap = snap
        self._plans: dict[str, Plan] = {}
        self._models = WeakKeyDictionary()

    @staticmethod
    def from_dh(
        rows: Sequence[DH],
        *,
        convention: str,
        joint_types: str | None = None,
        limits: Sequence[Sequence[float | None] | None] | ArrayLike | None = None,
        base: PoseLike | None = None,
        tool: PoseLike | None = None,
        name: str = "arm",
        joint_names: Sequence[str] | None = None,
        sign: ArrayLike | None = None,
        offset: ArrayLike | None = None,
        coupling: ArrayLike | None = None,
        snap: float | None = None,
    ) -> Arm:
        """Make an arm of a DH table; see `description.said.describe` for what each argument means.

        Raises:
            InputError: Something said is impossible; the message names the joint and what is allowed.
        """
        arm = Arm(
            describe(
                rows,
                convention=convention,
                joint_types=joint_types,
                limits=limits,
                base=base,
                tool=tool,
                name=name,
                joint_names=joint_names,
                sign=sign,
                offset=offset,
                coupling=coupling,
            ),
            snap=snap,
        )
        remark_sizes(arm.description, arm.chain)
        return arm

    @staticmethod
    def from_axes(
        axes: ArrayLike,
        points: ArrayLike,
        home: PoseLike,
        *,
        joint_types: str | None = None,
        limits: Sequence[Sequence[float | None] | None] | ArrayLike | None = None,
        name: str = "arm",
        joint_names: Sequence[str] | None = None,
        snap: float | None = None,
    ) -> Arm:
        """Make an arm of joint axes (n, 3), points on them (n, 3), m, and the tool's pose (4, 4), all joints at zero.

        Raises:
            InputError: Something said is impossible; see `description.axes.from_axes`.
        """
        from pieper.description.axes import from_axes

        said = from_axes(axes, points, home, joint_types=joint_types, limits=limits, name=name, joint_names=joint_names)
        arm = Arm(said, snap=snap)
        remark_sizes(said, arm.chain)
        return arm

    @staticmethod
    def from_opw(
        *,
        a1: float,
        a2: float,
        b: float,
        c1: float,
        c2: float,
        c3: float,
        c4: float,
        offsets: Sequence[float] = (0.0,) * 6,
        signs: Sequence[float] = (1.0,) * 6,
        limits: Sequence[Sequence[float | None] | None] | ArrayLike | None = None,
        name: str = "arm",
    ) -> Arm:
        """Make an arm of its OPW parameters (m, rad); see `description.opw.from_opw` for what each means."""
        from pieper.description.opw import from_opw

        return Arm(
            from_opw(
                a1=a1, a2=a2, b=b, c1=c1, c2=c2, c3=c3, c4=c4, offsets=offsets, signs=signs, limits=limits, name=name
            )
        )

    @property
    def n(self) -> int:
        """Number of joints."""
        return self.description.n

    @property
    def name(self) -> str:
        """The arm's name."""
        return self.description.name

    @property
    def joint_names(self) -> tuple[str, ...]:
        """One name a joint."""
        return self.description.joint_names

    @property
    def joint_types(self) -> str:
        """One letter a joint: R revolute, P prismatic."""
        return self.description.joint_types

    @property
    def limits(self) -> Array:
        """(n, 2) lower and upper limits, rad or m; infinite where there is none."""
        return self.description.limits

    @property
    def coupling(self) -> Array:
        """(n, n): values of the chain's joints = coupling @ joint values; the identity where no joint is coupled."""
        return np.eye(self.n) if self.description.coupling is None else self.description.coupling

    @property
    def notes(self) -> tuple[str, ...]:
        """What was read differently from the file the arm came from, one sentence each; empty if nothing."""
        return self.description.remarks

    @property
    def postures(self) -> dict[str, Array]:
        """Named joint vectors (n,), "zero" among them; wherever a joint vector goes, such a name does."""
        return {"zero": np.zeros(self.n)} | {name: np.array(q) for name, q in self.description.postures.items()}

    @property
    def base(self) -> Array:
        """(4, 4) pose of the DH table's first frame."""
        return self.description.base

    @property
    def tool(self) -> Array:
        """(4, 4) pose of the tool in the DH table's last frame."""
        return self.description.tool

    def fk(self, q: ArrayLike | str) -> Array:
        """Return the tool poses (..., 4, 4) in the base frame of joint vectors q (..., n), rad or m, or of a posture.

        Raises:
            InputError: q has the wrong shape or is not finite, or the arm has no such posture.
        """
        return forward.fk(self.chain, self._joints(q))

    def frames(self, q: ArrayLike | str) -> Array:
        """Return the frames (..., n + 2, 4, 4) of q (..., n): base, the DH frame after each joint, tool."""
        return forward.frames(self.chain, self._joints(q), self.description.base)

    def jacobian(self, q: ArrayLike | str) -> Array:
        """Return the geometric Jacobians (..., 6, n) of q (..., n): tool point, base frame, linear rows first."""
        return forward.jacobian(self.chain, self._joints(q))

    def _joints(self, q: ArrayLike | str, what: str = "q") -> ArrayLike:
        """Return the joint vector of a posture that is said by its name, anything else unchanged."""
        return posture(self.description, q, what) if isinstance(q, str) else q

    def with_tool(self, tool: PoseLike | str) -> Arm:
        """Return the arm with another tool: a pose in the table's last frame, or the name of one of its tools."""
        return Arm(change.with_tool(self.description, tool), snap=self._snap)

    def with_base(self, base: PoseLike) -> Arm:
        """Return the arm whose DH table begins at another pose."""
        return Arm(change.with_base(self.description, base), snap=self._snap)

    def with_limits(self, limits: Mapping[str, Sequence[float | None] | None]) -> Arm:
        """Return the arm with other limits: joint name -> (lower, upper), rad or m, None for none."""
        return Arm(change.with_limits(self.description, limits), snap=self._snap)

    def with_joints_locked(self, values: Mapping[str, float]) -> Arm:
        """Return the arm with some joints held: joint name -> value, rad or m. The others keep their numbers."""
        return Arm(change.with_joints_locked(self.description, values), snap=self._snap)

    def to(self, convention: str) -> Arm:
        """Return the same arm with its table in the "standard" or "modified" DH convention."""
        return Arm(change.to_convention(self.description, convention), snap=self._snap)

    def uncoupled(self) -> Arm:
        """Return the arm by its axes' own values v = arm.coupling @ q, without the limits of coupled joints."""
        return Arm(change.uncoupled(self.description), snap=self._snap)

    def reversed(self) -> Arm:
        """Return the arm seen from its tool, joints last to first: its pose is the inverse of this one's."""
        return Arm(change.reversed_arm(self.description), snap=self._snap)

    @property
    def plan(self) -> Plan:
        """How this arm is solved for its default task."""
        return self._plans.get("default") or self.plan_for(None)

    def plan_for(self, task: str | None) -> Plan:
        """Return how this arm is solved for a task: "pose", "position", "position+axis", or None for its default.

        Raises:
            InputError: The task is unknown.
            PlanError: The arm cannot have the task, or is beyond the solver; the message names the geometry found.
        """
        key = "default" if task is None else str(task)
        if key not in self._plans:
            self._plans[key] = make_plan(self.chain, self.description, task=task, snap=self._snap)
        return self._plans[key]

    def ik(
        self, T: PoseLike, *, task: str | None = None, redundancy: Redundancy = None, scene: Scene | None = None
    ) -> Solutions:
        """Return every solution of a pose.

        Args:
            T: (4, 4), base to tool.
            task: "pose", "position" or "position+axis"; the plan states the default.
            redundancy: Value of the redundant coordinate of an arm that has one, rad or m; one a coordinate, in the
                order of `plan.redundancy`; or by name, such as `{"joint_3": 0.3}` or `{"arm angle": 0.3}`, of
                `plan.choices`, as many as the arm has to spare.
            scene: What stands around the arm: `clearance` and `clear` of the answer say which rows touch nothing.

        Raises:
            InputError: T is not a pose, or the redundancy value is impossible.
        """
        sols = verbs.ik(self.plan if task is None else self.plan_for(task), T, redundancy)
        if not len(sols.all_q):
            self._remark_far_away(sols.T[None], np.ones(1, bool))
        if scene is not None:
            sols.keep_clear(partial(self.distance, scene=scene))
        return sols

    def _remark_far_away(self, T: Array, nowhere: Bools) -> None:
        """Warn where poses (N, 4, 4) without a solution are so far away that millimetres were probably meant."""
        base, reach = self.extent
        remark_far_away(T[:, :3, 3], nowhere, np.array(base), reach, self.name)

    def ik_many(
        self,
        Ts: PoseLike,
        threads: int | None = None,
        near: ArrayLike | str | None = None,
        start: ArrayLike | str | None = None,
        weights: ArrayLike | None = None,
        invalid: str = "raise",
        out: SolutionBatch | None = None,
        *,
        task: str | None = None,
        redundancy: Redundancy = None,
        progress: Progress | None = None,
    ) -> SolutionBatch:
        """Return every solution of N poses and, where `near` says near what, one chosen row of each.

        Args:
            Ts: (N, 4, 4), base to tool.
            threads: Number of threads; None for all cores.
            near: Choose the row inside the limits nearest to a joint vector (n,), to one a pose (N, n), whole turns
                resolved; or "previous", nearest to the one chosen for the pose before. See `SolutionBatch.nearest`.
            start: Where "previous" begins, (n,); None to begin with the first row inside the limits.
            weights: (n,) what the squared differences of the joints count in the distance; None for one each. Sliding
                joints are measured in the arm's characteristic length.
            invalid: "raise" when one of Ts is no pose, or "mark" it with Status.INVALID (`SolutionBatch.reasons`).
            out: An earlier answer of this arm to as many poses: its arrays are written over and handed back, which
                saves the pages of new ones.
            task: As in `ik`.
            redundancy: As in `ik`, one value or one a pose.
            progress: Called now and then with how many poses are done and how many there are.

        Raises:
            InputError: Something given is impossible; the message says what, what is allowed and how to cure it.
        """
        found = verbs.ik_many(
            self.plan if task is None else self.plan_for(task),
            Ts,
            threads,
            redundancy,
            near=posture(self.description, near, "near", (PREVIOUS,))
            if isinstance(near, str) and near != PREVIOUS
            else near,
            start=self._where(start, "start"),
            weights=weights,
            invalid=invalid,
            out=out,
            progress=progress,
        )
        nowhere = found.status == Status.OUT_OF_REACH
        if nowhere.any():
            self._remark_far_away(np.asarray(as_pose(Ts), np.float64), nowhere)
        return found

    def _where(self, q: ArrayLike | str | None, what: str) -> ArrayLike | None:
        return None if q is None else self._joints(q, what)

    def closest(self, T: PoseLike, *, task: str | None = None, weights: ArrayLike | None = None) -> Closest:
        """Return the posture inside the limits that comes nearest to a pose: its q, metres, radians and T.

        Args:
            T: (4, 4), base to tool.
            task: As in `ik`; only what it asks for counts.
            weights: (2,) what a metre and a radian count, times what is missed of each, squared and added up; None for
                position first, and then orientation.
        """
        from pieper.solver.words.closest import closest

        return closest(self.plan if task is None else self.plan_for(task), checked_pose(T), weights=weights)

    def arm_angle(self, q: ArrayLike | str) -> tuple[Array, Bools]:
        """Return the arm angles (...), rad in (-pi, pi], of joint vectors q (..., 7), and whether each is defined.

        `ik(T, redundancy={"arm angle": value})` solves for one. An undefined angle is given as zero; where that is so
        and how the angle counts is told in docs/inverse.md.

        Raises:
            InputError: The arm has no arm angle; the message says why.
        """
        return read_arm_angle(self.plan_for("pose"), self._joints(q))

    def follow(self, path: PoseLike, *, start: ArrayLike | str | None = None) -> Track:
        """Follow poses (N, 4, 4) from the joint vector start (n,); see `motion.follow`."""
        from pieper.motion.follow import follow

        return follow(self.plan, path, start=None if start is None else self._joints(start, "start"))

    def configuration(self, q: ArrayLike | str, maker: str) -> Configuration:
        """Return a posture in a maker's configuration words; see `motion.dialects.configuration`."""
        from pieper.motion.dialects.configuration import configuration

        return configuration(self.plan, self._joints(q), maker, self.description.manufacturer)

    @property
    def symbolic(self) -> Symbolic:
        """The arm's equations: `.fk()`, `.jacobian()`, `.singularities()`, `.ik()`."""
        return self._symbolic

    @cached_property
    def _symbolic(self) -> Symbolic:
        from pieper.equations import Symbolic

        return Symbolic(self)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the arm as a robot file (.toml; comments of an existing one are kept) or .urdf, whole or not at all."""
        from pieper.description import source

        source.write(self.description, path)

    def __repr__(self) -> str:
        return f"<Arm {self.name}: {plural(self.n, 'joint')} {self.joint_types}, {self.description.convention} DH>"
