"""Pictures of the arm: with its frames and joint axes, first and last configuration, all solutions of a pose."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from pieper.drawing.draw3d import draw_arm, draw_axes_lines, draw_frame, draw_shadow, placed, space_axes
from pieper.drawing.skeleton import Skeleton, extent, skeleton
from pieper.drawing.style import AXES, COLOURS, FAINT, INK, MM, new_figure
from pieper.kinematics.forward import checked_joints
from pieper.solver.results import Solutions

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from pieper.motion.track import Track
    from pieper.presentation.arm import Arm


def arm_figure(arm: Arm, q: np.ndarray | None = None, *, title: str = "") -> Figure:
    """Draw an arm with its joint axes, the DH frames, base and tool.

    Args:
        arm: The arm.
        q: (n,) posture, rad or m; all joints at zero when left out.
        title: Text above the picture.

    Returns:
        The figure.
    """
    q = checked_joints(np.zeros(arm.n) if q is None else q, arm.n)
    parts = skeleton(arm.description, q)
    centre, half = extent(parts.polyline, np.zeros((1, 3)))
    size = 2 * half
    figure = new_figure(6.4, 5.8)
    axes = space_axes(figure, (1, 1, 1), centre, half * 1.12, title=title, view=good_view(parts))
    draw_shadow(axes, parts)
    draw_arm(axes, parts, size)
    draw_axes_lines(axes, parts, size)
    for T in parts.frames[1:-1]:
        draw_frame(axes, T, 0.07 * size, width=1.2, alpha=0.8)
    draw_frame(axes, parts.frames[0], 0.14 * size, names=True, width=2.2)
    draw_frame(axes, parts.frames[-1], 0.12 * size, names=True, width=2.2)
    _axes_legend(axes)
    return figure


def _axes_legend(axes: Any) -> None:
    from matplotlib.lines import Line2D

    handles = [Line2D([], [], color=c, linewidth=2, label=f"frame {n}") for c, n in zip(AXES, "xyz", strict=True)]
    handles.append(Line2D([], [], color=INK, linewidth=0.9, linestyle=(0, (6, 2, 1, 2)), label="joint axis"))
    axes.legend(handles=handles, fontsize=8, frameon=False, loc="upper right", labelcolor=INK)


def configuration_figure(
    arm: Arm, track: Track, *, titles: tuple[str, str] = ("First configuration", "Last configuration")
) -> Figure:
    """Draw an arm in the first and the last configuration of a track, with the path.

    Args:
        arm: The arm.
        track: What following a path gave, with at least one point reached.
        titles: Text above each picture.

    Returns:
        The figure.
    """
    ends = [skeleton(arm.description, track.followed[0]), skeleton(arm.description, track.followed[-1])]
    centre, half = extent(*(p.polyline for p in ends), track.path[:, :3, 3])
    figure = new_figure(9.6, 4.9)
    for k, (parts, title) in enumerate(zip(ends, titles, strict=True)):
        axes = space_axes(figure, (1, 2, k + 1), centre, half, title=title)
        draw_shadow(axes, parts)
        axes.plot(*(track.path[:, :3, 3].T * MM), color=COLOURS[1], linewidth=1.8, linestyle=(0, (3, 1.5)), zorder=10)
        draw_arm(axes, parts, 2 * half)
        draw_frame(axes, parts.frames[-1], 0.11 * 2 * half, names=True, width=2.0)
        draw_frame(axes, parts.frames[0], 0.11 * 2 * half, names=True, width=2.0)
    return figure


def postures_figure(arm: Arm, postures: np.ndarray, titles: list[str]) -> Figure:
    """Draw an arm in several postures side by side.

    Args:
        arm: The arm.
        postures: (k, n), rad or m.
        titles: One text a posture.

    Returns:
        The figure.
    """
    everything = [skeleton(arm.description, q) for q in postures]
    figure = new_figure(3.8 * len(everything), 3.6)
    for k, (parts, title) in enumerate(zip(everything, titles, strict=True)):
        centre, half = extent(parts.polyline)
        axes = space_axes(figure, (1, len(everything), k + 1), centre, half, title=title, view=good_view(parts))
        draw_shadow(axes, parts)
        draw_arm(axes, parts, 2 * half)
        draw_axes_lines(axes, parts, 2 * half)
        draw_frame(axes, parts.frames[-1], 0.11 * 2 * half, names=True, width=2.0)
    return figure


def good_view(parts: Skeleton) -> tuple[float, float]:
    """Return elevation and azimuth, deg, that look across the plane an arm stands in rather than along it."""
    flat = parts.polyline[:, :2] - parts.polyline[0, :2]
    far = flat[np.argmax(np.linalg.norm(flat, axis=1))]
    if np.linalg.norm(far) < 0.05 * np.ptp(parts.polyline, axis=0).max():
        return 22.0, -58.0
    return 22.0, float(np.degrees(np.arctan2(far[1], far[0]))) - 58.0


def solutions_figure(
    arm: Arm, q: np.ndarray | Solutions, *, labels: list[str] | None = None, columns: int = 4
) -> Figure:
    """Draw every solution of a pose, each in its own picture with the others as ghosts behind it.

    Args:
        arm: The arm.
        q: (m, n) joint vectors of one pose, or Solutions.
        labels: One text a row; the posture labels of Solutions when left out.
        columns: Pictures a row.

    Returns:
        The figure.
    """
    if isinstance(q, Solutions):
        labels = list(q.labels) if labels is None else labels
        q = q.q
    q = np.asarray(q, float)
    labels = [""] * len(q) if labels is None else labels
    everything = [skeleton(arm.description, row) for row in q]
    if not everything:
        figure = new_figure(4, 1.2)
        figure.text(0.5, 0.5, "no solution", ha="center", va="center", color=INK)
        return figure
    centre, half = extent(*(p.polyline for p in everything))
    view = good_view(everything[0])
    columns = min(columns, len(q))
    rows = -(-len(q) // columns)
    figure = new_figure(2.9 * columns, 3.1 * rows)
    for i, parts in enumerate(everything):
        axes = space_axes(figure, (rows, columns, i + 1), centre, half, view=view)
        for other in everything:
            if other is not parts:
                axes.plot(
                    *(other.polyline.T * MM), color=FAINT, linewidth=1.4, alpha=0.35, zorder=2, solid_capstyle="round"
                )
        draw_arm(axes, parts, 2 * half, colour=COLOURS[0])
        draw_frame(axes, parts.frames[-1], 0.2 * half, width=1.8)
        values = ", ".join(_value(v, kind) for v, kind in zip(q[i], arm.joint_types, strict=True))
        axes.set_title(f"{i + 1}. {labels[i]}\n{values}", fontsize=7.5, color=INK)
        axes.tick_params(labelbottom=False, labelleft=False, labelright=False)
        for axis in (axes.xaxis, axes.yaxis, axes.zaxis):
            axis.set_label_text("")
            axis.set_ticklabels([])
    placed(figure)  # a title needs its room, of one picture too
    return figure


def _value(value: float, kind: str) -> str:
    return f"{np.degrees(value):z.1f}°" if kind == "R" else f"{value * MM:z.1f} mm"
