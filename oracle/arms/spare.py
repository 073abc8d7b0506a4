"""Arms with joints to spare: the catalogue's of seven joints, and arms of no name of seven and of eight."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

import pieper
from pieper import DH, Arm, PlanError

#: Arms of seven joints in all, and of eight.
SEVEN, EIGHT = 20, 10
SEED = 7_8


def of_no_name(joints: int, number: int) -> Arm:
    """Return a random arm of turns, every other one with any twists, the others with none and right angles.

    Where chance makes an arm that no six joints can solve, the next one is drawn.
    """
    rng = np.random.default_rng([SEED, joints, number])
    while True:
        rows = []
        for _ in range(joints):
            a = rng.uniform(-0.5, 0.5) * (number % 2 == 0 or rng.uniform() < 0.7)
            alpha = rng.uniform(-3, 3) if number % 2 == 0 else rng.choice([0.0, np.pi / 2, -np.pi / 2])
            rows.append(DH(float(a), float(alpha), float(rng.uniform(-0.5, 0.5)), 0.0))
        arm = Arm.from_dh(rows, convention="standard", name=f"{joints} joints, no. {number}")
        try:
            arm.plan  # noqa: B018
        except PlanError:
            continue
        return arm


def known(name: str) -> Callable[[], Arm]:
    """Return a call that loads an arm of the catalogue."""
    return lambda: pieper.load(name)


def drawn(joints: int, number: int) -> Callable[[], Arm]:
    """Return a call that makes a random arm."""
    return lambda: of_no_name(joints, number)


def spare_arms() -> dict[str, Callable[[], Arm]]:
    """Return twenty arms of seven joints and ten of eight by name."""
    out = {name: known(name) for name in pieper.catalog() if pieper.load(name).n == 7}
    out |= {f"7 joints, no. {k}": drawn(7, k) for k in range(SEVEN - len(out))}
    return out | {f"8 joints, no. {k}": drawn(8, k) for k in range(EIGHT)}


ARMS = spare_arms()
