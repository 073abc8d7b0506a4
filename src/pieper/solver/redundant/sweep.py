"""All solutions of one pose over the whole range of a redundant coordinate, slice by slice, finer where they change."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper.kinematics.arrays import Array, Bools, Indices
from pieper.kinematics.joints import JointSpace
from pieper.kinematics.pose import stepped
from pieper.solver.arm_rows import full_rows
from pieper.solver.plan.plan import Plan
from pieper.solver.redundant.approach import held_or_beside, pulled
from pieper.tolerances import RELATIVE_ROUNDING, ROUNDING, SIDE_STEPS, SWEEP_FINEST

#: Slices over the range to begin with: many where one prepared kernel serves all values, few where each needs its own.
SLICES, SLICES_PREPARED = 96, 24
#: An interval is halved where solutions appear or vanish or move farther than this (rad; per length); rows farther
#: apart than the second number are not one branch.
FAR, LOST = 0.3, 2.0
#: How often an interval is halved at most, and the most new slices in all, for both kinds.
HALVINGS, MOST_NEW, HALVINGS_PREPARED, MOST_NEW_PREPARED = 5, 400, 2, 40
#: Rows of a slice that are looked at, at most: no family gives more.
MOST_ROWS = 16
#: Rows of a pose beside this one are known when one of this pose is so near; of the others, so many are followed.
KNOWN, MOST_FOLLOWED = 0.25, 150
#: By how much a side step shrinks from stage to stage when it is followed back, and how often.
FOLLOW_RATIO, FOLLOW_STAGES = 0.3, 13


@dataclass(frozen=True, eq=False)
class Sweep:
    """Solutions of one pose, slice by slice.

    Args:
        values: (V,) of the redundant coordinate, ascending, rad or m.
        q: (V, M, n) rows of each slice, the task's virtual joints included.
        valid: (V, M).
        after: (V - 1, M) the row of the next slice that continues a row, or -1 where it ends or that is in doubt.
    """

    values: Array
    q: Array
    valid: Bools
    after: Indices

    @property
    def before(self) -> Indices:
        """(V - 1, M) the row of slice i that leads to a row of slice i + 1, or -1."""
        out = np.full_like(self.after, -1)
        slices, rows = np.nonzero(self.after >= 0)
        out[slices, self.after[slices, rows]] = rows
        return out


def sweep(plan: Plan, T: Array, coordinate: int, values: Array) -> Sweep:
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
    after, doubt = _continued(plan, q[:-1], valid[:-1], q[1:], valid[1:])
    room = MOST_NEW_PREPARED if prepared else MOST_NEW
    for _ in range(HALVINGS_PREPARED if prepared else HALVINGS):
        halved = np.flatnonzero(doubt & (np.diff(at) > SWEEP_FINEST))[:room]
        if not len(halved):
            break
        room -= len(halved)
        middle = (at[halved] + at[halved + 1]) / 2
        rows, ok = _slices(plan, T, coordinate, values, middle)
        left, left_doubt = _continued(plan, q[halved], valid[halved], rows, ok)
        right, right_doubt = _continued(plan, rows, ok, q[halved + 1], valid[halved + 1])
        after[halved], doubt[halved] = left, left_doubt
        after = np.insert(after, halved + 1, right, axis=0)
        doubt = np.insert(doubt, halved + 1, right_doubt)
        at = np.insert(at, halved + 1, middle)
        q, valid = np.insert(q, halved + 1, rows, axis=0), np.insert(valid, halved + 1, ok, axis=0)
    return Sweep(at, q, valid, after)


def slices(plan: Plan, T: Array, threads: int) -> tuple[Indices, Array]:
    """Return the pose index (m,) and the rows (m, n) of poses (N, 4, 4) at a sweep's first slices.

    The first redundant coordinate takes the values, the others their defaults.
    """
    lower, upper = span(plan, plan.reduction.locked[0])
    at = np.linspace(lower, upper, SLICES if plan.reduction.at_ends is not None else SLICES_PREPARED)
    held = np.tile(plan.defaults, (len(at) * len(T), 1))
    held[:, 0] = np.repeat(at, len(T))
    found = full_rows(plan, np.tile(T, (len(at), 1, 1)), held, threads)
    case, row = np.nonzero(found.valid)
    return case % len(T), found.q[case, row]


def span(plan: Plan, joint: int) -> tuple[float, float]:
    """Return over what a redundant joint (0-based, virtual ones included) is swept: a turn, or a slide's limits.

    A slide without a limit is swept over twice the arm's length to that side of zero, or of its other limit.
    """
    if not plan.exact.full.prismatic[joint]:
        return -np.pi, np.pi
    lower, upper = plan.full_limits[joint]
    reach = 2 * plan.chain.length
    if not np.isfinite(lower):
        lower = min(-reach, upper - reach)
    return lower, upper if np.isfinite(upper) else max(reach, lower + reach)


def _slices(plan: Plan, T: Array, coordinate: int, values: Array, at: Array) -> tuple[Array, Bools]:
    held = np.tile(values, (len(at), 1))
    held[:, coordinate] = at
    most = plan.spec.max_solutions
    found = full_rows(plan, np.broadcast_to(T, (len(at), 4, 4)), held, 1)
    q, valid = found.q, found.valid
    if q.shape[1] < most:  # kernels prepared for a value may give fewer rows than the plan's own
        q = np.pad(q, ((0, 0), (0, most - q.shape[1]), (0, 0)))
        valid = np.pad(valid, ((0, 0), (0, most - valid.shape[1])))
    return q[:, :MOST_ROWS], valid[:, :MOST_ROWS]


def _apart(plan: Plan, q: Array, other: Array) -> Array:
    """Return the distances (V, M, K) of rows (V, M, n) from others (V, K, n), angles around the circle."""
    gap = plan.exact.full.joints.difference(q[:, :, None], other[:, None, :])
    return np.sqrt(np.einsum("vabn,vabn->vab", gap, gap))


def _continued(plan: Plan, q: Array, valid: Bools, q_next: Array, valid_next: Bools) -> tuple[Indices, Bools]:
    """Return for each row of slices its mutually nearest row of the next ones (V, M), or -1, and whether in doubt.

    There is doubt (V,) where a row is not continued, or moves far.
    """
    distance = _apart(plan, q, q_next)
    distance[~(valid[:, :, None] & valid_next[:, None, :])] = np.inf
    there: Indices = distance.argmin(2)
    back: Indices = distance.argmin(1)
    nearest: Array = np.take_along_axis(distance, there[..., None], 2)[..., 0]
    and_back: Indices = np.take_along_axis(back, there, 1)
    mutual: Bools = np.equal(and_back, np.arange(q.shape[1], dtype=np.int64)) & (nearest < LOST)
    kept: Indices = mutual.sum(1)
    far: Bools = np.logical_or.reduce(mutual & (nearest > FAR), axis=1)
    doubt = (kept != valid.sum(1)) | (kept != valid_next.sum(1)) | far
    return np.where(mutual, there, -1), doubt


def beside(plan: Plan, T: Array, coordinate: int, values: Array, swept: Sweep) -> Array:
    """Return points (m, n) of curves that a sweep of the pose passed over, met from poses beside it.

    A curve of solutions that lies between two slices is small. As the pose changes it shrinks to a point and is gone,
    and the other way it grows like the square root of the change: poses a little to either side of T are swept as
    well, and rows that have no neighbour among those of T are followed back to T, in steps that shrink as fast.

    Args:
        plan: A plan with redundancy.
        T: The pose (4, 4).
        coordinate: Which redundant coordinate was swept.
        values: (k,) of all of them.
        swept: The sweep of T.
    """
    full = plan.exact.full
    prepared = plan.reduction.at_ends is None
    lower, upper = span(plan, plan.reduction.locked[coordinate])
    at = np.linspace(lower, upper, SLICES_PREPARED if prepared else SLICES)
    here = np.searchsorted(swept.values, at - ROUNDING)
    twists = _to_either_side()
    poses = np.repeat(stepped(T, twists, full.length), len(at), 0)
    q, valid = _slices(plan, poses, coordinate, values, np.tile(at, len(twists)))
    slices, rows = np.nonzero(valid & ~_known(plan, swept, np.tile(here, len(twists)), q))
    every = max(1, -(-len(slices) // MOST_FOLLOWED))
    slices, rows = slices[::every], rows[::every]
    q, twists = q[slices, rows], np.repeat(twists, len(at), 0)[slices]
    for k in range(1, FOLLOW_STAGES + 1):
        q = pulled(full, q, stepped(T, twists * FOLLOW_RATIO**k, full.length), 3)
    return held_or_beside(full, pulled(full, q, np.broadcast_to(T, (len(q), 4, 4)), 12), T)


def unknown(plan: Plan, swept: Sweep, coordinate: int, q: Array) -> Array:
    """Return the rows (k, n) of q (m, n) that have no neighbour among those of a sweep."""
    at = q[:, plan.reduction.locked[coordinate]]
    here = np.minimum(np.searchsorted(swept.values, at), len(swept.values) - 1)
    return q[~_known(plan, swept, here, q[:, None])[:, 0]]


def _known(plan: Plan, swept: Sweep, here: Indices, q: Array) -> Bools:
    """Return (N, M): whether rows q (N, M, n), each at or before slice `here` (N,), have a neighbour in the sweep."""
    joints = plan.exact.full.joints
    mine, theirs = _on_circles(joints, q), _on_circles(joints, swept.q)
    size, sizes = (np.einsum("vmc,vmc->vm", c, c) for c in (mine, theirs))
    sizes[~swept.valid] = np.inf
    known = np.zeros(q.shape[:2], bool)
    # a slice further on counts too: near its ends a branch moves fast
    for step in (-1, 0, 1):
        near = np.clip(here + step, 0, len(swept.values) - 1)
        # few pairs are near each other: those are looked at whose chords are, which are no longer than their arcs
        square = size[:, :, None] + sizes[near][:, None] - 2 * mine @ np.swapaxes(theirs[near], 1, 2)
        i, row, other = np.nonzero(square < KNOWN**2 + RELATIVE_ROUNDING)
        gap = joints.difference(q[i, row], swept.q[near[i], other])
        close = np.einsum("kn,kn->k", gap, gap) < KNOWN**2
        known[i[close], row[close]] = True
    return known


def _on_circles(joints: JointSpace, q: Array) -> Array:
    """Return joint vectors (..., n) as points, of which a chord is no longer than the joints' difference.

    Of coupled joints, whose differences are not those of their axes, all are one point.
    """
    if joints.coupled is not None:
        return np.zeros((*q.shape[:-1], 1))
    turning = ~joints.prismatic
    return np.concatenate(
        [np.cos(q[..., turning]), np.sin(q[..., turning]), (q / joints.unit)[..., joints.prismatic]], -1
    )


def _to_either_side() -> Array:
    """Return small twists (N, 6) in opposite pairs (per length; rad), the same ones every time."""
    rng = np.random.default_rng(12)
    twists = np.concatenate([size * rng.standard_normal((count, 6)) / 6**0.5 for size, count in SIDE_STEPS])
    return np.concatenate([twists, -twists])
