"""Every curve of postures at a pose that comes inside the limits, traced once each."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from pieper.kinematics.arrays import Array, Bools, Indices
from pieper.motion.route.front import FINER
from pieper.motion.route.grid import grid
from pieper.motion.route.setting import Setting
from pieper.solver.redundant.bounded_motion import BoundedMotion, bounded_motion
from pieper.solver.redundant.self_motions import on_curve
from pieper.solver.redundant.stops import stops
from pieper.solver.singular.trace import MOST_STEPS, trace
from pieper.solver.singular.traced_motion import TracedMotion

#: Rows of neighbouring cells that are this near (rad; lengths) are of one curve.
LINKED = 0.15


def curves_at(setting: Setting, T: Array) -> Iterator[BoundedMotion]:
    """Yield the curves at a pose (4, 4), one coordinate free, with the points at which they meet limits.

    A curve that comes inside the limits either meets one, and is found where it does, or is inside all the way round,
    and is found by the rows of a grid of a degree.
    """
    plan = setting.curves
    full, limits = plan.exact.full, setting.limits
    ends, inside = setting.chain.joints.inside_limits(
        setting.joints_at(stops(plan, T[None], every_turn=True).q), limits
    )
    ends = ends[inside]
    x, valid = grid(setting, FINER).rows(T[None])
    valid &= setting.chain.joints.inside_limits(x, setting.limits)[1]
    seeds = np.concatenate([ends, _few_each(setting, x[0], valid[0])])
    while len(seeds):
        # the axes' curve, and the same of coupled joints
        along = setting.axes_at(seeds)
        motion = trace(full, along[0], T, limits, plan.full_names, shown=plan.n, most_steps=MOST_STEPS)
        seeds = seeds[1:][~on_curve(motion, along[1:])]
        if setting.coupling is not None:
            points = setting.joints_at(motion.samples)
            motion = TracedMotion(
                setting.chain, T, points, motion.closed, motion.dimension, limits, motion.names, motion.shown
            )
        yield bounded_motion(motion, ends)


def _few_each(setting: Setting, x: Array, valid: Bools) -> Array:
    """Return the first, the middle and the last of the rows x (C, B, m) of each chain that goes from cell to cell."""
    joints = setting.chain.joints
    ever = valid.any(0)
    if not ever.any():
        return x[:0, 0]
    x, valid = x[:, ever], valid[:, ever]
    near = joints.apart(x[:-1, :, None], x[1:, None])
    near = np.where(valid[:-1, :, None] & valid[1:, None], near, np.inf)
    after: Indices = near.argmin(-1)
    goes = near.min(-1) < LINKED
    chain = np.full(valid.shape, -1, np.int64)
    begins: Indices = np.flatnonzero(valid[0])
    chain[0, begins] = np.arange(len(begins))
    count = len(begins)
    for k in range(1, len(x)):
        rows = np.flatnonzero(goes[k - 1] & (chain[k - 1] >= 0))
        chain[k, after[k - 1, rows]] = chain[k - 1, rows]
        new = np.flatnonzero(valid[k] & (chain[k] < 0))
        chain[k, new] = count + np.arange(len(new))
        count += len(new)
    cell, row = np.nonzero(valid)
    order = np.argsort(chain[cell, row], kind="stable")
    cell, row = cell[order], row[order]
    edges = np.searchsorted(chain[cell, row], np.arange(count + 1))
    picked = np.unique(np.concatenate([edges[:-1], (edges[:-1] + edges[1:]) // 2, edges[1:] - 1]))
    return x[cell[picked], row[picked]]
