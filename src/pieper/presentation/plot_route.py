"""A route on the map of path and turn: which turns are open on which branch, the curve chosen, where it is shut."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from pieper.drawing.style import COLOURS, INK, MM, legend, new_figure, plain_axes
from pieper.kinematics.arrays import Array
from pieper.motion.route.result import Blocked, Route
from pieper.motion.route.turn_map import TurnMap

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: Most branches that are told apart, each in a strip of its own.
MOST = 8
#: A turn, and what its ends are told by, deg; how far a curve stays from the edges of a strip.
ROUND, QUARTER, EDGE = 360.0, 90.0, 10.0
#: Part of an interval of turns that is left free beyond its ends.
INSET = 0.05
#: The narrowest band, in parts of the path; words stand so far off it, up so much of the strip, on the roomier side.
THIN, ASIDE, UP, MIDDLE = 0.004, 0.012, 0.08, 0.5
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
            _draw_proof(axes, route.blocked, _shut(route, known, k), first=k == 0)
    name = title or f"{route.plan.name}: {route.verdict.name.lower()}"
    figure.suptitle(name, color=INK, fontsize=11, x=0.02, ha="left")
    return figure


def _shut(route: Route, known: TurnMap, strip: int) -> str:
    """Return what shuts a strip at the place that nothing gets past, in a few words; none where that is not known."""
    blocked, plan = route.blocked, route.plan
    assert blocked is not None
    back = blocked.begun > blocked.s[1]
    # the first station that nothing gets to
    far = np.searchsorted(known.s, blocked.s[0], "right") - 1 if back else np.searchsorted(known.s, blocked.s[1])
    if known.open[strip][np.clip(far, 0, len(known.s) - 1)].any():
        return f"open, but not reached from {'behind' if back else 'before'}"
    for closed in blocked.closed:
        if closed.branch == known.branches[strip] and closed.joint in plan.names:
            scale, unit = (MM, " mm") if plan.prismatic[plan.names.index(closed.joint)] else (np.degrees(1.0), "°")
            limit, excess = closed.limit * scale, closed.excess * scale
            return f"{closed.joint} {closed.side} {limit:.4g}{unit}: {excess:.2g}{unit} short"
    return ""


def _draw_proof(axes: Axes, blocked: Blocked, words: str, *, first: bool) -> None:
    """Draw where a strip is shut, by what, and along what part of the path everything was followed to there."""
    begin, end = blocked.s
    last = max(end, begin + THIN)
    axes.axvspan(begin, last, color=INK, alpha=0.85, linewidth=0, label="blocked")
    followed = (blocked.begun, begin) if blocked.begun < begin else (last, blocked.begun)
    if followed[1] - followed[0] > THIN:
        axes.axvspan(*followed, facecolor="none", edgecolor=INK, alpha=0.25, linewidth=0, hatch="//", label="followed")
    left = (begin + last) / 2 > MIDDLE
    axes.annotate(
        words,
        (begin - ASIDE if left else last + ASIDE, UP),
        xycoords=("data", "axes fraction"),
        ha="right" if left else "left",
        color=INK,
        fontsize=8,
        bbox={"facecolor": "white", "alpha": 0.8, "linewidth": 0, "pad": 1.5} if words else None,
    )
    if first:
        legend(axes, **ABOVE, ncols=2)


def _shown(turn: Array) -> tuple[float, float]:
    """Return from where to where a strip goes round: the turns of a route, a whole turn at least, by quarters, deg."""
    if not len(turn):
        return 0.0, ROUND
    low = QUARTER * np.floor((turn.min() - EDGE) / QUARTER)
    high = QUARTER * np.ceil((turn.max() + EDGE) / QUARTER)
    more = max(0.0, ROUND - (high - low)) / QUARTER
    return float(low - QUARTER * (more // 2)), float(high + QUARTER * (more - more // 2))
