"""Random arms of every family, as DH tables."""

from __future__ import annotations

import numpy as np

from pieper import DH, Arm
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
