"""How much of each limit a motion uses, over time, and which one binds."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from pieper.drawing.style import COLOURS, FAINT, INK, curve, legend, new_figure, plain_axes
from pieper.errors import InputError
from pieper.kinematics.arrays import Array, Bools
from pieper.motion.motion import Motion
from pieper.presentation.plot_curves import joint_text
from pieper.tolerances import DRAWN_AS_BINDING, DRAWN_TIME

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
    used = {kind: np.asarray(values / most, np.float64) for kind, values, most in kinds}
    binding = _binding(motion, names, used)
    figure = new_figure(7.2, 1.9 * len(kinds) + 0.6 + 0.28 * len(binding))
    grid = figure.add_gridspec(len(kinds) + 1, 1, height_ratios=[*[1.9] * len(kinds), 0.35 + 0.28 * len(binding)])
    first: Axes | None = None
    for row, (kind, parts) in enumerate(used.items()):
        axes = figure.add_subplot(grid[row], sharex=first)
        first = first or axes
        plain_axes(axes, x="", y=f"{kind}, %", title=title if row == 0 else "")
        for y in (-100, 100):
            axes.axhline(y, color=INK, linewidth=1.0, linestyle=(0, (4, 3)))
        for joint in range(n):
            curve(axes, motion.t, 100 * parts[:, joint], joint, joint_text(names[joint]))
        axes.set_ylim(-112, 112)
        axes.set_yticks([-100, -50, 0, 50, 100])
        axes.tick_params(labelbottom=False)
        if row == 0:
            legend(axes, loc="center left", bbox_to_anchor=(1.0, 0.5))
    _strip(figure.add_subplot(grid[len(kinds)], sharex=first), motion, binding)
    assert first is not None
    first.set_xlim(0, max(motion.duration, DRAWN_TIME))
    return figure


@dataclass(frozen=True)
class _Binding:
    """A limit that binds somewhere: in words, in the colour of its joint, with its stretches (start, length)."""

    words: str
    colour: str
    pieces: list[tuple[float, float]]


def _binding(motion: Motion, names: tuple[str, ...], used: dict[str, Array]) -> list[_Binding]:
    """Return each limit that binds somewhere, the one that does longest first.

    Of several that bind at once a motion names one; where a curve shows another at its limit too it is drawn as well.

    Args:
        motion: The motion.
        names: Of the joints.
        used: Kind of limit -> (k, n) part of it that is used.
    """
    found: dict[tuple[str, str | None], list[tuple[float, float]]] = {}
    for piece in motion.tight:
        found.setdefault((piece.limit, piece.joint), []).append((piece.start, piece.end))
    out: list[_Binding] = []
    for (limit, joint), pieces in found.items():
        at = names.index(joint) if joint in names else None
        if at is not None and limit in used:
            pieces = pieces + _stretches(motion.t, np.abs(used[limit][:, at]) >= DRAWN_AS_BINDING)
        words = f"{limit} of {joint_text(joint)}" if joint else limit
        drawn = [(start, end - start) for start, end in _joined(pieces)]
        out.append(_Binding(words, INK if at is None else COLOURS[at % len(COLOURS)], drawn))
    return sorted(out, key=lambda one: -sum(length for _, length in one.pieces))


def _stretches(t: Array, on: Bools) -> list[tuple[float, float]]:
    """Return where samples (k,) hold one after the other."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], on, [False]]).astype(np.int8)))
    return [(float(t[a]), float(t[b - 1])) for a, b in zip(edges[::2], edges[1::2], strict=True)]


def _joined(pieces: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Return intervals in order, those that touch as one."""
    out: list[tuple[float, float]] = []
    for start, end in sorted(pieces):
        if out and start <= out[-1][1] + DRAWN_TIME:
            out[-1] = (out[-1][0], max(out[-1][1], end))
        else:
            out.append((start, end))
    return out


def _strip(axes: Axes, motion: Motion, binding: list[_Binding]) -> None:
    plain_axes(axes, x="time, s", y="")
    for row, one in enumerate(binding):
        axes.broken_barh(one.pieces, (row - 0.38, 0.76), facecolors=one.colour, linewidth=0)
    axes.set_yticks(np.arange(len(binding)), [one.words for one in binding], fontsize=8.5)
    axes.set_ylim(max(len(binding), 1) - 0.5, -0.5)
    axes.grid(False, axis="y")
    if not binding:
        axes.text(0.5, 0.5, "no limit binds", transform=axes.transAxes, ha="center", va="center", color=FAINT)
