"""Twenty arms whose formulas are right; tests plant slips into them."""

from __future__ import annotations

from .arm import PlantedArm
from .short_arms import CRAIG3, CYLINDER, ELBOW, FIVE, GANTRY, OFFSET, POLAR, RPR, RR, RRR, SCARA, SKEW, WRIST, WRIST4
from .six_joints import DENSO, KUKA, PUMA, STANFORD, UR, YASKAWA

__all__ = ["ARMS", "PlantedArm"]

ARMS: tuple[PlantedArm, ...] = (
    RR, RRR, SCARA, ELBOW, OFFSET, POLAR, CYLINDER, GANTRY, WRIST4, PUMA,
    DENSO, STANFORD, UR, KUKA, FIVE, RPR, CRAIG3, YASKAWA, WRIST, SKEW,
)  # fmt: skip
