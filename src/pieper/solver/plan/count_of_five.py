"""How many solutions an arm of five joints can have that depend on each other nowhere but at singular poses.

Displacements are points of a projective space of seven dimensions, as dual quaternions. What a joint does is a line in
it, c + s e, where e is its axis as a dual quaternion (of a slide its direction times the dual unit). What three joints
do is every product of three such: a point of the Segre variety P1 x P1 x P1, seen in the space of displacements.
"""

from __future__ import annotations

from itertools import product

import numpy as np

from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.geometry import Geometry
from pieper.tolerances import RANK

#: Centres that the two joints beside a wrist can put where the pose has it, by the slides among the two.
_CENTRES = {0: 2, 1: 2, 2: 1}


def five_joints(geometry: Geometry, slides: Bools) -> tuple[int, str] | None:
    """Return a bound on the solutions of an arm of five joints and why there are no more; None where it has none."""
    if len(slides) != 5:
        return None
    for group in geometry.spherical:
        beside = [joint for joint in range(5) if joint not in group.joints]
        centres = _CENTRES[int(slides[beside].sum())]
        ways = ("one way", "two ways")[centres - 1]
        return 2 * centres, (
            f"the two joints beside its wrist have {ways} to put the centre of the wrist in its place, and the wrist "
            "has two ways to an orientation"
        )
    if not any(_independent(geometry, slides, first) for first in (0, 2)):
        return None
    return 4, (
        "three joints of it hold the body behind them on the Segre variety of three lines, the other two in a space of "
        "three dimensions, and such a space meets that variety in four points at most wherever it meets it in points "
        "alone (Eisenbud, Green, Hulek, Popescu 2005)"
    )


def _independent(geometry: Geometry, slides: Bools, joint: int) -> bool:
    """Whether the eight products of three joints' lines are independent, so that nothing of the variety is lost."""
    chain = geometry.chain
    lines: list[Array] = []
    for k in range(joint, joint + 3):
        axis, point = chain.axes[k], (chain.points[k] - chain.points[joint]) / chain.length
        real, dual = (0.0 * axis, axis) if slides[k] else (axis, np.cross(point, axis))
        lines.append(np.array([0.0, *real, 0.0, *dual]))
    one = np.eye(8)[0]
    first, second, third = ((one, line) for line in lines)
    products = np.array([_times(_times(a, b), c) for a, b, c in product(first, second, third)])
    s = np.linalg.svd(products, compute_uv=False)
    return bool(s[-1] > RANK * s[0])


def _times(a: Array, b: Array) -> Array:
    """Return the product of two dual quaternions (8,), real part first."""
    real, dual = _quaternions(a[:4], b[:4]), _quaternions(a[:4], b[4:]) + _quaternions(a[4:], b[:4])
    return np.concatenate([real, dual])


def _quaternions(a: Array, b: Array) -> Array:
    scalar = a[0] * b[0] - a[1:] @ b[1:]
    return np.array([scalar, *(a[0] * b[1:] + b[0] * a[1:] + np.cross(a[1:], b[1:]))])
