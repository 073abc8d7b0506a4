"""Pictures of a lesson: the frames of a DH table moved one transformation at a time, the triangle of two links."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from pieper.drawing.style import AXES, COLOURS, FAINT, INK, MM, new_figure
from pieper.kinematics.joints import short_way

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from pieper.equations.triangle import Triangle
    from pieper.presentation.arm import Arm

Matrix = npt.NDArray[np.float64]
AZIMUTH, ELEVATION = np.radians(28.0), np.radians(24.0)  # from where the frames are seen
ROWS = 4  # of a table in one picture
HEAD = 0.055  # length of an arrow's head, in panels
WHITE = {"bbox": {"facecolor": "white", "edgecolor": "none", "pad": 1.0}}  # behind words that a line may run under
SHIFT = 1.25  # of the longest shift of a row, in axes' lengths


def dh_steps_figure(arm: Arm, q: Matrix, first: int = 0, last: int | None = None) -> Figure:
    """Draw how each row of the DH table moves its frame: theta, d, a and alpha in the convention's order.

    Args:
        arm: The arm.
        q: (n,) posture, rad or m, whose joint values are drawn.
        first: The first row (0-based).
        last: The row after the last one; all rows when left out.

    Returns:
        The figure, a line a row, a column a transformation.
    """
    rows = range(first, arm.n if last is None else last)
    figure = new_figure(7.2, 1.72 * len(rows))
    axes = figure.add_subplot(1, 1, 1)
    axes.set_axis_off()
    axes.set_xlim(-0.25, 4)
    axes.set_ylim(-len(rows), 0)
    for line, i in enumerate(rows):
        T, panels, titles = np.eye(4), [], []
        moves = _moves(arm, q, i)
        longest = max(abs(size) for kind, _, size, _ in moves if kind == "shift")
        for kind, axis, size, words in moves:
            move = np.eye(4)
            if kind == "shift":
                move[axis, 3] = SHIFT * size / longest if longest else 0.0
            else:
                move[:3, :3] = _turn(axis, size)
            lines = _frame(T, 0.85 if not size else 0.3, names=not size)
            if size:
                lines += [_between(T, kind, axis, size, move), *_frame(T @ move, 0.95, names=True)]
            panels.append(lines)
            titles.append((words, FAINT if not size else INK))
            T = T @ move
        _drawn(axes, panels, titles, line)
        axes.text(-0.22, -line - 0.55, f"{i} → {i + 1}", fontsize=9, color=INK, va="center")
    return figure


def _drawn(axes: Any, panels: list[list[Line]], titles: list[tuple[str, str]], line: int) -> None:
    """The four pictures of a row, on the same piece of paper each, so that nothing jumps."""
    from matplotlib.lines import Line2D
    from matplotlib.patches import Polygon

    points = np.concatenate([part.points for lines in panels for part in lines])
    low, high = points.min(0), points.max(0)
    # a panel is 1 wide and 1 high in the axes' units, and 1.69 by 1.72 inches
    scale = 0.74 / max(high - low)
    for column, (lines, (words, colour)) in enumerate(zip(panels, titles, strict=True)):
        centre = np.array([column + 0.5, -line - 0.56])
        axes.text(column + 0.5, -line - 0.02, words, fontsize=8.5, color=colour, ha="center", va="top")
        for part in lines:
            at = centre + scale * (part.points - (low + high) / 2)
            if part.letter:
                axes.text(*at[0], part.letter, fontsize=7.5, color=part.colour, ha="center", va="center")
                continue
            # `plot` would look for limits, units and colours that are settled here, five times as long
            stroke = Line2D(*at.T, color=part.colour, alpha=part.alpha, linewidth=1.4, linestyle=part.dashes)
            axes.add_artist(stroke)
            if part.arrow:
                along = (at[-1] - at[0]) / (np.linalg.norm(at[-1] - at[0]) or 1.0)
                if np.linalg.norm(at[-1] - at[0]) > HEAD:
                    side = HEAD * 0.4 * np.array([along[1], -along[0]])
                    head = np.array([at[-1], at[-1] - HEAD * along + side, at[-1] - HEAD * along - side])
                    axes.add_artist(Polygon(head, color=part.colour, alpha=part.alpha, linewidth=0))


def _moves(arm: Arm, q: Matrix, i: int) -> list[tuple[str, int, float, str]]:
    """(kind, axis, size, words) of a row's four transformations in their order."""
    d = arm.description
    row, number = d.rows[i], i + 1
    before = number if d.convention == "standard" else i
    moved = float(d.sign[i] * q[i] + d.offset[i])
    revolute = arm.joint_types[i] == "R"
    theta = row.theta + (moved if revolute else 0.0)
    shift = row.d + (0.0 if revolute else moved)

    def degrees(letter: str, index: int, value: float, axis: str) -> str:
        return f"{letter}{_index(index)} = {np.degrees(value):.4g}° about {axis}".replace("-", "−")

    def length(letter: str, index: int, value: float, axis: str) -> str:
        return f"{letter}{_index(index)} = {value * MM:.4g} mm along {axis}".replace("-", "−")

    theta = float(short_way(theta))
    about_z = [
        ("turn", 2, theta, degrees("θ", number, theta, "z")),
        ("shift", 2, shift, length("d", number, shift, "z")),
    ]
    along_x = [
        ("shift", 0, row.a, length("a", before, row.a, "x")),
        ("turn", 0, row.alpha, degrees("α", before, row.alpha, "x")),
    ]
    return about_z + along_x if d.convention == "standard" else along_x[::-1] + about_z


def _index(number: int) -> str:
    return "".join(chr(0x2080 + int(c)) for c in str(number))


def _turn(axis: int, angle: float) -> Matrix:
    i, j = (axis + 1) % 3, (axis + 2) % 3
    R = np.eye(3)
    R[i, i] = R[j, j] = np.cos(angle)
    R[i, j], R[j, i] = -np.sin(angle), np.sin(angle)
    return R


def _seen(points: Matrix) -> Matrix:
    """Points (..., 3) on the paper (..., 2)."""
    ca, sa, ce, se = np.cos(AZIMUTH), np.sin(AZIMUTH), np.cos(ELEVATION), np.sin(ELEVATION)
    return np.asarray(points) @ np.array([[-sa, ca, 0.0], [-se * ca, -se * sa, ce]]).T


@dataclass(frozen=True)
class Line:
    """A stroke on the paper, or a letter at its first point."""

    points: Matrix
    colour: str
    alpha: float = 1.0
    dashes: Any = "-"
    arrow: bool = False
    letter: str = ""


def _frame(T: Matrix, alpha: float, *, names: bool) -> list[Line]:
    lines: list[Line] = []
    for k, (letter, colour) in enumerate(zip("xyz", AXES, strict=True)):
        lines.append(Line(_seen(np.array([T[:3, 3], T[:3, 3] + T[:3, k]])), colour, alpha, arrow=True))
        if names:
            lines.append(Line(_seen((T[:3, 3] + 1.17 * T[:3, k])[None]), colour, letter=letter))
    return lines


def _between(T: Matrix, kind: str, axis: int, size: float, move: Matrix) -> Line:
    """The path of the move: a dashed line, or the arc of an axis that turns."""
    if kind == "shift":
        return Line(_seen(np.array([T[:3, 3], (T @ move)[:3, 3]])), COLOURS[0], dashes=(0, (3, 1.5)))
    other = np.eye(3)[(axis + 1) % 3] * 0.62
    return Line(
        _seen(np.array([T[:3, 3] + T[:3, :3] @ _turn(axis, t) @ other for t in np.linspace(0, size, 30)])), COLOURS[0]
    )


def triangle_figure(triangle: Triangle, q: Matrix) -> Figure:
    """Draw the triangle of the law of cosines to scale at a posture, its sides and the angle at the elbow named.

    Args:
        triangle: The triangle, `equations.triangle.triangle_of`.
        q: (n,) posture, rad or m.

    Returns:
        The figure.
    """
    one, two, third, inner = triangle.first * MM, triangle.second * MM, triangle.third(q) * MM, triangle.inner(q)
    # the first corner at the origin, the third to the right of it, the elbow above
    x = (one**2 + third**2 - two**2) / (2 * third) if third else 0.0
    elbow = np.array([x, np.sqrt(max(one**2 - x**2, 0.0))])
    corners = np.array([[0.0, 0.0], elbow, [third, 0.0]])
    size = max(one, two, third)
    across, up = np.ptp(corners, axis=0) + np.array([0.5, 0.42]) * size
    figure = new_figure(5.2, float(np.clip(5.2 * up / across, 1.8, 5.0)))
    axes = figure.add_subplot(1, 1, 1)
    axes.plot(*corners[[0, 1]].T, color=COLOURS[0], linewidth=3, solid_capstyle="round")
    axes.plot(*corners[[1, 2]].T, color=COLOURS[1], linewidth=3, solid_capstyle="round")
    axes.plot(*corners[[0, 2]].T, color=FAINT, linewidth=1.6, linestyle=(0, (4, 2)))
    axes.plot(*corners.T, "o", color=INK, markersize=6, markerfacecolor="white", markeredgewidth=1.6)
    centre = corners.mean(0)
    names = (f"axis {triangle.shoulder}", f"axis {triangle.elbow}", triangle.end)
    for k, (words, side) in enumerate(zip(names, ("top", "bottom", "top"), strict=True)):
        x, y = corners[k] + np.array([0.0, -0.05 if side == "top" else 0.05]) * size
        axes.text(x, y, words, fontsize=9, color=INK, ha="center", va=side)
    for (i, j), words in (
        ((0, 1), f"L₁ = {one:z.1f} mm"),
        ((1, 2), f"L₂ = {two:z.1f} mm"),
        ((0, 2), f"r = {third:z.1f} mm"),
    ):
        middle = corners[[i, j]].mean(0)
        along = corners[j] - corners[i]
        across = np.array([along[1], -along[0]]) / (np.linalg.norm(along) or 1.0)
        across = across if across @ (middle - centre) > 0 else -across
        turn = np.degrees(np.arctan2(along[1], along[0]))
        x, y = middle + 0.05 * size * across
        axes.text(
            x,
            y,
            words,
            fontsize=9,
            color=INK,
            ha="center",
            va="center",
            rotation=turn,
            rotation_mode="anchor",
        )
    if inner > 0.02 and one and two:
        _angle(axes, corners, 0.16 * min(one, two, size), inner)
    axes.set_aspect("equal")
    axes.margins(0.12, 0.2)
    axes.set_axis_off()
    return figure


def _angle(axes: Any, corners: Matrix, radius: float, inner: float) -> None:
    """The arc of the angle inside at the elbow, with its letter and value."""
    start = np.arctan2(*(corners[0] - corners[1])[::-1])
    end = start + inner
    turns = np.linspace(start, end, 40)
    arc = corners[1] + radius * np.column_stack([np.cos(turns), np.sin(turns)])
    axes.plot(*arc.T, color=INK, linewidth=1.2)
    middle = (start + end) / 2
    place = corners[1] + 1.9 * radius * np.array([np.cos(middle), np.sin(middle)])
    axes.text(*place, f"γ = {np.degrees(inner):z.1f}°", fontsize=9, color=INK, ha="center", va="center", **WHITE)
