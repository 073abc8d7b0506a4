"""Cuspidal arms: those that can pass from one solution to another without meeting a singularity, found by search.

On a cuspidal arm "elbow up" and "elbow down" have no meaning: two solutions of one pose lie in the same
singularity-free region of joint space (Wenger, 1992). The search looks for two solutions of a pose whose Jacobian
determinants have the same sign and for a path between them on which the determinant never changes it: proof by example.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper.kinematics.chain import Chain
from pieper.kinematics.forward import fk
from pieper.kinematics.newton import scaled_jacobian
from pieper.solver.plan.plan import Plan
from pieper.solver.plan.six_joints import sample_joints
from pieper.solver.results import TURN

#: Poses tried, shapes of path for each pair of solutions, points first checked on a path, pairs tried at the most.
POSES, DETOURS, POINTS, PAIRS = 40, 40, 65, 120
#: |det J| must stay above this part of its largest value: a path that nearly touches a singularity proves nothing.
CLEAR = 2e-3


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
    path: np.ndarray
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


def search(plan: Plan, *, seed: int = 0, poses: int = POSES) -> Cuspidal:
    """Look for a singularity-free path between two solutions of one pose of a six-joint arm.

    Args:
        plan: A plan for six joints and a full pose.
        seed: Seed of the random poses.
        poses: Number of poses tried.

    Returns:
        The finding; `found` False is no proof that there is none.
    """
    from pieper.solver.verbs import ik_many

    if plan.family == "spherical_wrist_parallel":
        # det J is a product of a shoulder, an elbow and a wrist factor, and each pair of branches differs in the sign
        # of one of them: no search can find what cannot be
        return Cuspidal(False, np.empty((0, plan.n)), 0.0, 0)
    chain = plan.chain
    q = sample_joints(chain, poses, seed=seed)
    largest = float(np.abs(determinant(chain, sample_joints(chain, 400, seed=seed + 1))).max())
    batch = ik_many(plan, fk(chain, q), 1)
    rng = np.random.default_rng(seed)
    tried = 0
    best: tuple[float, np.ndarray] | None = None
    for i in range(poses):
        rows = batch.q[i][batch.valid[i]]
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
        return Cuspidal(False, np.empty((0, plan.n)), 0.0, tried)
    return Cuspidal(True, best[1], best[0], tried)


def determinant(chain: Chain, q: np.ndarray) -> np.ndarray:
    """Return the determinants (...) of the Jacobian without units at q (..., 6)."""
    return np.linalg.det(scaled_jacobian(chain, q))


def _connect(chain, a, b, sign, largest, rng) -> tuple[float, np.ndarray] | None:
    """Try straight and bent paths, the short way round and the long, for one that keeps the determinant's sign."""
    s = np.linspace(0.0, 1.0, POINTS)[:, None]
    gap = np.where(chain.prismatic, b - a, (b - a + np.pi) % TURN - np.pi)
    straight = a + s * gap
    bumps = rng.standard_normal((DETOURS, 1, chain.n)) * np.linspace(0.0, 1.6, DETOURS)[:, None, None]
    turns = rng.integers(-1, 2, (DETOURS, 1, chain.n)) * (rng.uniform(size=(DETOURS, 1, chain.n)) < 0.2)
    turns = np.where(chain.prismatic, 0, turns)
    turns[: DETOURS // 2] = 0
    paths = straight + 4 * s * (1 - s) * bumps + TURN * s * turns
    worst = (determinant(chain, paths) * sign).min(1) / largest
    best = int(np.argmax(worst))
    if worst[best] <= CLEAR:
        return None
    # between the points too: neighbours of a fine look may differ by no more than what is left to zero
    fine = np.linspace(0.0, 1.0, 40 * (POINTS - 1) + 1)[:, None]
    path = a + fine * gap + 4 * fine * (1 - fine) * bumps[best] + TURN * fine * turns[best]
    det = determinant(chain, path) * sign / largest
    change = np.abs(np.diff(det))
    if det.min() <= CLEAR or np.any(change > 0.5 * np.minimum(det[:-1], det[1:])):
        return None
    return float(det.min()), path[::40]
