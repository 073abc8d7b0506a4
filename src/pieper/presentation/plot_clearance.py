"""The proof along a path: how far it keeps away, what of that is proved between the points, and where it hits."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pieper.collision.swept import Clearance
from pieper.drawing.style import COLOURS, FAINT, INK, LINES, MM, legend, new_figure, plain_axes

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from pieper.collision.profile import Profile

#: Most pairs that are told apart; the others are one.
MOST = 5
#: Free space above the highest and below the lowest that is drawn, as a part of the height.
ROOM = 0.08


def clearance_figure(profile: Profile, *, title: str = "") -> Figure:
    """Draw how far a path keeps away, with what is proved on each stretch, the margin, and what was found.

    Args:
        profile: Of `arm.clearance`.
        title: Text above the picture.

    Returns:
        The figure.
    """
    swept, s = profile.swept, profile.s
    figure = new_figure(7.2, 3.8)
    axes = figure.subplots()
    plain_axes(axes, x="path, s", y="distance of the nearest two bodies, mm")
    metres = np.where(np.isfinite(profile.metres), profile.metres, np.nan) * MM
    proved = np.where(np.isnan(profile.proved), 0.0, profile.proved) * MM
    axes.set_xlim(0, 1)
    drawn = np.concatenate([metres[np.isfinite(metres)], [0.0, swept.margin * MM]])
    height = float(np.ptp(drawn)) or 1.0
    axes.set_ylim(drawn.min() - ROOM * height * bool(drawn.min() < 0), drawn.max() + ROOM * height)
    if len(proved):
        axes.stairs(proved, s, fill=True, color=COLOURS[2], alpha=0.25, linewidth=0, label="proved to be kept")
    _curves(axes, profile, metres)
    _open(axes, profile)
    if swept.margin > 0:
        axes.axhline(swept.margin * MM, color=INK, linewidth=1.0, linestyle=(0, (4, 3)), label="margin")
    if drawn.min() < 0:
        axes.axhline(0.0, color=FAINT, linewidth=1.0)
    if swept.verdict is not Clearance.CLEAR:
        hit = swept.verdict is Clearance.HIT
        colour, word = (COLOURS[1], "hit") if hit else (INK, "not decided")
        axes.axvline(swept.s, color=colour, linewidth=1.6, label=word)
    legend(axes, loc="upper left", bbox_to_anchor=(1.0, 1.0))
    figure.suptitle(title or _said(profile), color=INK, fontsize=11, x=0.02, ha="left")
    return figure


def _said(profile: Profile) -> str:
    swept = profile.swept
    if swept.verdict is Clearance.CLEAR:
        least = profile.proved[np.isfinite(profile.proved)] * MM
        return f"clear, proved: {least.min():.3g} mm at least" if len(least) else "clear, proved: nothing can touch"
    pair = " and ".join(swept.pair)
    if swept.verdict is Clearance.UNCERTAIN:
        return f"not decided at s = {swept.s:.4g}: {pair} within {swept.gap * MM:.3g} mm of the margin"
    return f"hit at s = {swept.s:.4g}: {pair}, {swept.depth * MM:.3g} mm too near at worst"


def _curves(axes: Axes, profile: Profile, metres: np.ndarray) -> None:
    """Draw the distance in the colour of the two that are nearest, with a name for each of the first pairs."""
    names = np.array([" and ".join(pair) for pair in profile.pair.tolist()])
    known, count = np.unique(names[np.isfinite(metres)], return_counts=True)
    first = [str(name) for name in known[np.argsort(-count, kind="stable")]][:MOST]
    for number, name in enumerate([*first, None]):
        mine = ~np.isin(names, first) if name is None else names == name
        # a stretch is drawn as what is nearest at its first end
        shown = np.where(mine | np.roll(mine, 1) & (np.arange(len(mine)) > 0), metres, np.nan)
        if np.isfinite(metres[mine]).any():
            which = number % len(COLOURS)
            axes.plot(
                profile.s, shown, color=COLOURS[which], linestyle=LINES[which], linewidth=1.8, label=name or "others"
            )


def _open(axes: Axes, profile: Profile) -> None:
    """Mark the stretches on which nothing is proved."""
    gaps = np.flatnonzero(np.isnan(profile.proved) & np.isfinite(profile.metres[:-1]))
    for k in gaps:
        axes.axvspan(
            profile.s[k],
            profile.s[k + 1],
            color=COLOURS[1],
            alpha=0.18,
            linewidth=0,
            label="not proved to be apart" if k == gaps[0] else None,
        )
