"""Three joints that place a point, and three revolute joints through one point that turn a body."""

from __future__ import annotations

import numpy as np

from pieper import _kernel
from pieper.kinematics.chain import Chain
from pieper.kinematics.geometry import Geometry
from pieper.solver.families.family import KernelSpec
from pieper.solver.families.loop import rank


def match(chain: Chain, geometry: Geometry | None) -> bool | None:
    """Return True for three joints, of any kinds, that can move the tool point every way; else None."""
    if chain.n != 3:
        return None
    q = np.array([0.37, -1.13, 0.91]) * np.where(chain.prismatic, chain.length, 1.0)
    return True if rank(chain.native.jacobian(q)[:3]) == 3 else None


def prepare(chain: Chain, found: bool) -> KernelSpec:
    """Return the numbers of the kernel for Za A Zb B Zc p = g: at most four solutions, by a quartic or quadratics."""
    return KernelSpec(_kernel.Position3(length=chain.length, links=chain.links, slides=chain.prismatic))


def prepare_orientation(chain: Chain) -> KernelSpec:
    """Return the numbers of the kernel for three revolute axes' orientation alone: at most two solutions."""
    return KernelSpec(_kernel.Orientation3(links=chain.links))
