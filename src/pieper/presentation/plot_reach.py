"""The workspace in two slices: where the tool can be, seen from the side and from above."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from pieper.drawing.skeleton import skeleton
from pieper.drawing.style import COLOURS, FAINT, INK, MM, new_figure, plain_axes
from pieper.tolerances import DRAWN_CELL, NO_DIRECTION, UPRIGHT_AXIS

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from pieper.presentation.arm import Arm

#: Joint vectors drawn for a picture of the reach.
SAMPLES = 200_000
#: Cells along the longer side of a slice.
CELLS = 150
#: How narrow a slice is drawn at least, in parts of its longer side: the marks of a flat one need the room.
NARROWEST = 0.2


def reach_samples(arm: Arm, *, samples: int = SAMPLES, seed: int = 1) -> np.ndarray:
    """Return tool positions (k, 3), m, of joint vectors drawn evenly inside the limits, at most a turn.

    When the first joint turns about an upright axis it is held at the middle of its range: its sweep is known.
    """
    low, high = joint_range(arm)
    if is_upright(arm):
        low[0] = high[0] = (low[0] + high[0]) / 2
    rng = np.random.default_rng(seed)
    points = []
    for _ in range(max(1, samples // 50_000)):
        q = low + (high - low) * rng.random((min(samples, 50_000), arm.n))
        points.append(arm.fk(q)[:, :3, 3])
    return np.concatenate(points)


def is_upright(arm: Arm) -> bool:
    """Return whether the first joint turns about an axis along z."""
    return bool(abs(arm.chain.axes[0][2]) > UPRIGHT_AXIS and arm.joint_types[0] == "R")


def joint_range(arm: Arm) -> tuple[np.ndarray, np.ndarray]:
    """Return the range (n,), (n,) a joint is drawn from: its limits, at most a turn wide; rad or m."""
    low, high = arm.limits[:, 0].copy(), arm.limits[:, 1].copy()
    for i, kind in enumerate(arm.joint_types):
        if kind == "R":
            if not (np.isfinite(low[i]) and np.isfinite(high[i])) or high[i] - low[i] > 2 * np.pi:
                low[i], high[i] = -np.pi, np.pi
        else:
            low[i] = low[i] if np.isfinite(low[i]) else 0.0
            high[i] = high[i] if np.isfinite(high[i]) else low[i] + arm.chain.length
    return low, high


def reach_figure(arm: Arm, *, points: np.ndarray | None = None, q: np.ndarray | None = None) -> Figure:
    """Draw where the tool can be: turned into one half plane through the first axis, and a slice from above.

    Args:
        arm: The arm.
        points: (k, 3) tool positions, m, for example from `reach_samples`; drawn here when left out.
        q: (n,) a posture whose arm is drawn into the pictures for scale.

    Returns:
        The figure. Cells are shaded by how many of the evenly drawn postures end in them.
    """
    points = reach_samples(arm) if points is None else points
    upright, foot = is_upright(arm), arm.chain.points[0]
    line = skeleton(arm.description, np.zeros(arm.n) if q is None else q).polyline
    figure = new_figure(8.6, 4.3)
    if upright:
        radius = np.hypot(points[:, 0] - foot[0], points[:, 1] - foot[1])
        side = np.stack([radius, points[:, 2]], 1)
        # the posture is shown with its radius signed by where its tool points
        ahead = line[-1, :2] - foot[:2]
        ahead = ahead / np.linalg.norm(ahead) if np.linalg.norm(ahead) > NO_DIRECTION else np.array([1.0, 0.0])
        drawn = np.stack([(line[:, :2] - foot[:2]) @ ahead, line[:, 2]], 1)
        labels = ("distance from the first axis, mm", "z, mm")
    else:
        side, drawn, labels = points[:, [0, 2]], line[:, [0, 2]], ("x, mm", "z, mm")
    _slice(figure.add_subplot(1, 2, 1), side, drawn, labels, "from the side")
    height = float(np.median(points[:, 2]))
    thick = 0.04 * float(np.ptp(points[:, 2])) + NO_DIRECTION
    near = np.abs(points[:, 2] - height) <= thick
    flat = round(thick * MM) == 0
    title = f"from above, z = {height * MM:z.0f}" + ("" if flat else f" ± {thick * MM:z.0f}") + " mm"
    above = points[near][:, :2]
    if upright:
        above = _swept(arm, above - foot[:2], foot[:2])
    _slice(figure.add_subplot(1, 2, 2), above, None, ("x, mm", "y, mm"), title)
    return figure


def _swept(arm: Arm, cloud: np.ndarray, foot: np.ndarray) -> np.ndarray:
    """Turn a cloud (k, 2) about the first axis through all the range of that joint."""
    low, high = joint_range(arm)
    half = (high[0] - low[0]) / 2
    few = cloud[:: max(1, len(cloud) // 12_000)]
    few = np.tile(few, (max(1, 1_000_000 // max(len(few), 1)), 1))
    turn = np.random.default_rng(2).uniform(-half, half, len(few))
    c, s = np.cos(turn), np.sin(turn)
    return np.stack([c * few[:, 0] - s * few[:, 1], s * few[:, 0] + c * few[:, 1]], 1) + foot


def _slice(axes: Any, cloud: np.ndarray, line: np.ndarray | None, labels: tuple[str, str], title: str) -> None:
    from matplotlib.colors import LinearSegmentedColormap, LogNorm

    plain_axes(axes, x=labels[0], y=labels[1], title=title)
    cloud = cloud * MM
    low, high = cloud.min(0), cloud.max(0)
    cell = max(float((high - low).max()) / CELLS, DRAWN_CELL)
    bins = [np.arange(low[k] - 2 * cell, high[k] + 3 * cell, cell) for k in range(2)]
    counts, x, y = np.histogram2d(*cloud.T, bins=bins)
    shades = LinearSegmentedColormap.from_list("reach", ["#d6e9f5", "#56B4E9", "#0072B2"])
    shown = np.ma.masked_equal(counts.T, 0)
    if shown.count():
        axes.pcolormesh(x, y, shown, cmap=shades, norm=LogNorm(1, max(2, counts.max())), rasterized=True, linewidth=0)
        middle_x, middle_y = (x[1:] + x[:-1]) / 2, (y[1:] + y[:-1]) / 2
        axes.contour(middle_x, middle_y, _smooth(counts.T > 0), levels=[0.45], colors=INK, linewidths=1.0)
    if line is not None:
        axes.plot(*(line * MM).T, color=COLOURS[1], linewidth=2.6, solid_capstyle="round", marker="o", markersize=3.5)
    axes.axvline(0, color=FAINT, linewidth=0.8, linestyle=(0, (6, 2, 1, 2)))
    axes.set_aspect("equal")
    _widened(axes)


def _widened(axes: Any) -> None:
    """Give a slice that is flat, as a planar arm's is from the side, room for the numbers along its short side."""
    sides = {"x": axes.get_xlim(), "y": axes.get_ylim()}
    least = NARROWEST * max(high - low for low, high in sides.values())
    for name, (low, high) in sides.items():
        if high - low < least:
            axes.set(**{f"{name}lim": ((low + high - least) / 2, (low + high + least) / 2)})
            axes.locator_params(axis=name, nbins=2)


def _smooth(filled: np.ndarray) -> np.ndarray:
    out = np.pad(filled.astype(float), 1, mode="edge")
    for _ in range(2):
        out = (out[:-2] + 2 * out[1:-1] + out[2:]) / 4
        out = (out[:, :-2] + 2 * out[:, 1:-1] + out[:, 2:]) / 4
        out = np.pad(out, 1, mode="edge")
    return out[1:-1, 1:-1]
