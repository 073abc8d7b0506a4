"""How an arm is solved for one task: what was decided once, and the native solvers that follow from it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from typing import Any

import numpy as np

from pieper.description.dh import Description
from pieper.errors import PlanError
from pieper.kinematics.arm_angle import ArmAngle, arm_angle
from pieper.kinematics.arrays import Array, Bools, Indices, median
from pieper.kinematics.chain import Chain
from pieper.kinematics.geometry import Geometry
from pieper.kinematics.newton import missed, scaled_jacobian, singular_values
from pieper.kinematics.pose import pose_error
from pieper.solver.families.family import KernelSpec
from pieper.solver.native import SixJointSolver, without_far_ends
from pieper.solver.plan.beside import arms_beside
from pieper.solver.plan.cuspidal import Cuspidal, never, search
from pieper.solver.plan.prepared import UNLIMITED, Prepared
from pieper.solver.plan.six_joints import Reduction, refilled, sample_joints, with_task_joints
from pieper.tolerances import RANK, RANK_ROUNDING
from pieper.words_by_number import plural

#: Most solvers kept for values of locked joints, of the arm that is solved and of a snapped arm as described.
MOST_SOLVERS, MOST_EXACT_SOLVERS = 512, 64
#: Most plans kept of the arm with its locked joints at values.
MOST_LOCKED = 64


@dataclass(frozen=True)
class Count:
    """How many solutions a pose can have, away from singularities, limits not applied.

    Attributes:
        kind: What the arm is, such as "a SCARA arm".
        most: The bound, for a chosen value of the spare joints where there are any.
        argument: Why there are no more, a clause.
    """

    kind: str
    most: int
    argument: str


def as_it_is(plan: Plan) -> Plan | None:
    """Return no special arm, where nobody handed in how to find one."""
    return None


def as_near(plan: Plan, distance: float) -> Plan:
    """Refuse to make another plan for poses far away, where nobody handed in how.

    Raises:
        PlanError: Always.
    """
    raise PlanError(f"{plan.name} has one plan for every distance.")


def uncounted(plan: Plan) -> Count:
    """Count the slots, where nobody handed in how to count."""
    return Count("an arm", plan.max_solutions, "the equation it is solved by has no more roots")


@dataclass(frozen=True, eq=False)
class Plan:
    """How an arm is solved for one task.

    Attributes:
        name: The arm's name.
        description: The arm's table, limits and names.
        chain: The arm as described.
        nominal: The chain that is solved; another one than `chain` only where geometry was snapped.
        geometry: Which axes are parallel or meet, with margins.
        limits: (n, 2), rad or m.
        names: Joint names.
        task: "pose", "position" or "position+axis".
        family: The family that solves the six-joint chain.
        max_solutions: Slots a pose has in a batch, the most that the six-joint problem can have; `count` is the arm's.
        reduction: How arm and task became six joints.
        spec: The prepared kernel.
        rank: How many things the arm can do at once for this task.
        snapped: What was moved to make the geometry special, in words; empty when nothing was.
        defaults: Values (k,) of the locked joints when nobody chooses, rad or m.
        base: (4, 4) the frame the arm's table stands in; the arm angle counts from it.
        words: Tells the plan as a teacher would; handed in, since words read plans.
        counting: Counts by the arm's own axes; handed in, since it reads plans.
        special: Plans through the special arm that this one nearly is, None where it is none; handed in as well.
        from_afar: How the arm is solved for poses so many metres away, its length counted as no less than that; raises
            PlanError where it is not. Handed in as well.
        uncoupled: Of coupled joints how the chain itself is solved, its joints free and without limits; else None.
        virtual_limits: (v, 2) limits of the task's virtual joints, rad; None where they have none.
    """

    name: str
    description: Description = field(repr=False)
    chain: Chain
    nominal: Chain
    geometry: Geometry
    limits: Array
    names: tuple[str, ...]
    task: str
    family: str
    max_solutions: int
    reduction: Reduction
    spec: KernelSpec
    rank: int
    snapped: tuple[str, ...] = ()
    defaults: Array = field(default_factory=lambda: np.zeros(0))
    base: Array = field(default_factory=lambda: np.eye(4))
    words: Callable[[Plan], str] = field(default=repr, repr=False)
    counting: Callable[[Plan], Count] = field(default=uncounted, repr=False)
    special: Callable[[Plan], Plan | None] = field(default=as_it_is, repr=False)
    from_afar: Callable[[Plan, float], Plan] = field(default=as_near, repr=False)
    uncoupled: Plan | None = field(default=None, repr=False)
    virtual_limits: Array | None = field(default=None, repr=False)

    def __getstate__(self) -> dict[str, Any]:
        """What pickle keeps: what was decided; solvers are prepared again."""
        return {entry.name: getattr(self, entry.name) for entry in fields(self)}

    @property
    def n(self) -> int:
        """Number of joints of the arm."""
        return self.chain.n

    @cached_property
    def count(self) -> Count:
        """What kind of arm it is and how many solutions a pose can have by what its own axes do, and why."""
        return self.counting(self)

    @cached_property
    def slides(self) -> bool:
        """Whether a joint of the arm slides."""
        return bool(self.prismatic.any())

    @property
    def prismatic(self) -> Bools:
        """(n,) bool."""
        return self.chain.prismatic

    @cached_property
    def redundancy(self) -> tuple[str, ...]:
        """Names of the redundant coordinates, in the order their values are given; empty where there is none."""
        return tuple(self._joint_name(j) for j in self.reduction.locked)

    @property
    def redundancy_limits(self) -> Array:
        """Limits (k, 2) of the redundant coordinates, rad or m; infinite for a task's own, which have none."""
        return self.full_limits[list(self.reduction.locked)]

    @property
    def choices(self) -> tuple[str, ...]:
        """Names that `redundancy` may be given for: joints that self-motions move, what the task leaves, the arm angle.

        The redundant coordinates, which are held when nobody chooses, come first.
        """
        if not self.redundancy:
            return ()
        others = (self._joint_name(joint) for joint in self.movable if joint not in self.reduction.locked)
        return (*self.redundancy, *others, *(("arm angle",) if self.arm_angle else ()))

    @cached_property
    def nearly_free(self) -> bool:
        """Whether what is to spare is so nearly alone: joints that do the same but for what an angle was typed with.

        A pose holds only some points of what would be a self-motion, and slices of it may meet none of them.
        """
        if not self.redundancy:
            return False
        full = self.exact.full
        # without base and tool, as a rank is taken
        s = singular_values(full.section(0, full.n - 1), sample_joints(full, 12))
        return bool(np.any((s > RANK_ROUNDING * s[:, :1]) & (s <= RANK * s[:, :1])))

    @cached_property
    def movable(self) -> tuple[int, ...]:
        """Joints (0-based, the task's virtual ones included) that self-motions move, each of which can be chosen."""
        full = self.reduction.full
        if not self.redundancy:
            return ()
        J = scaled_jacobian(full, sample_joints(full, 12))
        rest = np.array([[j for j in range(full.n) if j != joint] for joint in range(full.n)])
        s = np.linalg.svd(np.moveaxis(J[:, :, rest], 2, 0), compute_uv=False)  # joints, postures, singular values
        return tuple(np.flatnonzero(median(s[..., self.rank - 1] / s[..., 0]) > RANK).tolist())

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
    def full_limits(self) -> Array:
        """Limits of the arm's joints and of the task's virtual ones, which have none unless they were given some."""
        if self.virtual_limits is not None:
            return np.vstack([self.limits, self.virtual_limits])
        extra = self.reduction.full.n - self.n
        return np.vstack([self.limits, np.tile([-np.inf, np.inf], (extra, 1))])

    @cached_property
    def farthest(self) -> float:
        """How far the links reach from the first axis's frame laid end to end, m; slides as far as their limits."""
        full = self.exact.full
        slides = np.abs(np.where(full.prismatic[:, None], self.full_limits, 0.0)).max(1).sum()
        return float(np.linalg.norm(full.links[1:, :3, 3], axis=1).sum() + slides)

    @cached_property
    def nearly(self) -> Plan | None:
        """How the special arm is solved that this one nearly is, rows refined on this one; None where it is none."""
        return self.special(self)

    @cached_property
    def direct(self) -> bool:
        """Whether the arm itself is the six-joint chain, exactly as described."""
        return self.reduction.trivial and self.nominal is self.chain and self.uncoupled is None

    @cached_property
    def whole(self) -> bool:
        """Whether the six joints are the arm's and its task's own, as described: none is held, filled up or coupled."""
        own = not (self.reduction.locked or self.reduction.fill)
        return own and self.nominal is self.chain and self.uncoupled is None

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
        return float(missed(self.chain, q, self.nominal.native.fk(q)).max())

    @cached_property
    def solver(self) -> SixJointSolver:
        """The native solver of the six-joint chain (for locked joints at the ends or none)."""
        limits = self.full_limits[self.reduction.kept] if self.immediate else UNLIMITED
        six, ends = without_far_ends(self.reduction.six(self.defaults))
        return SixJointSolver(six, self.spec, limits, ends)

    @cached_property
    def _refillings(self) -> tuple[tuple[Prepared, Indices], ...]:
        return tuple((Prepared(way.six, MOST_SOLVERS), way.real) for way in refilled(self.reduction))

    def refilled_at(self, values: Array) -> Iterator[tuple[SixJointSolver, Indices]]:
        """Yield solvers of other fillings, locked joints at values (k,), and which of the six joints are real."""
        for prepared, real in self._refillings:
            try:
                yield prepared.at(tuple(values.tolist())), real
            except PlanError:
                continue

    @cached_property
    def refilled(self) -> tuple[tuple[SixJointSolver, Indices], ...]:
        """The same where no joint is locked, for poses at which the first filling is singular; none elsewhere."""
        return () if self.reduction.locked else tuple(self.refilled_at(np.zeros(0)))

    @cached_property
    def arms_beside(self) -> tuple[SixJointSolver, ...]:
        """Solvers of arms a little off this one, where every elimination of its own vanishes; none elsewhere."""
        vanish = self.whole and not self.spec.info.get("certified", True)
        return arms_beside(self.reduction.full) if vanish else ()

    @cached_property
    def solvers(self) -> Prepared:
        """The native solvers with locked joints at values, made once a value."""
        return Prepared(self.reduction.six, MOST_SOLVERS)

    @cached_property
    def exact_solvers(self) -> Prepared:
        """The same of the arm as described, where geometry was snapped."""
        return Prepared(self.exact.six, MOST_EXACT_SOLVERS)

    @cached_property
    def held(self) -> dict[tuple[int, ...], Plan | PlanError]:
        """What `holding` made of this plan, by the joints that are held."""
        return {}

    @cached_property
    def seen_from(self) -> dict[float, Plan | PlanError]:
        """What `from_afar` made of this plan, by the power of ten of the distance, m."""
        return {}

    @cached_property
    def locked(self) -> dict[tuple[tuple[int, float], ...], Plan | PlanError]:
        """What `locked_at` made of this plan, by the joints that are held and their values."""
        return {}

    def residual(self, q: Array, T: Array) -> Array:
        """Return (..., 2): metres and radians by which q misses T, of what the task asks for."""
        now = self.chain.native.fk(q)
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
        if not self.direct:
            return None
        if self.family == "spherical_wrist_parallel":
            return never(self.n)
        return search(self.chain, lambda poses: self.solver.many(poses, 1)[:2])

    def explain(self) -> str:
        """Tell how this arm is solved and why, as a teacher would."""
        return self.words(self)

    def __repr__(self) -> str:
        return f"<Plan for {self.name}: {self.task} by {self.family}, at most {plural(self.count.most, 'solution')}>"
