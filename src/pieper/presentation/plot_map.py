"""A reach map as pictures: three sections through its box, shaded by the share of orientations that is reached."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pieper.drawing.style import MM, new_figure, plain_axes
from pieper.errors import InputError
from pieper.maps.reach_map import ReachMap

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: What can be shaded, and its words.
SHADES = {
    "fraction": "share of orientations reached",
    "count": "solutions, all orientations",
    "manipulability": "best manipulability",
    "margin": "distance to limits, share of half a range",
}


def map_figure(m: ReachMap, *, what: str = "fraction", at: tuple[float, float, float] | None = None) -> Figure:
    """Draw sections through a map, one across each axis.

    Args:
        m: The map.
        what: "fraction", "count", "manipulability" or "margin".
        at: Where the sections lie (x, y, z), m; through the voxel that is best served when left out.

    Returns:
        The figure. White is not reached at all.

    Raises:
        InputError: Something else to shade, a map that was not measured, a place outside the box.
    """
    if what not in SHADES:
        raise InputError(f"what is {what!r}; it may be {', '.join(SHADES)}.", given=what, allowed=tuple(SHADES))
    values = np.asarray(getattr(m, what), np.float64)
    if at is None:
        index = np.unravel_index(int(np.argmax(values)), values.shape)
    else:
        inside, voxel = m.grid.voxel_of(np.asarray(at, np.float64)[None])
        if not inside[0]:
            raise InputError(f"at = {at} m lies outside the map's box.", given=at)
        index = np.unravel_index(int(voxel[0]), values.shape)
    from matplotlib.colors import LinearSegmentedColormap

    shades = LinearSegmentedColormap.from_list("map", ["#d6e9f5", "#56B4E9", "#0072B2", "#003350"])
    edges = [(low + np.arange(n + 1) * m.grid.step) * MM for low, n in zip(m.grid.low, m.grid.shape, strict=True)]
    most = float(values.max()) or 1.0
    figure = new_figure(10.2, 4.0)
    drawn = None
    for place, (across, x, y) in enumerate(((1, 0, 2), (0, 1, 2), (2, 0, 1))):
        axes = figure.add_subplot(1, 3, place + 1)
        centre = m.axes[across][index[across]] * MM
        plain_axes(axes, x=f"{'xyz'[x]}, mm", y=f"{'xyz'[y]}, mm", title=f"{'xyz'[across]} = {centre:.0f} mm")
        layer = np.take(values, index[across], axis=across)
        shown = np.ma.masked_where(np.take(m.fraction, index[across], axis=across) == 0, layer)
        drawn = axes.pcolormesh(
            edges[x], edges[y], shown.T, cmap=shades, vmin=0.0, vmax=most, rasterized=True, linewidth=0
        )
        axes.set_aspect("equal")
    if drawn is not None:
        figure.colorbar(drawn, ax=figure.axes, label=SHADES[what], shrink=0.8)
    return figure
