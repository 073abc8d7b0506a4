"""The units a command speaks: degrees and millimetres unless one says otherwise."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

import pieper

LENGTHS = {"mm": 0.001, "m": 1.0}
ANGLES = {"deg": math.pi / 180, "rad": 1.0}


class Units:
    """The units a command speaks.

    Args:
        length: "mm" or "m".
        angle: "deg" or "rad".
    """

    def __init__(self, length: str = "mm", angle: str = "deg") -> None:
        self.length, self.angle = length, angle
        self.metres, self.radians = LENGTHS[length], ANGLES[angle]

    @property
    def said(self) -> str:
        """Both in one word or two."""
        return f"{self.length} {self.angle}"

    def of_joints(self, arm: pieper.Arm) -> npt.NDArray[np.float64]:
        """Return the SI value (n,) of one unit of each joint."""
        return np.array([self.radians if kind == "R" else self.metres for kind in arm.joint_types])

    def names_of_joints(self, arm: pieper.Arm) -> list[str]:
        """Return the unit of each joint."""
        return [self.angle if kind == "R" else self.length for kind in arm.joint_types]

    def said_of_joints(self, arm: pieper.Arm) -> str:
        """Return the units of the joints in words: one for all of them, or one each."""
        names = self.names_of_joints(arm)
        return names[0] if len(set(names)) == 1 else ", ".join(names)
