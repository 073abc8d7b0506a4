"""A family's kernel alone, without the careful look behind it: what it misses, held against plain Newton steps."""

from __future__ import annotations

import numpy as np

from oracle.joints import difference, random_joints, scaled
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


def newton_solutions(rng, chain: Chain, T: np.ndarray, starts: int) -> np.ndarray:
    """Return the distinct solutions (m, n) that damped Newton finds from many starts: slow, and knows no geometry."""
    q = random_joints(chain, rng, starts, slide=0.6) * np.where(chain.prismatic, 3.0, 1.0)
    damping = np.full(starts, 1e-2)

    def error(q):
        F = fk(chain, q)
        turn = 0.5 * np.cross(F[..., :3, :3], T[:3, :3], axisa=-2, axisb=-2, axisc=-1).sum(-2)
        return np.concatenate([(T[:3, 3] - F[..., :3, 3]) / chain.length, turn], -1), np.abs(F - T).max((-1, -2))

    e, size = error(q)
    for _ in range(120):
        J = scaled(chain, q)
        A = np.swapaxes(J, -1, -2) @ J + damping[:, None, None] * np.eye(chain.n)
        step = np.linalg.solve(A, np.swapaxes(J, -1, -2) @ e[..., None])[..., 0]
        trial = q + np.clip(step, -0.5, 0.5)
        e2, size2 = error(trial)
        better = size2 < size
        q, e, size = (
            np.where(better[:, None], trial, q),
            np.where(better[:, None], e2, e),
            np.where(better, size2, size),
        )
        damping = np.clip(np.where(better, damping / 8, damping * 4), 1e-14, 1e3)
    distinct: list[np.ndarray] = []
    for row in q[size < 1e-10]:
        if all(difference(chain, row, other) > 1e-5 for other in distinct):
            distinct.append(row)
    return np.array(distinct).reshape(-1, chain.n)
