"""Curves: tool coordinates and joints against the point number, joints, rates and accelerations against time."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pieper.drawing.style import FAINT, INK, MM, curve, legend, new_figure, plain_axes
from pieper.motion.path import checked_path
from pieper.motion.track import Track

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from pieper.motion.sequence import Motion
    from pieper.presentation.arm import Arm


def coordinates_figure(path: np.ndarray | Track, *, title: str = "") -> Figure:
    """Draw the tool's X, Y and Z against the point number.

    Args:
        path: (N, 4, 4) poses, m, or a Track.
        title: Text above the picture.

    Returns:
        The figure.
    """
    poses = checked_path(path.path if isinstance(path, Track) else path)
    number = np.arange(1, len(poses) + 1)
    figure = new_figure(6.4, 3.7)
    axes = plain_axes(figure.add_subplot(), x="point number", y="tool position, mm", title=title)
    for k, name in enumerate("XYZ"):
        curve(axes, number, poses[:, k, 3] * MM, k, name)
    _point_axis(axes, len(poses))
    legend(axes, ncols=3, loc="lower right", bbox_to_anchor=(1.0, 1.0))
    return figure


def joints_figure(track: Track, *, title: str = "") -> Figure:
    """Draw the joints against the point number, with the first stop where there is one.

    Args:
        track: What following a path gave.
        title: Text above the picture.

    Returns:
        The figure: revolute joints in degrees, prismatic joints below them in millimetres.
    """
    number = np.arange(1, track.points + 1)
    groups = _groups(track.prismatic)
    figure = new_figure(6.4, 4.1 if len(groups) == 1 else 5.8)
    for row, (columns, factor, label) in enumerate(groups):
        axes = figure.add_subplot(len(groups), 1, row + 1)
        plain_axes(axes, x="point number", y=label, title=title if row == 0 else "")
        for joint in columns:
            curve(axes, number, track.followed[:, joint] * factor, joint, joint_text(track.joint_names[joint]))
        _point_axis(axes, len(track.path))
        if (stop := track.stop) is not None:
            at = 1 + stop.s * (len(track.path) - 1)
            axes.axvline(at, color=INK, linewidth=1.1, linestyle=(0, (2, 2)))
            axes.axvspan(at, len(track.path), color=FAINT, alpha=0.12, linewidth=0)
            axes.text(
                at,
                1.01,
                f" stop: {stop.cause}",
                transform=axes.get_xaxis_transform(),
                fontsize=8.5,
                color=INK,
                va="bottom",
            )
        legend(axes, loc="center left", bbox_to_anchor=(1.0, 0.5))
    return figure


def time_figure(motion: Motion, *, arm: Arm | None = None, title: str = "") -> Figure:
    """Draw joint positions, rates and accelerations against time.

    Args:
        motion: The joint curves.
        arm: Gives the joints their names and kinds; revolute joints are assumed when left out.
        title: Text above the picture.

    Returns:
        The figure: degrees and millimetres.
    """
    n = motion.q.shape[1]
    names = arm.joint_names if arm is not None else tuple(f"joint_{i + 1}" for i in range(n))
    prismatic = np.array([t == "P" for t in arm.joint_types]) if arm is not None else np.zeros(n, bool)
    unit = "deg" if not prismatic.any() else "deg or mm"
    factor = np.where(prismatic, MM, 180 / np.pi)
    figure = new_figure(7.2, 6.6)
    first: Axes | None = None
    for row, (values, label) in enumerate(
        ((motion.q, f"position, {unit}"), (motion.dq, f"rate, {unit}/s"), (motion.ddq, f"acceleration, {unit}/s²"))
    ):
        axes = figure.add_subplot(3, 1, row + 1, sharex=first)
        first = first or axes
        plain_axes(axes, x="time, s" if row == 2 else "", y=label, title=title if row == 0 else "")
        for joint in range(n):
            curve(axes, motion.t, values[:, joint] * factor[joint], joint, joint_text(names[joint]))
        for begin, end in zip(motion.arrivals[1:], motion.departures[1:], strict=True):
            if end > begin:
                axes.axvspan(begin, end, color=FAINT, alpha=0.13, linewidth=0)
        axes.set_xlim(0, motion.duration)
        if row == 0:
            legend(axes, loc="center left", bbox_to_anchor=(1.0, 0.5))
    return figure


def joint_text(name: str) -> str:
    """Return a joint's name as it is written on a figure: joint_3 becomes theta 3 of the papers, other names stay."""
    if name.startswith("joint_") and name[6:].isdigit():
        return f"$q_{{{name[6:]}}}$"
    return name


def _point_axis(axes: Axes, n: int) -> None:
    margin = 0.015 * max(n - 1, 1)
    axes.set_xlim(1 - margin, max(n, 2) + margin)


def _groups(prismatic: np.ndarray) -> list[tuple[np.ndarray, float, str]]:
    groups = [
        (np.flatnonzero(~prismatic), 180 / np.pi, "joint angle, deg"),
        (np.flatnonzero(prismatic), MM, "joint position, mm"),
    ]
    return [g for g in groups if len(g[0])]
