"""Frames of a chain moved along their own axes so that a family's loop takes its simplest form."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.kinematics.chain import Chain
from pieper.kinematics.newton import scaled_jacobian
from pieper.kinematics.pose import translation
from pieper.tolerances import RANK, RANK_ROUNDING, TINY


def centred(chain: Chain, first: int) -> np.ndarray:
    """Return links (7, 4, 4) of the same chain with the frames of joints first..first+2 at their common point.

    A revolute joint's frame may slide along its axis without changing the joint's angle. What is left of the
    translations between the three frames, the amount by which the axes miss each other, is dropped.
    """
    joints = range(first, first + 3)
    normals = np.eye(3) - chain.axes[joints, :, None] * chain.axes[joints, None, :]
    normal: Array = normals.sum(0)
    side: Array = (normals @ chain.points[joints, :, None])[..., 0].sum(0)
    centre = np.linalg.lstsq(normal, side, rcond=None)[0]
    links = np.array(chain.links)
    for j in joints:
        # the axis in the chain at zero; its frame moves by s along its own z
        s = float((centre - chain.points[j]) @ chain.axes[j])
        links[j] = links[j] @ translation(z=s)
        links[j + 1] = translation(z=-s) @ links[j + 1]
    links[first + 1][:3, 3] = 0.0
    links[first + 2][:3, 3] = 0.0
    return links


#: Postures of no special kind (rad, or lengths of the arm): what an arm can do, it can do at one of them.
_POSTURES = np.array(
    [
        [0.37, -1.13, 0.91, 1.57, -0.53, 2.29],
        [-2.11, 0.48, -1.74, 0.66, 1.21, -0.35],
        [1.09, 2.63, 0.27, -0.94, -1.83, 0.71],
    ]
)


def rank(J: np.ndarray) -> int:
    """Return the numerical rank of a matrix."""
    singular = np.linalg.svd(J, compute_uv=False)
    return int((singular > RANK * max(float(singular[0]), TINY)).sum())


def _jacobians(chain: Chain) -> np.ndarray:
    """Return Jacobians (3, 6, n) without units at postures of no special kind, of the arm without base and tool."""
    q = _POSTURES[:, : chain.n] * np.where(chain.prismatic, chain.length, 1.0)
    return scaled_jacobian(chain.section(0, chain.n - 1), q)


def positioning_rank(chain: Chain, first: int) -> int:
    """Return in how many directions the three joints beside a wrist can move its centre, at a generic posture."""
    wrist = [first, first + 1, first + 2]
    others = [j for j in range(6) if j not in wrist]
    # a full chain of six has rank 3 + 3: the wrist spans the rotations about its centre, the others must add three more
    return max(rank(J[:, wrist + others]) - rank(J[:, wrist]) for J in _jacobians(chain))


def full_rank(chain: Chain) -> bool:
    """Return whether a six-joint chain reaches all six directions at a posture of no special kind."""
    return any(rank(J) == 6 for J in _jacobians(chain))


def nearly_full_rank(chain: Chain) -> bool:
    """Return whether it does but for a direction that is weak beyond rounding, as between nearly parallel axes."""
    weak = (np.linalg.svd(J, compute_uv=False) for J in _jacobians(chain))
    return any(s[-1] > RANK_ROUNDING * s[0] for s in weak)


def planar(chain: Chain, first: int, normal: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return links (7, 4, 4) with the frames of three planar joints in one plane, and the sense (3,) of each joint.

    Afterwards z is the plane's normal in all three frames: a turning joint against it has sense -1; a sliding one has x
    along its slide. What is left of tilt and height between the frames is dropped.
    """
    links = np.array(chain.links)
    frames = np.tile(np.eye(4), (3, 1, 1))
    sense = np.ones(3, int)
    height = chain.points[first] @ normal
    at = np.eye(4)
    for j in range(first + 3):
        at = at @ chain.links[j]
        if j < first:
            continue
        k = j - first
        frame = at[:3, :3]
        local = frame.T @ normal
        gauge = np.eye(4)
        if chain.prismatic[j]:
            gauge[:3, 0], gauge[:3, 2] = (0, 0, 1), local - local[2] * np.array([0, 0, 1.0])
            gauge[:3, 2] /= np.linalg.norm(gauge[:3, 2])
            gauge[:3, 1] = np.cross(gauge[:3, 2], gauge[:3, 0])
        elif local[2] < 0:
            gauge[1, 1] = gauge[2, 2] = -1.0
            sense[k] = -1
        frames[k] = gauge @ translation(z=float(height - at[:3, 3] @ normal))
    for k in range(3):
        links[first + k] = links[first + k] @ frames[k]
        links[first + k + 1] = np.linalg.inv(frames[k]) @ links[first + k + 1]
    for k in (first + 1, first + 2):
        link = links[k]
        angle = np.arctan2(link[1, 0] - link[0, 1], link[0, 0] + link[1, 1])
        c, s = np.cos(angle), np.sin(angle)
        links[k] = [[c, -s, 0, link[0, 3]], [s, c, 0, link[1, 3]], [0, 0, 1, 0], [0, 0, 0, 1]]
    return links, sense
