"""Joint vectors for tests: random ones, ones near singular postures, and how far two lie apart."""

from __future__ import annotations

import itertools
from collections.abc import Iterator

import numpy as np
from scipy.optimize import brentq

from pieper import Arm
from pieper.kinematics.chain import Chain
from pieper.kinematics.forward import jacobian


def random_joints(arm: Arm | Chain, rng: np.random.Generator, count: int, slide: float | None = None) -> np.ndarray:
    """Return joint vectors (count, n): angles over the whole turn, slides over `slide`, or the arm's length, m."""
    chain = arm.chain if isinstance(arm, Arm) else arm
    span = np.where(chain.prismatic, chain.length if slide is None else slide, np.pi)
    return span * rng.uniform(-1, 1, (count, chain.n))


def around(angle: np.ndarray) -> np.ndarray:
    """Return angles a whole number of turns away, in [-pi, pi), rad."""
    return (angle + np.pi) % (2 * np.pi) - np.pi


def flips(q: np.ndarray) -> np.ndarray:
    """Return the eight postures (8, 7) of an arm with round shoulder and wrist that have q's (7,) pose and elbow."""
    out = []
    for over in itertools.product((False, True), repeat=3):
        p = np.array(q, float)
        for joint, on in zip((1, 3, 5), over, strict=True):
            if on:
                p[joint - 1 : joint + 2] = p[joint - 1] + np.pi, -p[joint], p[joint + 1] + np.pi
        out.append(around(p))
    return np.array(out)


def turns_apart(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Return |a - b| of angles, whole turns not counted."""
    return np.abs(around(a - b))


def difference(chain: Chain, a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Return the largest joint difference (...) of joint vectors, angles around the circle."""
    return np.where(chain.prismatic, np.abs(a - b), turns_apart(a, b)).max(-1)


def same_set(a: np.ndarray, b: np.ndarray, prismatic: np.ndarray, tolerance: float = 1e-6) -> bool:
    """Return whether two sets of joint vectors (k, n) are equal, angles around the circle."""
    if len(a) != len(b):
        return False
    apart = np.where(prismatic, np.abs(a[:, None] - b), turns_apart(a[:, None], b)).max(-1) < tolerance
    return bool(apart.any(1).all() and apart.any(0).all())


def scaled(chain: Chain, q: np.ndarray) -> np.ndarray:
    """Return Jacobians (..., 6, n) with lengths in units of the arm."""
    J = jacobian(chain, q).copy()
    J[..., :3, :] /= chain.length
    return J


def on_singular(rng, chain: Chain, tries: int) -> Iterator[np.ndarray]:
    """Yield singular joint vectors, where the determinant changes sign along a random joint from a random posture."""
    for _ in range(tries):
        q, j = random_joints(chain, rng, 1, slide=0.6)[0], int(rng.integers(chain.n))
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
            yield q


def near_singular(rng, chain: Chain, count: int) -> np.ndarray:
    """Return joint vectors at 1e-10 to 1e-2 (log-uniform) from singular ones, which are found along random joints."""
    out = []
    for q in on_singular(rng, chain, 6 * count):
        step = rng.standard_normal(chain.n)
        out.append(q + 10 ** rng.uniform(-10, -2) * step / np.linalg.norm(step))
        if len(out) == count:
            break
    return np.array(out).reshape(-1, chain.n)
