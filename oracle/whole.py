"""Search a pose until its rarest solution was met often enough; hold an arm's answers against what was found."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from oracle.model import TASKS, Machine, equations, gap, polish
from oracle.starts import Found, compiled_newton, damped_newton, distinct

#: Two answers are the same solution within this (rad, arm lengths), and within as much more as rounding moves one.
SAME, ROUNDED = 1e-6, 1e-14
#: An answer closes when this little is left of the equations.
CLOSED = 1e-9
#: Smallest singular value below which two roots can be one within rounding.
DOUBLE = 1e-5


def whole_set(m: Machine, T, *, library, rng, task="pose", least=1500, sure=8, most=48_000, at_most=40) -> Found:
    """Find the solutions of pose T (4, 4): `least` starts, and more while the rarest was met under `sure` times.

    The number of starts is doubled each time, up to `most`. Where every solution was met eight times, one with a basin
    as small as the rarest would have been passed over with a probability of e^-8. The library is the compiled search,
    or None for the one in NumPy.
    """
    pose, code = m.pose(T), TASKS[task]
    span = np.where(m.slides, 1.5 + np.linalg.norm(pose[:3, 3] - m.links[0][:3, 3]), np.pi)
    reps, hits = np.zeros((0, m.n)), np.zeros(0, int)
    total, crowded = 0, False
    while True:
        fresh = min(max(least, total), most - total)
        v = rng.uniform(-1, 1, (fresh, m.n)) * span
        ends = compiled_newton(library, m, pose, v, code) if library else damped_newton(m, pose, v, code)
        total += fresh
        for i in range(len(reps)):
            near = gap(m, ends, reps[i]) < SAME
            hits[i] += near.sum()
            ends = ends[~near]
        while len(ends) and len(reps) < at_most:
            near = gap(m, ends, ends[0]) < SAME
            reps, hits = np.vstack([reps, ends[:1]]), np.append(hits, near.sum())
            ends = ends[~near]
        crowded = len(ends) > 0
        if crowded or total >= most or (len(reps) and hits.min() >= sure):
            break
    if not len(reps):
        return Found(reps, hits, np.zeros(0), np.zeros(0), False)
    v, residual, sigma = polish(m, pose, reps, code, rounds=2)
    weak = sigma < 1e-4  # near a double root Newton is slow at first
    if weak.any():
        v[weak], residual[weak], sigma[weak] = polish(m, pose, v[weak], code, rounds=8)
    keep = residual <= 1e-11 * (1 + np.abs(pose).max())
    return distinct(m, v[keep], hits[keep], sigma[keep], residual[keep], crowded)


@dataclass
class Compared:
    """How an arm's rows and the found solutions of a pose differ.

    Attributes:
        missing: Found solutions that no row matches, (q, hits, sigma).
        extra: Rows that do not close, or match a solution that another row matches already, (q, why).
        unseen: Rows that close and that the search has not found, (q, sigma): a weakness of the search.
        sigma: Smallest singular value over all solutions, inf where there is none.
    """

    missing: list = field(default_factory=list)
    extra: list = field(default_factory=list)
    unseen: list = field(default_factory=list)
    sigma: float = np.inf


def compare(m: Machine, T, rows, found: Found, task="pose") -> Compared:
    """Hold rows (k, n) against what was found."""
    out = Compared()
    pose, code = m.pose(T), TASKS[task]
    mine, theirs = m.inner(found.q), m.inner(np.asarray(rows).reshape(-1, m.n))
    taken = np.zeros(len(mine), bool)
    if len(mine):
        out.sigma = float(found.sigma.min())
    if len(theirs):
        left = np.linalg.norm(equations(m, theirs, pose, code)[0], axis=1) / (1 + np.linalg.norm(pose[:3, 3]))
        sigma = polish(m, pose, theirs, code, rounds=0)[2]
        out.sigma = min(out.sigma, float(sigma.min()))
    for i in range(len(theirs)):
        if left[i] > CLOSED:
            out.extra.append((rows[i].tolist(), f"does not close: {left[i]:.1e}"))
            continue
        near = gap(m, mine, theirs[i]) if len(mine) else np.zeros(0)
        wide = SAME + ROUNDED / max(sigma[i], 1e-300)
        order = [j for j in np.argsort(near) if near[j] <= wide + ROUNDED / max(found.sigma[j], 1e-300)]
        untaken = [j for j in order if not taken[j]]
        if untaken:
            taken[untaken[0]] = True
        elif order:
            out.extra.append((rows[i].tolist(), f"given twice, {near[order[0]]:.1e} apart, sigma {sigma[i]:.1e}"))
        else:
            out.unseen.append((rows[i].tolist(), float(sigma[i])))
    for j in np.flatnonzero(~taken):
        out.missing.append((found.q[j].tolist(), int(found.hits[j]), float(found.sigma[j])))
    return out
