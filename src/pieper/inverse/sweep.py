"""All solutions of one pose over the whole range of a redundant coordinate, slice by slice, finer where they change."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper.inverse.plan import Plan
from pieper.inverse.reduced import full_rows
from pieper.inverse.solutions import TURN

#: Slices over the range to begin with: many where one prepared kernel serves all values, few where each needs its own.
SLICES, SLICES_PREPARED = 96, 24
#: An interval is halved where solutions appear or vanish or move farther than this (rad; per length) ...
FAR = 0.3
#: ... at most so often, and never with more new slices in all than this.
HALVINGS, HALVINGS_PREPARED, MOST_NEW = 5, 2, 400


@dataclass(frozen=True, eq=False)
class Sweep:
    """Solutions of one pose, slice by slice.

    Args:
        values: (V,) of the redundant coordinate, ascending, rad or m.
        q: (V, M, n) rows of each slice, the task's virtual joints included.
        valid: (V, M).
        after: (V - 1, M) the row of the next slice that continues a row, or -1 where it ends or that is in doubt.
    """

    values: np.ndarray
    q: np.ndarray
    valid: np.ndarray
    after: np.ndarray

    @property
    def before(self) -> np.ndarray:
        """(V - 1, M) the row of slice i that leads to a row of slice i + 1, or -1."""
        out = np.full_like(self.after, -1)
        slices, rows = np.nonzero(self.after >= 0)
        out[slices, self.after[slices, rows]] = rows
        return out


def sweep(plan: Plan, T: np.ndarray, coordinate: int, values: np.ndarray) -> Sweep:
    """Solve a pose (4, 4) at slices of one redundant coordinate.

    A turning coordinate is swept all the way round, a sliding one within its limits; intervals in which solutions
    appear, vanish or move far are halved, so that what continues what is seen.

    Args:
        plan: A plan with redundancy.
        T: The pose.
        coordinate: Which of the redundant coordinates is swept (index into `plan.redundancy`).
        values: (k,) of all of them; the others stay.
    """
    prepared = plan.reduction.at_ends is None
    lower, upper = span(plan, plan.reduction.locked[coordinate])
    at = np.linspace(lower, upper, SLICES_PREPARED if prepared else SLICES)
    q, valid = _slices(plan, T, coordinate, values, at)
    new = 0
    for _ in range(HALVINGS_PREPARED if prepared else HALVINGS):
        after, moved = _continued(plan, q, valid)
        ends = (valid[:-1] & (after < 0)).any(1) | (valid[1:].sum(1) > (after >= 0).sum(1)) | (moved > FAR)
        halved = np.flatnonzero(ends & (np.diff(at) > 1e-6))[: MOST_NEW - new]
        if not len(halved):
            break
        new += len(halved)
        middle = (at[halved] + at[halved + 1]) / 2
        rows, ok = _slices(plan, T, coordinate, values, middle)
        at = np.insert(at, halved + 1, middle)
        q, valid = np.insert(q, halved + 1, rows, axis=0), np.insert(valid, halved + 1, ok, axis=0)
    return Sweep(at, q, valid, _continued(plan, q, valid)[0])


def span(plan: Plan, joint: int) -> tuple[float, float]:
    """Return over what a redundant joint (0-based, virtual ones included) is swept: a turn, or its limits."""
    if not plan.reduction.full.prismatic[joint]:
        return -np.pi, np.pi
    lower, upper = plan.full_limits[joint]
    reach = 2 * plan.chain.length
    return max(lower, -reach), min(upper, reach)


def _slices(plan: Plan, T: np.ndarray, coordinate: int, values: np.ndarray, at: np.ndarray):
    held = np.tile(values, (len(at), 1))
    held[:, coordinate] = at
    most = plan.spec.max_solutions
    q, valid, _ = full_rows(plan, np.tile(T, (len(at), 1, 1)), held, 1)
    if q.shape[1] < most:  # kernels prepared for a value may give fewer rows than the plan's own
        q = np.pad(q, ((0, 0), (0, most - q.shape[1]), (0, 0)))
        valid = np.pad(valid, ((0, 0), (0, most - valid.shape[1])))
    return q[:, :16], valid[:, :16]


def _continued(plan: Plan, q: np.ndarray, valid: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return for each row its mutually nearest row of the next slice (V - 1, M), or -1, and the farthest move (V - 1,)."""
    full = plan.reduction.full
    gap = q[:-1, :, None] - q[1:, None, :]
    gap = np.where(full.prismatic, gap / plan.chain.length, (gap + np.pi) % TURN - np.pi)
    distance = np.sqrt(np.sum(gap * gap, -1))
    distance = np.where(valid[:-1, :, None] & valid[1:, None, :], distance, np.inf)
    there, back = distance.argmin(2), distance.argmin(1)
    rows = np.arange(q.shape[1])
    nearest = np.take_along_axis(distance, there[..., None], 2)[..., 0]
    mutual = (np.take_along_axis(back, there, 1) == rows) & np.isfinite(nearest)
    after = np.where(mutual & (nearest < 2.0), there, -1)
    return after, np.where(mutual, nearest, 0.0).max(1, initial=0.0)
