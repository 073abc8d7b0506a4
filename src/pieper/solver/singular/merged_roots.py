"""Merged roots: how many branches meet in a solution, along which direction, and which solutions are one."""

from __future__ import annotations

import numpy as np

from pieper import _kernel
from pieper.kinematics.arrays import Array, Bools, Indices
from pieper.kinematics.chain import Chain
from pieper.kinematics.joints import inside
from pieper.kinematics.newton import (
    determinant,
    missed,
    null_space,
    pose_difference,
    scaled_jacobian,
    settled,
    shortest,
)
from pieper.solver.singular import near_curve
from pieper.tolerances import (
    HELD_FIRMLY,
    LIMIT_SLACK,
    MERGED_ALONG,
    MERGED_BLUR,
    MERGED_ROUNDING,
    MERGED_SAME,
    MERGED_TWINS,
)

#: The least number of branches that merge in a root where several directions are free.
SEVERAL_FREE = 4


def null_direction(chain: Chain, q: Array) -> Array:
    """Return the unit joint direction (n,), without units, that the pose feels least; its largest entry is positive."""
    v = null_space(chain, q)[1][min(chain.n, 6) - 1]
    return v * np.sign(v[np.argmax(np.abs(v))])


def merged_root(chain: Chain, q: Array, T: Array) -> tuple[Array, int]:
    """Return the root (n,) that a singular solution q (n,) of a pose is, and how many branches merge in it.

    What the pose misses along the one direction that is free to first order is c0 + c1 t + c2 t^2 + ...: where all
    below c_m vanish to rounding, m branches meet, and the place where c_(m-1) vanishes is known to the last digits,
    though rounding parts them by its m-th root. 1 where the Jacobian is merely poor; of k free directions it is at
    least 2^k.
    """
    unit, mixed = chain.joints.unit, chain.coupling
    if mixed is not None:
        mixed = mixed * unit / np.where(chain.sliding, chain.length, 1.0)[:, None]
    placed, branches = _kernel.unfold(chain.plain, q=q / unit, T=T, mixed=mixed)
    return placed * unit, branches


def distinct_roots(chain: Chain, placed: list[tuple[Array, int]], T: Array) -> list[tuple[Array, int]]:
    """Return one of each cluster of singular rows that forward kinematics cannot tell apart, the most exact first.

    Each is given and returned with how many branches merge in it.

    Two rows are one when everything between them holds the pose to rounding as well: the blur of a double root is
    about 1e-8 wide, that of a triple root 1e-5. Neighbouring roots on a curve lie on two sides of a singularity: such
    rows are kept apart even where rounding hides what is between them. Where several directions are free a root has
    no two sides, and one in which branches merge stands between its own: what is missed on the way to them is rounding;
    and on the way between two places that Newton's method has found such a root at.
    Of two that are one, each on its side, two branches merge.
    """
    if not placed:
        return []
    q, branches = np.array([root for root, _ in placed]), np.array([count for _, count in placed])
    order = np.lexsort((missed(chain, q, T), branches == 1))
    q, branches = q[order], branches[order]
    unit = chain.joints.unit
    side = np.sign(determinant(chain, q)) if chain.n == 6 else np.zeros(len(q))
    size = 1.0 + float(np.linalg.norm(T[:3, 3])) / chain.length
    kept: list[int] = []
    for index, row in enumerate(q):
        for k in kept:
            other = q[k]
            gap = chain.joints.way(row, other)
            apart = np.max(np.abs(gap / unit))
            if apart < MERGED_SAME:
                branches[k] = max(branches[k], branches[index] * (branches[k] > 1))
                break
            own = branches[index] == 1 < branches[k] or max(branches[k], branches[index]) >= SEVERAL_FREE
            sides = side[k] != side[index] and not own
            if apart < (MERGED_TWINS if sides else MERGED_BLUR):
                # a chord leaves a bent curve: what lies between is moved onto it
                chord = other + np.array([[0.25], [0.5], [0.75]]) * gap
                between = near_curve.onto(chain, chord, T, 3)
                strayed = np.abs((between.q - chord) / unit).max()
                along = MERGED_ROUNDING * size if own else MERGED_ALONG
                told = np.abs(between.miss).max() > along or between.rest.max() > MERGED_ROUNDING * size
                if strayed < apart / 4 and not told:
                    if sides and branches[k] == 1:
                        branches[k] = 2
                    # what rounding parts from a root of several directions may look like a root of fewer
                    branches[k] = max(branches[k], branches[index] * (branches[k] > 1))
                    break
        else:
            kept.append(index)
    return [(q[k], int(branches[k])) for k in kept]


def few_apart(chain: Chain, q: Array, miss: Array, most: int) -> Indices:
    """Return which of isolated points q (k, n), which miss a pose by (k,), stay: no more than the pose can have.

    Points found with different values of a task's virtual joints are found each on its own, and next to a fold
    rounding parts them in the arm's joints too: of the two nearest to each other the one that misses by less is both.
    """
    keep = list(range(len(q)))
    while len(keep) > most:
        apart = chain.joints.apart(q[keep, None], q[None, keep])
        apart[np.diag_indices(len(keep))] = np.inf
        i, j = map(int, np.unravel_index(np.argmin(apart), apart.shape))
        if not apart[i, j] < MERGED_BLUR:
            break
        keep.pop(i if miss[keep[i]] > miss[keep[j]] else j)
    return np.array(keep, np.int64)


def all_into_limits(chain: Chain, roots: list[Array], T: Array, limits: Array) -> list[Array]:
    """Return singular solutions (n,) of a pose put at limits (n, 2) as `into_limits` says.

    But for two that would come to one posture: both roots of a fold beside a limit are rows.
    """
    placed = [into_limits(chain, q, T, limits) for q in roots]

    def alone(a: int) -> bool:
        return not any(
            chain.joints.apart(placed[a], placed[b]) < chain.joints.apart(roots[a], roots[b]) / 4
            for b in range(len(roots))
            if b != a
        )

    return [placed[a] if alone(a) else roots[a] for a in range(len(roots))]


def into_limits(chain: Chain, q: Array, T: Array, limits: Array) -> Array:
    """Return a singular solution q (n,) put at limits (n, 2) it lies outside of, where it takes the pose there as well.

    Rounding blurs a merged root along what is free there to first order, and a stop may lie within the blur: then the
    posture at the stop is as good a solution. Otherwise q is returned as it is. Just outside a limit while it is inside
    a turn on it is put there too: at the stop the posture is a turn nearer.
    """
    moved, _ = chain.joints.inside_limits(q, limits)
    out = ~inside(moved, limits)
    q = _at_stops(chain, q, T, limits, out) if out.any() else q
    lower, upper = (_way_to(chain, limits[:, k], q) for k in (0, 1))
    nearest = np.where(np.abs(lower) < np.abs(upper), lower, upper)
    outside = np.where(nearest == lower, nearest > 0, nearest < 0) | np.isclose(lower, upper, 0, LIMIT_SLACK)
    beside = ~chain.prismatic & outside & (np.abs(nearest) < MERGED_BLUR)
    return _at_stops(chain, q, T, limits, beside) if beside.any() else q


def _way_to(chain: Chain, ends: Array, q: Array) -> Array:
    """Return what leads joints q (n,) to limits (n,), angles the short way round; infinite where there is none."""
    some = np.isfinite(ends)
    return np.where(some, chain.joints.way(np.where(some, ends, 0.0), np.where(some, q, 0.0)), np.inf)


def _at_stops(chain: Chain, q: Array, T: Array, limits: Array, held: Bools) -> Array:
    """Return q (n,) with joints held at the nearer of their limits, or q where the pose is not taken there."""
    lower, upper = (np.where(held, _way_to(chain, limits[:, k], q), 0.0) for k in (0, 1))
    way = np.where(np.abs(lower) < np.abs(upper), lower, upper)
    if not np.all(np.abs(way / chain.joints.unit) < MERGED_BLUR):
        return q
    there, _ = settled(
        lambda at, _: pose_difference(chain, at, T),
        lambda at, _: np.where(held, 0.0, scaled_jacobian(chain, at)),
        np.asarray(q + way)[None],
        chain.joints.unit,
        steps=6,
        longest=MERGED_BLUR,
        step=shortest(HELD_FIRMLY),
    )
    rounding = max(
        MERGED_ROUNDING * (1.0 + float(np.linalg.norm(T[:3, 3])) / chain.length), missed(chain, q[None], T)[0]
    )
    near = missed(chain, there, T)[0] <= rounding and chain.joints.apart(there[0], q) < MERGED_BLUR
    return there[0] if near and chain.joints.inside_limits(there[0], limits)[1] else q
