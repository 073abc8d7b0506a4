"""Proven bounds of the tool's speed and acceleration on each piece of a curve."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array, Indices
from pieper.motion.profile import Profile
from pieper.motion.tool_bounds import ToolCurve


def vector_peaks(value: Array, strays: Array, x: Array) -> Array:
    """Return a bound (k,) of |f(s)| sqrt(x) on each piece, f within `strays` of the line between its ends' values.

    Args:
        value: (k + 1, 3) f at the pieces' ends.
        strays: (k,) how far f may be from the line between.
        x: (k + 1,) linear on each piece.
    """
    a, b = value[:-1], value[1:]
    aa, ab, bb = (a * a).sum(1), (a * b).sum(1), (b * b).sum(1)
    x0, x1 = x[:-1], x[1:]
    # Bernstein coefficients of |line|^2 x, a cubic
    top = np.max([aa * x0, (2 * ab * x0 + aa * x1) / 3, (bb * x0 + 2 * ab * x1) / 3, bb * x1], axis=0)
    return np.sqrt(np.maximum(top, 0.0)) + strays * np.sqrt(np.maximum(x0, x1))


def tool_acceleration_peaks(tool: ToolCurve, h: Array, x: Array) -> Array:
    """Return a bound (k,) of the tool point's acceleration p' u + p'' x on each piece.

    Its second derivative by s is 5 u p''' + x p'''', whose bounds say how far it departs from the larger of its ends.
    """
    u = np.diff(x) / (2 * h)
    ends = [np.linalg.norm(tool.point[k] * u[:, None] + tool.bend[k] * x[k][:, None], axis=1) for k in _ENDS]
    bent = 5 * np.abs(u) * tool.third + np.maximum(x[:-1], x[1:]) * tool.fourth
    return np.maximum(*ends) + h**2 / 8 * bent


def tool_acceleration_in_time(
    tool: ToolCurve, cell: Indices, point: Array, bend: Array, profile: Profile, fastest: Array | None
) -> Array:
    """Return a bound (k,) of the tool point's acceleration on each piece of a profile that lies on one cell of a grid.

    Its second derivative by time is p4 v^4 + 6 p3 v^2 a + p2 (3 a^2 + 4 v j): p2, p3 and p4 the second to fourth
    derivative of the point by s; v, a and j those of s by time. An eighth of it, times the piece's length squared, is
    how far it departs from the larger of its ends.

    Args:
        tool: What bounds the tool on the grid's cells.
        cell: (k,) the cell of each piece.
        point: (k + 1, 3) p' where pieces begin and end, m.
        bend: (k + 1, 3) p'' there, m.
        profile: s(t) in k pieces.
        fastest: (k,) bounds of ds/dt on each piece; None where the ends alone are asked for.
    """
    h = np.diff(profile.t)
    _, v, a, j = profile.c.T
    last = v + h * (a + h * j / 2), a + h * j
    sizes = [
        np.linalg.norm(p * over[:, None] + d * (rate * rate)[:, None], axis=1)
        for p, d, rate, over in ((point[:-1], bend[:-1], v, a), (point[1:], bend[1:], *last))
    ]
    if fastest is None:
        return np.maximum(*sizes)
    most = np.maximum(np.abs(a), np.abs(last[1]))
    size = np.linalg.norm(bend, axis=1)
    bent = tool.fourth[cell] * fastest**4 + 6 * tool.third[cell] * fastest**2 * most
    bent += (np.maximum(size[:-1], size[1:]) + tool.third[cell] * h * fastest) * (3 * most**2 + 4 * fastest * np.abs(j))
    return np.maximum(*sizes) + h**2 / 8 * bent


_ENDS = (slice(None, -1), slice(1, None))
