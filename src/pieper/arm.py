"""Arm: what a user holds. Its methods delegate; there is no mathematics here."""

from __future__ import annotations

import os
from collections.abc import Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from pieper.description.dh import DH, Description, describe
from pieper.description.fold import chain_of
from pieper.kinematics import forward
from pieper.solver import verbs as solve
from pieper.solver.plan.plan import Plan, make_plan

if TYPE_CHECKING:
    from pieper.equations import Symbolic
    from pieper.motion.track import Track
    from pieper.solver.results import SolutionBatch, Solutions


class Arm:
    """A serial arm, made by `pieper.load` or `Arm.from_dh`.

    Args:
        description: What is known of the arm.
        snap: Distances (m, per metre of arm) and angles (rad) below which axes count as parallel or meeting; the
            default takes only exact tables. Give about 1e-2 for a maker's drawing; the plan says what it snapped.
    """

    def __init__(self, description: Description, *, snap: float | None = None) -> None:
        self.description = description
        self.chain = chain_of(description)
        self._snap = snap
        self._plans: dict[str, Plan] = {}

    @staticmethod
    def from_dh(
        rows: Sequence[DH],
        *,
        convention: str,
        joint_types: str | None = None,
        limits: Sequence | None = None,
        base: np.ndarray | None = None,
        tool: np.ndarray | None = None,
        name: str = "arm",
        joint_names: Sequence[str] | None = None,
        sign: Sequence[float] | None = None,
        offset: Sequence[float] | None = None,
        snap: float | None = None,
    ) -> Arm:
        """Make an arm of a DH table; see `description.dh.describe` for what each argument means.

        Raises:
            InputError: Something said is impossible; the message names the joint and what is allowed.
        """
        return Arm(
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
            ),
            snap=snap,
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
    def limits(self) -> np.ndarray:
        """(n, 2) lower and upper limits, rad or m; infinite where there is none."""
        return self.description.limits

    @property
    def base(self) -> np.ndarray:
        """(4, 4) pose of the DH table's first frame."""
        return self.description.base

    @property
    def tool(self) -> np.ndarray:
        """(4, 4) pose of the tool in the DH table's last frame."""
        return self.description.tool

    @property
    def postures(self) -> dict[str, np.ndarray]:
        """Named joint vectors (n,), rad or m."""
        return dict(self.description.postures)

    def fk(self, q: object) -> np.ndarray:
        """Return the tool poses (..., 4, 4) in the base frame of joint vectors q (..., n), rad or m.

        Raises:
            InputError: q has the wrong shape or is not finite.
        """
        return forward.fk(self.chain, q)

    def frames(self, q: object) -> np.ndarray:
        """Return the frames (..., n + 2, 4, 4) of q (..., n): base, the DH frame after each joint, tool."""
        return forward.frames(self.chain, q, self.description.base)

    def jacobian(self, q: object) -> np.ndarray:
        """Return the geometric Jacobians (..., 6, n) of q (..., n): tool point, base frame, linear rows first."""
        return forward.jacobian(self.chain, q)

    @property
    def plan(self) -> Plan:
        """How this arm is solved for its default task."""
        return self.plan_for(None)

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

    def ik(self, T: object, *, task: str | None = None, redundancy: object = None) -> Solutions:
        """Return every solution of a pose.

        Args:
            T: (4, 4), base to tool.
            task: "pose", "position" or "position+axis"; the plan states the default.
            redundancy: Value of the redundant coordinate of an arm that has one, rad or m; one a coordinate, in the
                order of `plan.redundancy`; or by name, such as `{"joint_1": 0.3}` or `{"arm angle": 0.3}`, one of
                `plan.choices`.

        Raises:
            InputError: T is not a pose, or the redundancy value is impossible.
        """
        return solve.ik(self.plan if task is None else self.plan_for(task), T, redundancy)

    def ik_many(
        self, Ts: object, *, threads: int | None = None, task: str | None = None, redundancy: object = None
    ) -> SolutionBatch:
        """Return every solution of N poses.

        Args:
            Ts: (N, 4, 4), base to tool.
            threads: Number of threads; None for all cores.
            task: As in `ik`.
            redundancy: As in `ik`, one value or one a pose.
        """
        return solve.ik_many(self.plan if task is None else self.plan_for(task), Ts, threads, redundancy)

    def closest(self, T: object) -> tuple[np.ndarray, float, float]:
        """Return the posture (n,) that comes closest to a pose, limits aside, and what is missing, m and rad.

        Position gives way before orientation. The search begins at random places: a nearer posture may exist.
        """
        from pieper.kinematics.pose import checked_pose
        from pieper.solver.words.closest import nearest_reachable

        q, metres, radians = nearest_reachable(self.plan.reduction.full, checked_pose(T))
        return q[: self.n], metres, radians

    def arm_angle(self, q: object) -> tuple[np.ndarray, np.ndarray]:
        """Return the arm angles (...), rad in (-pi, pi], of joint vectors q (..., 7), and whether each is defined.

        `ik(T, redundancy={"arm angle": value})` solves for one. An undefined angle is given as zero; where that is so
        and how the angle counts is told in docs/inverse.md.

        Raises:
            InputError: The arm has no arm angle; the message says why.
        """
        return solve.read_arm_angle(self.plan_for("pose"), q)

    def follow(self, path: object, *, start: object) -> Track:
        """Follow poses (N, 4, 4) from the joint vector start (n,); see `motion.track.follow`."""
        from pieper.motion.track import follow

        return follow(self, path, start=start)

    @cached_property
    def symbolic(self) -> Symbolic:
        """The arm's equations: `.fk()`, `.jacobian()`, `.singularities()`, `.ik()`."""
        from pieper.equations import Symbolic

        return Symbolic(self)

    def save(self, path: str | os.PathLike) -> None:
        """Write the arm as a robot file (.toml), whole or not at all; comments of an existing file are kept."""
        from pieper.description import robotfile

        robotfile.write(self.description, path)

    def __repr__(self) -> str:
        return f"<Arm {self.name}: {self.n} joints {self.joint_types}, {self.description.convention} DH>"


def load(source: str | os.PathLike, *, snap: float | None = None) -> Arm:
    """Load an arm: a catalogue name or a unique part of one, or a path to a robot file (.toml) or a .urdf.

    Raises:
        InputError: No such arm or file, or the file says something impossible.
    """
    from pieper.description import catalog as shelf
    from pieper.description import robotfile

    text = os.fspath(source)
    if text.endswith(".urdf"):
        from pieper.description import urdf

        return Arm(urdf.read(Path(text)), snap=snap)
    if text.endswith(".toml") or os.sep in text:
        return Arm(robotfile.read(Path(text)), snap=snap)
    return Arm(shelf.load(text), snap=snap)


def catalog() -> list[str]:
    """Return the names of the arms that ship."""
    from pieper.description import catalog as shelf

    return list(shelf.names())
