"""Six joints of which two slide, in any order: the turning joints make the orientation, the slides undo the rest."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper import _kernel
from pieper.kinematics.arrays import Bools
from pieper.kinematics.chain import Chain
from pieper.kinematics.geometry import Geometry
from pieper.solver.families.family import Family, KernelSpec
from pieper.solver.families.hidden_angle import general_model
from pieper.solver.families.loop import full_rank
from pieper.tolerances import HIDDEN_FOUND

#: Test poses a turning joint is tried on as the hidden one, and the share of them that may stay unclear.
TRIALS, MOST_UNCLEAR = 48, 0.3


@dataclass(frozen=True)
class Match:
    """Two slides among six joints.

    Args:
        hidden: 0-based turning joints whose angle can be the unknown, best first.
    """

    hidden: tuple[int, ...]


def match(chain: Chain, geometry: Geometry) -> Match | None:
    """Return the turning joints that can be hidden, found by trying each on test poses, or None where none will do."""
    if chain.n != 6 or chain.prismatic.sum() != 2 or not full_rank(chain):
        return None
    rng = np.random.default_rng(5)
    made = np.where(chain.prismatic, chain.length, np.pi) * rng.uniform(-1, 1, (TRIALS, 6))
    poses = chain.native.fk(made)
    tried: list[tuple[float, int]] = []
    free = np.tile([-np.inf, np.inf], (6, 1))
    for hidden in np.flatnonzero(~chain.prismatic):
        alone = KernelSpec(_geometry(chain, (int(hidden),), None))
        q, valid, _, flag = alone.solver(free, chain.prismatic).many(poses, 1)
        found: Bools = np.any((chain.joints.apart(q, made[:, None]) < HIDDEN_FOUND) & valid, axis=1)
        clear: Bools = np.equal(flag & _kernel.Flag.UNCERTAIN, 0)
        if np.all(found | ~clear) and np.mean(~clear) <= MOST_UNCLEAR:
            tried.append((float(np.mean(~clear)), int(hidden)))
    tried.sort()
    return Match(tuple(hidden for _, hidden in tried)) if tried else None


def prepare(chain: Chain, found: Match) -> KernelSpec:
    """Return the kernel's numbers.

    With the hidden angle chosen the other three turning joints are a wrist, and the slides must undo what is left of
    the loop in the plane of their directions: a trigonometric polynomial of degree 4, at most eight solutions. It
    degenerates where turning axes line up or the slides are parallel; another joint is then hidden, and what no way
    decides is solved by the general solver.
    """
    return KernelSpec(
        _geometry(chain, found.hidden, general_model(chain)),
        facts=(f"The angle chosen is that of joint {found.hidden[0] + 1}; it has at most 8 values.",),
    )


FAMILY = Family(
    name="two_slides",
    arrangement="two sliding joints, which turn nothing, so that the four turning ones alone make the orientation",
    words=(
        "With the angle of one turning joint chosen, the other three follow like a wrist, in two ways; the "
        "slides must undo what is then left along their two directions. That is one equation for the chosen "
        "angle, a trigonometric polynomial, of which every real root is isolated."
    ),
    match=match,
    prepare=prepare,
    eliminating=True,
)


def _geometry(chain: Chain, hidden: tuple[int, ...], general: _kernel.General | None) -> _kernel.TwoSlides:
    return _kernel.TwoSlides(
        length=chain.length, links=chain.links, slides=tuple(chain.prismatic.tolist()), hidden=hidden, general=general
    )
