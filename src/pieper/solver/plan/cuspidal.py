"""Cuspidal arms: those that can pass from one solution to another without meeting a singularity, found by search.

On a cuspidal arm "elbow up" and "elbow down" have no meaning: two solutions of one pose lie in the same
singularity-free region of joint space (Wenger, 1992). The search looks for two solutions of a pose whose Jacobian
determinants have the same sign and for a path between them on which the determinant never changes it: proof by example.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.chain import Chain
from pieper.kinematics.joints import TURN
from pieper.kinematics.newton import determinant
from pieper.solver.plan.six_joints import sample_joints
from pieper.tolerances import CLEAR_OF_SINGULAR

#: Poses tried, shapes of path for each pair of solutions, points first checked on a path, pairs tried at the most.
POSES, DETOURS, POINTS, PAIRS = 40, 40, 65, 120


@dataclass(frozen=True, eq=False)
class Cuspidal:
    """What the search found.

    Attributes:
        found: Whether a singularity-free path between two solutions of one pose was found.
        path: (k, n) joint vectors of that path; its ends reach the same pose. Empty if none was found.
        margin: Smallest |det J| on the path as a fraction of the largest seen on the arm: how clear of singularities.
        tried: Number of pairs of solutions tried.
    """

    found: bool
    path: Array
    margin: float
    tried: int

    def __str__(self) -> str:
        if not self.found and not self.tried:
            return "not cuspidal: shoulder, elbow and wrist each change side only at a singularity of their own"
        if self.found:
            return (
                "cuspidal: a path leads from one solution to another of the same pose without meeting a singularity "
                f"(|det J| stays above {self.margin:.2g} of its largest value), so posture names do not separate "
                "solutions"
            )
        return f"no singularity-free path between two solutions was found in {self.tried} tries"


def never(joints: int) -> Cuspidal:
    """Return the finding for arms whose det J is a product of a shoulder, an elbow and a wrist factor.

    Each pair of branches differs in the sign of one of them: no search can find what cannot be.
    """
    return Cuspidal(False, np.empty((0, joints)), 0.0, 0)


def search(
    chain: Chain, solve: Callable[[Array], tuple[Array, Bools]], *, seed: int = 0, poses: int = POSES
) -> Cuspidal:
    """Look for a singularity-free path between two solutions of one pose of a six-joint arm.

    Args:
        chain: An arm of six joints.
        solve: Maps poses (N, 4, 4) to rows (N, M, 6) and which of them are solutions (N, M).
        seed: Seed of the random poses.
        poses: Number of poses tried.

    Returns:
        The finding; `found` False is no proof that there is none.
    """
    q = sample_joints(chain, poses, seed=seed)
    largest = float(np.abs(determinant(chain, sample_joints(chain, 400, seed=seed + 1))).max())
    solutions, valid = solve(chain.native.fk(q))
    rng = np.random.default_rng(seed)
    tried = 0
    best: tuple[float, Array] | None = None
    for i in range(poses):
        rows = solutions[i][valid[i]]
        signs = np.sign(determinant(chain, rows))
        for a in range(len(rows)):
            for b in range(a):
                if signs[a] != signs[b] or tried >= PAIRS:
                    continue
                tried += 1
                found = _connect(chain, rows[a], rows[b], signs[a], largest, rng)
                if found is not None and (best is None or found[0] > best[0]):
                    best = found
        if best is not None or tried >= PAIRS:
            break
    if best is None:
        return Cuspidal(False, np.empty((0, chain.n)), 0.0, tried)
    return Cuspidal(True, best[1], best[0], tried)


def _connect(
    chain: Chain, a: Array, b: Array, sign: float, largest: float, rng: np.random.Generator
) -> tuple[float, Array] | None:
    """Try straight and bent paths, the short way round and the long, for one that keeps the determinant's sign."""
    s = np.linspace(0.0, 1.0, POINTS)[:, None]
    gap = chain.joints.way(b, a)
    straight = a + s * gap
    bumps = rng.standard_normal((DETOURS, 1, chain.n)) * np.linspace(0.0, 1.6, DETOURS)[:, None, None]
    turns = rng.integers(-1, 2, (DETOURS, 1, chain.n)) * (rng.uniform(size=(DETOURS, 1, chain.n)) < 0.2)
    turns = np.where(chain.prismatic, 0, turns)
    turns[: DETOURS // 2] = 0
    paths = straight + 4 * s * (1 - s) * bumps + TURN * s * turns
    worst = (determinant(chain, paths) * sign).min(1) / largest
    best = int(np.argmax(worst))
    if worst[best] <= CLEAR_OF_SINGULAR:
        return None
    # between the points too: neighbours of a fine look may differ by no more than what is left to zero
    fine = np.linspace(0.0, 1.0, 40 * (POINTS - 1) + 1)[:, None]
    path = a + fine * gap + 4 * fine * (1 - fine) * bumps[best] + TURN * fine * turns[best]
    det = determinant(chain, path) * sign / largest
    change = np.abs(np.diff(det))
    if det.min() <= CLEAR_OF_SINGULAR or np.any(change > 0.5 * np.minimum(det[:-1], det[1:])):
        return None
    return float(det.min()), path[::40]
