"""A family's kernel alone, without the careful look behind it: what it misses, and what the search finds."""

from __future__ import annotations

import numpy as np

from oracle.joints import difference, near_singular, random_joints, scaled
from oracle.model import machine_of
from oracle.starts import search
from pieper.kinematics.chain import Chain
from pieper.kinematics.forward import fk
from pieper.kinematics.geometry import look
from pieper.solver.native import SixJointSolver


def backwards_alike(family, chain, back, rng, count) -> None:
    """Assert that a chain and the one walked from tool to base have the same solutions at random poses."""
    there, here = solver_of(family, back), solver_of(family, chain)
    for T in fk(chain, random_joints(chain, rng, count)):
        ours = here.one(np.ascontiguousarray(T))[0]
        other = there.one(np.ascontiguousarray(np.linalg.inv(T)))[0][:, ::-1]
        assert len(ours) == len(other)
        assert all(difference(chain, other, row).min() < 1e-6 for row in ours)


def solver_of(family, chain: Chain) -> SixJointSolver:
    """Return the native solver of a chain that the family must recognise."""
    found = family.match(chain, look(chain, 1e-9))
    assert found is not None, "the family did not recognise its own arm"
    return SixJointSolver(chain, family.prepare(chain, found), np.tile([-np.inf, np.inf], (chain.n, 1)))


def missed(solver: SixJointSolver, chain: Chain, Q: np.ndarray, tolerance=1e-6) -> np.ndarray:
    """Return the rows of Q that are not among the solutions of their own poses; and check every solution returned."""
    T = fk(chain, Q)
    q, valid, _, _ = solver.many(T, 1)
    assert np.isfinite(q).all() and not q[~valid].any()
    error = fk(chain, q[valid]) - np.repeat(T[:, None], valid.shape[1], 1)[valid]
    # a slide of many lengths carries its own rounding
    size = chain.length + np.where(chain.prismatic, np.abs(q[valid]), 0.0).max(1)
    error[:, :3, 3] /= size[:, None]
    assert np.abs(error).max(initial=0.0) < 2e-12
    gap = np.where(valid, difference(chain, q, Q[:, None]), np.inf).min(1)
    return Q[gap > tolerance]


def newton_solutions(rng: np.random.Generator, chain: Chain, T: np.ndarray, starts: int) -> np.ndarray:
    """Return the distinct solutions (m, n) that the multi-start search finds: slow, and knows no geometry."""
    return search(None, T, m=machine_of(chain), starts=starts, rng=rng).q


def lost_near_singular(family, chain: Chain, rng: np.random.Generator) -> tuple[int, int]:
    """Return how many near-singular postures were not found as well as the pose tells them, and how many were tried."""
    solver, Q = solver_of(family, chain), near_singular(rng, chain, 40)
    # a pose in double precision tells the joints no better than its rounding over the smallest singular value
    told = np.maximum(1e-6, 1e-14 / np.linalg.svd(scaled(chain, Q), compute_uv=False)[:, -1])
    return sum(len(missed(solver, chain, q[None], t)) for q, t in zip(Q, told, strict=True)), len(Q)


def check_sets(family, chain: Chain, rng: np.random.Generator, starts: int) -> None:
    """Check that a family's solutions of four random poses are those of the multi-start search."""
    solver = solver_of(family, chain)
    for T in fk(chain, random_joints(chain, rng, 4)):
        ours, oracle = solver.one(np.ascontiguousarray(T))[0], newton_solutions(rng, chain, T, starts)
        assert len(ours) == len(oracle)
        assert all(difference(chain, oracle, row).min() < 1e-6 for row in ours)
