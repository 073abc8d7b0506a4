"""What a kernel returns for a batch of poses: rows of joint vectors, which of them count, and what was remarked."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper._kernel import Flag
from pieper.kinematics.arrays import Array, Bits, Bools, Indices, Slots

__all__ = ["Chosen", "Flag", "Refused", "Rows", "any_row"]


@dataclass(frozen=True, eq=False, slots=True)
class Rows:
    """Solutions of N poses.

    Args:
        q: (N, M, n), rad or m; zeros where not valid.
        valid: (N, M) which are solutions, limits not applied.
        inside: (N, M) which of them lie inside the limits.
        flags: (N,) bits of `Flag`.
    """

    q: Array
    valid: Bools
    inside: Bools
    flags: Bits

    def of(self, index: int) -> tuple[Array, Slots, Bools, int]:
        """Return one pose's valid rows (m, n), their slots (m,), whether they are inside (m,), and its flags."""
        valid = self.valid[index]
        return self.q[index][valid], valid.nonzero()[0], self.inside[index][valid], int(self.flags[index])

    def part(self, at: slice | Indices) -> Rows:
        """Return the rows of some of the poses; those of a slice can be written to here too."""
        return Rows(self.q[at], self.valid[at], self.inside[at], self.flags[at])

    def put(self, at: Indices, part: Rows) -> None:
        """Write the rows of some of the poses."""
        self.q[at], self.valid[at], self.inside[at], self.flags[at] = part.q, part.valid, part.inside, part.flags

    def put_one(self, at: int, q: Array, inside: Bools, flag: int) -> None:
        """Write what one pose has: its rows (m, n) that have a slot, and whether they are inside (m,)."""
        k = min(len(q), self.q.shape[1])
        self.q[at], self.valid[at], self.inside[at], self.flags[at] = 0.0, False, False, flag
        self.q[at, :k], self.valid[at, :k], self.inside[at, :k] = q[:k], True, inside[:k]


@dataclass(frozen=True, eq=False, slots=True)
class Chosen:
    """A row a pose, chosen near a joint vector.

    Args:
        q: (N, n), rad or m; finite everywhere.
        found: (N,) whether there is a row inside the limits to be chosen.
    """

    q: Array
    found: Bools

    def part(self, at: slice | Indices) -> Chosen:
        """Return those of some of the poses; those of a slice can be written to here too."""
        return Chosen(self.q[at], self.found[at])


@dataclass(frozen=True, eq=False, slots=True)
class Refused:
    """What of a batch was no pose.

    Args:
        index: (k,) which of the batch.
        poses: (k, 4, 4) what was given; not finite where that was no matrix of numbers.
        told: (k) what is to be said of what was no matrix; empty of a matrix, which says it itself.
    """

    index: Indices
    poses: Array
    told: tuple[str, ...]

    def part(self, of: Indices) -> Refused:
        """Return what was refused of some of the poses, given by their numbers."""
        at = np.flatnonzero(np.isin(of, self.index))
        there: list[int] = np.searchsorted(self.index, of[at]).tolist()
        return Refused(at, self.poses[there], tuple(self.told[k] for k in there))


def any_row(rows: Bools) -> Bools:
    """Return rows.any(1) of bools (N, M), eight at a time where that is possible: this runs once a pose."""
    if rows.shape[1] != 8 or not rows.flags.c_contiguous:
        return np.logical_or.reduce(rows, axis=1)
    return rows.view(np.uint64)[:, 0] != 0
