"""A slow tracer of what seven turning joints leave free at a pose: Newton's method bordered by the tangent.

Nothing is shared with the package but the forward kinematics that is handed in.
"""

from __future__ import annotations

import numpy as np

#: Longest and shortest step (rad).
LONGEST, SHORTEST = 0.05, 1e-9
#: How far it goes straight on where another curve crosses nearly along this one, and where others pass closely.
FAR, CLOSELY = 1e-5, 1e-6


def around(x):
    return (np.asarray(x) + np.pi) % (2 * np.pi) - np.pi


def missing(forward, chain, q, T):
    """Return the way (m) and the turn (rad) from where q (7,) stands to T, (6,)."""
    now = forward.fk(chain, q)
    R = T[:3, :3] @ now[:3, :3].T
    turn = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / 2
    return np.concatenate([T[:3, 3] - now[:3, 3], turn])


def onto(forward, chain, q, T, way, through):
    """Return the point (7,) near q that holds T in the plane across `way` through a point; None where there is none."""
    least = np.inf
    for _ in range(12):
        e = np.append(missing(forward, chain, q, T), way @ (through - q))
        size = np.linalg.norm(e)
        if size < 1e-15 or (size < 1e-13 and size > least / 2):
            return q
        least = min(least, size)
        A = np.vstack([forward.jacobian(chain, q), way])
        step = np.linalg.lstsq(A, e, rcond=1e-15)[0]
        if np.linalg.norm(step) > 0.5:
            return None
        q = q + step
    return q if np.linalg.norm(missing(forward, chain, q, T)) < 1e-13 else None


def tangent(forward, chain, q, before):
    """Return the free way (7,) at q along `before`, its side, and the weakest singular value beside it."""
    _, s, Vt = np.linalg.svd(forward.jacobian(chain, q))
    way = Vt[6] * (np.sign(Vt[6] @ before) or 1.0)
    sign = np.sign(np.linalg.det(np.vstack([forward.jacobian(chain, q), way])))
    return way, sign, s[5]


def followed(forward, chain, q, T, *, across=FAR, most=20000):
    """Return the points (k, 7) of the curve of the pose T through q (7,), whether it closed, and its length (rad)."""
    start = np.array(q, float)
    first, side, _ = tangent(forward, chain, start, np.ones(7))
    points, way, step, length = [start], first, LONGEST / 4, 0.0
    while len(points) < most:
        here = points[-1]
        p = onto(forward, chain, here + step * way, T, way, here + step * way)
        good = p is not None and np.linalg.norm(p - here) < 1.05 * step
        if good:
            new, now, weak = tangent(forward, chain, p, way)
            hidden = step <= 4 * across and weak < 1e-3 * step  # where curves cross the free way is noise
            good = hidden or (new @ way > 0.95 and (now == side or step <= across))
        if not good:
            step /= 2
            if step < SHORTEST:
                return np.array(points), False, length
            continue
        assert p is not None
        points.append(p)
        size = float(np.linalg.norm(p - here))
        length += size
        gap = around(start - here)
        if len(points) > 4 and 0 < gap @ way <= 1.001 * size and np.linalg.norm(gap - gap @ way * way) < 0.3 * size:
            # another curve may pass as near: only this one meets the plane through the start in the start itself
            on = onto(forward, chain, here + gap @ way / size * (p - here), T, way, here + gap)
            if on is not None and np.linalg.norm(on - here - gap) < 1e-7:
                return np.array(points), True, length - size + float(np.linalg.norm(gap))
        if hidden:
            step = 4 * across
            continue
        way, side = new, now
        step = min(LONGEST, 1.5 * step)
    return np.array(points), False, length
