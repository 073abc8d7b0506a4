"""Points of a pose inside a box of joint limits, met by descent: steps that stop at a limit and go on along it."""

from __future__ import annotations

import numpy as np

from pieper import _kernel
from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.chain import Chain
from pieper.kinematics.newton import scaled_jacobian
from pieper.solver.plan.six_joints import RANK, sample_joints
from pieper.tolerances import (
    BOX_DAMPING,
    BOX_LEAST_DAMPING,
    BOX_NEARER,
    BOX_ON_POSE,
    BOX_REGULAR,
    BOX_ROOM,
    BOX_SETTLED,
    CLOSES,
    LIMIT_SLACK,
    TINY,
)

#: How often a posture is tried, and the longest step (rad; per length).
STEPS, LONGEST = 60, 0.5
#: A step is made again at most so often, each time without the joints that it would carry through a limit.
MADE_AGAIN = 3
#: A row rests after so many steps in turn that left more than this of the square that is missed: it is at a minimum.
IDLE, LEFT = 5, 0.9
#: Steps of the way to the nearest point.
NEARING = 60


def spread(chain: Chain, low: Array, high: Array, count: int, seed: int = 5) -> Array:
    """Return postures (count, n) spread evenly over a box, the first one its middle; the same ones every time."""
    part = np.full((count, chain.n), 0.5)
    if count > 1:
        unit = np.where(chain.prismatic, chain.length, np.pi)
        part[1:] = ((sample_joints(chain, count, seed=seed) / unit + 1) / 2)[1:]
    return low + part * (high - low)


def descended(chain: Chain, q: Array, T: Array, low: Array, high: Array) -> tuple[Array, Array]:
    """Move joint vectors inside boxes towards poses, never out of the box.

    Args:
        chain: The arm, the task's virtual joints included.
        q: (k, n) starts, inside their boxes.
        T: (k, 4, 4) poses.
        low: (k, n) or (n,) lower ends of the boxes, rad or m.
        high: Upper ends likewise.

    Returns:
        (k, n), and by how much the pose is missed (k,), per length and rad: held where that is below `CLOSES`.
    """
    lower, upper = np.empty(q.shape), np.empty(q.shape)
    lower[:], upper[:] = low, high
    return _kernel.descend(
        chain.plain,
        q=q,
        T=T,
        lower=lower,
        upper=upper,
        steps=STEPS,
        again=MADE_AGAIN,
        longest=LONGEST,
        damping=(*BOX_DAMPING, BOX_LEAST_DAMPING, BOX_LEAST_DAMPING),
        done=BOX_ON_POSE,
        idle=IDLE,
        left=LEFT,
    )


def well_inside(chain: Chain, q: Array, T: Array, low: Array, high: Array) -> Array:
    """Return for points (k, n) of poses (k, 4, 4) inside a box others near them, clear of its sides if possible.

    The box is made narrower by the same part of its width on every side; of the widths tried the narrowest counts in
    which the pose is still held.
    """
    out, left = np.array(q), np.arange(len(q))
    width = np.minimum(high - low, np.where(chain.prismatic, chain.length, np.pi))
    for part in BOX_ROOM:
        margin = part * width
        inner = low + margin, high - margin
        start = np.minimum(np.maximum(q[left], inner[0]), inner[1])
        moved, away = descended(chain, start, T[left], *inner)
        held = away <= CLOSES
        out[left[held]] = moved[held]
        left = left[~held]
        if not len(left):
            break
    return out


def box(chain: Chain, limits: Array) -> tuple[Array, Array]:
    """Return the ends (n,) of the box that is searched: limits, else a turn about zero, or twice the arm's length."""
    reach = np.where(chain.prismatic, 2 * chain.length, np.pi)
    low, high = limits.T
    return (
        np.where(np.isfinite(low), low, np.minimum(-reach, high - 2 * reach)),
        np.where(np.isfinite(high), high, np.maximum(reach, low + 2 * reach)),
    )


def closest(chain: Chain, q: Array, T: Array, limits: Array, now: Array, weights: Array) -> Array:
    """Return the point (n,) of a pose inside the limits closest to a posture, of those that descent reaches.

    The projected gradient: along what the pose leaves free, joints that would be carried through a limit held, then
    back onto the pose inside the box; steps that do not come nearer are shortened.

    Args:
        chain: The arm, the task's virtual joints included.
        q: (k, n) starts on the pose and inside the limits, whole turns as they are to stay.
        T: (4, 4).
        limits: (n, 2).
        now: (n,) the posture.
        weights: (n,) how much each joint counts.
    """
    low, high = limits[:, 0] - LIMIT_SLACK, limits[:, 1] + LIMIT_SLACK
    unit, q = chain.joints.unit, np.array(q)
    root = np.sqrt(weights)

    def away(at: Array) -> Array:
        return np.linalg.norm((at - now) / unit * root, axis=-1)

    least, longest = away(q), np.full(len(q), LONGEST)
    going = np.arange(len(q))
    for _ in range(NEARING):
        at = q[going]
        step = _towards(scaled_jacobian(chain, at), (now - at) / unit, weights, at <= low, at >= high)
        size = np.linalg.norm(step, axis=1)
        step *= np.minimum(1.0, longest[going] / np.maximum(size, TINY))[:, None]
        start = np.clip(at + step * unit, low, high)
        moved, off = descended(chain, start, np.broadcast_to(T, (len(at), 4, 4)), low, high)
        new = away(moved)
        better = (off <= CLOSES) & (new < least[going] - BOX_NEARER)
        q[going[better]], least[going[better]] = moved[better], new[better]
        longest[going] = np.where(better, 2 * longest[going], np.minimum(size, longest[going]) / 4)
        going = going[(longest[going] > BOX_SETTLED) & (size > BOX_SETTLED)]
        if not len(going):
            break
    return q[int(np.argmin(least))]


def _towards(J: Array, gap: Array, weights: Array, low: Bools, high: Bools) -> Array:
    """Return steps (k, n) within the null space of J (k, 6, n) that close the weighted gap (k, n) the most."""
    free = np.ones(gap.shape, bool)
    step = np.zeros(gap.shape)
    for _ in range(MADE_AGAIN):
        _, s, Vt = np.linalg.svd(J * free[:, None])
        rank = np.concatenate([s, np.zeros((len(s), gap.shape[1] - s.shape[1]))], 1) > RANK * s[:, :1]
        N = np.where(rank[..., None], 0.0, Vt) * free[:, None]  # rows that span what is free, held joints taken out
        A = np.einsum("kin,n,kjn->kij", N, weights, N) + BOX_REGULAR * weights.max() * np.eye(gap.shape[1])
        b = np.einsum("kin,n,kn->ki", N, weights, gap)
        shares = np.asarray(np.linalg.solve(A, b[..., None])[..., 0], np.float64)
        step = np.einsum("kin,ki->kn", N, shares)
        stopped = free & ((low & (step < 0)) | (high & (step > 0)))
        if not stopped.any():
            break
        free &= ~stopped
    return np.where(free, step, 0.0)
