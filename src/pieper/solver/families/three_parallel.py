"""Six joints, three neighbouring ones of a plane (three parallel axes, or slides across them), wherever they stand."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper import _kernel
from pieper.kinematics.chain import Chain
from pieper.kinematics.geometry import Geometry
from pieper.kinematics.newton import scaled_jacobian
from pieper.solver.families.family import Family, KernelSpec
from pieper.solver.families.loop import full_rank, planar, rank
from pieper.solver.families.pairs import group


@dataclass(frozen=True)
class Match:
    """Three joints of a plane found.

    Args:
        first: 0-based index of the first of them.
        normal: (3,) the plane's normal at zero, world frame.
        margin: How far a joint leans out of the plane at worst, rad.
    """

    first: int
    normal: tuple[float, float, float]
    margin: float


def match(chain: Chain, geometry: Geometry) -> Match | None:
    """Return three neighbouring planar joints of a six-joint chain whose Jacobian has full rank, or None.

    Turning axes must be parallel and slides perpendicular to them within the geometry's tolerance.
    """
    if chain.n != 6 or not full_rank(chain):
        return None
    found: list[tuple[Match, int]] = []
    for first in range(4):
        joints = np.arange(first, first + 3)
        turning = joints[~chain.prismatic[joints]]
        if len(turning) == 0:
            continue
        axes = chain.axes[joints]
        normal = chain.axes[turning[0]]
        out_of_plane = np.where(
            chain.prismatic[joints], np.abs(axes @ normal), np.linalg.norm(np.cross(axes, normal), axis=1)
        )
        # three slides, two slides along one line, or one axis twice move less than a plane does
        if out_of_plane.max() <= geometry.tolerance and _spans_plane(chain, joints):
            found.append((Match(first, tuple(normal), float(out_of_plane.max())), int(chain.prismatic[joints].sum())))
    # slides last: three turns are the common case; then an outer place, where links do not hold the pose
    return min(found, key=lambda entry: (entry[1], entry[0].first in (1, 2)))[0] if found else None


def _spans_plane(chain: Chain, joints: np.ndarray) -> bool:
    section = chain.section(int(joints[0]), int(joints[-1]))
    q = np.array([0.37, -1.13, 0.91]) * np.where(section.prismatic, chain.length, 1.0)
    return rank(scaled_jacobian(section, q)) == 3


def prepare(chain: Chain, found: Match) -> KernelSpec:
    """Return the kernel's numbers.

    The plane keeps its normal and its height, which gives two equations for two of the other three joints: a quartic,
    or two quadratics, then a triangle in the plane: eight solutions. It degenerates where the normal lies along the
    middle one of the other joints (the wrist of a UR arm), and where the plane's own arm is stretched or folded; the
    pose is then flagged.
    """
    links, sense = planar(chain, found.first, np.array(found.normal))
    return KernelSpec(
        _kernel.ThreeParallel(**group(chain, links, found.first, True), sense=sense),
        closed_form=True,
    )


FAMILY = Family(
    name="three_parallel",
    arrangement="three neighbouring parallel axes",
    words=(
        "The parallel joints move within a plane; what happens across that plane fixes the other joints, and "
        "a two-link triangle in it fixes the three."
    ),
    match=match,
    prepare=prepare,
)
