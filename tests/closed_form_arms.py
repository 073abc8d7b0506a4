"""Random six-joint arms of the closed-form families, a slow oracle, and joint vectors on purpose near singular ones."""

from __future__ import annotations

import numpy as np
from scipy.optimize import brentq

from pieper.kinematics.chain import Chain
from pieper.kinematics.forward import fk, jacobian
from pieper.kinematics.geometry import look
from pieper.kinematics.pose import inverse, rotation_about, rotation_x, rotation_z, transform, translation
from pieper.solver.native import SixJointSolver

QUARTER = np.pi / 2


def solver_of(family, chain: Chain) -> SixJointSolver:
    """Return the native solver of a chain that the family must recognise."""
    found = family.match(chain, look(chain, 1e-9))
    assert found is not None, "the family did not recognise its own arm"
    return SixJointSolver(chain, family.prepare(chain, found), np.tile([-np.inf, np.inf], (chain.n, 1)))


def _rigid(rng) -> np.ndarray:
    axis = rng.standard_normal(3)
    return transform(rotation_about(axis / np.linalg.norm(axis), rng.uniform(-np.pi, np.pi)), rng.uniform(-0.5, 0.5, 3))


def _typed(rng) -> np.ndarray:
    """A link as tables have it: twists of right angles, many lengths zero."""
    shift = translation(float(rng.choice([0, 0, 0.3, 0.5])), 0.0, float(rng.choice([0, 0, 0.2, 0.4])))
    return (
        rotation_z(float(rng.choice([0, QUARTER])))
        @ shift
        @ rotation_x(float(rng.choice([0, QUARTER, -QUARTER, np.pi])))
    )


def wrist_arm(rng, first: int, others: str, typed: bool) -> Chain:
    """Return an arm with a spherical wrist at joints first..first+2 and three others, in loop order after the wrist."""
    links = [(_typed if typed else _rigid)(rng) for _ in range(7)]
    for k in (first + 1, first + 2):
        twist = float(rng.choice([-1, 1])) * QUARTER if typed else rng.uniform(0.3, 2.8)
        links[k] = rotation_z(rng.uniform(-3, 3)) @ rotation_x(twist) @ rotation_z(rng.uniform(-3, 3))
    for j in range(first, first + 3):  # where a frame sits on its axis must not matter
        shift = translation(z=rng.uniform(-0.3, 0.3))
        links[j], links[j + 1] = links[j] @ shift, inverse(shift) @ links[j + 1]
    types = ["R"] * 6
    for j, kind in zip([*range(first + 3, 6), *range(first)], others, strict=True):
        types[j] = kind
    return Chain.of(np.array(links), np.array([t == "P" for t in types]))


def plane_arm(rng, first: int, types: str, typed: bool) -> Chain:
    """Return an arm whose joints first..first+2 turn about parallel axes (of either sense) or slide across them."""
    links = [(_typed if typed else _rigid)(rng) for _ in range(7)]
    for k in (first + 1, first + 2):
        links[k] = rotation_z(rng.uniform(-3, 3)) @ translation(*rng.uniform(-0.5, 0.5, 3))
    for j in range(first, first + 3):
        if types[j] == "P":
            gauge = transform(np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]))
        else:
            gauge = rotation_x(np.pi * float(rng.integers(2)))
        links[j], links[j + 1] = links[j] @ gauge, inverse(gauge) @ links[j + 1]
    return Chain.of(np.array(links), np.array([t == "P" for t in types]))


def random_joints(rng, chain: Chain, count: int) -> np.ndarray:
    """Return joint vectors (count, n) over the whole turn; slides within the size of the arm."""
    return np.where(chain.prismatic, 0.6, np.pi) * rng.uniform(-1, 1, (count, chain.n))


def difference(chain: Chain, a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Return the largest joint difference (...) of joint vectors, angles around the circle."""
    gap = a - b
    return np.abs(np.where(chain.prismatic, gap, (gap + np.pi) % (2 * np.pi) - np.pi)).max(-1)


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


def scaled(chain: Chain, q: np.ndarray) -> np.ndarray:
    """Return Jacobians (..., 6, n) with lengths in units of the arm."""
    J = jacobian(chain, q).copy()
    J[..., :3, :] /= chain.length
    return J


def near_singular(rng, chain: Chain, count: int) -> np.ndarray:
    """Return joint vectors at 1e-10 to 1e-2 (log-uniform) from singular ones, which are found along random joints."""
    out = []
    for _ in range(6 * count):
        q, j = random_joints(rng, chain, 1)[0], int(rng.integers(chain.n))
        grid = np.repeat(q[None], 33, 0)
        grid[:, j] = np.linspace(-1, 1, 33) * (0.6 if chain.prismatic[j] else np.pi)
        det = np.linalg.det(scaled(chain, grid))
        crossings = np.nonzero(det[:-1] * det[1:] < 0)[0]
        if len(crossings):
            k = int(rng.choice(crossings))

            def at(x, q=q, j=j):
                return np.linalg.det(scaled(chain, np.where(np.arange(chain.n) == j, x, q)))

            if at(grid[k, j]) * at(grid[k + 1, j]) >= 0:
                continue  # rounding: one row alone is summed in another order than many
            q[j] = brentq(at, grid[k, j], grid[k + 1, j], xtol=1e-15)
            step = rng.standard_normal(chain.n)
            out.append(q + 10 ** rng.uniform(-10, -2) * step / np.linalg.norm(step))
        if len(out) == count:
            break
    return np.array(out).reshape(-1, chain.n)


def newton_solutions(rng, chain: Chain, T: np.ndarray, starts: int) -> np.ndarray:
    """Return the distinct solutions (m, n) that damped Newton finds from many starts: slow, and knows no geometry."""
    q = random_joints(rng, chain, starts) * np.where(chain.prismatic, 3.0, 1.0)
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


def offset_arm(rng, alike: bool) -> Chain:
    """Return an arm with axes 2 and 3 parallel (of either sense), 1 across them, 4 and 5 meeting, all else any.

    Args:
        rng: The generator.
        alike: Whether the two sides of the arm are alike: no offset of shoulder or forearm, no twist out of the plane.
    """
    links = [_rigid(rng) for _ in range(7)]
    side = float(rng.choice([-1, 1])) * QUARTER
    links[1] = (
        rotation_z(rng.uniform(-3, 3))
        @ translation(x=0.0 if alike else rng.uniform(-0.3, 0.3), z=0.2)
        @ rotation_x(side)
    )
    turned = rotation_x(float(rng.choice([0, np.pi])))
    links[2] = rotation_z(rng.uniform(-3, 3)) @ translation(x=0.5, z=0.0 if alike else rng.uniform(-0.2, 0.2)) @ turned
    if alike:  # axis 4 leaves the elbow along the forearm
        links[3] = rotation_z(rng.uniform(-3, 3)) @ rotation_x(side) @ rotation_z(rng.uniform(-3, 3))
    links[4] = translation(z=0.4) @ rotation_x(rng.uniform(0.4, 2.7)) @ rotation_z(rng.uniform(-3, 3))
    for j in range(6):  # where a frame sits on its axis must not matter
        shift = translation(z=rng.uniform(-0.3, 0.3))
        links[j], links[j + 1] = links[j] @ shift, inverse(shift) @ links[j + 1]
    return Chain.of(np.array(links), np.zeros(6, bool))


def sliding_arm(rng, order: str, typed: bool) -> Chain:
    """Return an arm with joints in an order such as "RPRRPR"; its links any, or such as tables have."""
    links = [(_typed if typed else _rigid)(rng) for _ in range(7)]
    return Chain.of(np.array(links), np.array([kind == "P" for kind in order]))
