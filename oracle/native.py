"""A family's kernel alone, without the careful look behind it: what it misses, and what the search finds."""

from __future__ import annotations

import numpy as np

from oracle.joints import difference
from oracle.model import machine_of
from oracle.starts import search
from pieper.kinematics.chain import Chain
from pieper.kinematics.forward import fk
from pieper.kinematics.geometry import look
from pieper.solver.native import SixJointSolver


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
