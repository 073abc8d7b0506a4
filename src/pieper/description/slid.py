"""A table that is as short as the arm, where common normals lie far away; see `dh.Slid`."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from pieper.description.commonnormal import standard_table
from pieper.description.dh import Description, Slid
from pieper.description.fold import FAR_LONGER, chain_of
from pieper.kinematics.pose import inverse


def with_short_rows(description: Description) -> Description:
    """Return the same arm with slid rows between nearly parallel axes; itself where its table is no longer than it.

    The joints' zeros and senses become those of the rows: theta_i = row.theta + q_i.
    """
    if slid_rows(description):
        return description
    chain = chain_of(description)
    size = chain.length
    if sum(abs(row.a) + abs(row.d) for row in description.rows) < FAR_LONGER * size:
        return description
    # from the arm's own base, so that the table begins there wherever that stands
    off = inverse(description.base)
    axes, points = chain.axes @ off[:3, :3].T, chain.points @ off[:3, :3].T + off[:3, 3]
    table = standard_table(axes, points, off @ chain.home, size)
    if not any(isinstance(row, Slid) for row in table.rows):
        return description
    return replace(
        description,
        convention="standard",
        rows=table.rows,
        base=description.base @ table.base,
        tool=table.tool,
        sign=np.ones(len(table.rows)),
        offset=np.zeros(len(table.rows)),
        tools={},
        frames={},
        checks=(),
        bodies=(),
        origin=None,
    )


def slid_rows(description: Description) -> list[int]:
    """Return the numbers (1-based) of slid rows."""
    return [i for i, row in enumerate(description.rows, 1) if isinstance(row, Slid)]
