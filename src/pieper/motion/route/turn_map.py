"""Where along a path which turn of the tool is open, branch by branch: what a picture of a route is drawn from."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper.errors import InputError
from pieper.kinematics.arrays import Array, Bools
from pieper.motion.route.grid import grid
from pieper.motion.route.setting import Setting
from pieper.solver.words.labels import posture_words

#: Stations along the path.
STATIONS = 121


@dataclass(frozen=True, eq=False)
class TurnMap:
    """Open turns along a path.

    Attributes:
        s: (M,) stations.
        turn: (K,) turns, rad.
        branches: (b,) posture labels.
        open: (b, M, K) whether a posture of that label is inside the limits.
    """

    s: Array
    turn: Array
    branches: tuple[str, ...]
    open: Bools


def turn_map(world: Setting) -> TurnMap:
    """Return the map of what is solved along a path, whether a route was found there or not.

    Raises:
        InputError: The turn was not free, or the arm's own joints decide it.
    """
    if not (world.turn_on_grid and world.free.turns):
        raise InputError("a map of path and turn needs a turn that is free to choose.", given=repr(world.free))
    cells = grid(world, 2)
    assert cells.turn is not None
    upright = cells.cells[:, -1] == 0
    for k, held in enumerate(cells.held):
        # spare joints of the arm are shown at their middle value
        middle = held.values[len(held.values) // 2]
        upright &= cells.cells[:, 1 + k] == middle
    s = np.linspace(0.0, 1.0, STATIONS)
    x, valid = cells.rows(world.at(s))
    x, valid = x[:, upright], valid[:, upright]
    ok = valid & world.chain.joints.inside_limits(x, world.limits)[1]
    i, k, _ = np.nonzero(ok)
    words = np.array(posture_words(world.plan, x[ok][:, : world.n])) if len(i) else np.zeros(0, str)
    branches = tuple(sorted(set(words.tolist())))
    out = np.zeros((len(branches), len(s), int(upright.sum())), bool)
    for b, label in enumerate(branches):
        mine = words == label
        out[b, i[mine], k[mine]] = True
    return TurnMap(s, cells.turn.values, branches, out)
