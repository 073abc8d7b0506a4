"""A chain of joint vectors at other places of the path than its own."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array


def between(x: Array, place: Array, at: Array) -> Array:
    """Return a chain x (k, m) at places (k,) as it is at others (M,), on the straight lines between."""
    columns: list[Array] = [np.interp(at, place, column) for column in x.T]
    return np.stack(columns, -1)


def spread(place: Array) -> Array:
    """Return places of a chain that stands now and then, ascending: what happens on the spot takes half the way."""
    out = place.copy()
    for value in np.unique(place):
        same = np.flatnonzero(place == value)
        before = place[same[0] - 1] if same[0] > 0 else value
        after = place[same[-1] + 1] if same[-1] + 1 < len(place) else value
        out[same] = np.linspace(value - (value - before) * 0.45, value + (after - value) * 0.45, len(same))
    if len(out) > 1:
        out[0], out[-1] = place[0], place[-1]
    return out
