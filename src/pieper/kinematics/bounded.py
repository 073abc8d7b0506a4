"""How near a tool comes to a pose inside limits: Newton on the distance itself, with its second derivatives."""

from __future__ import annotations

import numpy as np

from pieper import _kernel
from pieper.kinematics.arrays import Array
from pieper.kinematics.chain import Chain


def nearer(chain: Chain, q: Array, T: Array, limits: Array, turning: Array, steps: int) -> tuple[Array, Array]:
    """Go downhill from joint vectors q (k, n) in |p - p_T|^2 / 2 + turning (1 - cos angle), inside limits.

    The remainder is large where a pose is out of reach: Gauss's and Newton's step would crawl, so the second
    derivatives are taken as they are, with their eigenvalues' absolute values (kernels/chain/nearer.cpp).

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
    coupling, limits = by_axes(chain, limits)
    found, left = _kernel.nearer(
        chain.plain,
        coupling=coupling,
        lower=limits[:, 0],
        upper=limits[:, 1],
        q=as_axes(chain, q),
        T=T,
        turning=turning,
        steps=steps,
    )
    return found[:, : chain.n], left


def by_axes(chain: Chain, limits: Array) -> tuple[Array | None, Array]:
    """Return coupling and limits as the kernel takes them: a number an axis, those that are too many move nothing."""
    extra = chain.axis_count - chain.n
    if chain.coupling is None or not extra:
        return chain.coupling, limits
    return np.pad(chain.coupling, ((0, 0), (0, extra))), np.pad(limits, ((0, extra), (0, 0)))


def as_axes(chain: Chain, q: Array) -> Array:
    """Return joint vectors (k, n) with a number an axis, (k, axes)."""
    return q if chain.coupling is None else np.pad(q, ((0, 0), (0, chain.axis_count - chain.n)))
