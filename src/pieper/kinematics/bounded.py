"""How near a tool comes to a pose inside limits: Newton on the distance itself, with its second derivatives."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.chain import Chain
from pieper.kinematics.newton import bounded

#: Damping: at first, its factor after a step that helped and after one that did not, and where a row rests.
FIRST, SHRINK, GROW, MOST = 1e-3, 0.1, 8.0, 1e4
#: Longest step (rad; lengths).
LONGEST = 0.8
#: Steps shorter than this are none (rad; lengths).
SETTLED = 1e-9
#: Eigenvalues of the second derivative are kept above this part of the largest.
FLAT = 1e-13


def nearer(chain: Chain, q: Array, T: Array, limits: Array, turning: Array, steps: int) -> tuple[Array, Array]:
    """Go downhill from joint vectors q (k, n) in |p - p_T|^2 / 2 + turning (1 - cos angle), inside limits.

    The remainder is large where a pose is out of reach: Gauss's and Newton's step would crawl, so the second
    derivatives are taken as they are, with their eigenvalues' absolute values.

    Args:
        chain: The arm.
        q: Starts inside the limits, rad or m.
        T: (4, 4).
        limits: (n, 2).
        turning: (k,) what a turn counts beside a distance of one length of the arm; infinite for turns alone.
        steps: How often a posture is tried.

    Returns:
        (k, n) and the values (k,) that are left.
    """
    at = np.clip(q, limits[:, 0], limits[:, 1])
    damp = np.full(len(at), FIRST)
    value, slope, bend = _expanded(chain, at, T, turning)
    for _ in range(steps):
        step = _step(at, slope, bend, damp, limits)
        if np.abs(step).max() < SETTLED:
            break
        tried = np.clip(at + bounded(step, LONGEST) * chain.joints.unit, limits[:, 0], limits[:, 1])
        new = _expanded(chain, tried, T, turning)
        better: Bools = np.less(new[0], value)
        at[better], value[better], slope[better], bend[better] = (x[better] for x in (tried, *new))
        damp[:] = np.clip(damp * np.where(better, SHRINK, GROW), 1e-14, MOST)
        if (damp >= MOST).all():
            break
    return at, value


def _step(q: Array, g: Array, bend: Array, damp: Array, limits: Array) -> Array:
    """Return the damped Newton step (k, n) of the joints that no limit stops, downhill whatever the curvature."""
    stopped = ((q <= limits[:, 0]) & (g > 0)) | ((q >= limits[:, 1]) & (g < 0))
    free = ~stopped
    bent = np.where(free[:, :, None] & free[:, None, :], bend, np.eye(q.shape[1]))
    s, V = np.linalg.eigh(bent)
    largest = np.abs(s).max(1, keepdims=True)
    size = np.maximum(np.abs(s), FLAT * largest) + damp[:, None] * largest
    return -np.einsum("kij,kj->ki", V, np.einsum("kij,ki->kj", V, np.where(free, g, 0.0)) / size)


def _expanded(chain: Chain, q: Array, T: Array, turning: Array) -> tuple[Array, Array, Array]:
    """Return the value (k,), slope (k, n) and second derivative (k, n, n), without units."""
    frames = chain.native_axes.frames(q, np.eye(4))
    z, o, tool = frames[:, 1:-1, :3, 2], frames[:, 1:-1, :3, 3], frames[:, -1]
    length = chain.length
    gap = (T[:3, 3] - tool[:, :3, 3]) / length
    turn = np.where(chain.prismatic[:, None], 0.0, z)
    move = np.where(chain.prismatic[:, None], z, np.cross(z, (tool[:, None, :3, 3] - o) / length))
    M = tool[:, :3, :3] @ T[:3, :3].T
    trace = np.einsum("kii->k", M)
    skew = np.stack([M[:, 2, 1] - M[:, 1, 2], M[:, 0, 2] - M[:, 2, 0], M[:, 1, 0] - M[:, 0, 1]], -1)
    near, turned = np.where(np.isinf(turning), 0.0, 1.0), np.where(np.isinf(turning), 1.0, turning)
    value = near * np.einsum("ki,ki->k", gap, gap) / 2 + turned * (3 - trace) / 2
    slope = (
        -near[:, None] * np.einsum("kni,ki->kn", move, gap) + turned[:, None] * np.einsum("kni,ki->kn", turn, skew) / 2
    )
    # a joint turns what the joints behind it do: d2 p / dq_i dq_j = turn_i x move_j for i <= j
    second = -np.einsum("kmi,kni->kmn", np.cross(gap[:, None], turn), move)
    both = turn @ np.swapaxes(turn, 1, 2)
    around = (both * trace[:, None, None] - turn @ M @ np.swapaxes(turn, 1, 2)) / 2
    bent = near[:, None, None] * second + turned[:, None, None] * around
    upper = np.triu(bent)
    bent = upper + np.swapaxes(np.triu(bent, 1), 1, 2) + near[:, None, None] * (move @ np.swapaxes(move, 1, 2))
    if chain.coupling is not None:
        C = chain.coupling * chain.joints.unit / chain.joints.unit[:, None]
        slope, bent = slope @ C, C.T @ bent @ C
    return value, slope, bent
