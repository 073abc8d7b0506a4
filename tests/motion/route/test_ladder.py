"""The kernel's ladder beside a dynamic programme over every step, branch and whole turn, written anew."""

import itertools

import numpy as np
import pytest

from pieper import _kernel

TURN = 2 * np.pi


def cheapest(q, valid, limits, weights, longest, parts, near, largest):
    """Return the cost of the cheapest chain, whole turns of the joints written out."""
    rungs, cells, rows, n = q.shape
    wide = [range(int(np.floor((high - low) / TURN)) + 1) for low, high in limits]
    lifts = np.array(list(itertools.product(*wide))) * TURN
    cost = best = before = np.zeros(0)
    for r in range(rungs):
        at = q[r][:, :, None] + lifts
        good = valid[r][:, :, None] & ((at >= limits[:, 0]) & (at <= limits[:, 1])).all(-1)
        if r == 0:
            cost = np.where(good, 0.0, np.inf)
        else:
            best = np.full(good.shape, np.inf)
            for c, others in enumerate(near):
                for other in others[others >= 0]:
                    gap = np.abs(at[c][:, :, None, None] - before[other])
                    step = (np.sqrt(weights) * gap).max(-1) if largest else (weights * gap**2).sum(-1) / parts[r - 1]
                    step = np.where((gap > longest[r - 1]).any(-1), np.inf, step) + cost[other]
                    best[c] = np.minimum(best[c], step.min((2, 3)))
            cost = np.where(good, best, np.inf)
        before = at
    return cost.min()


@pytest.mark.parametrize("largest", [False, True])
def test_the_cheapest_chain_is_that_of_every_step_looked_at(largest):
    rng = np.random.default_rng(11)
    reached = 0
    for _ in range(40):
        rungs, cells, rows, n = 5, 6, 3, 3
        limits = np.array([[-np.pi, np.pi], [-TURN, TURN], [-2.5, 2.0]])
        q = limits[:, 0] + rng.uniform(0, TURN, (rungs, cells, rows, n))
        # rows that hang together, so that there are ways, among others that do not
        q[..., 0] = (
            limits[0, 0]
            + (np.cumsum(rng.uniform(-0.4, 0.9, rungs))[:, None, None] + 0.3 * rng.random(q.shape[:3])) % TURN
        )
        q[..., 1] = limits[1, 0] + (3 + 0.7 * np.arange(rungs)[:, None, None] + 0.4 * rng.random(q.shape[:3])) % TURN
        q[..., 2] = np.where(rng.random(q.shape[:3]) < 0.7, 0.5 * rng.random(q.shape[:3]), q[..., 2])
        valid = rng.random(q.shape[:3]) < 0.8
        around = np.arange(cells)[:, None] + np.array([0, -1, 1])
        near = np.where((around >= 0) & (around < cells), around, -1)
        weights, parts = rng.uniform(0.5, 2.0, n), rng.integers(1, 4, rungs - 1).astype(float)
        longest = rng.uniform(0.5, 1.4, (rungs - 1, n))
        _, _, cost, furthest, _ = _kernel.ladder(
            q=q,
            valid=valid,
            limits=limits,
            circle=np.ones(n, bool),
            weights=weights,
            longest=longest,
            parts=parts,
            near=near,
            spot=near,
            on_spot=np.full(n, -1.0),
            largest=largest,
            slack=1e-9,
            first=np.full(n, -1, np.int32),
            last=np.full(n, -1, np.int32),
        )
        wanted = cheapest(q, valid, limits, weights, longest, parts, near, largest)
        assert np.isfinite(wanted) == (furthest == rungs - 1)
        if np.isfinite(wanted):
            reached += 1
            # the kernel adds in single precision
            assert cost == pytest.approx(wanted, rel=2e-6)
    assert 10 < reached
