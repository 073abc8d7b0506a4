"""A slow search over turns, branches and whole turns, written from the definition alone: what may be reached at all."""

import itertools

import numpy as np

from pieper.kinematics.pose import rotation_z, transform


def reaches(arm, path, turns, step=0.5, fold=0.25):
    """Return the last point that is reached, -1 for none: turning on the spot is allowed, jumps over `step` are not."""
    low, high = arm.limits.T
    Rz = rotation_z(np.arange(turns) * 2 * np.pi / turns)
    choices = [range(int((high[j] - low[j] + 1e-9) / (2 * np.pi)) + 1) for j in range(arm.n)]
    lifts = np.array(list(itertools.product(*choices))) * 2 * np.pi
    before = None
    for i, T in enumerate(path):
        many = arm.ik_many(T @ Rz)
        q = low + (many.q - low + 1e-9) % (2 * np.pi) - 1e-9
        q = (q[:, :, None] + lifts).reshape(turns, -1, arm.n)
        ok = np.repeat(many.valid, len(lifts), 1) & ((q >= low - 1e-9) & (q <= high + 1e-9)).all(-1)
        keep = ok.any(0)
        q, ok = q[:, keep], ok[:, keep]
        if before is None:
            now = ok.copy()
        else:
            now = np.zeros_like(ok)
            for d in np.flatnonzero(before[1].any(0)):
                near = np.abs(q - before[0][:, d : d + 1]).max(-1) <= step
                now |= ok & before[1][:, d, None] & near
        if not now.any():
            return i - 1
        around = np.abs(q[:, :, None] - np.roll(q, -1, 0)[:, None]).max(-1) <= step
        beside = np.abs(q[:, :, None] - q[:, None]).max(-1) <= fold
        count = -1
        while now.sum() != count:
            count = now.sum()
            for k in [*range(turns), *range(turns)]:
                now[(k + 1) % turns] |= ok[(k + 1) % turns] & (around[k] & now[k][:, None]).any(0)
            for k in [*range(turns - 1, -1, -1)] * 2:
                now[k] |= ok[k] & (around[k] & now[(k + 1) % turns][None]).any(1)
            now |= ok & (beside & now[:, :, None]).any(1)
        before = (q, now)
    return len(path) - 1


def cheapest(arm, path, turns):
    """Return the cost of the cheapest chain over a grid of turns, every step to every row, wrapped angles."""
    Rz = rotation_z(np.arange(turns) * 2 * np.pi / turns)
    low, high = arm.limits.T
    cost = last = np.zeros(0)
    for k, T in enumerate(path):
        many = arm.ik_many(T @ Rz)
        q = many.q[many.in_limits]
        if k == 0:
            cost = np.zeros(len(q))
        else:
            gap = q[:, None] - last[None]
            wide = high - low > 2 * np.pi
            gap = np.where(wide, gap - 2 * np.pi * np.round(gap / (2 * np.pi)), gap)
            jump = np.abs(gap).max(-1) > 0.6
            cost = np.min(np.where(jump, np.inf, (gap**2).sum(-1)) + cost[None], axis=1)
        last = q
    return float(cost.min())


def ring(N, centre, radius, tilt=np.pi / 6):
    """Return a seam (N, 4, 4) round a circle, the tool leaning inwards."""
    a = np.linspace(0, 2 * np.pi, N)
    p = np.stack([centre[0] + radius * np.cos(a), centre[1] + radius * np.sin(a), centre[2] + 0 * a], -1)
    x = np.stack([-np.sin(a), np.cos(a), 0 * a], -1)
    out = np.stack([np.cos(a), np.sin(a), 0 * a], -1)
    z = -np.cos(tilt) * np.array([0, 0, 1.0]) - np.sin(tilt) * out
    return np.stack([transform(R, q) for R, q in zip(np.stack([x, np.cross(z, x), z], -1), p, strict=True)])


def flooded(arm, path, turns, step=0.25, beside=0.1, lifted=True):
    """Return the last point that is reached over a fine grid of turns, -1 for none, by connected pieces at each point.

    Args:
        arm: The arm.
        path: (N, 4, 4), so fine that no joint moves by more than `step` (rad) from point to point.
        turns: How many turns of the tool about its z axis.
        step: From point to point.
        beside: From turn to turn and, where two branches meet, on the spot (rad).
        lifted: Whether whole turns are told apart; else a joint that can turn all the way round has no limits.
    """
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    low, high = arm.limits.T
    Rz = rotation_z(np.arange(turns) * 2 * np.pi / turns)
    wide = (high - low >= 2 * np.pi - 1e-9) & np.isfinite(high - low)
    if not lifted:
        low, high = np.where(wide, -np.inf, low), np.where(wide, np.inf, high)
    bounded = np.isfinite(low) & np.isfinite(high)
    choices = [range(int((high[j] - low[j] + 1e-9) / (2 * np.pi)) + 1) if bounded[j] else (0,) for j in range(arm.n)]
    lifts = np.array(list(itertools.product(*choices))) * 2 * np.pi
    base = np.where(bounded, low, -np.pi)

    def gap(a, b):
        d = np.abs(a - b)
        return np.where(bounded, d, np.minimum(d, 2 * np.pi - d)).max(-1)

    before = None
    for i, T in enumerate(path):
        many = arm.ik_many(T @ Rz)
        q = base + (many.q - base + 1e-9) % (2 * np.pi) - 1e-9
        q = (q[:, :, None] + lifts).reshape(turns, -1, arm.n)
        ok = np.repeat(many.valid, len(lifts), 1) & ((q >= low - 1e-9) & (q <= high + 1e-9)).all(-1)
        keep = ok.any(0)
        q, ok = q[:, keep], ok[:, keep]
        rows = q.shape[1]
        if before is None:
            now = ok.copy()
        else:
            now = np.zeros_like(ok)
            for d in np.flatnonzero(before[1].any(0)):
                now |= ok & before[1][:, d, None] & (gap(q, before[0][:, d : d + 1]) <= step)
        if not now.any():
            return i - 1
        ends = []
        node = np.arange(turns * rows).reshape(turns, rows)
        for a in range(rows):
            for b in range(rows):
                near = ok[:, a] & np.roll(ok[:, b], -1) & (gap(q[:, a], np.roll(q[:, b], -1, 0)) <= beside)
                ends.append((node[near, a], np.roll(node[:, b], -1)[near]))
                if a < b:
                    met = ok[:, a] & ok[:, b] & (gap(q[:, a], q[:, b]) <= beside)
                    ends.append((node[met, a], node[met, b]))
        m, n = (np.concatenate(side) for side in zip(*ends, strict=True))
        _, piece = connected_components(coo_array((np.ones(len(m)), (m, n)), (node.size, node.size)), directed=False)
        reached = np.zeros(piece.max() + 1, bool)
        reached[piece[node[now]]] = True
        now = ok & reached[piece].reshape(turns, rows)
        before = (q, now)
    return len(path) - 1


def random_ring(rng, n, reach, *, out, around, up, wide):
    """Return a ring of n poses; how far out and up its centre is and how wide it is are parts of a reach."""
    far, angle = rng.uniform(*out) * reach, rng.uniform(-around, around)
    centre = (far * np.cos(angle), far * np.sin(angle), rng.uniform(*up) * reach)
    return ring(n, centre, rng.uniform(*wide) * reach, rng.uniform(0, 1.2))
