"""Whether a pose has solutions inside the limits at any value of the spare coordinates, and one to show for it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper.kinematics.arrays import Array, Bools, Indices
from pieper.kinematics.joints import TURN, short_way
from pieper.kinematics.newton import newton_and_miss
from pieper.solver.beyond import beyond
from pieper.solver.plan.plan import Plan
from pieper.solver.redundant.approach import LAST_STEPS, beside_rest, from_anywhere
from pieper.solver.redundant.box import box, descended, spread, well_inside
from pieper.solver.redundant.stops import stops
from pieper.solver.redundant.sweep import slices
from pieper.tolerances import ALL_BUT_HELD, CLOSES, NEAR_INSIDE

#: Starts of the descent inside the limits, where fewer have shown nothing: of postures inside, one start in eighty met
#: the rarest. The last are for what the other ways have not found either.
STARTS = 8, 64, 512
#: Free descents a pose, and poses that are sliced or approached in one go: it bounds the memory.
FREE_STARTS, TOGETHER = 16, 128
#: What a pose has: no solution at all, solutions outside the limits alone, or some inside.
NONE, OUTSIDE, INSIDE = 0, 1, 2


@dataclass(frozen=True, eq=False, slots=True)
class Anywhere:
    """What poses have at any value of the spare coordinates.

    Args:
        kind: (N,) NONE, OUTSIDE or INSIDE.
        q: (N, n) a solution of each pose that has one, the task's virtual joints included: inside the limits where
            that is possible, and then clear of them where that is.
    """

    kind: Indices
    q: Array


def anywhere(plan: Plan, T: Array, threads: int = 1) -> Anywhere:
    """Look for solutions of poses T (N, 4, 4) inside the limits, cheap ways first, for all that are left together.

    A point inside the limits is its own proof. What lies inside is bounded by stops, unless a whole self-motion does:
    where neither descent nor stops show a point, the pose is sliced and approached freely; and where the limits leave
    it nearly held, every self-motion is met as for tracing, since one that is small and inside may be there.
    """
    full, limits = plan.exact.full, plan.full_limits
    low, high = box(full, limits)
    kind, q = np.full(len(T), NONE), np.zeros((len(T), full.n))
    left = np.flatnonzero(~beyond(plan, T))

    def keep(pose: Indices, rows: Array, within: Bools) -> None:
        """Keep the first row of each pose, the first inside before any other."""
        nonlocal left
        for what, of in ((INSIDE, within), (OUTSIDE, ~within)):
            if not np.count_nonzero(of):
                continue
            first, at = pose[of], np.zeros(1, np.int64)
            if len(first) > 1:
                first, at = np.unique(first, return_index=True)
            new = kind[first] < what
            kind[first[new]], q[first[new]] = what, rows[of][at[new]]
        left = left[kind[left] < INSIDE]

    def parts() -> list[Indices]:
        # all of them before the first is looked at: `left` shrinks with what is found
        return [left[i : i + TOGETHER] for i in range(0, len(left), TOGETHER)]

    def descend(count: int) -> None:
        starts = spread(full, low, high, count)
        for part in parts():
            pose = np.repeat(part, count)
            rows, off = descended(full, starts[np.arange(len(pose)) % count], T[pose], low, high)
            np.minimum.at(least, pose, off)
            held = off <= CLOSES
            keep(pose[held], rows[held], np.ones(int(held.sum()), bool))
            near = np.flatnonzero((off > CLOSES) & (off < NEAR_INSIDE) & (kind[pose] < INSIDE))
            if len(near):
                take_last_steps(pose[near], rows[near])

    def take_last_steps(pose: Indices, rows: Array) -> None:
        # beside singular postures a damped descent rests before it arrives: small self-motions are met by what follows
        rows, off = newton_and_miss(full, rows, T[pose], steps=LAST_STEPS)
        rows, within = full.joints.inside_limits(rows, limits)
        held = off <= CLOSES
        keep(pose[held], rows[held], within[held])
        for i, row, miss in zip(pose, rows, off, strict=True):
            if CLOSES < miss < rests.get(int(i), (ALL_BUT_HELD, row))[0]:
                rests[int(i)] = float(miss), row

    def look_round() -> None:
        for i in left:
            if int(i) in rests:
                rows = beside_rest(full, rests[int(i)][1], T[i])
                rows, within = full.joints.inside_limits(rows, limits)
                keep(np.full(len(rows), i), rows, within)

    def stand() -> None:
        at = stops(plan, T[left], threads)
        keep(left[at.pose], at.q, at.inside)

    def slice_up() -> None:
        for part in parts():
            pose, rows = slices(plan, T[part], threads)
            rows, within = full.joints.inside_limits(rows, limits)
            keep(part[pose], rows, within)

    def approach() -> None:
        for part in parts():
            met_here = from_anywhere(plan, T[part], FREE_STARTS)
            rows, within = full.joints.inside_limits(np.concatenate(met_here), limits)
            keep(np.repeat(part, [len(r) for r in met_here]), rows, within)

    least = np.full(len(T), np.inf)
    # by how little the pose is missed where descents rest, and where that is
    rests: dict[int, tuple[float, Array]] = {}
    # descents before stops: they cost less, and what is inside is most often met by one
    few, more, many = STARTS
    ways = [
        lambda: descend(1),
        lambda: descend(few),
        lambda: descend(more),
        look_round,
        stand,
        slice_up,
        approach,
        lambda: descend(many),
        look_round,
    ]
    for way in ways:
        if len(left):
            way()
    # a small self-motion outside the limits is a solution too: where nothing was found, limits count for nothing
    none = left[kind[left] == NONE]
    if len(none):
        wide = np.where(full.prismatic, (low, high), ((-TURN,), (TURN,)))
        starts = np.tile(spread(full, wide[0], wide[1], FREE_STARTS), (len(none), 1))
        pose = np.repeat(none, FREE_STARTS)
        np.minimum.at(least, pose, descended(full, starts, T[pose], *wide)[1])
    for i in left[least[left] < NEAR_INSIDE]:
        from pieper.solver.redundant.self_motions import met

        rows = met(plan, T[i], plan.defaults)
        if len(rows):
            poses = np.tile(T[i], (len(rows), 1, 1))
            rows, within = full.joints.inside_limits(rows, limits)
            keep(np.full(len(rows), i), rows, within)
            near, off = descended(full, np.clip(rows, low, high), poses, low, high)
            held = off <= CLOSES
            keep(np.full(int(held.sum()), i), near[held], np.ones(int(held.sum()), bool))
    found = np.flatnonzero(kind == INSIDE)
    q[found] = well_inside(full, q[found], T[found], low, high)
    return Anywhere(kind, q)


def spare_values(plan: Plan, q: Array) -> Array:
    """Return the values (..., k) of the redundant coordinates at joint vectors (..., n), angles as limits want them."""
    locked = list(plan.reduction.locked)
    values = q[..., locked]
    lower, upper = plan.full_limits[locked].T
    turned = short_way(values)
    keep = plan.exact.full.prismatic[locked] | (turned < lower) | (turned > upper)
    return np.where(keep, np.minimum(np.maximum(values, lower), upper), turned)
