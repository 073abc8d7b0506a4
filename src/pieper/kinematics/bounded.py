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
    coupling, extra = chain.coupling, chain.axis_count - chain.n
    if coupling is not None and extra:
        # the kernel takes as many numbers as axes: those that are too many move nothing
        coupling = np.pad(coupling, ((0, 0), (0, extra)))
        q, limits = np.pad(q, ((0, 0), (0, extra))), np.pad(limits, ((0, extra), (0, 0)))
    found, left = _kernel.nearer(
        chain.plain,
        coupling=coupling,
        lower=np.ascontiguousarray(limits[:, 0]),
        upper=np.ascontiguousarray(limits[:, 1]),
        q=np.ascontiguousarray(q),
        T=T,
        turning=turning,
        steps=steps,
    )
    return found[:, : chain.n], left
