"""The three either-ors of an arm with shoulder, elbow and spherical wrist, read off the axes at a posture."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper.errors import InputError
from pieper.kinematics.arrays import Array
from pieper.kinematics.geometry import axes_at
from pieper.solver.plan.plan import Plan
from pieper.tolerances import AXES_ACROSS, WRIST_OVER_AXIS

_LEANING = np.array([0.0, 0.1, 0.0, 0.0, 0.0, 0.0])


@dataclass(frozen=True)
class Shape:
    """Where the arm is.

    Attributes:
        rear: The wrist centre lies behind axis 1, seen from the front of the arm as it turns.
        above: The elbow lies above the line from shoulder to wrist centre, for somebody who looks along the arm.
        behind_lower_arm: The wrist centre lies behind the lower arm: on the far side of its line from where the forearm
            points when the lower arm is upright and the forearm level to the front.
        bend: Sine of the wrist's bend about axis 5, of the sign of joint 5; straight at zero.
        nearest: The least of the three quantities whose signs these are, without units: at zero the words are open.
    """

    rear: bool
    above: bool
    behind_lower_arm: bool
    bend: float
    nearest: float


def has_shape(plan: Plan) -> bool:
    """Whether the arm is of the kind: six turning joints, axis 2 across axis 1, 3 along 2, the last three meeting."""
    if plan.n != 6 or plan.prismatic.any() or plan.chain.coupling is not None:
        return False
    pairs = plan.geometry.pairs
    wrist = any(set(group.joints) >= {3, 4, 5} for group in plan.geometry.spherical)
    across = abs(float(plan.chain.axes[0] @ plan.chain.axes[1])) < AXES_ACROSS
    return wrist and across and pairs[1].relation == "parallel" and pairs[0].relation != "parallel"


def shape(plan: Plan, q: Array, what: str) -> Shape:
    """Return the shape of an arm at q (n,).

    Raises:
        InputError: The arm is not of the kind that the words are defined for.
    """
    if plan.chain.coupling is not None:
        raise InputError(
            f"{what} are told of the axes, and {plan.name}'s joints are coupled: ask them of arm.uncoupled() at "
            "arm.coupling @ q."
        )
    if not has_shape(plan):
        raise InputError(
            f"{what} are words for six turning joints with a shoulder, an elbow and three wrist axes that meet; "
            f"{plan.name} is another kind of arm. Write joint targets for it."
        )
    axes, points = axes_at(plan.chain, np.stack([q, np.zeros(6), _LEANING]))
    here, zero = _signs(plan, axes[0], points[0]), _signs(plan, axes[1], points[1])
    # the front is where the wrist centre is with all joints at zero, or goes to where joint 2 turns on from there
    front = zero[0]
    if abs(front) < WRIST_OVER_AXIS * plan.chain.length:
        front = _signs(plan, *(x[2] for x in (axes, points)))[0]
    front = float(np.sign(front)) or 1.0
    ahead, over, sine, bend = here
    return Shape(
        rear=bool(ahead * front < 0),
        above=bool(over * front > 0 if ahead * front >= 0 else over * front < 0),
        behind_lower_arm=bool(sine * front < 0),
        bend=bend,
        nearest=min(abs(ahead) / plan.chain.length, abs(sine), abs(bend)),
    )


def _signs(plan: Plan, a: Array, o: Array) -> tuple[float, float, float, float]:
    """Return how far ahead the wrist is, m, how far over the line the elbow is, and sines of elbow and wrist."""
    base = plan.chain.links[0][:3, 3]
    up = a[0] * (1.0 if (o[1] - base) @ a[0] >= 0 else -1.0)
    forward = np.cross(a[1], up)
    shoulder, elbow, wrist = o[1], o[2], _meeting(a, o)
    plane = a[1]
    # everything in the plane across axis 2
    elbow = elbow + ((shoulder - elbow) @ plane) * plane
    centre = wrist + ((shoulder - wrist) @ plane) * plane
    lower, fore, way = elbow - shoulder, centre - elbow, centre - shoulder
    # up x forward is the axis about which a level forearm lies before an upright lower arm
    normal = np.cross(up, forward)
    sine = float(np.cross(lower, fore) @ normal) / float(np.linalg.norm(lower) * np.linalg.norm(fore))
    over = float(lower @ np.cross(way, normal))
    ahead = float((wrist - o[0]) @ forward)
    bend = float(np.cross(a[3], a[5]) @ a[4])
    straight = plan.chain.axes[3] @ plan.chain.axes[5]
    return ahead, over, sine, bend * float(np.sign(straight) or 1.0)


def _meeting(a: Array, o: Array) -> Array:
    """Return the point of axis 5 that is nearest to axis 4."""
    u, v = a[3], a[4]
    w = o[4] - o[3]
    b = float(u @ v)
    t = (b * float(u @ w) - float(v @ w)) / (1 - b * b)
    return o[4] + t * v
