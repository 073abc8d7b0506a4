"""One solver family per file; each says which arms it takes, prepares its kernel and tells how it solves."""

from __future__ import annotations

from pieper.kinematics.chain import Chain
from pieper.kinematics.geometry import Geometry
from pieper.solver.families import (
    general,
    offset_wrist,
    spherical_wrist,
    spherical_wrist_parallel,
    three_parallel,
    two_slides,
)
from pieper.solver.families.family import Family, KernelSpec

#: Every family, in the order in which they are asked: the fastest first, the one that takes all it can last.
FAMILIES: tuple[Family, ...] = (
    spherical_wrist_parallel.FAMILY,
    spherical_wrist.FAMILY,
    three_parallel.FAMILY,
    offset_wrist.FAMILY,
    two_slides.FAMILY,
    general.FAMILY,
)


def named(name: str) -> Family:
    """Return the family of this name."""
    return next(family for family in FAMILIES if family.name == name)


def choose(chain: Chain, geometry: Geometry, families: tuple[Family, ...] = FAMILIES) -> tuple[str, KernelSpec]:
    """Return the name of the first family that takes a six-joint chain, and its kernel prepared for it.

    Raises:
        PlanError: No family takes the chain; raised by the last one asked, with the reason.
    """
    for family in families:
        match = family.match(chain, geometry)
        if match is not None:
            return family.name, family.prepare(chain, match)
    raise LookupError("no family takes this chain")


def tier(chain: Chain, geometry: Geometry) -> int:
    """Return how early in FAMILIES a chain is taken, without preparing it; fewer is faster."""
    for index, family in enumerate(FAMILIES[:-1]):
        if family.match(chain, geometry) is not None:
            return index
    return len(FAMILIES) - 1
