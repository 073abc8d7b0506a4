"""Arms whose true axes are known because the test moved them, and what would be measured of them."""

from __future__ import annotations

import numpy as np

import pieper
from pieper.calibration.model import AxesModel, screw_motion
from pieper.calibration.parameters import parameters_of

#: Noise of one number, m and rad.
NOISE = (5e-5, 1e-4)
#: Six families of solvers, slides and spare joints among them.
ARMS = (
    "universal-robots-ur5e",
    "denso-vp6242",
    "fanuc-crx-10ia",
    "adept-cobra-600",
    "kuka-lbr-iiwa-14-r820",
    "stanford-arm",
)


def planted(arm: pieper.Arm, rng: np.random.Generator, terms: tuple[str, ...] = ()) -> AxesModel:
    """Return the arm with its axes, tool and joint terms moved by half of what is plausible."""
    parameters = parameters_of(arm.chain, arm.joint_names, (), terms)
    model = AxesModel.of(arm.chain)
    return model.moved(rng.normal(0, 0.5, parameters.count) * parameters.sizes, parameters)


def postures(arm: pieper.Arm, rng: np.random.Generator, count: int) -> np.ndarray:
    """Return joint vectors (count, n) inside the limits, at most a turn wide."""
    slides = arm.chain.prismatic[:, None]
    limits = np.where(np.isfinite(arm.limits), arm.limits, [-np.pi, np.pi])
    limits = np.where(slides, limits, np.clip(limits, -np.pi, np.pi))
    return rng.uniform(limits[:, 0], limits[:, 1], (count, arm.n))


def noisy(T: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """Return poses (N, 4, 4) with noise on position and orientation."""
    out = T.copy()
    out[:, :3, 3] += rng.normal(0, NOISE[0], (len(T), 3))
    turn = screw_motion(np.concatenate([rng.normal(0, NOISE[1], (len(T), 3)), np.zeros((len(T), 3))], 1))
    out[:, :3, :3] = turn[:, :3, :3] @ out[:, :3, :3]
    return out


def apart(a: np.ndarray, b: np.ndarray, aligned: bool) -> float:
    """Return the root mean square distance of points (N, 3), after the best rigid alignment where asked."""
    if aligned:
        A, B = a - a.mean(0), b - b.mean(0)
        U, _, V = np.linalg.svd(A.T @ B)
        a, b = A @ (U @ np.diag([1, 1, np.sign(np.linalg.det(U @ V))]) @ V), B
    return float(np.sqrt(np.mean(np.sum((a - b) ** 2, 1))))
