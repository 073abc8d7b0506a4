"""Where does a claim hold? The search for the region of joint space that separates its successes from its failures."""

from __future__ import annotations

import numpy as np

from pieper.algebra.expression import Div, Expr


def region_features(n: int, env: dict[str, np.ndarray], own: list[str]) -> list[tuple[str, np.ndarray]]:
    """Return (words, value) whose signs may bound a region.

    They are sines and cosines of joints and of runs of joints, and the file's symbols.
    """
    features = []
    for first in range(1, n + 1):
        for last in range(first, min(n, first + 2) + 1):
            angle = sum(env[f"theta{j}"] for j in range(first, last + 1))
            name = "+".join(f"theta{j}" for j in range(first, last + 1))
            features += [(f"sin({name})", np.sin(angle)), (f"cos({name})", np.cos(angle))]
    features += [(name, env[name]) for name in own if name in env and np.ndim(env[name]) == 1]
    features.sort(key=lambda f: (f[0].count("+"), f[0] not in own))
    return features


def find_region(holds: np.ndarray, features: list[tuple[str, np.ndarray]]) -> str:
    """Return the region in words, such as "sin(theta5) < 0"; "" when no single sign separates the samples.

    Args:
        holds: (K,) bool, where the claim held.
        features: from `region_features`.
    """
    if holds.all() or not holds.any():
        return ""
    for name, value in features:
        positive = value > 0
        if np.array_equal(positive, holds):
            return f"{name} > 0"
        if np.array_equal(~positive, holds):
            return f"{name} < 0"
    for k, (first, x) in enumerate(features):
        for second, y in features[k + 1 :]:
            same = (x > 0) == (y > 0)
            if np.array_equal(same, holds):
                return f"{first} and {second} have the same sign"
            if np.array_equal(~same, holds):
                return f"{first} and {second} have opposite signs"
    for k, (first, x) in enumerate(features):
        for second, y in features[k + 1 :]:
            for sx in (1, -1):
                for sy in (1, -1):
                    both = (sx * x > 0) & (sy * y > 0)
                    if np.array_equal(both, holds):
                        return f"{first} {'>' if sx > 0 else '<'} 0 and {second} {'>' if sy > 0 else '<'} 0"
    return ""


def zero_denominators(root: Expr, env: dict[str, np.ndarray]) -> list[str]:
    """Return the denominators that vanish at every sample."""
    out = []
    for node in root.walk():
        if isinstance(node, Div):
            with np.errstate(all="ignore"):
                value = np.asarray(node.args[1].evaluate(env), dtype=float)
            if np.all(np.abs(value) < 1e-12):
                out.append(str(node.args[1]))
    return out
