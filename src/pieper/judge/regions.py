"""Where a claim holds: the search for the region of joint space that separates its successes from its failures."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator

import numpy as np

from pieper.algebra.expression import Div, Expr
from pieper.judge.arm_sides import FORWARD, Feature, arm_features
from pieper.judge.evidence import Evidence
from pieper.tolerances import BORDER_OF_REGION, ROUNDING

FRESH = 2000  # joint vectors at which a region is confirmed
ENOUGH = 20  # of them that must lie in it


def region_features(ev: Evidence, env: dict[str, np.ndarray], own: list[str]) -> list[Feature]:
    """Return (words, value) whose signs may bound a region.

    They are sines and cosines of joints and of runs of joints, the file's symbols, how far the arm reaches forward, and
    to which side its elbows bend.
    """
    n = ev.model.n
    features = []
    for first in range(1, n + 1):
        for last in range(first, min(n, first + 2) + 1):
            angle = sum(env[f"theta{j}"] for j in range(first, last + 1))
            name = "+".join(f"theta{j}" for j in range(first, last + 1))
            features += [(f"sin({name})", np.sin(angle)), (f"cos({name})", np.cos(angle))]
    features += [(name, env[name]) for name in own if name in env and np.ndim(env[name]) == 1]
    features.sort(key=lambda f: (f[0].count("+"), f[0] not in own))
    return features + arm_features(ev.model, ev.samples)


Inside = Callable[[list[Feature]], np.ndarray]


def region_of(ev: Evidence, judged: Callable[[Evidence], tuple[np.ndarray, dict[str, np.ndarray]]]) -> str:
    """Return the region in which a claim holds, in words such as "sin(theta5) < 0"; "" when no simple one does.

    A region that separates a hundred samples may do so by chance; it is said only when it separates fresh ones too.

    Args:
        ev: the arm and its samples.
        judged: evidence -> where the claim holds (K,) bool, and the values of all symbols.
    """
    own = list(ev.definitions)

    def seen(at: Evidence) -> tuple[np.ndarray, list[Feature]]:
        holds, env = judged(at)
        nominal = at.samples.nominal
        rows = nominal if holds[nominal].any() else np.ones_like(nominal)
        return holds[rows], [(name, value[rows]) for name, value in region_features(at, env, own)]

    holds, features = seen(ev)
    fresh: tuple[np.ndarray, list[Feature]] | None = None
    for words, inside, places in _separating(holds, features):
        fresh = fresh or seen(ev.drawn(FRESH, seed=314_159))
        clear = np.all([np.abs(fresh[1][k][1]) > BORDER_OF_REGION for k in places], axis=0)
        mask = inside(fresh[1])
        if np.array_equal(mask[clear], fresh[0][clear]) and mask.sum() >= ENOUGH:
            return words
    return ""


def _separating(holds: np.ndarray, features: list[Feature]) -> Iterator[tuple[str, Inside, tuple[int, ...]]]:
    """Yield the regions, simplest first, that hold exactly the samples at which a claim held."""
    if holds.all() or not holds.any():
        return
    for words, inside, places in _regions([name for name, _ in features]):
        if np.array_equal(inside(features), holds):
            yield words, inside, places


def _regions(names: list[str]) -> Iterator[tuple[str, Inside, tuple[int, ...]]]:
    for k, name in enumerate(names):
        front, rear = (" (front)", " (rear)") if name.startswith(FORWARD) else ("", "")
        yield f"{name} > 0{front}", (lambda f, k=k: f[k][1] > 0), (k,)
        yield f"{name} < 0{rear}", (lambda f, k=k: ~(f[k][1] > 0)), (k,)
    pairs = list(itertools.combinations(range(len(names)), 2))
    for i, j in pairs:
        both = f"{names[i]} and {names[j]} have"
        yield f"{both} the same sign", (lambda f, i=i, j=j: (f[i][1] > 0) == (f[j][1] > 0)), (i, j)
        yield f"{both} opposite signs", (lambda f, i=i, j=j: (f[i][1] > 0) != (f[j][1] > 0)), (i, j)
    for (i, j), x, y in itertools.product(pairs, (1, -1), (1, -1)):
        words = f"{names[i]} {'>' if x > 0 else '<'} 0 and {names[j]} {'>' if y > 0 else '<'} 0"
        yield words, (lambda f, i=i, j=j, x=x, y=y: (x * f[i][1] > 0) & (y * f[j][1] > 0)), (i, j)


def zero_denominators(root: Expr, env: dict[str, np.ndarray]) -> list[str]:
    """Return the denominators that vanish at every sample."""
    out = []
    for node in root.walk():
        if isinstance(node, Div):
            with np.errstate(all="ignore"):
                value = np.asarray(node.args[1].evaluate(env), dtype=float)
            if np.all(np.abs(value) < ROUNDING):
                out.append(str(node.args[1]))
    return out
