"""A description folded into a chain: what is said about an arm becomes what the mathematics needs."""

from __future__ import annotations

import numpy as np

from pieper.description.dh import Description
from pieper.kinematics.chain import Chain
from pieper.kinematics.geometry import near_feet
from pieper.kinematics.pose import FLIP, rotation_x, rotation_z, translation


def chain_of(description: Description) -> Chain:
    """Return the chain of an arm: base, tool, table, the makers' zeros and senses folded into constant links."""
    n = description.n
    prismatic = np.array([t == "P" for t in description.joint_types])
    links = np.empty((n + 1, 4, 4))
    frames_after = np.empty((n, 4, 4))
    pending = description.base.copy()
    for i, row in enumerate(description.rows):
        constant = description.offset[i]
        if prismatic[i]:
            before, after = rotation_z(row.theta), translation(z=row.d + constant)
        else:
            before, after = rotation_z(row.theta + constant), translation(z=row.d)
        x_part = rotation_x(row.alpha)
        x_part[0, 3] = row.a
        if description.convention == "standard":
            after = after @ x_part
        else:
            pending = pending @ x_part
        # a reversed sense is the same motion about the axis turned over: Z(-q) = F Z(q) F
        if description.sign[i] < 0:
            before, after = before @ FLIP, FLIP @ after
        links[i] = pending @ before
        frames_after[i] = after
        pending = after
    links[n] = pending @ description.tool
    links, frames_after = near_feet(links, frames_after)
    return Chain.of(links, prismatic, frames_after, description.coupling)
