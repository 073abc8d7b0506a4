"""A calibration as a picture: the error on held-out poses before and after, and how far each axis was moved."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pieper.calibration.fit import Fit
from pieper.drawing.style import COLOURS, INK, MM, new_figure, plain_axes

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def calibration_figure(fit: Fit) -> Figure:
    """Draw what a fit gained, where poses were held out, and how each joint's axis tilted and shifted.

    Args:
        fit: A calibrated arm.

    Returns:
        The figure. Errors are on poses the fit has not seen; an axis's shift is measured across it, where the nominal
        axis was given.
    """
    figure = new_figure(9.6, 3.6)
    if (held := fit.held_out) is not None:
        axes = figure.add_subplot(1, 3, 1)
        words = ("nominal", "fitted", "predicted")
        values = np.array([held.nominal_metres, held.metres, held.predicted_metres]) * MM
        bars = axes.bar(words, values, color=(COLOURS[1], COLOURS[0], COLOURS[4]), zorder=3)
        axes.bar_label(bars, [f"{v:.3g}" for v in values], color=INK, fontsize=9, padding=2)
        axes.set_yscale("log")
        axes.margins(y=0.25)
        plain_axes(axes, x="", y="error, mm (rms)", title=f"{held.count} held-out poses")
    before = fit.make(fit.nominal).chain
    after = fit.geometry.chain
    names = [str(j + 1) for j in range(before.n)]
    tilt = np.arctan2(
        np.linalg.norm(np.cross(before.axes, after.axes), axis=1), np.sum(before.axes * after.axes, axis=1)
    )
    apart = after.points - before.points
    across = apart - np.sum(apart * after.axes, axis=1, keepdims=True) * after.axes
    shift = np.where(before.prismatic, 0.0, np.linalg.norm(across, axis=1))
    for place, (value, label) in enumerate(((tilt * 1e3, "tilt, mrad"), (shift * MM, "shift across it, mm"))):
        axes = figure.add_subplot(1, 3, 2 + place)
        axes.bar(names, value, color=COLOURS[2 * place], zorder=3)
        plain_axes(axes, x="joint", y=label, title=("axes tilted", "axes shifted")[place])
    return figure


def deviations_figure(fit: Fit) -> Figure:
    """Draw how sure each fitted number is: one standard deviation, over the size by which it may plausibly depart.

    Args:
        fit: A calibrated arm.

    Returns:
        The figure. Numbers that could not be seen, or were held, have no bar.
    """
    deviation = np.sqrt(np.maximum(np.diag(fit.covariance), 0.0)) / fit.parameters.sizes
    figure = new_figure(9.6, 0.22 * len(deviation) + 1.0)
    axes = figure.add_subplot(1, 1, 1)
    place = np.arange(len(deviation))
    axes.barh(place, deviation, color=COLOURS[0], zorder=3)
    axes.set_yticks(place, fit.parameters.names, fontsize=8)
    axes.invert_yaxis()
    plain_axes(axes, x="one deviation / plausible departure", y="", title="how sure each number is")
    return figure
