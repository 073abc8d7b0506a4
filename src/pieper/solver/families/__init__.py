"""One solver family per file; each says which arms it takes and prepares its kernel.

A family module has `match(chain, geometry)`, which returns what it recognised or None, and
`prepare(chain, match)`, which returns the KernelSpec. They are asked in the order of FAMILIES, the fastest first.
"""

from __future__ import annotations

from importlib import import_module

from pieper.kinematics.chain import Chain
from pieper.kinematics.geometry import Geometry
from pieper.solver.families.spec import KernelSpec

FAMILIES = ("spherical_wrist_parallel", "spherical_wrist", "three_parallel", "offset_wrist", "two_slides", "general")
#: Families that eliminate joints: next to a self-motion the elimination is nearly singular and may hide solutions.
ELIMINATING = ("offset_wrist", "two_slides", "general")


def choose(chain: Chain, geometry: Geometry, families: tuple[str, ...] = FAMILIES) -> tuple[str, KernelSpec]:
    """Return the first family that takes a six-joint chain, prepared for it; `general` comes last and takes all it can.

    Raises:
        PlanError: No family takes the chain; raised by the last one asked, with the reason.
    """
    for name in families:
        family = import_module(f"pieper.solver.families.{name}")
        match = family.match(chain, geometry)
        if match is not None:
            return name, family.prepare(chain, match)
    raise LookupError("no family takes this chain")


def tier(chain: Chain, geometry: Geometry) -> int:
    """Return how early in FAMILIES a chain is taken, without preparing it; fewer is faster."""
    for index, name in enumerate(FAMILIES[:-1]):
        if import_module(f"pieper.solver.families.{name}").match(chain, geometry) is not None:
            return index
    return len(FAMILIES) - 1
