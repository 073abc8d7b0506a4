"""Bodies taken along when an arm's table is written anew: the same solids, in the frames of the new one."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import numpy.typing as npt

from pieper.description.dh import Description
from pieper.description.fold import frames_of
from pieper.description.shapes import Body
from pieper.kinematics.pose import inverse

Array = npt.NDArray[np.float64]


def carried(
    old: Description,
    new: Description,
    q_old: Array,
    q_new: Array,
    on: Callable[[int], int] = lambda k: k,
    world: Array | None = None,
) -> tuple[Body, ...]:
    """Return the bodies of an arm as bodies of another that is the same in space.

    Args:
        old: The arm that has them.
        new: The arm that shall have them.
        q_old: (n,) a posture of the first, rad or m.
        q_new: The same posture of the second.
        on: Number of a frame of the first (0 base, links, n + 1 tool) -> the one of the second that moves with it.
        world: (4, 4) the first's world in the second's; the identity when left out.
    """
    from pieper.description.tree_bodies import known_bodies  # reads meshes of URDFs; most arms have none

    bodies, _ = known_bodies(old)
    if not bodies:
        return ()
    before, after = frames_of(old, q_old), frames_of(new, q_new)
    world = np.eye(4) if world is None else world
    return tuple(body.moved(inverse(after[on(body.on)]) @ world @ before[body.on], on(body.on)) for body in bodies)
