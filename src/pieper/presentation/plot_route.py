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
    low, high = float(np.degrees(known.turn[0])), float(np.degrees(known.turn[-1]))
    step = (high - low) / max(len(known.turn) - 1, 1)
    drawn = False
    for k, axes in enumerate(grid):
        plain_axes(axes, x="path, s" if k == rows - 1 else "", y="turn, deg")
        axes.set_xlim(0, 1)
        axes.set_ylim(low - step / 2, high + step / 2)
        if not branches:
            axes.text(0.5, 0.5, "no turn is open anywhere", transform=axes.transAxes, ha="center", color=INK)
            break
        if high - low > 180:
            axes.set_yticks(np.arange(0, 361, 90))
        axes.set_title(branches[k], color=INK, fontsize=9, loc="left")
        colour = COLOURS[k % (len(COLOURS) - 1)]
        axes.contourf(
            known.s,
            np.degrees(known.turn),
            known.open[k].T.astype(float),
            levels=[0.5, 1.5],
            colors=[colour],
            alpha=0.3,
        )
        if route.found:
            mine = np.array([label == branches[k] for label in labels])
            turn = (np.degrees(route.turn) - low + step / 2) % 360.0 + low - step / 2
            if known.turn[-1] - known.turn[0] < 2 * np.pi - 2 * np.radians(step):
                turn = np.degrees(route.turn)
            shown = np.where(mine, turn, np.nan)
            shown[1:][np.abs(np.diff(turn)) > 180] = np.nan
            axes.plot(route.s, shown, color=INK, linewidth=1.8, label=None if drawn or not mine.any() else "route")
            drawn |= bool(mine.any())
            if mine.any() and drawn:
                legend(axes, loc="best")
        elif route.blocked is not None:
            first, last = route.blocked.s
            axes.axvspan(first, max(last, first + 0.004), color=COLOURS[1], alpha=0.8, label="blocked")
            if k == 0:
                legend(axes, loc="best")
    name = title or f"{route.plan.name}: {route.verdict.name.lower()}"
    figure.suptitle(name, color=INK, fontsize=11, x=0.02, ha="left")
    return figure
