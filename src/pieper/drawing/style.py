"""How every figure looks: colours that the colour-blind can tell apart, line styles that survive a grey print."""

from __future__ import annotations

import io
import os
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from pieper import arguments
from pieper.document import identity
from pieper.document.blocks import Picture
from pieper.document.writing import write_whole
from pieper.errors import InputError

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: Millimetres a metre.
MM = 1e3
#: Colours of curves: those of the whole house, as many as there are line styles.
COLOURS = identity.curves()[:7]
#: One line style a curve, in the same order.
LINES = ("-", (0, (5, 2)), (0, (1, 1.4)), (0, (7, 2, 1.5, 2)), (0, (3, 1.5)), (0, (7, 2, 1.5, 2, 1.5, 2)), (0, (9, 3)))
#: One marker a curve, in the same order.
MARKERS = ("o", "s", "^", "D", "v", "P", "X")
#: x, y, z axes of a frame.
AXES = identity.axes()
INK, FAINT, GRID = identity.colour("ink"), identity.colour("edge"), identity.colour("line")

SUFFIXES = (".png", ".svg", ".pdf")


def new_figure(width: float, height: float) -> Figure:
    """Return an empty figure, width and height in inches, that belongs to no window and no global list."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width, height), layout="constrained")
    FigureCanvasAgg(figure)
    return figure


def plain_axes(axes: Axes, *, x: str, y: str, title: str = "") -> Axes:
    """Give plane axes the house look and return them; x and y are labels with their units."""
    axes.set_xlabel(x, color=INK, fontsize=10)
    axes.set_ylabel(y, color=INK, fontsize=10)
    if title:
        axes.set_title(title, color=INK, fontsize=11, loc="left")
    axes.grid(True, color=GRID, linewidth=0.7)
    axes.set_axisbelow(True)
    axes.tick_params(colors=INK, labelsize=9, length=3)
    for side, spine in axes.spines.items():
        spine.set_visible(side in ("left", "bottom"))
        spine.set_color(FAINT)
    return axes


def curve(axes: Axes, x: np.ndarray, y: np.ndarray, number: int, label: str) -> None:
    """Draw curve `number` with its own colour, line style and a few markers of its own."""
    y = np.asarray(y)
    few = max(1, len(y) // 8)
    axes.plot(
        x,
        y,
        color=COLOURS[number % len(COLOURS)],
        linestyle=LINES[number % len(LINES)],
        linewidth=1.6,
        marker=MARKERS[number % len(MARKERS)],
        markersize=4,
        markevery=(number * few // 7, few),
        label=label,
    )


def legend(axes: Axes, **options: Any) -> None:
    """Add a legend in the house look."""
    box = axes.legend(fontsize=9, frameon=False, handlelength=3.2, labelcolor=INK, **options)
    box.set_zorder(20)


def png(figure: Figure, *, dpi: int = 150) -> bytes:
    """Return a figure as PNG."""
    return _saved(figure, format="png", dpi=dpi, facecolor="white")


def svg(figure: Figure) -> str:
    """Return a figure as SVG text that needs no font and nothing from elsewhere."""
    return _saved(figure, format="svg", metadata={"Date": None, "Creator": None}, transparent=False).decode()


def _saved(figure: Figure, **options: Any) -> bytes:
    out, engine = io.BytesIO(), figure.get_layout_engine()
    if engine is not None:
        # laid out here and not by savefig, which draws the whole figure for it first and throws the drawing away
        engine.execute(figure)
        figure.set_layout_engine(None)
    figure.savefig(out, **options)
    if engine is not None:
        figure.set_layout_engine(engine)
    return out.getvalue()


class Drawn:
    """A matplotlib figure as a page holds it; its SVG text is made once."""

    def __init__(self, figure: Figure) -> None:
        self.figure = figure

    @cached_property
    def _svg(self) -> str:
        return svg(self.figure)

    def svg(self) -> str:
        """Return SVG text."""
        return self._svg

    def pdf(self) -> bytes:
        """Return a PDF file."""
        return _saved(self.figure, format="pdf", metadata={"CreationDate": None})

    def png(self) -> bytes:
        """Return a PNG file."""
        return png(self.figure)


def picture(figure: Figure, caption: str, name: str, width: float = 1.0) -> Picture:
    """Return a figure as a block of a page; see `document.blocks.Picture`."""
    return Picture(Drawn(figure), caption, name, width)


def save_figure(figure: Figure, path: str | os.PathLike[str]) -> Path:
    """Write a figure as .png, .svg or .pdf, whole or not at all.

    Args:
        figure: What a figure function returned.
        path: Where to; the suffix decides the format.

    Returns:
        The path.

    Raises:
        InputError: An unknown suffix, or a place that cannot be written.
    """
    path = arguments.file(path)
    suffix = path.suffix.lower()
    if suffix not in SUFFIXES:
        raise InputError(
            f"a figure is written as {', '.join(SUFFIXES)}; {path.name!r} ends in {suffix or 'nothing'}.", given=suffix
        )
    return write_whole(path, _saved(figure, format=suffix[1:], dpi=150, facecolor="white"))
