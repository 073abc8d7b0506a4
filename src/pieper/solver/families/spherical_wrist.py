"""Six joints with a spherical wrist at the end, at the base or inside the chain, and any other three joints."""

from __future__ import annotations

from dataclasses import dataclass

from pieper import _kernel
from pieper.kinematics.chain import Chain
from pieper.kinematics.geometry import Geometry
from pieper.solver.families.family import Family, KernelSpec
from pieper.solver.families.loop import centred, positioning_rank
from pieper.solver.families.pairs import group


@dataclass(frozen=True)
class Match:
    """A spherical wrist found.

    Args:
        first: 0-based index of its first joint.
        margin: How far the three axes miss one point, m.
    """

    first: int
    margin: float


def match(chain: Chain, geometry: Geometry) -> Match | None:
    """Return the spherical wrist of a six-joint chain whose other three joints can place its centre, or None.

    A wrist at the end is preferred, then at the base, then inside: the positioning problem of the first two does not
    change with the pose.
    """
    if chain.n != 6:
        return None
    found = [Match(group.joints[0], group.margin) for group in geometry.spherical]
    found = [m for m in found if positioning_rank(chain, m.first) == 3]
    order = {3: 0, 0: 1, 1: 2, 2: 2}
    return min(found, key=lambda m: (order[m.first], m.margin), default=None)


def prepare(chain: Chain, found: Match) -> KernelSpec:
    """Return the kernel's numbers.

    Solves W Pre Za A Zb B Zc C = I for at most four positions of the wrist's centre and two turns of the wrist each:
    eight solutions. It degenerates where the wrist's outer axes line up, where the centre meets an axis or leaves the
    reach; the pose is then flagged and one representative of each family is returned.
    """
    links = centred(chain, found.first)
    return KernelSpec(
        _kernel.SphericalWrist(**group(chain, links, found.first, False)),
        closed_form=True,
    )


FAMILY = Family(
    name="spherical_wrist",
    arrangement="three neighbouring axes that meet in one point",
    words=(
        "The point where they meet depends on the other three joints alone: a positioning problem with at "
        "most four solutions. The three meeting axes then turn the tool, in at most two ways each."
    ),
    match=match,
    prepare=prepare,
)
