"""Arms for the oracle to judge: random ones of every kind, perturbed ones, known ones without their limits."""

from __future__ import annotations

from typing import Any

import numpy as np

import pieper
from oracle.arms import kinds
from oracle.arms.gauge import from_chain
from oracle.arms.tables import TABLES
from pieper import DH, Arm

QUARTER = np.pi / 2


def free(name: str, *, placed: bool = False) -> Arm:
    """Return an arm of the catalogue without its limits; without its base and tool too, unless `placed`."""
    d = pieper.load(name).description
    types = "".join(d.joint_types)
    said: dict[str, Any] = {"sign": d.sign, "offset": d.offset, "name": name} | (
        {"base": d.base, "tool": d.tool} if placed else {}
    )
    return Arm.from_dh(d.rows, convention=d.convention, joint_types=types, **said)


def tabled(name: str) -> Arm:
    """Return an arm of the speed benchmark."""
    return Arm.from_dh([DH(a, alpha, d, 0.0) for d, a, alpha in TABLES[name]], convention="standard", name=name)


def structured(rng, slides=0.2, n=6) -> Arm:
    """Return an arm whose twists are mostly right angles or nothing and half of whose lengths are zero."""
    types = "".join("P" if rng.uniform() < slides else "R" for _ in range(n))
    rows = []
    for _ in range(n):
        alpha = rng.choice([0, QUARTER, -QUARTER, np.pi, rng.uniform(-3, 3)], p=[0.25, 0.25, 0.25, 0.05, 0.2])
        a, d = rng.choice([0, rng.uniform(-0.6, 0.6)]), rng.choice([0, rng.uniform(-0.6, 0.6)])
        rows.append(DH(a, alpha, d, rng.choice([0, rng.uniform(-3, 3)])))
    return Arm.from_dh(rows, convention="standard", joint_types=types, name=f"structured {types}")


def perturbed(name: str, size: float, rng) -> Arm:
    """Return an arm of the catalogue with errors in its lengths (m) and twists (rad)."""
    d = pieper.load(name).description
    rows = [
        DH(
            r.a + size * rng.standard_normal(),
            r.alpha + size * rng.standard_normal(),
            r.d + size * rng.standard_normal(),
            r.theta,
        )
        for r in d.rows
    ]
    return Arm.from_dh(rows, convention=d.convention, name=f"{name} with errors of {size:g}")


def backwards(kind):
    """Return a maker of the same arms with base and tool exchanged."""
    return lambda rng: from_chain(kind(rng).chain.reversed())


KINDS = {kind.__name__: kind for kind in kinds.KINDS}
KINDS |= {f"{kind.__name__} backwards": backwards(kind) for kind in kinds.KINDS[:4]}
KINDS |= {"structured": structured, "structured 6R": lambda rng: structured(rng, 0.0)}
