"""Arms of the spherical-wrist, parallel-shoulder family with every kind of offset, for the kernel's tests."""

from __future__ import annotations

from math import pi

import numpy as np

from pieper import _kernel
from pieper.description.dh import DH
from pieper.description.fold import chain_of
from pieper.description.said import describe
from pieper.kinematics.chain import Chain
from pieper.kinematics.geometry import look
from pieper.solver.families import spherical_wrist_parallel as family


def arm(a, alpha, d, theta=(0,) * 6, **rest) -> Chain:
    rows = [DH(a=w, alpha=x, d=y, theta=z) for w, x, y, z in zip(a, alpha, d, theta, strict=True)]
    return chain_of(describe(rows, convention="standard", **rest))


def placed(seed: int) -> np.ndarray:
    """Return a random pose with positions of some tenths of a metre."""
    rng = np.random.default_rng(seed)
    R = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    T = np.eye(4)
    T[:3, :3] = R * np.linalg.det(R)
    T[:3, 3] = 0.3 * rng.normal(size=3)
    return T


USUAL = (pi / 2, 0, -pi / 2, pi / 2, -pi / 2, 0)

ARMS = {
    "no offsets": arm((0, 0.21, -0.075, 0, 0, 0), USUAL, (0.125, 0, 0, 0.21, 0, 0.07)),
    "lateral offset, base, tool, senses and zeros": arm(
        (0, 0.4318, 0.0203, 0, 0, 0),
        USUAL,
        (0.67, 0.139, 0, 0.4318, 0, 0.056),
        base=placed(1),
        tool=placed(2),
        sign=(1, -1, -1, 1, -1, 1),
        offset=(0.3, -2.0, 1.1, 2.9, -0.4, 1.7),
    ),
    "shoulder offset, third axis against the second": arm(
        (0.35, -1.2, 0.145, 0, 0, 0),
        (-pi / 2, pi, pi / 2, -pi / 2, pi / 2, 0),
        (0.675, 0, 0.05, -1.2, 0, 0.2),
        tool=placed(3),
    ),
    "fourth axis out of the arm's plane": arm(
        (0.1, 0.5, 0.1, 0, 0, 0),
        (pi / 2, 0, -pi / 2 + 0.4, pi / 2, -pi / 2, 0),
        (0.3, 0.1, 0.05, 0.4, 0, 0.1),
        tool=placed(4),
    ),
    "upper arm as long as the forearm": arm((0, 0.3, 0, 0, 0, 0), USUAL, (0.3, 0, 0, 0.3, 0, 0.1)),
}


def specification(chain: Chain):
    found = family.match(chain, look(chain, 1e-9))
    assert found is not None
    return family.prepare(chain, found)


def solver(chain: Chain, limits: np.ndarray | None = None) -> _kernel.Solver:
    limits = np.tile([-np.inf, np.inf], (6, 1)) if limits is None else np.asarray(limits, float)
    return specification(chain).solver(limits, chain.prismatic)
