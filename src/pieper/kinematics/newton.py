"""The one Newton's method: what misses a pose, its Jacobian without units, and the steps that are taken with them."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from pieper import _kernel
from pieper.kinematics.arrays import Array, Bools, Indices
from pieper.kinematics.chain import Chain
from pieper.kinematics.pose import rotation_vector
from pieper.tolerances import (
    NEWTON_CUTOFF,
    NEWTON_DAMPING,
    NEWTON_DONE,
    NEWTON_FINITE,
    NEWTON_HELD_RANK,
    NEWTON_SQUARE,
    NEWTON_STALLS,
    TINY,
)

#: Longest step (rad; lengths of the arm).
LONGEST = 0.5

#: From joint vectors (k, n) and their places in the batch (k,): what is missed (k, r), or its slope (k, r, n).
Equations = Callable[[Array, Indices], Array]
#: A step (k, n) without units from a slope (k, r, n) and what is missed (k, r).
Step = Callable[[Array, Array], Array]


def pose_difference(chain: Chain, q: Array, T: Array) -> Array:
    """Return what is missing from fk(q) to T, (..., 6): position per length of the arm, then rotation vector, rad."""
    # the solver's own joint vectors: not checked, and curves of slides and turns may lead far
    now = chain.native.fk(q)
    dR = T[..., :3, :3] @ np.swapaxes(now[..., :3, :3], -1, -2)
    out = np.empty((*dR.shape[:-2], 6))
    out[..., :3] = (T[..., :3, 3] - now[..., :3, 3]) / chain.length
    w = out[..., 3:]
    w[..., 0] = dR[..., 2, 1] - dR[..., 1, 2]
    w[..., 1] = dR[..., 0, 2] - dR[..., 2, 0]
    w[..., 2] = dR[..., 1, 0] - dR[..., 0, 1]
    w *= 0.5
    square = np.einsum("...i,...i->...", w, w)
    if np.all((square < 0.25) & (dR[..., 0, 0] + dR[..., 1, 1] + dR[..., 2, 2] > 1.0)):
        # less than 30 degrees: the skew part holds the sine, and that is the angle with its series' correction
        sine = np.sqrt(np.maximum(square, TINY))
        w *= (np.arcsin(sine) / sine)[..., None]
    else:
        w[...] = rotation_vector(dR)
    return out


def missed(chain: Chain, q: Array, T: Array) -> Array:
    """Return the size (...) of the pose difference (per length; rad)."""
    return np.asarray(np.linalg.norm(pose_difference(chain, q, T), axis=-1), np.float64)


def size_of(chain: Chain, T: Array) -> float:
    """Return how much larger than one the numbers are that forward kinematics rounds."""
    return 1.0 + float(np.linalg.norm(T[:3, 3])) / chain.length


def scaled_jacobian(chain: Chain, q: Array) -> Array:
    """Return Jacobians (..., 6, n) without units: lengths per characteristic length, prismatic columns likewise."""
    J = chain.native.jacobian(q)
    J[..., :3, :] /= chain.length
    return np.where(chain.prismatic, J * chain.length, J)


def determinant(chain: Chain, q: Array) -> Array:
    """Return the determinants (...) of the Jacobian without units at q (..., 6)."""
    return np.linalg.det(scaled_jacobian(chain, q))


def singular_values(chain: Chain, q: Array) -> Array:
    """Return the singular values (..., min(n, 6)) of the Jacobian without units, largest first."""
    return np.asarray(np.linalg.svd(scaled_jacobian(chain, q), compute_uv=False), np.float64)


def at_least_as_strong(chain: Chain, q: Array) -> Array:
    """Return what part of the largest singular value at q (k, n) the smallest is at least: up to six times too low."""
    if chain.coupling is None:
        return _kernel.parts_of_weakest(chain.plain, q=q)
    s = singular_values(chain, q)
    return np.asarray(s[:, -1] / s[:, 0], np.float64)


def null_space(chain: Chain, q: Array) -> tuple[Array, Array]:
    """Return all n singular values (..., n) of the Jacobian without units and their joint directions (..., n, n), rows.

    The last row is the direction that the pose feels least; joints beyond the sixth have the singular value zero.
    """
    _, s, Vt = np.linalg.svd(scaled_jacobian(chain, q))
    spare = chain.n - s.shape[-1]
    return (np.concatenate([s, np.zeros((*s.shape[:-1], spare))], -1) if spare else s), Vt


def bounded(step: Array, longest: float) -> Array:
    """Return steps (..., n), none longer than `longest`."""
    return step * np.minimum(1.0, longest / np.maximum(np.linalg.norm(step, axis=-1, keepdims=True), TINY))


def shortest(cutoff: float, *, but: int | None = None) -> Step:
    """Return the step of minimum norm that leaves singular directions below `cutoff` (relative), and `but`, alone."""

    def step(J: Array, e: Array) -> Array:
        U, s, Vt = np.linalg.svd(J, full_matrices=False)
        return turned_back(s, Vt, np.einsum("nik,ni->nk", U, e), cutoff, but)

    return step


def turned_back(s: Array, Vt: Array, along: Array, cutoff: float, but: int | None = None) -> Array:
    """Return the minimum-norm step (N, n) from what is missed along the singular directions (N, k)."""
    gain = np.where(s > cutoff * s[..., :1], 1.0 / np.maximum(s, TINY), 0.0)
    if but is not None:
        gain[:, but] = 0.0
    return np.einsum("nkj,nk->nj", Vt, gain * along)


def damped(damping: Array | float) -> Step:
    """Return the step J^T (J J^T + damping I)^-1 e: of minimum norm, and bounded where J has lost rank."""

    def step(J: Array, e: Array) -> Array:
        # of slopes over several decades an absolute damping may be lost: what keeps A regular grows with it
        square: Array = J * J
        damped_by: Array = np.asarray(damping, np.float64) + NEWTON_FINITE * square.sum((-2, -1))
        A: Array = J @ np.swapaxes(J, -1, -2) + damped_by[..., None, None] * np.eye(J.shape[-2])
        return np.einsum("bij,bi->bj", J, np.linalg.solve(A, e[..., None])[..., 0])

    return step


def settled(
    miss: Equations, slope: Equations, q: Array, unit: Array, *, steps: int, longest: float, step: Step
) -> tuple[Array, Array]:
    """Take Newton steps on any equations until rounding is reached, or what is missed has stopped shrinking there.

    Args:
        miss: What the equations miss by; infinite where they are not defined, which ends a row.
        slope: How much that shrinks with the joints, without units.
        q: (k, n) start, rad or m.
        unit: (n,) what counts as one of each joint.
        steps: Most steps.
        longest: Longest step, rad or characteristic lengths.
        step: How a step is made of slope and miss.

    Returns:
        (k, n) joint vectors with the smallest miss met on the way, and that miss (k,).
    """
    q = np.array(q, float)
    best, least = q.copy(), np.full(len(q), np.inf)
    stalled = np.zeros(len(q), np.int64)
    going = np.arange(len(q))
    for taken in range(steps + 1):
        here = q[going]
        e = miss(here, going)
        size = np.linalg.norm(e, axis=-1)
        stalled[going] = np.where(size > 0.5 * least[going], stalled[going] + 1, 0)
        better = size < least[going]
        best[going[better]] = here[better]
        least[going[better]] = size[better]
        # rounding is reached, or what is missed has stopped shrinking: at a double root it shrinks by four a step
        on = (size > NEWTON_DONE) & (size < np.inf) & ((least[going] > NEWTON_STALLS) | (stalled[going] < 3))
        going, here, e = going[on], here[on], e[on]
        if not len(going) or taken == steps:
            break
        q[going] = here + bounded(step(slope(here, going), e), longest) * unit
    return best, least


def newton(
    chain: Chain,
    q: Array,
    T: Array,
    *,
    steps: int = 12,
    cutoff: float = NEWTON_CUTOFF,
    max_step: float = LONGEST,
    rows: Array | None = None,
) -> Array:
    """Move joint vectors q (..., n) towards the poses T (..., 4, 4), or one by minimum-norm Newton steps.

    Singular directions below `cutoff` times the largest singular value are left alone, which lets the iteration settle
    on a point of a self-motion; a step is never longer than `max_step` (rad, or characteristic lengths).

    Args:
        chain: The arm.
        q: Start, rad or m.
        T: Wanted poses.
        steps: Number of steps.
        cutoff: Relative singular value below which a direction is left alone.
        max_step: Longest step.
        rows: (r, 6) what of the pose difference counts; all of it if None.

    Returns:
        (..., n) joint vectors with the smallest pose difference met on the way.
    """
    q = np.asarray(q, float)
    poses = T if T.ndim == 2 else np.broadcast_to(T, (*q.shape[:-1], 4, 4)).reshape(-1, 4, 4)

    start = q.reshape(-1, chain.n)
    if rows is None and chain.coupling is None:
        moved, _ = _kernel.onto(chain.plain, q=start, T=poses, steps=steps, cutoff=cutoff, longest=max_step)
        return moved.reshape(q.shape)
    counted = np.eye(6) if rows is None else rows

    def miss(at: Array, index: Indices) -> Array:
        return pose_difference(chain, at, poses if poses.ndim == 2 else poses[index]) @ counted.T

    def slope(at: Array, index: Indices) -> Array:
        return counted @ scaled_jacobian(chain, at)

    step = shortest(cutoff)
    return settled(miss, slope, start, chain.joints.unit, steps=steps, longest=max_step, step=step)[0].reshape(q.shape)


def newton_and_miss(chain: Chain, q: Array, T: Array, steps: int) -> tuple[Array, Array]:
    """Move joint vectors q (k, n) towards poses T (k, 4, 4) as `newton` does; return them and what they miss (k,)."""
    if chain.coupling is not None:
        moved = newton(chain, q, T, steps=steps)
        return moved, missed(chain, moved, T)
    return _kernel.onto(chain.plain, q=q, T=T, steps=steps, cutoff=NEWTON_CUTOFF, longest=LONGEST)


def newton_on_planes(
    chain: Chain, q: Array, T: Array, directions: Array, *, holds: float, steps: int = 12
) -> tuple[Array, Bools]:
    """Pull q (k, n) onto the pose T within planes across directions (k, n); return them and which got there (k,)."""
    q = q.copy()
    e = pose_difference(chain, q, T)
    active = np.arange(len(q))
    for _ in range(steps):
        active = active[np.linalg.norm(e[active], axis=1) >= holds]
        if not len(active):
            break
        A = np.concatenate([scaled_jacobian(chain, q[active]), directions[active, None]], axis=1)
        step = shortest(NEWTON_HELD_RANK)(A, np.concatenate([e[active], np.zeros((len(active), 1))], axis=1))
        near = np.linalg.norm(step, axis=1) <= 1.0
        active = active[near]
        q[active] += step[near] * chain.joints.unit
        e[active] = pose_difference(chain, q[active], T)
    return q, np.linalg.norm(e, axis=1) < holds


def downhill(
    chain: Chain,
    q: Array,
    T: Array,
    *,
    steps: int,
    weights: Array,
    damping: tuple[float, float, float, float],
    relative: Callable[[Array, Array], Array],
) -> tuple[Array, Array]:
    """Minimise the weighted square of the pose difference from joint vectors q (k, n) (Levenberg-Marquardt).

    Args:
        chain: The arm.
        q: Starts, rad or m.
        T: (4, 4) or (k, 4, 4).
        steps: How often a posture is tried, the start included.
        weights: (6,) of the parts of the pose difference.
        damping: At first; its factor after a step that helped, and after one that did not; the largest, at which a row
            rests.
        relative: What damping counts in (k,), from slopes (k, 6, n) and squares (k,).

    Returns:
        (k, n) and the squares (k,) that are left.
    """
    first, shrink, grow, most = damping
    q = np.array(q)
    damp, square = np.full(len(q), first), np.full(len(q), np.inf)
    active, tried = np.arange(len(q)), q.copy()
    e = np.empty((len(q), 6))
    for _ in range(steps):
        missing = pose_difference(chain, tried, T if T.ndim == 2 else T[active]) * weights
        new = np.einsum("bi,bi->b", missing, missing)
        better = new < square[active]
        q[active[better]], square[active[better]], e[active[better]] = tried[better], new[better], missing[better]
        damp[active] = np.clip(damp[active] * np.where(better, shrink, grow), NEWTON_DAMPING, most)
        active = active[(square[active] > NEWTON_SQUARE) & (damp[active] < most)]
        if not len(active):
            break
        J = scaled_jacobian(chain, q[active]) * weights[:, None]
        step = damped(damp[active] * relative(J, square[active]) + NEWTON_FINITE)(J, e[active])
        tried = q[active] + bounded(step, 0.7) * chain.joints.unit
    return q, square
