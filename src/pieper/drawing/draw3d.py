"""Pencils for 3-D figures: axes in millimetres, arms, frames, joint drums, floor shadow."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from pieper.drawing.skeleton import Skeleton
from pieper.drawing.style import AXES, FAINT, GRID, INK, MM
from pieper.tolerances import NO_LENGTH

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Inches above a 3-D picture for its title of one or two lines, beside it, and below it for its labels; how much of
#: its height is empty below.
TITLE, SIDE, LABELS, HANGS = 0.36, 0.08, 0.5, 0.11


def space_axes(
    figure: Figure,
    position: tuple[int, int, int],
    centre: np.ndarray,
    half: float,
    *,
    title: str = "",
    view: tuple[float, float] = (22.0, -58.0),
    floor: bool = True,
) -> Any:
    """Add 3-D axes in millimetres with equal scales and return them.

    Args:
        figure: The figure.
        position: Rows, columns and number of the picture, as `add_subplot` takes them.
        centre: (3,) middle of the picture, m.
        half: Half the side of the cube shown, m.
        title: Text above, left.
        view: Elevation and azimuth, deg.
        floor: Whether the lower side is kept at z = 0 when that is near.
    """
    from matplotlib import rc_context

    with rc_context({"grid.color": GRID, "grid.linewidth": 0.6}):  # 3-D axes read these when they are made
        axes: Any = figure.add_subplot(*position, projection="3d")
    # the order is ours: a drum lies over its link, a name over everything
    axes.computed_zorder = False
    low, high = (centre - half) * MM, (centre + half) * MM
    if floor and -0.5 * half * MM < low[2] < 0.35 * half * MM:
        low[2], high[2] = 0.0, 2 * half * MM
    axes.set_xlim(low[0], high[0])
    axes.set_ylim(low[1], high[1])
    axes.set_zlim(low[2], high[2])
    axes.set_box_aspect((1, 1, 1), zoom=0.92)
    axes.set_proj_type("persp", focal_length=0.9)
    axes.view_init(*view)
    for axis, name in ((axes.xaxis, "x"), (axes.yaxis, "y"), (axes.zaxis, "z")):
        axis.set_pane_color((0.975, 0.98, 0.985, 1.0))
        axis.line.set_color(FAINT)
        axis.set_tick_params(labelsize=8, colors=INK, pad=0)
        axis.set_major_locator(_locator())
        axis.set_label_text(f"{name}, mm", color=INK, fontsize=9)
    if title:
        axes.set_title(title, color=INK, fontsize=11, loc="left")
    placed(figure)
    return axes


def placed(figure: Figure) -> None:
    """Lay a figure of 3-D pictures alone out by inches: what surrounds each is known, and asking it costs a drawing."""
    figure.set_layout_engine(None)
    width, height = figure.get_size_inches()
    place: Any = figure.axes[0].get_subplotspec()
    rows, columns = place.get_gridspec().get_geometry()
    titled = any(figure.axes[0].get_title(loc=where) for where in ("left", "center"))
    title = TITLE if rows * columns > 1 or titled else 0.0
    tall = height / rows - title
    # the lower end of a picture is empty but for its labels: it may hang over the edge, and over the title below
    hangs = HANGS * tall - LABELS
    figure.subplots_adjust(
        left=SIDE / width,
        right=1 - SIDE / width,
        bottom=-hangs / height,
        top=1 - title / height,
        wspace=0.0,
        hspace=(title - hangs) / (tall + hangs),
    )


def _locator() -> Any:
    from matplotlib.ticker import MaxNLocator

    return MaxNLocator(nbins=5, steps=[1, 2, 2.5, 5, 10])


def draw_arm(
    axes: Any,
    parts: Skeleton,
    size: float,
    *,
    colour: str = "#5d6d7c",
    alpha: float = 1.0,
    solid: bool = True,
    order: float = 5,
) -> None:
    """Draw an arm.

    Args:
        axes: 3-D axes in millimetres.
        parts: The arm in its posture.
        size: The arm's size, m; joint drums are drawn in proportion.
        colour: Of the links.
        alpha: 1 opaque, less for ghosts.
        solid: Whether joint drums are drawn.
        order: Drawing order; higher is later.
    """
    line = parts.polyline * MM
    if solid:
        axes.plot(
            *line.T,
            color="white",
            linewidth=9,
            solid_capstyle="round",
            solid_joinstyle="round",
            zorder=order,
            alpha=alpha,
        )
    axes.plot(
        *line.T,
        color=colour,
        linewidth=6.5 if solid else 2.6,
        solid_capstyle="round",
        solid_joinstyle="round",
        zorder=order + 0.1,
        alpha=alpha,
    )
    if solid:
        axes.plot(*line.T, color="white", linewidth=1.4, solid_capstyle="round", alpha=0.5 * alpha, zorder=order + 0.2)
        for centre, direction in zip(parts.centres, parts.directions, strict=True):
            _drum(axes, centre * MM, direction, 0.030 * size * MM, 0.078 * size * MM, alpha, order + 0.3)


def _drum(axes: Any, centre: Any, direction: Any, radius: float, length: float, alpha: float, order: float) -> None:
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    side = np.cross(direction, [1.0, 0, 0] if abs(direction[0]) < 0.8 else [0, 1.0, 0])
    side /= np.linalg.norm(side)
    other = np.cross(direction, side)
    angle = np.linspace(0, 2 * np.pi, 25)
    ring = radius * (np.cos(angle)[:, None] * side + np.sin(angle)[:, None] * other)
    top, bottom = centre + direction * length / 2 + ring, centre - direction * length / 2 + ring
    normals = np.cos(angle[:-1] + np.pi / 24)[:, None] * side + np.sin(angle[:-1] + np.pi / 24)[:, None] * other
    light = np.array([0.35, -0.6, 0.72])
    shade = np.clip(0.60 + 0.36 * np.concatenate([normals @ light, [direction @ light, -direction @ light]]), 0.3, 1.0)
    faces = [np.array([top[k], top[k + 1], bottom[k + 1], bottom[k]]) for k in range(24)] + [top, bottom]
    base = np.array([0.94, 0.62, 0.16])
    colours = [(*np.clip(base * s, 0, 1), alpha) for s in shade]
    edge = [(*c[:3], alpha) for c in colours[:-2]] + [(0.35, 0.2, 0.02, alpha)] * 2
    axes.add_collection3d(Poly3DCollection(faces, facecolors=colours, edgecolors=edge, linewidths=0.5, zorder=order))


def draw_axes_lines(axes: Any, parts: Skeleton, size: float) -> None:
    """Draw the joint axes as dash-dotted centre lines with their names z1, z2 ..."""
    reach = 0.11 * size
    placed: list[np.ndarray] = []
    for i, (centre, direction) in enumerate(zip(parts.centres, parts.directions, strict=True)):
        ends = np.array([centre - direction * reach, centre + direction * reach]) * MM
        axes.plot(*ends.T, color=INK, linewidth=0.9, linestyle=(0, (6, 2, 1, 2)), zorder=8)
        tip = (centre + direction * reach * 1.22) * MM
        if any(_on_segment(tip, a * MM, b * MM, 0.03 * size * MM) for a, b in _segments(parts)):
            tip = (centre - direction * reach * 1.22) * MM
        while any(np.linalg.norm(tip - p) < 0.05 * size * MM for p in placed):
            tip = tip + direction * 0.055 * size * MM
        placed.append(tip)
        text(axes, tip, f"$q_{{{i + 1}}}$")


def _segments(parts: Skeleton) -> list[tuple[np.ndarray, np.ndarray]]:
    line = parts.polyline
    return list(zip(line[:-1], line[1:], strict=True))


def _on_segment(point: np.ndarray, a: np.ndarray, b: np.ndarray, near: float) -> bool:
    along = b - a
    share = np.clip((point - a) @ along / max(along @ along, NO_LENGTH), 0.0, 1.0)
    return bool(np.linalg.norm(a + share * along - point) < near)


def draw_frame(
    axes: Any,
    T: np.ndarray,
    length: float,
    *,
    names: bool = False,
    width: float = 1.8,
    alpha: float = 1.0,
    order: float = 9,
) -> None:
    """Draw a frame (4, 4) as three arrows, length in m, with the letters x, y, z when named."""
    origin = T[:3, 3] * MM
    for k, (colour, name) in enumerate(zip(AXES, "xyz", strict=True)):
        tip = origin + T[:3, k] * length * MM
        axes.plot(
            *np.array([origin, tip]).T, color=colour, linewidth=width, zorder=order, alpha=alpha, solid_capstyle="round"
        )
        if names:
            at = origin + T[:3, k] * length * 1.28 * MM
            text(axes, at, f"${name}$", colour)


def text(axes: Any, at: np.ndarray, words: str, colour: str = INK, **options: Any) -> None:
    """Write words at a point (3,), mm, with a white halo so that they stay readable over lines."""
    from matplotlib.patheffects import withStroke

    options = {"fontsize": 9, "ha": "center", "va": "center"} | options
    halo = [withStroke(linewidth=2.4, foreground="white")]
    axes.text(*at, words, color=colour, zorder=30, path_effects=halo, **options)


def draw_shadow(axes: Any, parts: Skeleton) -> None:
    """Draw the arm's shadow on the lower side of the picture."""
    line = parts.polyline * MM
    low = axes.get_zlim()[0]
    axes.plot(line[:, 0], line[:, 1], low, color="#000000", linewidth=4, alpha=0.08, solid_capstyle="round", zorder=1)
