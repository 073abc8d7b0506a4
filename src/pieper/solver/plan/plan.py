"""Classify an arm once and decide how it is solved; everything per pose happens elsewhere."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from pieper.description.dh import Description
from pieper.errors import InputError, PlanError
from pieper.kinematics.armangle import ArmAngle, arm_angle
from pieper.kinematics.chain import Chain
from pieper.kinematics.forward import fk
from pieper.kinematics.geometry import Geometry, look, snapped
from pieper.kinematics.newton import pose_difference
from pieper.kinematics.pose import pose_error
from pieper.solver.families import choose, tier
from pieper.solver.families.family import KernelSpec
from pieper.solver.native import SixJointSolver, without_far_ends
from pieper.solver.plan.six_joints import (
    TASKS,
    Reduction,
    default_task,
    generic_rank,
    reduce,
    sample_joints,
    with_task_joints,
)
from pieper.tolerances import GEOMETRY_EXACT

if TYPE_CHECKING:
    from pieper.solver.plan.cuspidal import Cuspidal


@dataclass(frozen=True, eq=False)
class Plan:
    """How an arm is solved for one task.

    Attributes:
        name: The arm's name.
        chain: The arm as described.
        nominal: The chain that is solved; another one than `chain` only where geometry was snapped.
        geometry: Which axes are parallel or meet, with margins.
        limits: (n, 2), rad or m.
        names: Joint names.
        task: "pose", "position" or "position+axis".
        family: The family that solves the six-joint chain.
        max_solutions: The most solutions a pose can have (for a chosen redundancy value).
        reduction: How arm and task became six joints.
        spec: The prepared kernel.
        rank: How many things the arm can do at once for this task.
        snapped: What was moved to make the geometry special, in words; empty when nothing was.
        defaults: Values (k,) of the locked joints when nobody chooses, rad or m.
        base: (4, 4) the frame the arm's table stands in; the arm angle counts from it.
    """

    name: str
    chain: Chain
    nominal: Chain
    geometry: Geometry
    limits: np.ndarray
    names: tuple[str, ...]
    task: str
    family: str
    max_solutions: int
    reduction: Reduction
    spec: KernelSpec
    rank: int
    snapped: tuple[str, ...] = ()
    defaults: np.ndarray = field(default_factory=lambda: np.zeros(0))
    base: np.ndarray = field(default_factory=lambda: np.eye(4))

    @property
    def n(self) -> int:
        """Number of joints of the arm."""
        return self.chain.n

    @property
    def prismatic(self) -> np.ndarray:
        """(n,) bool."""
        return self.chain.prismatic

    @cached_property
    def redundancy(self) -> tuple[str, ...]:
        """Names of the redundant coordinates, in the order their values are given; empty where there is none."""
        return tuple(self._joint_name(j) for j in self.reduction.locked)

    @property
    def redundancy_limits(self) -> np.ndarray:
        """Limits (k, 2) of the redundant coordinates, rad or m; infinite for a task's own, which have none."""
        return self.full_limits[list(self.reduction.locked)]

    @property
    def choices(self) -> tuple[str, ...]:
        """Names that `redundancy` may be given for: the redundant coordinates, and the arm angle where there is one."""
        return (*self.redundancy, *(("arm angle",) if self.arm_angle else ()))

    def _joint_name(self, joint: int) -> str:
        if joint < self.n:
            return self.names[joint]
        if self.task == "position+axis":
            return "tool roll"
        return ("tool turn 1", "tool turn 2", "tool turn 3")[joint - self.n]

    @property
    def full_names(self) -> tuple[str, ...]:
        """Names of the arm's joints and of the task's virtual ones."""
        return tuple(self._joint_name(j) for j in range(self.reduction.full.n))

    @cached_property
    def full_limits(self) -> np.ndarray:
        """Limits of the arm's joints and of the task's virtual ones, which have none."""
        extra = self.reduction.full.n - self.n
        return np.vstack([self.limits, np.tile([-np.inf, np.inf], (extra, 1))])

    @property
    def direct(self) -> bool:
        """Whether the arm itself is the six-joint chain, exactly as described."""
        return self.reduction.trivial and self.nominal is self.chain

    @cached_property
    def immediate(self) -> bool:
        """Whether the native solver's rows are the answer but for locked columns: nothing filled, polished or cut."""
        reduction = self.reduction
        return not reduction.fill and not self.snapped and (reduction.trivial or reduction.at_ends is not None)

    @cached_property
    def exact(self) -> Reduction:
        """The reduction of the arm as described; another one than `reduction` only where geometry was snapped."""
        if self.nominal is self.chain:
            return self.reduction
        return replace(self.reduction, arm=self.chain, full=with_task_joints(self.chain, self.task))

    @cached_property
    def drift(self) -> float:
        """How far the nominal arm's pose is from the arm's own at the same joint vector, at most (per length; rad)."""
        if self.nominal is self.chain:
            return 0.0
        q = sample_joints(self.chain, 64)
        return float(np.linalg.norm(pose_difference(self.chain, q, fk(self.nominal, q)), axis=-1).max())

    @cached_property
    def solver(self) -> SixJointSolver:
        """The native solver of the six-joint chain (for locked joints at the ends or none)."""
        limits = self.full_limits[self.reduction.kept] if self.immediate else np.tile([-np.inf, np.inf], (6, 1))
        six, ends = without_far_ends(self.reduction.six(self.defaults))
        return SixJointSolver(six, self.spec, limits, ends)

    def residual(self, q: np.ndarray, T: np.ndarray) -> np.ndarray:
        """Return (..., 2): metres and radians by which q misses T, of what the task asks for."""
        now = fk(self.chain, q)
        error = pose_error(now, T)
        if self.task == "position":
            error[..., 1] = 0.0
        elif self.task == "position+axis":
            a, b = now[..., :3, 2], T[..., :3, 2]
            error[..., 1] = np.arctan2(np.linalg.norm(np.cross(a, b), axis=-1), np.sum(a * b, -1))
        return error

    @property
    def arm_angle(self) -> ArmAngle | None:
        """The arm angle, which may be chosen instead of the redundant joint; None where `no_arm_angle` says why not."""
        return self._arm_angle if isinstance(self._arm_angle, ArmAngle) else None

    @property
    def no_arm_angle(self) -> str:
        """Why the arm angle cannot be chosen, in words; empty where it can."""
        return self._arm_angle if isinstance(self._arm_angle, str) else ""

    @cached_property
    def _arm_angle(self) -> ArmAngle | str:
        if self.task != "pose" or len(self.redundancy) != 1:
            return "an arm angle needs a full pose and one joint to spare"
        return arm_angle(self.chain, self.base)

    @cached_property
    def cuspidal(self) -> Cuspidal | None:
        """Whether one can pass between solutions without meeting a singularity, with an example path.

        Searched for on first use, in a second or so; None for arms it does not apply to (spare joints, partial tasks).
        """
        from pieper.solver.plan.cuspidal import search

        return search(self) if self.direct else None

    def explain(self) -> str:
        """Tell how this arm is solved and why, as a teacher would."""
        from pieper.solver.words.why import explain

        return explain(self)

    def __repr__(self) -> str:
        return f"<Plan for {self.name}: {self.task} by {self.family}, at most {self.max_solutions} solutions>"


#: Ways to lock spare joints that are tried before an arm is refused.
MOST_WAYS = 24


def make_plan(chain: Chain, description: Description, *, task: str | None = None, snap: float | None = None) -> Plan:
    """Classify a chain and choose how it is solved.

    Args:
        chain: The arm.
        description: Its names and limits.
        task: "pose", "position", "position+axis", or None for the default of the arm.
        snap: Angles (rad) and distances (per characteristic length) below which axes are made parallel or meeting;
            None takes the table as exact.

    Raises:
        InputError: The task is unknown.
        PlanError: The arm cannot have the task, or no solver takes it; the message names the geometry found.
    """
    if task is not None and task not in TASKS:
        raise InputError(
            f"task {task!r} is unknown; allowed are {', '.join(map(repr, TASKS))}.", given=task, allowed=TASKS
        )
    if snap is not None and not 0 <= snap < 0.5:
        raise InputError(f"snap must be between 0 and 0.5 (rad, and per length of the arm), got {snap!r}.", given=snap)
    nominal, moved, _ = (chain, [], 0.0) if snap is None else snapped(chain, snap)
    tolerance = GEOMETRY_EXACT
    geometry = look(nominal, tolerance)
    if generic_rank(chain) == 0:
        raise PlanError(
            f"{description.name} cannot move its tool at all: no joint changes the pose.", geometry=geometry
        )
    wanted = default_task(nominal) if task is None else task
    full = with_task_joints(nominal, wanted)
    ways = reduce(nominal, wanted)
    if not ways:
        raise PlanError(f"{description.name}: no choice of locked joints leaves a solvable arm.", geometry=geometry)
    # the fastest family wins, then locks at the ends (which keep one plan for all values), then conditioning
    if len(ways) > 1:
        ways = _ranked(ways, description, tolerance)
    reduction, defaults, family, spec = _first_solvable(ways, description, tolerance)
    most = spec.max_solutions
    if wanted == "position" and reduction.full.n - len(reduction.locked) == 6 and not reduction.fill and chain.n <= 3:
        most //= 2  # the two turns of the virtual wrist are one position
    if moved:
        most = max(most, 16)  # what nearly is special need not be bounded as what is
    return Plan(
        name=description.name,
        chain=chain,
        nominal=nominal,
        geometry=geometry,
        limits=description.limits,
        names=description.joint_names,
        task=wanted,
        family=family,
        max_solutions=most,
        reduction=reduction,
        spec=spec,
        rank=full.n - len(reduction.locked),
        snapped=tuple(moved),
        defaults=defaults,
        base=description.base,
    )


def _first_solvable(ways: list[Reduction], description: Description, tolerance: float):
    """Return the first way that a solver takes, with the values of its locked joints, its family and kernel."""
    refused: PlanError | None = None
    for reduction in ways[:MOST_WAYS]:
        defaults = _defaults(reduction, description)
        six, _ = without_far_ends(reduction.six(defaults))
        try:
            family, spec = choose(six, look(six, tolerance))
        except PlanError as error:
            refused = refused or error
            continue
        return reduction, defaults, family, spec
    raise refused


def _ranked(ways: list[Reduction], description: Description, tolerance: float) -> list[Reduction]:
    scored = []
    for order, way in enumerate(ways[:MOST_WAYS]):
        values = np.full(len(way.locked), 0.3719)  # a generic value: zero often looks more special than the arm is
        six = way.six(values)
        real = sum(j < way.arm.n for j in way.locked)
        # an arm of fewer than six joints cannot keep a chosen orientation: its own joints are held, not the task's
        real = real if way.arm.n >= 6 else -real
        scored.append((real, tier(six, look(six, tolerance)), way.at_ends is None, order, way))
    scored.sort(key=lambda entry: entry[:4])
    return [entry[-1] for entry in scored]


def _defaults(reduction: Reduction, description: Description) -> np.ndarray:
    """Return the values locked joints have when nobody chooses: the middle of their limits, or zero."""
    values = []
    for joint in reduction.locked:
        lower, upper = description.limits[joint] if joint < reduction.arm.n else (-np.inf, np.inf)
        values.append(
            (lower + upper) / 2 if np.isfinite(lower) and np.isfinite(upper) else float(np.clip(0.0, lower, upper))
        )
    return np.array(values)
