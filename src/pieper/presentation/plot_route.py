"""A route on the map of path and turn: which turns are open on which branch, the curve chosen, where it is shut."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pieper.drawing.style import COLOURS, INK, legend, new_figure, plain_axes
from pieper.motion.route.result import Route

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Most branches that are told apart, each in a strip of its own.
MOST = 8


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
    # all the way round: the first turn is the last one too
    whole = float(np.ptp(degrees)) > 360.0 - 1.5 * step
    degrees = np.append(degrees, degrees[0] + 360.0) if whole else degrees
    low, high = float(degrees[0]), float(degrees[-1])
    drawn = False
    for k, axes in enumerate(grid):
        plain_axes(axes, x="path, s" if k == rows - 1 else "", y="turn, deg")
        axes.set_xlim(0, 1)
        axes.set_ylim(low, high)
        if not branches:
            axes.text(0.5, 0.5, "no turn is open anywhere", transform=axes.transAxes, ha="center", color=INK)
            break
        if high - low > 180:
            axes.set_yticks(np.arange(0, 361, 90))
        axes.set_title(branches[k], color=INK, fontsize=9, loc="left")
        colour = COLOURS[k % (len(COLOURS) - 1)]
        is_open = known.open[k].T.astype(float)
        axes.contourf(
            known.s,
            degrees,
            np.vstack([is_open, is_open[:1]]) if whole else is_open,
            levels=[0.5, 1.5],
            colors=[colour],
            alpha=0.3,
        )
        if route.found:
            mine = np.array([label == branches[k] for label in labels])
            shown = np.where(mine, np.degrees(route.turn), np.nan)
            # the curve goes on at the other end of the strip as often as it goes round
            first, last = (int(np.floor((np.degrees(v) - low) / 360.0)) for v in (route.turn.min(), route.turn.max()))
            for round_ in range(first, last + 1) if whole else (0,):
                named = "route" if mine.any() and not drawn else None
                axes.plot(route.s, shown - 360.0 * round_, color=INK, linewidth=1.8, label=named)
                drawn |= bool(mine.any())
            if axes.get_legend_handles_labels()[1]:
                legend(axes, loc="best")
        elif route.blocked is not None:
            first, last = route.blocked.s
            axes.axvspan(first, max(last, first + 0.004), color=INK, alpha=0.85, linewidth=0, label="blocked")
            if k == 0:
                legend(axes, loc="best")
    name = title or f"{route.plan.name}: {route.verdict.name.lower()}"
    figure.suptitle(name, color=INK, fontsize=11, x=0.02, ha="left")
    return figure
