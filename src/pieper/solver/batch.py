"""What an inverse-kinematics call of many poses returns: every solution of each, as plain data, and each by itself."""

from __future__ import annotations

import operator
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TypeAlias, overload

import numpy as np

from pieper import arguments
from pieper.document.columns import Column, Tabular, Units
from pieper.errors import InputError
from pieper.kinematics.arrays import Array, Bits, Bools, Indices, Slots
from pieper.kinematics.pose import reason_against
from pieper.solver.plan.plan import Plan
from pieper.solver.results import Status
from pieper.solver.rows import Chosen, Refused, Rows
from pieper.solver.solution import batch_columns
from pieper.solver.words.labels import posture_words
from pieper.words_by_number import plural

#: Which poses of a batch: a slice, their numbers, or which of all.
Some: TypeAlias = slice | Sequence[int] | Indices | Bools


@dataclass(frozen=True, eq=False, repr=False, slots=True)
class PoseSolutions:
    """What a batch says of one of its poses: a sequence of the rows inside the limits. Its arrays are copies.

    Attributes:
        pose: The pose's index in the batch it was taken from.
        plan: How the arm was solved.
        all_q: (k, n) solutions before limits are applied, rad or m.
        slots: (k,) the branch of the plan each row of all_q belongs to.
        in_limits: (k,) bool: which rows of all_q lie inside the limits.
        flag: Bits of `pieper.solver.rows.Flag`.
        status: How the pose came out.
        reason: Why it is no pose where the status is INVALID; else empty.
        nearest: (n,) the row chosen near what `near=` gave; None where there is none, or nothing was given.
    """

    pose: int
    plan: Plan
    all_q: Array
    slots: Slots
    in_limits: Bools
    flag: int
    status: Status
    reason: str = ""
    nearest: Array | None = None

    @property
    def q(self) -> Array:
        """Solutions (m, n) inside the limits, in the order of all_q."""
        return self.all_q[self.in_limits]

    @property
    def labels(self) -> list[str]:
        """Posture label of each row of q."""
        return posture_words(self.plan, self.q)

    @property
    def all_labels(self) -> list[str]:
        """Posture label of each row of all_q."""
        return posture_words(self.plan, self.all_q)

    def __len__(self) -> int:
        return len(self.q)

    @overload
    def __getitem__(self, index: int) -> Array: ...
    @overload
    def __getitem__(self, index: slice) -> list[Array]: ...
    def __getitem__(self, index: int | slice) -> Array | list[Array]:
        """One row of q (n,), or several."""
        return list(self.q[index]) if isinstance(index, slice) else self.q[operator.index(index)]

    def __iter__(self) -> Iterator[Array]:
        return iter(self.q)

    def __repr__(self) -> str:
        count = f"{len(self)} inside the limits of {len(self.all_q)}"
        return f"<PoseSolutions at index {self.pose}: {count}, {self.status.name}>"


@dataclass(frozen=True, eq=False, repr=False, slots=True)
class SolutionBatch(Tabular):
    """Every solution of N poses, in the order of the plan's branches; a sequence of what there is of each.

    Attributes:
        plan: How the arm was solved.
        found: The solutions, as below.
        status: (N,) Status codes.
        chosen: The row of each pose near what `near=` gave; None where nothing was given.
        refused: What of the batch was no pose; None where everything was.
    """

    plan: Plan
    found: Rows
    status: Bits
    chosen: Chosen | None = None
    refused: Refused | None = None

    @property
    def q(self) -> Array:
        """(N, max_solutions, n), rad or m; zeros where not valid."""
        return self.found.q

    @property
    def valid(self) -> Bools:
        """(N, max_solutions) true solutions, limits not applied."""
        return self.found.valid

    @property
    def in_limits(self) -> Bools:
        """(N, max_solutions) those inside the limits."""
        return self.found.inside

    @property
    def flag(self) -> Bits:
        """(N,) bits of `pieper.solver.rows.Flag`."""
        return self.found.flags

    def __len__(self) -> int:
        return len(self.q)

    @overload
    def __getitem__(self, at: int) -> PoseSolutions: ...
    @overload
    def __getitem__(self, at: Some) -> SolutionBatch: ...
    def __getitem__(self, at: int | Some) -> PoseSolutions | SolutionBatch:
        """What there is of one pose, counted from the end where negative; or a batch of several of them.

        Args:
            at: A number; a slice, whose answers share this batch's arrays; numbers, or a bool a pose, which are copied.

        Raises:
            InputError: Neither of these.
            IndexError: There is no such pose.
        """
        if isinstance(at, slice):
            return self.part(at)
        if isinstance(at, (list, tuple, np.ndarray)) and np.ndim(at) == 1:
            return self.part(self._numbers(np.asarray(at)))
        try:
            given = operator.index(at)  # pyright: ignore[reportArgumentType]  # what is none is refused
        except TypeError:
            raise _no_index(at) from None
        if not -len(self) <= given < len(self):
            count = f"indices go from 0 to {len(self) - 1}" if len(self) else "there is none"
            raise IndexError(f"index {given} of {plural(len(self), 'pose')}; {count}.")
        k = given % len(self)
        all_q, slots, inside, flag = self.found.of(k)
        chosen = None if self.chosen is None or not self.chosen.found[k] else self.chosen.q[k].copy()
        status = Status(int(self.status[k]))
        reason = self.reasons.get(k, "") if status == Status.INVALID else ""
        return PoseSolutions(k, self.plan, all_q, slots, inside, flag, status, reason, chosen)

    def __iter__(self) -> Iterator[PoseSolutions]:
        return (self[k] for k in range(len(self)))

    def _numbers(self, at: Indices | Bools) -> Indices:
        """Return the poses' numbers, of numbers from the end too, or of a bool a pose."""
        if at.dtype == np.bool_ and at.shape == (len(self),):
            return np.flatnonzero(at)
        if not at.size:
            return np.zeros(0, np.int64)
        if at.dtype.kind not in "iu":
            raise _no_index(at)
        if at.min() < -len(self) or at.max() >= len(self):
            raise IndexError(
                f"indices {at.min()} to {at.max()} of {plural(len(self), 'pose')}; they go from 0 to {len(self) - 1}."
            )
        return np.asarray(at % len(self), np.int64)

    def part(self, at: slice | Indices) -> SolutionBatch:
        """Return the answers to some of the poses; those of a slice share this batch's arrays."""
        chosen = None if self.chosen is None else self.chosen.part(at)
        refused = None if self.refused is None else self.refused.part(np.arange(len(self))[at])
        return SolutionBatch(self.plan, self.found.part(at), self.status[at], chosen, refused)

    @property
    def count(self) -> Indices:
        """(N,) number of true solutions of each pose."""
        return self.valid.sum(1)

    def rows(self) -> tuple[Indices, Array]:
        """Return the valid rows one after the other: the index of each one's pose (M,), the rows (M, n), rad or m."""
        return np.nonzero(self.valid)[0], self.q[self.valid]

    @property
    def nearest(self) -> Array:
        """(N, n) the row inside the limits nearest to what `near=` gave, whole turns resolved; see `has_nearest`.

        A pose without one has zeros or, where each is near the one before (`near="previous"`), the joint vector before.
        """
        return self._near().q

    @property
    def has_nearest(self) -> Bools:
        """(N,) whether a pose has a row inside the limits, which `nearest` then says."""
        return self._near().found

    def _near(self) -> Chosen:
        if self.chosen is None:
            raise InputError('nothing was chosen: say near=, one joint vector, one a pose or "previous", in ik_many.')
        return self.chosen

    @property
    def reasons(self) -> dict[int, str]:
        """Why each pose whose status is INVALID is none, by its index; empty where all are poses."""
        if self.refused is None:
            return {}
        given = zip(self.refused.index, self.refused.poses, self.refused.told, strict=True)
        return {
            int(index): f"Ts[{index}] {told}" if told else reason_against(pose, f"Ts[{index}]")
            for index, pose, told in given
        }

    def columns(self, *, degrees: bool = False, mm: bool = False) -> dict[str, Column]:
        """Return the valid rows as columns; a pose without one has a row of its own, NaN.

        As in every table, the columns `pose` and `solution` count from 1; `rows` gives the indices.
        """
        words = [Status(int(code)).name for code in self.status]
        return batch_columns(self.plan, self.q, self.valid, self.in_limits, words, Units(degrees, mm))

    def __repr__(self) -> str:
        counts = {s.name: int(c) for s in Status if (c := np.count_nonzero(self.status == s))}
        return f"<SolutionBatch of {plural(len(self), 'pose')}: {counts}>"


def _no_index(at: object) -> InputError:
    return InputError(
        f"a batch is asked for one pose by its number, or for some by a slice, numbers or a bool a pose; got "
        f"{arguments.kind_of(at)}.",
        given=at,
    )
