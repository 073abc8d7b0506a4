"""An arm's table as constant placements between joints, row by row, without the chain that pieper solves."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, sin

import numpy as np

from pieper.description.dh import Description
from pieper.kinematics.arrays import Array


@dataclass(frozen=True)
class Placements:
    """A chain as any toolbox takes it: body i sits at `before[i]` in body i - 1 and moves about or along its own z.

    Attributes:
        before: (n, 4, 4) constant poses, the base's pose in the first.
        tool: (4, 4) pose of the tool in the last body.
        sense: (n,) +1 or -1: about +z or -z.
        slides: (n,) whether a joint slides.
    """

    before: Array
    tool: Array
    sense: Array
    slides: Array


def placements(arm: Description) -> Placements:
    """Return the placements of an arm.

    Standard (distal) rows are Rz(theta) Tz(d) Tx(a) Rx(alpha), modified (proximal) ones Rx(alpha) Tx(a) Rz(theta)
    Tz(d). The joint's own turn and slide are about one axis, so its constant parts may stand after it.
    """
    before, pending = [], np.array(arm.base, float)
    for i, row in enumerate(arm.rows):
        slides = arm.axis_types[i] == "P"
        theta = row.theta + (0.0 if slides else arm.offset[i])
        d = row.d + (arm.offset[i] if slides else 0.0)
        about, across = _screw_z(float(theta), float(d)), _screw_x(row.alpha, row.a)
        if arm.convention == "standard":
            before.append(pending)
            pending = about @ across
        else:
            before.append(pending @ across)
            pending = about
    kinds = np.array([kind == "P" for kind in arm.axis_types])
    return Placements(np.array(before), pending @ arm.tool, np.array(arm.sign, float), kinds)


def _screw_z(angle: float, along: float) -> Array:
    c, s = cos(angle), sin(angle)
    return np.array([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, along], [0, 0, 0, 1]])


def _screw_x(angle: float, along: float) -> Array:
    c, s = cos(angle), sin(angle)
    return np.array([[1, 0, 0, along], [0, c, -s, 0], [0, s, c, 0], [0, 0, 0, 1]])
