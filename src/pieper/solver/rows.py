"""What a kernel returns for a batch of poses: rows of joint vectors, which of them count, and what was remarked."""

from __future__ import annotations

from dataclasses import dataclass

from pieper._kernel import Flag
from pieper.kinematics.arrays import Array, Bits, Bools, Slots

__all__ = ["Flag", "Rows"]


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
