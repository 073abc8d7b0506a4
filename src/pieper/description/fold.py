"""A description folded into a chain: what is said about an arm becomes what the mathematics needs."""

from __future__ import annotations

import numpy as np

from pieper.description.dh import Description, Slid
from pieper.kinematics.arrays import Array
from pieper.kinematics.chain import Chain
from pieper.kinematics.pose import FLIP, inverse, rotation_x, rotation_z, translation
from pieper.tolerances import QUARTER_EXACT

#: Links that come out this many times shorter are taken; others stay as the table has them, to the last bit.
FAR_LONGER = 10.0


def chain_of(description: Description) -> Chain:
    """Return the chain of an arm: base, tool, table, the makers' zeros and senses folded into constant links."""
    n = len(description.rows)
    prismatic = np.array([t == "P" for t in description.axis_types])
    links = np.empty((n + 1, 4, 4))
    frames_after = np.empty((n, 4, 4))
    pending = description.base.copy()
    for i, row in enumerate(description.rows):
        constant = description.offset[i]
        if prismatic[i]:
            before, after = _whole(rotation_z(row.theta)), translation(z=row.d + constant)
        else:
            before, after = _whole(rotation_z(row.theta + constant)), translation(z=row.d)
        x_part = _whole(rotation_x(row.alpha))
        x_part[0, 3] = row.a
        if isinstance(row, Slid):
            x_part[1, 3] = row.f
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
    _shortened(links, frames_after)
    return Chain.of(links, prismatic, frames_after, description.coupling, description.own_axes)


def _whole(turn: Array) -> Array:
    """Return a turn (4, 4) about an axis, exact where it is by quarters of a circle: the sine of pi is none."""
    return np.where(np.abs(turn) < QUARTER_EXACT, 0.0, turn)


def frames_of(arm: Description, q: Array) -> Array:
    """Return the frames (n + 2, 4, 4) that bodies are said in, of a joint vector (n,): base, links, tool."""
    return chain_of(arm).native.frames(q, arm.base)


def _shortened(links: Array, frames_after: Array) -> None:
    """Slide the frames along their axes where a table's offsets are far longer than the arm.

    The common normal of nearly parallel axes lies far away: the table of a calibrated arm goes there by hundreds of
    metres and comes back in the next row. Both offsets lie along axes, along which a frame may slide.
    """
    n = len(links) - 1
    slid = np.linalg.norm(links[1:n, :3, 3], axis=1).sum()
    short, after = links.copy(), frames_after.copy()
    for i in range(1, n):
        back = translation(z=-float(short[i, :3, 3] @ short[i, :3, 2]))
        short[i] = short[i] @ back
        short[i + 1] = inverse(back) @ short[i + 1]
        after[i] = inverse(back) @ after[i]
    if np.linalg.norm(short[1:n, :3, 3], axis=1).sum() * FAR_LONGER < slid:
        links[:], frames_after[:] = short, after
