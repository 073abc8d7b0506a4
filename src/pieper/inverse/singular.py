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
from pieper.inverse.selfmotion import Family, crossings, moved, trace
from pieper.inverse.solutions import TURN
from pieper.kinematics.chain import Chain
from pieper.kinematics.pose import rotation_about
from pieper.tolerances import SINGULAR_EXAMINED

#: Sizes of the side steps (per length; rad) from which a singular pose is approached, and how many each.
APPROACHES, APPROACH_SIZES = 6, (1e-4, 1e-7)
#: Rows of the kernel closer than this are one (rad; per length); a double root is known to about 1e-8.
SAME = 1e-7
#: A point this near a traced curve is on it; samples lie 0.12 apart, so the polyline cuts corners by about 2e-3.
ON_POLYLINE = 5e-3
#: What forward kinematics cannot tell from the pose (per length; rad).
ROUNDING = 6e-16
#: Directions tried where curves cross, and the most curves followed at one pose.
FAN, MOST_FAMILIES = 12, 24
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
    pulled = newton(chain, solve(side_steps(chain, T)).reshape(-1, chain.n), T, steps=30, cutoff=1e-9)
    good = np.linalg.norm(pose_difference(chain, pulled, T), axis=-1) < HOLDS
    near_regular, near_singular = _split(chain, pulled[good])
    isolated = _distinct(chain, np.concatenate([regular, near_regular]), SAME)
    families: list[Family] = []
    doubles: list[np.ndarray] = []
    open_ended: list[Family] = []
    # the kernel's own rows are points of the pose itself; side steps only lead to curves and to what it overlooked
    for index, q in enumerate(np.concatenate([singular, _distinct(chain, near_singular, 1e-3)])):
        on_curve = _grow(chain, q, T, limits, names, families, open_ended)
        if not on_curve and index < len(singular):
            doubles.append(q)
    doubles = _told_apart(chain, sorted(doubles, key=lambda q: _miss(chain, q, T)), T)
    doubles = [d for d in doubles if not any(f.distance(d) < 1e-4 for f in families)]
    isolated = [q for q in isolated if not any(f.distance(q) < 1e-5 for f in families)]
    pairs = [_merged(chain, q, T) for q in doubles]
    rows = [*isolated, *doubles, *(f.representative for f in families)]
    family = [-1] * (len(isolated) + len(doubles)) + list(range(len(families)))
    multiplicity = [1] * len(isolated) + pairs + [1] * len(families)
    q = np.array(rows).reshape(-1, chain.n)
    wrapped = np.where(chain.prismatic, q, -((np.pi - q) % TURN) + np.pi)
    order = np.lexsort(np.round(wrapped, 6).T[::-1]) if len(q) else np.zeros(0, int)
    return Examined(wrapped[order], np.array(family, int)[order], np.array(multiplicity, int)[order], tuple(families))


def _grow(chain, q, T, limits, names, families: list[Family], open_ended: list[Family]) -> bool:
    """Add every curve through q, and every curve that crosses those, to `families`; say whether q lies on one."""
    found = any(f.distance(q) < 2e-3 for f in families)
    waiting = [q]
    while waiting and len(families) < MOST_FAMILIES:
        point = waiting.pop()
        for direction in _directions(chain, point):
            further = moved(chain, point, T, direction)
            if further is None:
                continue
            if any(f.distance(further) < ON_POLYLINE for f in families):
                found = True
                continue
            if any(f.distance(further) < ON_POLYLINE for f in open_ended):
                continue
            set_out = (further - point) / _unit(chain)
            family = trace(chain, point, T, limits, names, set_out / np.linalg.norm(set_out))
            # joint space without sliding joints has no ends: what does not close only came near a singular pose
            if not family.closed and not chain.prismatic.any():
                open_ended.append(family)
                continue
            found = True
            families.append(family)
            waiting += crossings(family)
    return found


def _directions(chain: Chain, q: np.ndarray) -> list[np.ndarray]:
    """Return directions in which a pose might be held at q; where two vanish at once, a fan of their mixtures."""
    _, s, Vt = np.linalg.svd(scaled_jacobian(chain, q))
    s = np.concatenate([s, np.zeros(chain.n - len(s))])
    null = Vt[s <= max(SINGULAR_EXAMINED * s[0], 1e-300)]
    if len(null) < 2:
        return list(null)
    angles = np.arange(FAN) * np.pi / FAN
    fan = [np.cos(t) * null[0] + np.sin(t) * null[1] for t in angles]
    # a curve's own tangent at a crossing is found by Newton from the nearest of the fan
    return [*null, *fan]


def _unit(chain: Chain) -> np.ndarray:
    return np.where(chain.prismatic, chain.length, 1.0)


def _miss(chain: Chain, q: np.ndarray, T: np.ndarray) -> float:
    return float(np.linalg.norm(pose_difference(chain, q, T)))


def _merged(chain: Chain, q: np.ndarray, T: np.ndarray) -> int:
    """Return 2 for a double root, 1 where the Jacobian is merely poor.

    Along the null direction the pose is missed by sigma t + kappa t^2 / 2: this root has a twin at 2 sigma / kappa.
    """
    U, s, Vt = np.linalg.svd(scaled_jacobian(chain, q))
    null, left, step = Vt[len(s) - 1], U[:, len(s) - 1], 1e-3
    bent = sum(pose_difference(chain, q + side * step * null * _unit(chain), T) @ left for side in (1, -1)) / step**2
    return 2 if 2 * s[-1] < SAME * abs(bent) else 1


def side_steps(chain: Chain, T: np.ndarray, sizes: tuple[float, ...] = APPROACH_SIZES) -> np.ndarray:
    """Poses at generic small side steps about T, the same ones every time."""
    rng = np.random.default_rng(20)
    poses = []
    for size in sizes:
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
    """Return the rows of q (k, n) without those that repeat an earlier one."""
    q = np.asarray(q, float).reshape(-1, chain.n)
    near = _apart(chain, q[:, None], q[None]) < tolerance
    keep: list[int] = []
    for i in range(len(q)):
        if not near[i, keep].any():
            keep.append(i)
    return q[keep]


def _told_apart(chain: Chain, rows: list[np.ndarray], T: np.ndarray) -> list[np.ndarray]:
    """Return one of each cluster of singular rows that forward kinematics cannot tell apart.

    Two rows are one when what lies halfway between them holds the pose to rounding as well: the blur of a double root
    is about 1e-8 wide, that of a triple root 1e-5.
    """
    kept: list[np.ndarray] = []
    for q in rows:
        for other in kept:
            gap = np.where(chain.prismatic, q - other, (q - other + np.pi) % TURN - np.pi)
            if np.max(np.abs(gap)) < SAME or (
                np.max(np.abs(gap)) < 1e-3 and _miss(chain, other + gap / 2, T) < ROUNDING
            ):
                break
        else:
            kept.append(q)
    return kept


def _apart(chain: Chain, a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Return the largest joint difference (...), angles around the circle, prismatic joints per length."""
    gap = np.where(chain.prismatic, (a - b) / chain.length, (a - b + np.pi) % TURN - np.pi)
    return np.max(np.abs(gap), axis=-1)
