"""Random arms of revolute and prismatic joints in any order, each made again from its number alone."""

from __future__ import annotations

import numpy as np

from pieper import DH, Arm

SEED = 20_25
QUARTER = np.pi / 2


def turned(rng, reach: float) -> np.ndarray:
    """Return a random pose (4, 4)."""
    x, y, z, w = (v := rng.standard_normal(4)) / np.linalg.norm(v)
    T = np.eye(4)
    T[:3, :3] = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    T[:3, 3] = rng.uniform(-reach, reach, 3)
    return T


def letters(rng, n: int = 6) -> str:
    """Return joint types: any number of slides, few more often than many, anywhere."""
    slides = min(n, int(rng.choice(7, p=[0.28, 0.22, 0.18, 0.14, 0.08, 0.05, 0.05])))
    types = np.array(["R"] * n)
    types[rng.choice(n, slides, replace=False)] = "P"
    return "".join(types)


def any_angle(rng) -> float:
    return rng.uniform(-np.pi, np.pi)


def drawn_angle(rng) -> float:
    """Return a twist as drawings have it: mostly right angles or none, now and then 30, 45 or 60 degrees."""
    if rng.uniform() < 0.12:
        return float(rng.choice([-1, 1]) * np.radians(rng.choice([30, 45, 60])))
    return float(rng.choice([0, QUARTER, -QUARTER, np.pi], p=[0.3, 0.32, 0.32, 0.06]))


def any_length(rng) -> float:
    return rng.uniform(0.05, 0.8) * rng.choice([-1, 1])


def drawn_length(rng) -> float:
    """Return a length in whole millimetres, nothing as often as not."""
    return float(rng.choice([0, 1])) * round(any_length(rng), 3)


def scaled_length(rng) -> float:
    """Return a length from a millimetre to a kilometre, nothing in one case of three."""
    return float(rng.choice([0, 1], p=[0.33, 0.67])) * 10 ** rng.uniform(-3, 3) * rng.choice([-1, 1])


def general(rng, n: int = 6) -> list[DH]:
    """Every length and angle any."""
    return [DH(any_length(rng), any_angle(rng), any_length(rng), any_angle(rng)) for _ in range(n)]


def drawn(rng, n: int = 6) -> list[DH]:
    """A table as makers print it."""
    zero = [0.0, 0.0, QUARTER, -QUARTER, np.pi]
    return [DH(drawn_length(rng), drawn_angle(rng), drawn_length(rng), float(rng.choice(zero))) for _ in range(n)]


def scales(rng, n: int = 6) -> list[DH]:
    """Lengths over six decades in one arm."""
    angle = [any_angle, drawn_angle][rng.integers(2)]
    return [DH(scaled_length(rng), angle(rng), scaled_length(rng), any_angle(rng)) for _ in range(n)]


def runs(rng, n: int) -> list[slice]:
    """Return one or two runs of two to four neighbouring links."""
    out = []
    for _ in range(rng.integers(1, 3)):
        first = int(rng.integers(0, max(1, n - 1)))
        out.append(slice(first, min(n - 1, first + int(rng.integers(1, 4)))))
    return out


def parallel(rng, n: int = 6) -> list[DH]:
    """Runs of two to four parallel axes, of either sense, in an arm that is otherwise any."""
    rows = [general, drawn][rng.integers(2)](rng, n)
    for run in runs(rng, n):
        for i in range(n)[run]:
            rows[i] = DH(any_length(rng), float(rng.choice([0, np.pi])), rows[i].d, rows[i].theta)
    return rows


def meeting(rng, n: int = 6) -> list[DH]:
    """Runs of axes that meet, half of them in one point, in an arm that is otherwise any."""
    rows = [general, drawn][rng.integers(2)](rng, n)
    for run in runs(rng, n):
        one_point = rng.uniform() < 0.5
        for k, i in enumerate(range(n)[run]):
            twist = float(rng.choice([-1, 1])) * (QUARTER if rng.uniform() < 0.5 else rng.uniform(0.3, 2.8))
            rows[i] = DH(0, twist, 0 if one_point and k else rows[i].d, rows[i].theta)
    return rows


def coincident(rng, n: int = 6) -> list[DH]:
    """One or two pairs of neighbouring axes on one line."""
    rows = [general, drawn, meeting][rng.integers(3)](rng, n)
    pairs = min(n - 1, int(rng.integers(1, 3)))
    for i in rng.choice(max(1, n - 1), pairs, replace=False):
        rows[i] = DH(0, float(rng.choice([0, np.pi])), rows[i].d, rows[i].theta)
    return rows


KINDS = (general, drawn, scales, parallel, meeting, coincident)


def random_arm(number: int, joints: int = 6, seed: int = SEED) -> tuple[Arm, str]:
    """Return the arm of a number and its kind: standard and modified tables, with and without base, tool and zeros."""
    rng = np.random.default_rng([seed, joints, number])
    kind = KINDS[number % len(KINDS)]
    rows, types = kind(rng, joints), letters(rng, joints)
    dressed = {}
    if rng.uniform() < 0.5:
        reach = float(sum(abs(r.a) + abs(r.d) for r in rows)) or 1.0
        dressed = {
            "base": turned(rng, reach),
            "tool": turned(rng, 0.2 * reach),
            "sign": rng.choice([-1, 1], joints),
            "offset": np.where(np.array(list(types)) == "P", 0.3 * reach, np.pi) * rng.uniform(-1, 1, joints),
        }
    convention = str(rng.choice(["standard", "modified"]))
    name = f"{kind.__name__} {types} {number}"
    return Arm.from_dh(rows, convention=convention, joint_types=types, name=name, **dressed), kind.__name__
