"""The path in space, with what of it was reached."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from pieper.drawing.draw3d import draw_arm, draw_frame, space_axes, text
from pieper.drawing.skeleton import extent, skeleton
from pieper.drawing.style import COLOURS, FAINT, INK, MM, legend, new_figure
from pieper.motion.path import checked_path
from pieper.motion.track import Track

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from pieper.presentation.arm import Arm


def path_figure(path: np.ndarray | Track, *, arm: Arm | None = None, title: str = "") -> Figure:
    """Draw a path in space: its points, the tool's orientation along it, the part that was reached.

    Args:
        path: (N, 4, 4) poses, m, or a Track.
        arm: When given together with a track, the arm is drawn along the way, as ghosts.
        title: Text above the picture.

    Returns:
        The figure.
    """
    track, poses = (path, path.path) if isinstance(path, Track) else (None, checked_path(path))
    points = poses[:, :3, 3]
    reached = track.points if track else len(poses)
    ghosts = []
    if arm is not None and track is not None and reached:
        steps = np.unique(np.linspace(0, reached - 1, 5).round().astype(int))
        ghosts = [skeleton(arm.description, track.followed[k]) for k in steps]
    centre, half = extent(points, *(g.polyline for g in ghosts))
    figure = new_figure(6.4, 5.6)
    axes = space_axes(figure, (1, 1, 1), centre, half * (1.0 if ghosts else 1.35), title=title, floor=bool(ghosts))
    size = 2 * half
    for k, ghost in enumerate(ghosts):
        strength = 0.25 + 0.6 * k / max(len(ghosts) - 1, 1)
        draw_arm(axes, ghost, size, colour="#5d6d7c", alpha=strength, solid=False)
    axes.plot(
        *(points[:reached].T * MM),
        color=COLOURS[0],
        linewidth=1.6,
        marker="o",
        markersize=2.6,
        label="reached",
        zorder=8,
    )
    if reached < len(poses):
        axes.plot(
            *(points[reached:].T * MM),
            color=COLOURS[1],
            linestyle="none",
            marker="x",
            markersize=4.5,
            label="not reached",
            zorder=8,
        )
    for k in np.unique(np.linspace(0, len(poses) - 1, 6).round().astype(int)):
        draw_frame(axes, poses[k], 0.055 * size if ghosts else 0.13 * size, names=k == 0, width=1.4)
    low = axes.get_zlim()[0]
    axes.plot(points[:, 0] * MM, points[:, 1] * MM, low, color=FAINT, linewidth=1.0, linestyle=(0, (2, 2)), zorder=1)
    _ends(axes, points * MM)
    if reached < len(poses):
        legend(axes, loc="upper right")
    return figure


def _ends(axes: Any, points: np.ndarray) -> None:
    for point, name in ((points[0], "first"), (points[-1], "last")):
        axes.plot(*point[:, None], color=INK, marker="o", markersize=6, markerfacecolor="white", zorder=11)
        words = f"   {name} ({point[0]:z.0f}, {point[1]:z.0f}, {point[2]:z.0f})"
        text(axes, point, words, fontsize=8.5, ha="left", va="bottom")
