"""What an inverse-kinematics call returns: every solution of a pose, verified, labelled, with the reason when none."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from enum import IntEnum
from typing import TYPE_CHECKING

import numpy as np

from pieper.errors import NoSolutionError
from pieper.kinematics.forward import checked_joints, fk
from pieper.kinematics.pose import pose_error
from pieper.tolerances import LIMIT_SLACK

if TYPE_CHECKING:
    from pieper.solver.plan.plan import Plan
    from pieper.solver.singular.selfmotion import Family

TURN = 2 * np.pi

#: Flag bits that the kernels set for a pose.
DEGENERATE, UNCERTAIN, OUT_OF_REACH_FLAG, ROUNDED = 1, 2, 4, 8
#: Flag bits that are set beside UNCERTAIN and say why: no arm angle at this pose; a snapped arm's count changes here.
NO_ARM_ANGLE, COUNT_CHANGES = 16, 32
#: Flag bit that says what was chosen: the arm angle, not the redundant joint.
AT_ARM_ANGLE = 64


class Status(IntEnum):
    """How a pose came out."""

    SOLVED = 0
    SINGULAR = 1
    REDUNDANT = 2
    OUT_OF_REACH = 3
    OUTSIDE_LIMITS = 4
    UNCERTAIN = 5


class Solutions:
    """Every solution of one pose.

    Attributes:
        T: The pose (4, 4) that was solved.
        all_q: (k, n) solutions before limits are applied; revolute joints in (-pi, pi], or a whole turn away where
            only that lies inside the limits. Rows keep the order of the plan's branches, which is stable.
        q: (m, n) those inside the limits, same order.
        in_family: (m,) index of the family a row of q represents, or -1 for an isolated solution.
        multiplicity: (m,) how many branches merge in a row of q: 1, or 2 at a double root, seldom more.
        direction: (m, n) unit null direction of the Jacobian (prismatic joints per length of the arm) of a row on a
            singularity: the self-motion, or the line along which branches merge; zeros for the other rows.
    """

    __slots__ = (
        "_all_direction",
        "_all_family",
        "_all_multiplicity",
        "_families",
        "_flag",
        "_inside",
        "_plan",
        "_q",
        "all_q",
        "slots",
        "T",
    )

    def __init__(
        self,
        plan: Plan,
        T: np.ndarray,
        all_q: np.ndarray,
        slots: np.ndarray,
        inside: np.ndarray,
        flag: int,
        families: tuple[Family, ...] | Callable[[], tuple[Family, ...]] = (),
        all_family: np.ndarray | None = None,
        all_multiplicity: np.ndarray | None = None,
        all_direction: np.ndarray | None = None,
    ) -> None:
        self._plan = plan
        self.T = T
        self.all_q = all_q
        self.slots = slots
        self._inside = inside
        self._flag = flag
        self._q = None
        self._families = families
        self._all_family = all_family
        self._all_multiplicity = all_multiplicity
        self._all_direction = all_direction

    @property
    def q(self) -> np.ndarray:
        """Solutions (m, n) inside the limits."""
        if self._q is None:
            inside = self._inside
            self._q = self.all_q if inside.all() else self.all_q[inside]
        return self._q

    def __len__(self) -> int:
        return len(self.q)

    def __iter__(self):
        return iter(self.q)

    @property
    def families(self) -> tuple[Family, ...]:
        """Continuous families through this pose; those of a redundant arm are traced when first asked for."""
        if callable(self._families):
            self._families = self._families()
        return self._families

    @property
    def in_limits(self) -> np.ndarray:
        """(k,) bool: which rows of all_q lie inside the limits."""
        return self._inside

    @property
    def in_family(self) -> np.ndarray:
        """(m,) index into families of each row of q, or -1."""
        return self._per_row(self._all_family, -1)

    @property
    def multiplicity(self) -> np.ndarray:
        """(m,) number of branches that merge in each row of q."""
        return self._per_row(self._all_multiplicity, 1)

    @property
    def direction(self) -> np.ndarray:
        """(m, n) null direction of each row of q on a singularity; zeros for the others."""
        return self._per_row(self._all_direction, np.zeros(self._plan.n))

    @property
    def merged_labels(self) -> list[tuple[str, ...]]:
        """The posture labels of the branches that merge in each row of q; empty for a row where none do."""
        from pieper.solver.words.labels import labels_beside

        rows = zip(self.q, self.direction, self.multiplicity, strict=True)
        return [labels_beside(self._plan, q, way) if count > 1 else () for q, way, count in rows]

    def _per_row(self, values: np.ndarray | None, default: object) -> np.ndarray:
        if values is None:
            return np.full((len(self.q), *np.shape(default)), default)
        return values[self._inside]

    @property
    def status(self) -> Status:
        """How this pose came out; see Status."""
        if self._flag & UNCERTAIN:
            return Status.UNCERTAIN
        if len(self.q) == 0:
            if len(self.all_q) == 0 and not self.families:
                return Status.OUT_OF_REACH
            # of a redundant arm this is said of the value of the spare coordinate that was chosen
            if (self._plan.redundancy and len(self.all_q)) or not any(family.inside for family in self.families):
                return Status.OUTSIDE_LIMITS
        if self._plan.redundancy:
            return Status.REDUNDANT
        if self.families:
            return Status.SINGULAR
        return Status.SOLVED

    @property
    def why(self) -> str:
        """One sentence, with a number, on how this pose came out."""
        from pieper.solver.words.why import why

        return why(self._plan, self)

    @property
    def labels(self) -> list[str]:
        """Posture label of each row of q."""
        from pieper.solver.words.labels import posture_words

        return posture_words(self._plan, self.q)

    @property
    def all_labels(self) -> list[str]:
        """Posture label of each row of all_q."""
        from pieper.solver.words.labels import posture_words

        return posture_words(self._plan, self.all_q)

    @property
    def residual(self) -> np.ndarray:
        """(m, 2): how far forward kinematics misses the pose, m and rad; only what the task asks for counts."""
        return self._plan.residual(self.q, self.T)

    @property
    def rounded(self) -> bool:
        """Whether the pose's rotation was replaced by the nearest one (a pose rounded to float32, for one)."""
        return bool(self._flag & ROUNDED)

    def windings(self) -> np.ndarray:
        """Every whole-turn variant (w, n) of q inside the limits; an unlimited joint keeps its one value."""
        rows = []
        limits, revolute = self._plan.limits, ~self._plan.prismatic
        for row in self.q:
            choices = []
            for value, (lower, upper), turns in zip(row, limits, revolute, strict=True):
                if not turns or not (np.isfinite(lower) and np.isfinite(upper)):
                    choices.append([value])
                    continue
                first = int(np.ceil((lower - LIMIT_SLACK - value) / TURN))
                last = int(np.floor((upper + LIMIT_SLACK - value) / TURN))
                choices.append([value + TURN * k for k in range(first, last + 1)])
            rows.extend(itertools.product(*choices))
        return np.array(rows).reshape(-1, self._plan.n)

    def nearest(self, q_now: object) -> np.ndarray:
        """Return the solution (n,) closest to q_now, whole turns resolved inside the limits, families included.

        The distance is Euclidean in radians, prismatic joints divided by the arm's characteristic length.

        Args:
            q_now: (n,) rad or m.

        Raises:
            NoSolutionError: No solution lies inside the limits; the message says why.
        """
        q_now = checked_joints(q_now, self._plan.n, "q_now")
        candidates = [unwound(row, q_now, self._plan.limits, self._plan.prismatic) for row in self.q]
        candidates += [point for family in self.families if (point := family.nearest(q_now)) is not None]
        if not candidates:
            raise NoSolutionError(f"there is no solution to be near to: {self.why}", status=self.status)
        rows = np.array(candidates)
        return rows[np.argmin(joint_distance(rows, q_now, self._plan.prismatic, self._plan.chain.length))]

    def nearest_row(self, q_now: object) -> tuple[int, np.ndarray]:
        """Return which row of q is closest to q_now, and that row (n,) with whole turns resolved inside the limits.

        Raises:
            NoSolutionError: No solution lies inside the limits; the message says why.
        """
        q_now = checked_joints(q_now, self._plan.n, "q_now")
        if not len(self.q):
            raise NoSolutionError(f"there is no solution to be near to: {self.why}", status=self.status)
        rows = unwound(self.q, q_now, self._plan.limits, self._plan.prismatic)
        row = int(np.argmin(joint_distance(rows, q_now, self._plan.prismatic, self._plan.chain.length)))
        return row, rows[row]

    def __repr__(self) -> str:
        return f"<Solutions: {len(self)} inside the limits of {len(self.all_q)}, {self.status.name}: {self.why}>"


class SolutionBatch:
    """Every solution of N poses, in the order of the plan's branches.

    Attributes:
        q: (N, max_solutions, n), rad or m; zeros where not valid.
        valid: (N, max_solutions) bool, true solutions, limits not applied.
        in_limits: (N, max_solutions) bool, those inside the limits.
        status: (N,) Status codes.
        flag: (N,) bits: 1 degenerate, 2 uncertain, 4 out of reach, 8 rotation rounded, 16 the arm angle is undefined,
            32 the number of solutions of a snapped arm changes near the pose, 64 solved at an arm angle.
    """

    __slots__ = ("_plan", "flag", "in_limits", "q", "status", "valid")

    def __init__(
        self, plan: Plan, q: np.ndarray, valid: np.ndarray, in_limits: np.ndarray, status: np.ndarray, flag: np.ndarray
    ):
        self._plan = plan
        self.q, self.valid, self.in_limits, self.status, self.flag = q, valid, in_limits, status, flag

    def __len__(self) -> int:
        return len(self.q)

    @property
    def count(self) -> np.ndarray:
        """(N,) number of true solutions of each pose."""
        return self.valid.sum(1)

    def nearest(self, q_now: object) -> tuple[np.ndarray, np.ndarray]:
        """Return for each pose the solution inside the limits closest to q_now, whole turns resolved.

        Args:
            q_now: (n,) or (N, n), rad or m.

        Returns:
            (N, n) joint vectors, zeros where there is none, and (N,) bool that says where there is one.
        """
        q_now = np.broadcast_to(checked_joints(q_now, self._plan.n, "q_now"), (len(self.q), self._plan.n))
        wound = unwound(self.q, q_now[:, None], self._plan.limits, self._plan.prismatic)
        distance = joint_distance(wound, q_now[:, None], self._plan.prismatic, self._plan.chain.length)
        best = np.argmin(np.where(self.in_limits, distance, np.inf), axis=1)
        found = self.in_limits.any(1)
        chosen = np.take_along_axis(wound, best[:, None, None], axis=1)[:, 0]
        return np.where(found[:, None], chosen, 0.0), found

    def nearest_in_turn(self, q_start: object) -> tuple[np.ndarray, np.ndarray]:
        """Return for each pose the solution closest to the one chosen for the pose before it, whole turns resolved.

        This is the papers' rule; it can jump from branch to branch without a word. `Arm.follow` does not.

        Args:
            q_start: (n,) where to begin, rad or m.

        Returns:
            (N, n) joint vectors and (N,) bool; a pose without a solution keeps the joint vector before it.
        """
        now = checked_joints(q_start, self._plan.n, "q_start")
        limits, prismatic, length = self._plan.limits, self._plan.prismatic, self._plan.chain.length
        chosen, found = np.empty((len(self.q), self._plan.n)), self.in_limits.any(1)
        for i in range(len(self.q)):
            if found[i]:
                rows = unwound(self.q[i][self.in_limits[i]], now, limits, prismatic)
                now = rows[np.argmin(joint_distance(rows, now, prismatic, length))]
            chosen[i] = now
        return chosen, found

    def __repr__(self) -> str:
        counts = {s.name: int(c) for s in Status if (c := np.count_nonzero(self.status == s))}
        return f"<SolutionBatch of {len(self)} poses: {counts}>"


def unwound(q: np.ndarray, near: np.ndarray, limits: np.ndarray, prismatic: np.ndarray) -> np.ndarray:
    """Return q (..., n) with each revolute joint moved by whole turns as near to `near` as its limits allow."""
    turns = np.round((near - q) / TURN)
    lowest = np.ceil((limits[:, 0] - LIMIT_SLACK - q) / TURN)
    highest = np.floor((limits[:, 1] + LIMIT_SLACK - q) / TURN)
    possible = lowest <= highest
    turns = np.where(possible, np.clip(turns, lowest, np.maximum(lowest, highest)), turns)
    return np.where(prismatic, q, q + TURN * turns)


def inside_limits(q: np.ndarray, limits: np.ndarray, prismatic: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return q (..., n), a whole turn added where only that lies inside, and whether all joints are inside (...)."""
    moved = unwound(q, q, limits, prismatic)
    ok = (moved >= limits[:, 0] - LIMIT_SLACK) & (moved <= limits[:, 1] + LIMIT_SLACK)
    return np.where(ok, moved, q), ok.all(-1)


def joint_distance(q: np.ndarray, near: np.ndarray, prismatic: np.ndarray, length: float) -> np.ndarray:
    """Return Euclidean joint distances (...), prismatic joints divided by the characteristic length."""
    difference = np.where(prismatic, (q - near) / length, q - near)
    return np.sqrt(np.sum(difference * difference, axis=-1))


def pose_residual(chain, q: np.ndarray, T: np.ndarray) -> np.ndarray:
    """Return (..., 2) metres and radians by which forward kinematics of q misses T."""
    return pose_error(fk(chain, q), T)
