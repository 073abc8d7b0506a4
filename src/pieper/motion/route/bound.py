"""A cost that no route along a path can undercut: by how little joints can move while the tool does what it must."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.kinematics.chain import Chain
from pieper.motion.route.setting import Setting


def least_motion(setting: Setting, largest: bool) -> float:
    """Return a lower bound of the cost of any route.

    Over a step the tool's point moves by |dp| at least along its chord. A turning joint moves it by no more than its
    angle times the point's largest distance from its axis; so does a slide by its length. With levers r, Cauchy's
    inequality gives a sum of squares of at least |dp|^2 / sum(r^2), and the largest difference at least |dp| / sum(r).
    """
    chain = setting.plan.chain
    dp = np.linalg.norm(np.diff(setting.asked[:, :3, 3], axis=0), axis=1)
    r = levers(chain, setting.asked[:, :3, 3], setting.plan.limits)
    r = np.maximum(r[:-1], r[1:]) + dp[:, None] * (np.arange(chain.n) == 0)
    unit = chain.joints.unit
    r = np.where(chain.prismatic, 1.0, r)
    if chain.coupling is not None:
        # a joint moves the axes that it is coupled to
        r = r @ np.abs(chain.coupling)
    r = r * unit
    if largest:
        return float(np.sum(dp / r.sum(1)))
    return float(np.sum(dp**2 / np.sum(r**2, axis=1)))


def levers(chain: Chain, p: Array, limits: Array) -> Array:
    """Return the largest distance (N, n) that points p (N, 3) of the tool can have from each joint's axis, m."""
    out = np.empty((len(p), chain.n))
    # behind joint j the links add up, slides at their longest; the first axis stands still
    slides = np.where(chain.prismatic, np.abs(np.where(np.isfinite(limits), limits, np.inf)).max(1), 0.0)
    length = float(np.linalg.norm(chain.links[-1][:3, 3]))
    for j in range(chain.n - 1, -1, -1):
        out[:, j] = length
        length += float(np.linalg.norm(chain.links[j][:3, 3])) + float(slides[j])
    gap = p - chain.points[0]
    along = gap @ chain.axes[0]
    first = np.sqrt(np.maximum(np.sum(gap**2, axis=1) - along**2, 0.0))
    if not chain.prismatic[0]:
        out[:, 0] = np.minimum(out[:, 0], first)
    return out
