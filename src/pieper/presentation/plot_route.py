"""A route on the map of path and turn: which turns are open on which branch, the curve chosen, where it is shut."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from pieper.drawing.style import COLOURS, INK, legend, new_figure, plain_axes
from pieper.kinematics.arrays import Array
from pieper.motion.route.result import Route

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Most branches that are told apart, each in a strip of its own.
MOST = 8
#: A turn, and what its ends are told by, deg; how far a curve stays from the edges of a strip.
ROUND, QUARTER, EDGE = 360.0, 90.0, 10.0
#: Part of an interval of turns that is left free beyond its ends.
INSET = 0.05
#: Where a legend stands: beside the title of its strip, off what is drawn in it.
ABOVE: dict[str, Any] = {"loc": "lower right", "bbox_to_anchor": (1.0, 0.98), "borderaxespad": 0.0}


def route_figure(route: Route, *, title: str = "") -> Figure:
    """Draw a route over its path and the turn of the tool, a strip a branch.

    Args:
        route: Found or not, with a free turn.
        title: Text above the picture.

    Returns:
        The figure.
    """
    known = route.map
    branches = known.branches[:MOST]
    rows = max(1, len(branches))
    figure = new_figure(7.2, 1.2 + 1.15 * rows)
    grid = figure.subplots(rows, 1, sharex=True, squeeze=False)[:, 0]
    labels = route.labels
    degrees = np.degrees(known.turn)
    step = float(np.ptp(degrees)) / max(len(degrees) - 1, 1)
    whole = float(np.ptp(degrees)) > ROUND - 1.5 * step
    # all the way round the turns that are drawn are those of the route, so that its curve is one curve
    low, high = _shown(np.degrees(route.turn)) if whole else (float(degrees[0]), float(degrees[-1]))
    number = np.arange(len(degrees))
    if whole:
        number = np.arange(np.floor((low - degrees[0]) / step), np.ceil((high - degrees[0]) / step) + 1).astype(int)
    levels = degrees[0] + step * number
    drawn = False
    for k, axes in enumerate(grid):
        plain_axes(axes, x="path, s" if k == rows - 1 else "", y="turn, deg")
        axes.set_xlim(0, 1)
        # a route may lie along an end of the turn's interval
        room = 0.0 if whole else INSET * (high - low)
        axes.set_ylim(low - room, high + room)
        if not branches:
            axes.text(0.5, 0.5, "no turn is open anywhere", transform=axes.transAxes, ha="center", color=INK)
            break
        if high - low > ROUND / 2:
            axes.set_yticks(np.arange(low, high + 1, QUARTER * max(1, round((high - low) / ROUND))))
        axes.set_title(branches[k], color=INK, fontsize=9, loc="left")
        colour = COLOURS[k % (len(COLOURS) - 1)]
        is_open = known.open[k].T[number % len(degrees)].astype(float)
        axes.contourf(known.s, levels, is_open, levels=[0.5, 1.5], colors=[colour], alpha=0.3)
        if route.found:
            mine = np.array([label == branches[k] for label in labels])
            if mine.any():
                # where the branch changes the curve goes on in the other strip from the same point
                shown = np.where(mine | np.roll(mine, 1) & (np.arange(len(mine)) > 0), np.degrees(route.turn), np.nan)
                axes.plot(route.s, shown, color=INK, linewidth=1.8, label=None if drawn else "route")
                drawn = True
            if axes.get_legend_handles_labels()[1]:
                legend(axes, **ABOVE)
        elif route.blocked is not None:
            first, last = route.blocked.s
            axes.axvspan(first, max(last, first + 0.004), color=INK, alpha=0.85, linewidth=0, label="blocked")
            if k == 0:
                legend(axes, **ABOVE)
    name = title or f"{route.plan.name}: {route.verdict.name.lower()}"
    figure.suptitle(name, color=INK, fontsize=11, x=0.02, ha="left")
    return figure


def _shown(turn: Array) -> tuple[float, float]:
    """Return from where to where a strip goes round: the turns of a route, a whole turn at least, by quarters, deg."""
    if not len(turn):
        return 0.0, ROUND
    low = QUARTER * np.floor((turn.min() - EDGE) / QUARTER)
    high = QUARTER * np.ceil((turn.max() + EDGE) / QUARTER)
    more = max(0.0, ROUND - (high - low)) / QUARTER
    return float(low - QUARTER * (more // 2)), float(high + QUARTER * (more - more // 2))
