"""The careful look at one pose: isolated solutions, merged roots and continuous families told apart, none lost.

A pose on a singularity is approached from generic directions: every isolated solution is the limit of solutions of
nearby poses, and every self-motion curve is met by some of them. What is found is pulled back onto the pose, and each
point is asked whether the pose can be held while moving along the null direction of its Jacobian.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from pieper.inverse.refine import newton, pose_difference, scaled_jacobian
from pieper.inverse.selfmotion import Family, moves, nullity, tangent, trace
from pieper.inverse.solutions import TURN
from pieper.kinematics.chain import Chain
from pieper.kinematics.pose import rotation_about
from pieper.tolerances import SINGULAR_EXAMINED

#: Sizes of the side steps (per length; rad) from which a singular pose is approached, and how many each.
APPROACHES, APPROACH_SIZES = 6, (1e-4, 1e-7)
#: A double root is known to about the square root of rounding, so two that are closer are one.
MERGED = 3e-6
#: A solution must hold the pose this well (per length; rad). At a double root this fixes q to its square root only.
HOLDS = 1e-11


@dataclass(frozen=True, eq=False)
class Examined:
    """All there is at one pose.

    Args:
        q: (m, n) isolated solutions and one representative a family.
        family: (m,) index of the family each row represents, or -1.
        multiplicity: (m,) branches that merge in the row.
        families: The curves.
    """

    q: np.ndarray
    family: np.ndarray
    multiplicity: np.ndarray
    families: tuple[Family, ...]


def examine(
    chain: Chain,
    T: np.ndarray,
    candidates: np.ndarray,
    solve: Callable[[np.ndarray], np.ndarray],
    limits: np.ndarray,
    names: tuple[str, ...],
) -> Examined:
    """Find every isolated solution and every family of a pose.

    Args:
        chain: The arm, as many joints as task freedoms.
        T: (4, 4) the pose.
        candidates: (k, n) solutions already known.
        solve: Maps poses (N, 4, 4) to all candidate solutions of all of them, (m, n).
        limits: (n, 2).
        names: Joint names.
    """
    regular, singular = _split(chain, candidates)
    pulled = newton(chain, solve(_around(chain, T)).reshape(-1, chain.n), T, steps=40, cutoff=1e-9)
    good = np.linalg.norm(pose_difference(chain, pulled, T), axis=-1) < HOLDS
    near_regular, near_singular = _split(chain, pulled[good])
    isolated = _distinct(chain, np.concatenate([regular, near_regular]), 1e-7)
    families: list[Family] = []
    doubles: list[np.ndarray] = []
    # candidates first: they are points of the pose itself; a merged pair nearby collapses onto them
    for q in np.concatenate([singular, near_singular]):
        if any(_apart(chain, q, d) < MERGED for d in doubles):
            continue
        if any(f.distance(q) < 2e-3 and f.contains(q, 1e-4) for f in families):
            continue
        direction = _moving_direction(chain, q, T)
        if direction is not None:
            families.append(trace(chain, q, T, limits, names, direction))
        else:
            doubles.append(q)
    # a point that moves along a curve is no isolated solution, however it was found
    doubles = [d for d in doubles if not any(f.distance(d) < 2e-3 and f.contains(d, 1e-4) for f in families)]
    doubles, pairs = _merge(chain, doubles, T)
    isolated = np.array([q for q in isolated if not any(f.distance(q) < 1e-5 for f in families)]).reshape(-1, chain.n)
    rows = [*isolated, *doubles, *(f.representative for f in families)]
    family = [-1] * (len(isolated) + len(doubles)) + list(range(len(families)))
    multiplicity = [1] * len(isolated) + pairs + [1] * len(families)
    q = np.array(rows).reshape(-1, chain.n)
    wrapped = np.where(chain.prismatic, q, -((np.pi - q) % TURN) + np.pi)
    order = np.lexsort(np.round(wrapped, 6).T[::-1]) if len(q) else np.zeros(0, int)
    return Examined(wrapped[order], np.array(family, int)[order], np.array(multiplicity, int)[order], tuple(families))


def _moving_direction(chain: Chain, q: np.ndarray, T: np.ndarray) -> np.ndarray | None:
    """Return a direction in which the pose can be held, or None. Where several vanish at once, try their mixtures."""
    _, s, Vt = np.linalg.svd(scaled_jacobian(chain, q))
    s = np.concatenate([s, np.zeros(chain.n - len(s))])
    null = Vt[s <= max(SINGULAR_EXAMINED * s[0], 1e-300)]
    if not len(null):
        return None
    trials = list(null[::-1])
    for i in range(len(null)):
        for j in range(i):
            trials += [(null[i] + null[j]) / np.sqrt(2), (null[i] - null[j]) / np.sqrt(2)]
    for direction in trials:
        if moves(chain, q, T, direction):
            return direction
    return None


def _around(chain: Chain, T: np.ndarray) -> np.ndarray:
    """Poses at generic small side steps about T, the same ones every time."""
    rng = np.random.default_rng(20)
    poses = []
    for size in APPROACH_SIZES:
        for _ in range(APPROACHES):
            twist = rng.standard_normal(6)
            twist *= size / np.linalg.norm(twist)
            moved = T.copy()
            angle = float(np.linalg.norm(twist[3:]))
            moved[:3, :3] = rotation_about(twist[3:] / angle, angle) @ T[:3, :3]
            moved[:3, 3] += twist[:3] * chain.length
            poses.append(moved)
    return np.array(poses)


def _split(chain: Chain, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Part joint vectors (k, n) into those with a well-conditioned Jacobian and those without."""
    q = np.asarray(q, float).reshape(-1, chain.n)
    if not len(q):
        return q, q
    s = np.linalg.svd(scaled_jacobian(chain, q), compute_uv=False)
    smallest = s[:, -1] if chain.n <= 6 else np.zeros(len(s))
    poor = smallest <= SINGULAR_EXAMINED * s[:, 0]
    return q[~poor], q[poor]


def _distinct(chain: Chain, q: np.ndarray, tolerance: float) -> np.ndarray:
    kept: list[np.ndarray] = []
    for row in q:
        if not any(_apart(chain, row, other) < tolerance for other in kept):
            kept.append(row)
    return np.array(kept).reshape(-1, chain.n)


def _merge(chain: Chain, doubles: list[np.ndarray], T: np.ndarray) -> tuple[list[np.ndarray], list[int]]:
    """Merge what lies within the blur of a double root; what remains and is singular counts twice."""
    kept: list[np.ndarray] = []
    size = lambda q: float(np.linalg.norm(pose_difference(chain, q, T)))  # noqa: E731
    for q in sorted(doubles, key=size):
        if not any(_apart(chain, q, other) < max(MERGED, _blur(chain, q)) for other in kept):
            kept.append(q)
    double = [nullity(chain, q, SINGULAR_EXAMINED) > 0 for q in kept]
    return kept, [2 if d else 1 for d in double]


def _blur(chain: Chain, q: np.ndarray) -> float:
    """How far apart along the null direction two roots may be read from rounding alone, at sigma of this size."""
    _, s = tangent(chain, q)
    return 4e-7 if s[-1] > 1e-9 * s[0] else 2e-5


def _apart(chain: Chain, a: np.ndarray, b: np.ndarray) -> float:
    gap = np.where(chain.prismatic, (a - b) / chain.length, (a - b + np.pi) % TURN - np.pi)
    return float(np.max(np.abs(gap)))
