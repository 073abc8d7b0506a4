"""Where a path leads farther away than the arm's links reach, however the tool is turned or tilted there."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.kinematics.chain import Chain
from pieper.motion.route.setting import Setting
from pieper.tolerances import REACH_ROUNDING, TINY

#: Rounds in which the points are moved along their axes; the bound holds after any of them.
ROUNDS = 40


def reach(chain: Chain, limits: Array) -> tuple[Array, float]:
    """Return a point (3,) of the first axis and a distance, m, that the tool's point is never farther away from it.

    With a point on each axis the ways from one to the next add up, and slides at their longest. The points are moved
    along their axes so that the sum is small (least squares weighed anew: Weiszfeld), which leaves it a bound.
    """
    n = chain.n
    A, o = chain.axes, np.vstack([chain.points, chain.home[:3, 3]])
    u = np.zeros(n)

    def ways(u: Array) -> Array:
        moved = o.copy()
        moved[:-1] += u[:, None] * A
        return np.asarray(np.diff(moved, axis=0), np.float64)

    rate = np.zeros((n, n, 3))
    for j in range(n):
        rate[j, j] -= A[j]
        if j:
            rate[j - 1, j] += A[j]
    best, least = u, float(np.linalg.norm(ways(u), axis=1).sum())
    for _ in range(ROUNDS):
        t = ways(u)
        w = 1 / np.maximum(np.linalg.norm(t, axis=1), TINY**0.25)
        H = np.einsum("k,kic,kjc->ij", w, rate, rate)
        u = u - np.linalg.lstsq(H, np.einsum("k,kic,kc->i", w, rate, t), rcond=None)[0]
        total = float(np.linalg.norm(ways(u), axis=1).sum())
        if total < least:
            best, least = u, total
    slides = np.where(chain.prismatic, np.abs(limits).max(1), 0.0)
    return chain.points[0] + best[0] * A[0], (least + float(slides.sum())) * (1 + REACH_ROUNDING)


def beyond_reach(setting: Setting) -> tuple[float, float] | None:
    """Return where (s) the path leads beyond the reach of all links, and by how much at the farthest (m); or None."""
    plan = setting.plan
    centre, far = reach(plan.chain.uncoupled, _slides(setting))
    if not np.isfinite(far):
        return None
    p = setting.asked[:, :3, 3]
    beyond = np.linalg.norm(p - centre, axis=1) - far
    if beyond.max() <= 0:
        return None
    k = int(np.argmax(beyond > 0))
    if k == 0:
        return 0.0, float(beyond.max())
    # on the line from the last point inside
    d, e = p[k] - p[k - 1], p[k - 1] - centre
    dd, de = float(d @ d), float(d @ e)
    part = (np.sqrt(max(de * de - dd * (float(e @ e) - far * far), 0.0)) - de) / dd
    return float(setting.s[k - 1] + part * (setting.s[k] - setting.s[k - 1])), float(beyond.max())


def _slides(setting: Setting) -> Array:
    """Return the limits (n, 2) of the axes' own values; of coupled joints none are known."""
    plan = setting.plan
    return plan.limits if plan.chain.coupling is None else np.where(plan.prismatic[:, None], np.inf, plan.limits)
