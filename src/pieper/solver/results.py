"""What an inverse-kinematics call of one pose returns: every solution, as plain data; how a pose came out."""

from __future__ import annotations

import operator
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import TYPE_CHECKING, overload

import numpy as np

from pieper.description.posture import posture
from pieper.document.columns import Column, Tabular, Units
from pieper.errors import NoSolutionError
from pieper.kinematics.arrays import Array, ArrayLike, Bools, Indices, Slots
from pieper.kinematics.forward import checked_joint_vector, checked_weights
from pieper.kinematics.joints import inside
from pieper.solver.marked import Marked
from pieper.solver.plan.plan import Plan
from pieper.solver.rows import Flag
from pieper.solver.solution import Closest, Solution, solution_columns
from pieper.tolerances import CLOSED_VERIFIED
from pieper.words_by_number import plural

if TYPE_CHECKING:
    from pieper.solver.singular.examined import Examined
    from pieper.solver.singular.self_motion import SelfMotion

# plain numbers: an IntFlag takes a microsecond to be combined with one
_UNCERTAIN, _ROUNDED = int(Flag.UNCERTAIN), int(Flag.ROUNDED)


class Status(IntEnum):
    """How a pose came out."""

    SOLVED = 0
    SINGULAR = 1
    REDUNDANT = 2
    OUT_OF_REACH = 3
    OUTSIDE_LIMITS = 4
    UNCERTAIN = 5
    INVALID = 6  # of batches alone: what was given is no pose


@dataclass(frozen=True, slots=True)
class Words:
    """Who puts results into words; handed in, since words read results.

    Args:
        why: One sentence, with a number, on how a pose came out.
        table: The solutions inside the limits as lines of text.
        labels: One posture label a row of q (m, n).
        beside: Labels of the branches that meet in q (n,) along a direction (n,).
        closest: The posture that comes nearest to the pose.
    """

    why: Callable[[Plan, Solutions], str]
    table: Callable[[Plan, Solutions], str]
    labels: Callable[[Plan, Array], list[str]]
    beside: Callable[[Plan, Array, Array], tuple[str, ...]]
    closest: Callable[[Plan, Solutions], Closest]


class Solutions(Marked, Tabular, Sequence[Solution]):
    """Every solution of one pose: a sequence of those inside the limits.

    Attributes:
        T: The pose (4, 4) that was solved.
        all_q: (k, n) solutions before limits are applied; revolute joints in (-pi, pi], or a whole turn away where
            only that lies inside the limits. Rows keep the order of the plan's branches, which is stable.
        slots: (k,) the branch of the plan each row of all_q belongs to.
        in_limits: (k,) bool: which rows of all_q lie inside the limits.
        flag: Bits of `Flag`.
        named: Names of the spare coordinates that were chosen where others were left open; else none.
    """

    __slots__ = (
        "T",
        "_closest",
        "_found",
        "_plan",
        "_q",
        "_self_motions",
        "_why",
        "_words",
        "all_q",
        "flag",
        "in_limits",
        "named",
        "slots",
    )

    def __init__(
        self,
        plan: Plan,
        words: Words,
        T: Array,
        all_q: Array,
        slots: Slots,
        in_limits: Bools,
        flag: int,
        found: Examined | None = None,
        self_motions: tuple[SelfMotion, ...] | Callable[[], tuple[SelfMotion, ...]] = (),
        named: tuple[str, ...] = (),
    ) -> None:
        self._plan = plan
        self._words = words
        self.T = T  # pyright: ignore[reportConstantRedefinition]  # a pose, not a constant
        self.all_q = all_q
        self.slots = slots
        self.in_limits = in_limits
        self.flag = flag
        self._found = found
        self._self_motions = self_motions
        self.named = named
        self._q: Array | None = None
        self._why: str | None = None
        self._closest: Closest | None = None
        self._apart = None

    def told_by(self, plan: Plan) -> Solutions:
        """Return the same as another plan of the arm tells it."""
        rows = self.all_q, self.slots, self.in_limits, self.flag
        return Solutions(plan, self._words, self.T, *rows, self._found, self._self_motions, self.named)

    @property
    def q(self) -> Array:
        """Solutions (m, n) inside the limits, in the order of all_q."""
        if self._q is None:
            inside = self.in_limits
            self._q = self.all_q if inside.all() else self.all_q[inside]
        return self._q

    def __len__(self) -> int:
        return len(self.q)

    @overload
    def __getitem__(self, index: int) -> Solution: ...
    @overload
    def __getitem__(self, index: slice) -> list[Solution]: ...
    def __getitem__(self, index: int | slice) -> Solution | list[Solution]:
        """One solution inside the limits, or several; the rows of q."""
        if isinstance(index, slice):
            return [self[i] for i in range(len(self))[index]]
        try:
            q = self.q[operator.index(index)]
        except IndexError:
            raise IndexError(
                f"index {index} of {plural(len(self), 'solution')} inside the limits; indices begin at 0."
            ) from None
        return Solution(q, self._words.labels(self._plan, q[None])[0], self._plan.residual(q[None], self.T)[0])

    def table(self) -> str:
        """Return the solutions inside the limits as lines of text: joints in deg or mm, label, residual; then why."""
        return self._words.table(self._plan, self)

    def __str__(self) -> str:
        return self.table()

    @property
    def self_motions(self) -> tuple[SelfMotion, ...]:
        """Continuous sets of solutions of this pose; those of a redundant arm are traced when first asked for."""
        if callable(self._self_motions):
            self._self_motions = self._self_motions()
        for motion in self._self_motions:
            motion.told(self._plan.description)
        return self._self_motions

    @property
    def in_self_motion(self) -> Indices:
        """(m,) index into self_motions of the one a row of q represents, or -1 for an isolated solution."""
        if self._found is None:
            return np.full(len(self.q), -1)
        return self._found.self_motion[self.in_limits]

    @property
    def multiplicity(self) -> Indices:
        """(m,) how many branches merge in a row of q: 1, or 2 at a double root, seldom more."""
        return np.ones(len(self.q), np.int64) if self._found is None else self._found.multiplicity[self.in_limits]

    @property
    def direction(self) -> Array:
        """(m, n) unit null direction of the Jacobian (slides per length of the arm) of rows of q on a singularity.

        The self-motion, or the line along which branches merge; zeros for the other rows.
        """
        return np.zeros((len(self.q), self._plan.n)) if self._found is None else self._found.direction[self.in_limits]

    @property
    def merged_labels(self) -> list[tuple[str, ...]]:
        """The posture labels of the branches that merge in each row of q; empty for a row where none do."""
        rows = zip(self.q, self.direction, self.multiplicity, strict=True)
        return [self._words.beside(self._plan, q, way) if count > 1 else () for q, way, count in rows]

    @property
    def status(self) -> Status:
        """How this pose came out; see Status."""
        if self.flag & _UNCERTAIN:
            return Status.UNCERTAIN
        if len(self.q) == 0:
            if len(self.all_q) == 0 and not self.self_motions:
                return Status.OUT_OF_REACH
            # of a redundant arm this is said of the value of the spare coordinate that was chosen
            if (self._plan.redundancy and len(self.all_q)) or not any(motion.inside for motion in self.self_motions):
                return Status.OUTSIDE_LIMITS
        if self._plan.redundancy:
            return Status.REDUNDANT
        return Status.SINGULAR if self.self_motions else Status.SOLVED

    @property
    def why(self) -> str:
        """One sentence, with a number, on how this pose came out; worked out when first asked for."""
        if self._why is None:
            self._why = self._words.why(self._plan, self)
        return self._why

    @property
    def closest(self) -> Closest:
        """The posture inside the limits that comes nearest, position first; a solution where there is one.

        Worked out when first asked for, by descent from many postures: a nearer one is unlikely, but not excluded.
        """
        if self._closest is None:
            self._closest = self._words.closest(self._plan, self)
        return self._closest

    @property
    def labels(self) -> list[str]:
        """Posture label of each row of q."""
        return self._words.labels(self._plan, self.q)

    @property
    def all_labels(self) -> list[str]:
        """Posture label of each row of all_q."""
        return self._words.labels(self._plan, self.all_q)

    @property
    def residual(self) -> Array:
        """(m, 2): how far forward kinematics misses the pose, m and rad; only what the task asks for counts."""
        return self._plan.residual(self.q, self.T)

    @property
    def rounded(self) -> bool:
        """Whether the pose's rotation was replaced by the nearest one (a pose rounded to float32, for one)."""
        return bool(self.flag & _ROUNDED)

    def windings(self) -> Array:
        """Every whole-turn variant (w, n) of q inside the limits; an unlimited joint keeps its one value."""
        joints, limits = self._plan.chain.joints.first(self._plan.n), self._plan.limits
        return np.concatenate([np.empty((0, self._plan.n)), *(joints.variants(row, limits) for row in self.q)])

    def nearest(self, q_now: ArrayLike | str, weights: ArrayLike | None = None) -> Array:
        """Return the solution (n,) closest to q_now, whole turns resolved inside the limits, self-motions included.

        The distance is Euclidean in radians, prismatic joints divided by the arm's characteristic length.

        Args:
            q_now: (n,) rad or m, or a posture's name.
            weights: (n,) how much the square of each joint's difference counts, none negative; all the same if None.

        Raises:
            InputError: A wrong length or weight.
            NoSolutionError: No solution lies inside the limits; the message says why.
        """
        joints, now = self._plan.chain.joints, self._here(q_now)
        counts = checked_weights(weights, self._plan.n)
        candidates = list(joints.unwound(self.q, now, self._plan.limits))
        candidates += [point for motion in self.self_motions if (point := motion.nearest(now, counts)) is not None]
        if (self.self_motions or self._plan.redundancy) and self._is_solution(now):
            candidates.append(now)  # what holds the pose is nearest to itself, whatever a search has met
        if not candidates:
            raise NoSolutionError(f"there is no solution to be near to: {self.why}", status=self.status)
        rows = np.array(candidates)
        return rows[np.argmin(joints.straight(rows, now, counts))]

    def _here(self, q_now: ArrayLike | str) -> Array:
        """Return where the arm is, (n,): a joint vector, or a posture's name."""
        q = posture(self._plan.description, q_now, "q_now") if isinstance(q_now, str) else q_now
        return checked_joint_vector(q, self._plan.n, "q_now", self._plan.prismatic)

    def _is_solution(self, q: Array) -> bool:
        """Return whether a joint vector (n,) lies inside the limits and takes the pose."""
        most = CLOSED_VERIFIED * np.array([self._plan.chain.length, 1.0])
        return bool(inside(q, self._plan.limits).all() and (self._plan.residual(q[None], self.T)[0] <= most).all())

    def nearest_row(self, q_now: ArrayLike | str) -> tuple[int, Array]:
        """Return which row of q is closest to q_now, and that row (n,) with whole turns resolved inside the limits.

        Raises:
            NoSolutionError: No solution lies inside the limits; the message says why.
        """
        joints, now = self._plan.chain.joints, self._here(q_now)
        if not len(self.q):
            raise NoSolutionError(f"there is no solution to be near to: {self.why}", status=self.status)
        rows = joints.unwound(self.q, now, self._plan.limits)
        row = int(np.argmin(joints.straight(rows, now)))
        return row, rows[row]

    def columns(self, *, degrees: bool = False, mm: bool = False) -> dict[str, Column]:
        """Return the rows of all_q as columns: joints, label, residual, whether inside the limits."""
        residual, units = self._plan.residual(self.all_q, self.T), Units(degrees, mm)
        return solution_columns(self._plan, self.all_q, self.all_labels, residual, self.in_limits, units)

    def __repr__(self) -> str:
        # what has not been traced stays so: printing an object never solves anything
        traced = (
            not callable(self._self_motions) or self._found is not None or len(self.q) > 0 or self.flag & _UNCERTAIN
        )
        status = self.status.name if traced else "status not worked out yet"
        return f"<Solutions: {len(self)} inside the limits of {len(self.all_q)}, {status}>"
