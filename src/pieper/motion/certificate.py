"""Proven bounds of the tool's speed and acceleration on each piece of a curve."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array
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


_ENDS = (slice(None, -1), slice(1, None))
