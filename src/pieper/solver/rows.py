"""What a kernel returns for a batch of poses: rows of joint vectors, which of them count, and what was remarked."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntFlag

from pieper.kinematics.arrays import Array, Bits, Bools


class Flag(IntFlag):
    """What is remarked about a pose, one bit each."""

    #: Roots merge or equations vanish here: the pose deserves the careful look.
    DEGENERATE = 1
    #: The certificate that nothing is missing failed.
    UNCERTAIN = 2
    #: No posture brings the tool so far.
    OUT_OF_REACH = 4
    #: The rotation was replaced by the nearest one.
    ROUNDED = 8
    #: Beside UNCERTAIN: the arm angle is undefined at this pose.
    NO_ARM_ANGLE = 16
    #: Beside UNCERTAIN: the number of solutions of a snapped arm changes here.
    COUNT_CHANGES = 32
    #: Solved at an arm angle, not at a value of the redundant joint.
    AT_ARM_ANGLE = 64


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

    def of(self, index: int) -> tuple[Array, Bools, Bools, int]:
        """Return one pose's valid rows (m, n), their slots (m,), whether they are inside (m,), and its flags."""
        valid = self.valid[index]
        return self.q[index][valid], valid.nonzero()[0], self.inside[index][valid], int(self.flags[index])
