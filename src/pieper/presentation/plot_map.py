"""A reach map as pictures: three sections through its box, shaded by the share of orientations that is reached."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pieper.drawing.style import MM, new_figure, plain_axes
from pieper.errors import InputError
from pieper.maps.reach_map import ReachMap

if TYPE_CHECKING:
    from matplotlib.colors import LinearSegmentedColormap
    from matplotlib.figure import Figure

#: What can be shaded, and its words.
SHADES = {
    "fraction": "share of orientations reached",
    "count": "solutions, all orientations",
    "manipulability": "best manipulability",
    "margin": "distance to limits, share of half a range",
    "least_singular": "smallest singular value, nearest to singular",
    "most_singular": "smallest singular value, farthest from singular",
}


def map_figure(m: ReachMap, *, what: str = "fraction", at: tuple[float, float, float] | None = None) -> Figure:
    """Draw sections through a map, one across each axis.

    Args:
        m: The map.
        what: "fraction", "count", "manipulability", "margin", "least_singular" or "most_singular".
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
    shades = _shades()
    edges = [(low + np.arange(n + 1) * m.grid.step) * MM for low, n in zip(m.grid.low, m.grid.shape, strict=True)]
    most = float(values.max()) or 1.0
    figure = new_figure(10.2, 4.0)
    drawn = None
    for place, (across, x, y) in enumerate(((1, 0, 2), (0, 1, 2), (2, 0, 1))):
        axes = figure.add_subplot(1, 3, place + 1)
        centre = m.axes[across][index[across]] * MM
        plain_axes(axes, x=f"{'xyz'[x]}, mm", y=f"{'xyz'[y]}, mm", title=f"{'xyz'[across]} = {centre:z.0f} mm")
        layer = np.take(values, index[across], axis=across)
        shown = np.ma.masked_where(np.take(m.fraction, index[across], axis=across) == 0, layer)
        drawn = axes.pcolormesh(
            edges[x], edges[y], shown.T, cmap=shades, vmin=0.0, vmax=most, rasterized=True, linewidth=0
        )
        axes.set_aspect("equal")
    if drawn is not None:
        figure.colorbar(drawn, ax=figure.axes, label=SHADES[what], shrink=0.8)
    return figure


def layers_figure(m: ReachMap, *, most: int = 6) -> Figure:
    """Draw slices across z from below upwards, shaded by the share of orientations that is reached.

    Args:
        m: The map.
        most: How many slices at most, evenly spread over the layers in which something is reached.

    Returns:
        The figure. White is not reached at all.
    """
    some = np.flatnonzero((m.fraction > 0).any((0, 1)))
    some = some if len(some) else np.arange(m.grid.shape[2])
    layers = some[np.unique(np.linspace(0, len(some) - 1, min(most, len(some))).round().astype(int))]
    x, y = (
        (low + np.arange(n + 1) * m.grid.step) * MM for low, n in zip(m.grid.low[:2], m.grid.shape[:2], strict=True)
    )
    columns = min(3, len(layers))
    rows = -(-len(layers) // columns)
    figure = new_figure(10.2, 3.4 * rows)
    top, drawn = float(m.fraction.max()) or 1.0, None
    for place, layer in enumerate(layers):
        axes = figure.add_subplot(rows, columns, place + 1)
        plain_axes(axes, x="x, mm", y="y, mm", title=f"z = {m.axes[2][layer] * MM:z.0f} mm")
        axes.locator_params(nbins=5)
        share = np.ma.masked_equal(m.fraction[:, :, layer], 0.0)
        drawn = axes.pcolormesh(x, y, share.T, cmap=_shades(), vmin=0.0, vmax=top, rasterized=True, linewidth=0)
        axes.set_aspect("equal")
    if drawn is not None:
        figure.colorbar(drawn, ax=figure.axes, label=SHADES["fraction"], shrink=0.8)
    return figure


def _shades() -> LinearSegmentedColormap:
    from matplotlib.colors import LinearSegmentedColormap

    return LinearSegmentedColormap.from_list("map", ["#d6e9f5", "#56B4E9", "#0072B2", "#003350"])
