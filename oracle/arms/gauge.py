"""Ways to say the same arm differently: other frames, other senses, a table made from a chain."""

from __future__ import annotations

import numpy as np

from pieper import DH, Arm
from pieper.description.said import describe
from pieper.kinematics.chain import Chain
from pieper.kinematics.geometry import axes_at, from_axes
from pieper.kinematics.pose import transform


def from_chain(chain: Chain, name: str = "chain") -> Arm:
    """Return an arm whose chain is the given one, made of modified DH rows with general base and tool.

    Every link is put into base, tool or a row by way of the common normals, so the table looks nothing like the
    one the chain came from.
    """
    rows, offsets, base, tool = modified_rows(chain)
    types = "".join("P" if p else "R" for p in chain.prismatic)
    return Arm(
        describe(rows, convention="modified", joint_types=types, base=base, tool=tool, offset=offsets, name=name)
    )


def modified_rows(chain: Chain):
    """Return modified DH rows, offsets, base and tool that describe a chain's motion."""
    frames = []
    z, o = axes_at(chain, np.zeros(chain.n))
    for i in range(chain.n):
        if i + 1 < chain.n:
            u, v, w = z[i], z[i + 1], o[i + 1] - o[i]
            cross = np.cross(u, v)
            if np.linalg.norm(cross) > 1e-9:
                x = cross / np.linalg.norm(cross)
                t = np.linalg.lstsq(np.stack([u, -v, x], 1), w, rcond=None)[0]
                foot = o[i] + t[0] * u
            else:
                away = w - (w @ u) * u
                x = away / np.linalg.norm(away) if np.linalg.norm(away) > 1e-9 else _any_normal(u)
                foot = o[i]
        else:
            x, foot = _any_normal(z[i]), o[i]
        frames.append(transform(np.stack([x, np.asarray(np.cross(z[i], x), float), z[i]], 1), foot))
    rows, offsets = [], []
    base = frames[0]
    for i in range(chain.n):
        if i == 0:
            a = alpha = d = theta = 0.0
        else:
            M = np.linalg.inv(frames[i - 1]) @ frames[i]
            a, alpha = M[0, 3], np.arctan2(-M[1, 2], M[2, 2])
            theta = np.arctan2(-M[0, 1], M[0, 0])
            d = M[2, 3] * np.cos(alpha) - M[1, 3] * np.sin(alpha)
        rows.append(DH(a, alpha, d, theta))
        offsets.append(0.0)
    tool = np.linalg.inv(frames[-1]) @ chain.home
    return rows, offsets, base, tool


def _any_normal(u: np.ndarray) -> np.ndarray:
    seed = np.eye(3)[np.argmin(np.abs(u))]
    x = seed - (seed @ u) * u
    return x / np.linalg.norm(x)


def slid(chain: Chain, rng) -> Chain:
    """Return the same motion from points slid along the axes and frames turned about them."""
    z, o = axes_at(chain, np.zeros(chain.n))
    return from_axes(z, o + rng.uniform(-1, 1, (chain.n, 1)) * z, chain.prismatic, chain.home)


def flipped(chain: Chain, joint: int) -> Chain:
    """Return the chain with one axis turned over: that joint runs the other way."""
    z, o = axes_at(chain, np.zeros(chain.n))
    z = z.copy()
    z[joint] *= -1
    return from_axes(z, o, chain.prismatic, chain.home)
