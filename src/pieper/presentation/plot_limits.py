"""How much of each limit a motion uses, over time, and which one binds."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pieper.drawing.style import COLOURS, FAINT, INK, curve, legend, new_figure, plain_axes
from pieper.errors import InputError
from pieper.motion.motion import Motion
from pieper.presentation.plot_curves import joint_text
from pieper.tolerances import DRAWN_TIME

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


def limits_figure(motion: Motion, *, title: str = "") -> Figure:
    """Draw each joint's speed, acceleration and jerk as a part of its limit, and below which limit binds when.

    Args:
        motion: A motion that knows its limits: of a time law, a program or a joint move.
        title: Text above the picture.

    Raises:
        InputError: The motion was not made within limits.
    """
    if motion.limits is None:
        raise InputError("this motion was not made within limits, so that there is nothing to compare it with.")
    n = motion.q.shape[1]
    names = motion.description.joint_names if motion.description else tuple(f"joint_{i + 1}" for i in range(n))
    bound = motion.limits.of(n, names)
    kinds = [("speed", motion.dq, bound.speed), ("acceleration", motion.ddq, bound.acceleration)]
    if bound.jerk is not None:
        kinds.append(("jerk", motion.dddq, bound.jerk))
    binding = _binding(motion)
    figure = new_figure(7.2, 1.9 * len(kinds) + 0.6 + 0.28 * len(binding))
    grid = figure.add_gridspec(len(kinds) + 1, 1, height_ratios=[*[1.9] * len(kinds), 0.35 + 0.28 * len(binding)])
    first: Axes | None = None
    for row, (kind, values, most) in enumerate(kinds):
        axes = figure.add_subplot(grid[row], sharex=first)
        first = first or axes
        plain_axes(axes, x="", y=f"{kind}, %", title=title if row == 0 else "")
        for y in (-100, 100):
            axes.axhline(y, color=INK, linewidth=1.0, linestyle=(0, (4, 3)))
        for joint in range(n):
            curve(axes, motion.t, 100 * values[:, joint] / most[joint], joint, joint_text(names[joint]))
        axes.set_ylim(-112, 112)
        axes.set_yticks([-100, -50, 0, 50, 100])
        axes.tick_params(labelbottom=False)
        if row == 0:
            legend(axes, loc="center left", bbox_to_anchor=(1.0, 0.5))
    _strip(figure.add_subplot(grid[len(kinds)], sharex=first), motion, binding)
    assert first is not None
    first.set_xlim(0, max(motion.duration, DRAWN_TIME))
    return figure


def _binding(motion: Motion) -> list[tuple[str, list[tuple[float, float]]]]:
    """Return each limit that binds somewhere, in words, with its stretches (start, length), the longest first."""
    found: dict[str, list[tuple[float, float]]] = {}
    for piece in motion.tight:
        words = f"{piece.limit} of {joint_text(piece.joint)}" if piece.joint else piece.limit
        found.setdefault(words, []).append((piece.start, piece.end - piece.start))
    return sorted(found.items(), key=lambda item: -sum(length for _, length in item[1]))


def _strip(axes: Axes, motion: Motion, binding: list[tuple[str, list[tuple[float, float]]]]) -> None:
    plain_axes(axes, x="time, s", y="")
    for row, (_, pieces) in enumerate(binding):
        colour = COLOURS[row % len(COLOURS)]
        axes.broken_barh(pieces, (row - 0.38, 0.76), facecolors=colour, linewidth=0)
    axes.set_yticks(np.arange(len(binding)), [words for words, _ in binding], fontsize=8.5)
    axes.set_ylim(max(len(binding), 1) - 0.5, -0.5)
    axes.grid(False, axis="y")
    if not binding:
        axes.text(0.5, 0.5, "no limit binds", transform=axes.transAxes, ha="center", va="center", color=FAINT)
