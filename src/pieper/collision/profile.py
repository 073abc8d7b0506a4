"""How far a path keeps away all along: distances at places of it, and between them what is proved to be kept."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from pieper.collision.distance import distance
from pieper.collision.model import Model
from pieper.collision.swept import Clearance, Swept, clear, postures_on
from pieper.kinematics.arrays import Array, ArrayLike

#: Stretches that a path is looked at in.
STRETCHES = 240
#: What a bound lies below the distances at the ends of its stretch at first, as a part of the largest distance of all;
#: it is doubled until it is proved.
BELOW = 0.004


@dataclass(frozen=True, eq=False)
class Profile:
    """What a path keeps away, in stretches that follow each other.

    Attributes:
        swept: What was found of the whole path.
        s: (k + 1,) the ends of the stretches, in [0, 1] of the path, its points evenly spread.
        metres: (k + 1,) distance of the nearest pair there, m.
        pair: (k + 1, 2) which two these are.
        proved: (k,) how far apart all are proved to be on the whole of each stretch, m; NaN where nothing is proved.
    """

    swept: Swept
    s: Array
    metres: Array
    pair: npt.NDArray[np.str_]
    proved: Array


def profile(model: Model, given: ArrayLike, margin: float = 0.0) -> Profile:
    """Return what a path of joint vectors (N, n), rad or m, keeps away; between two of them every joint moves evenly.

    Args:
        model: What must keep apart.
        given: (N, n) the path, or one posture (n,).
        margin: Distance to keep, m.

    Raises:
        InputError: As of `clear`.
    """
    swept = clear(model, given, margin)
    q: Array = np.atleast_2d(np.asarray(given, float))
    last = len(q) - 1
    each = max(1, -(-STRETCHES // max(last, 1)))
    # points of the path among the ends, or ends among its points
    at = np.linspace(0, last, last * each + 1) if each > 1 else np.unique(np.linspace(0, last, STRETCHES + 1).round())
    ends = postures_on(q, at)
    found = distance(model, ends)
    metres = np.asarray(found)
    apart = metres[np.isfinite(metres)]
    step = BELOW * float(apart.max(initial=0.0))
    proved = np.full(len(at) - 1, np.nan)
    for k in range(len(proved)):
        inner = q[int(np.floor(at[k])) + 1 : int(np.ceil(at[k + 1]))]
        stretch = np.concatenate([ends[k : k + 1], inner, ends[k + 1 : k + 2]])
        proved[k] = _bound(model, stretch, float(metres[k : k + 2].min()), step)
    share = at / last if last else at
    return Profile(swept, np.asarray(share, np.float64), metres, found.pair, proved)


def _bound(model: Model, q: Array, least: float, below: float) -> float:
    """Return what is proved to be kept on a stretch, by the margin next below the distances at its ends that is."""
    while least > 0.0:
        margin = max(least - below, 0.0) if below > 0 else 0.0
        if clear(model, q, margin).verdict is Clearance.CLEAR:
            return margin
        if margin == 0.0:
            break
        below *= 2
    return np.nan
