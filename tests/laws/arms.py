"""Random arms of every kind, and ways to say the same arm differently."""

from __future__ import annotations

import numpy as np

from pieper import DH, Arm
from pieper.kinematics.chain import Chain
from pieper.kinematics.geometry import axes_at, from_axes
from pieper.kinematics.pose import rotation_about, transform

QUARTER = np.pi / 2


def random_pose(rng: np.random.Generator, size: float = 0.5) -> np.ndarray:
    """Return a random pose (4, 4)."""
    axis = rng.standard_normal(3)
    return transform(
        rotation_about(axis / np.linalg.norm(axis), rng.uniform(-np.pi, np.pi)), rng.uniform(-size, size, 3)
    )


def _dressed(rows, rng, types="RRRRRR", dressed=True, name="random") -> Arm:
    base = random_pose(rng) if dressed else None
    tool = random_pose(rng, 0.2) if dressed else None
    return Arm.from_dh(rows, convention="standard", joint_types=types, base=base, tool=tool, name=name)


def _length(rng) -> float:
    return rng.uniform(0.1, 0.8) * rng.choice([-1, 1])


def _angle(rng) -> float:
    return rng.uniform(-np.pi, np.pi)


def _wrist(rng, last: float) -> list[DH]:
    first = rng.choice([-1, 1]) * QUARTER
    return [
        DH(0, first, _length(rng), _angle(rng)),
        DH(0, -first if rng.uniform() < 0.7 else first, 0, _angle(rng)),
        DH(rng.uniform(0, 0.1), _angle(rng), last, _angle(rng)),
    ]


def spherical_wrist_parallel(rng, dressed=True) -> Arm:
    """Anthropomorphic: axis 1 across 2 and 3, which are parallel; offsets of any sign; an orthogonal wrist."""
    a1 = rng.choice([0.0, _length(rng)])
    b = rng.choice([0.0, _length(rng) / 2])
    rows = [
        DH(a1, rng.choice([-1, 1]) * QUARTER, _length(rng), _angle(rng)),
        DH(_length(rng), rng.choice([0, np.pi]), b, _angle(rng)),
        DH(
            rng.choice([0.0, _length(rng) / 3]),
            rng.choice([-1, 1]) * QUARTER,
            rng.choice([0.0, _length(rng) / 3]),
            _angle(rng),
        ),
        *_wrist(rng, _length(rng)),
    ]
    return _dressed(rows, rng, dressed=dressed, name="spherical wrist, parallel 2 and 3")


def spherical_wrist(rng, dressed=True) -> Arm:
    """Any three first joints, revolute or prismatic, and a spherical wrist."""
    types = "".join(rng.choice(["R", "R", "P"], 3))
    rows = [DH(_length(rng), _angle(rng), _length(rng), _angle(rng)) for _ in range(3)]
    rows[2] = DH(rng.choice([0.0, _length(rng)]), rows[2].alpha, rows[2].d, rows[2].theta)
    return _dressed([*rows, *_wrist(rng, _length(rng))], rng, types + "RRR", dressed, f"{types} and wrist")


def three_parallel(rng, dressed=True) -> Arm:
    """Joints 2, 3 and 4 parallel, as on the arms of Universal Robots."""
    rows = [
        DH(0, rng.choice([-1, 1]) * QUARTER, _length(rng), _angle(rng)),
        DH(_length(rng), 0, 0, _angle(rng)),
        DH(_length(rng), 0, 0, _angle(rng)),
        DH(0, rng.choice([-1, 1]) * QUARTER, _length(rng), _angle(rng)),
        DH(0, rng.choice([-1, 1]) * QUARTER, _length(rng), _angle(rng)),
        DH(0, 0, _length(rng), _angle(rng)),
    ]
    return _dressed(rows, rng, dressed=dressed, name="three parallel")


def offset_wrist(rng, dressed=True) -> Arm:
    """Parallel second and third axes and a wrist with an offset."""
    rows = [
        DH(rng.choice([0.0, _length(rng)]), QUARTER, _length(rng), _angle(rng)),
        DH(_length(rng), rng.choice([0, np.pi]), 0, _angle(rng)),
        DH(_length(rng) / 3, QUARTER, 0, _angle(rng)),
        DH(0, -QUARTER, _length(rng), _angle(rng)),
        DH(rng.choice([0.0, 0.05]), QUARTER, _length(rng) / 4, _angle(rng)),
        DH(0, 0, _length(rng), _angle(rng)),
    ]
    return _dressed(rows, rng, dressed=dressed, name="offset wrist")


def general(rng, dressed=True) -> Arm:
    """Six revolute joints in no special arrangement."""
    rows = [DH(_length(rng), _angle(rng), _length(rng), _angle(rng)) for _ in range(6)]
    return _dressed(rows, rng, dressed=dressed, name="general 6R")


def general_mixed(rng, dressed=True) -> Arm:
    """Six joints, one or two of them prismatic, in no special arrangement."""
    types = ["R"] * 6
    for i in rng.choice(6, rng.integers(1, 3), replace=False):
        types[i] = "P"
    rows = [DH(_length(rng), _angle(rng), _length(rng), _angle(rng)) for _ in range(6)]
    return _dressed(rows, rng, "".join(types), dressed, f"general {''.join(types)}")


KINDS = (spherical_wrist_parallel, spherical_wrist, three_parallel, offset_wrist, general, general_mixed)


def random_joints(arm: Arm, rng, count: int) -> np.ndarray:
    """Return joint vectors (count, n): angles over the whole turn, prismatic joints over the arm's length."""
    span = np.where(arm.chain.prismatic, arm.chain.length, np.pi)
    return span * rng.uniform(-1, 1, (count, arm.n))


def from_chain(chain: Chain, name: str = "chain") -> Arm:
    """Return an arm whose chain is the given one, made of modified DH rows with general base and tool.

    Every link is put into base, tool or a row by way of the common normals, so the table looks nothing like the
    one the chain came from.
    """
    from pieper.description.dh import describe

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
        frames.append(transform(np.stack([x, np.cross(z[i], x), z[i]], 1), foot))
    rows, offsets = [], []
    base = frames[0]
    for i in range(chain.n):
        if i == 0:
            a = alpha = d = theta = 0.0
        else:
            M = np.linalg.inv(frames[i - 1]) @ frames[i]
            a, alpha = M[0, 3], np.arctan2(M[2, 1] if False else -M[1, 2], M[2, 2])
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
