"""Six turning joints, second and third parallel, fourth and fifth meeting: wrists whose axes miss one point."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from pieper import _kernel
from pieper.kinematics.arrays import Array
from pieper.kinematics.chain import Chain
from pieper.kinematics.geometry import Geometry, look
from pieper.solver.families.family import Family, KernelSpec
from pieper.solver.families.hidden_angle import general_model
from pieper.solver.families.loop import full_rank
from pieper.tolerances import SHORTEST_LINK, SIDES_ALIKE, SIDES_DIFFERENT, TINY


@dataclass(frozen=True)
class Match:
    """An offset wrist found.

    Args:
        backward: Whether it stands at the base: the arm is then solved from tool to base.
        margin: How far axes 4 and 5 miss each other, m.
    """

    backward: bool
    margin: float


def match(chain: Chain, geometry: Geometry) -> Match | None:
    """Return what is found in a six-joint chain: axes 2 and 3 parallel, 1 across them, 4 and 5 meeting; or None."""
    if chain.n != 6 or chain.prismatic.any() or not full_rank(chain):
        return None
    for backward in (False, True):
        seen = chain.reversed() if backward else chain
        found = look(seen, geometry.tolerance) if backward else geometry
        first, second, third, fourth, fifth = found.pairs
        if (
            second.relation == "parallel"
            and np.pi / 2 - first.angle <= geometry.tolerance
            and fourth.relation == "intersecting"
            and min(third.angle, fourth.angle, fifth.angle) > SHORTEST_LINK
        ):
            numbers = _measured(seen)
            if min(numbers["upper"], numbers["fore"]) > SHORTEST_LINK and _sides(numbers) is not None:
                return Match(backward, fourth.distance)
    return None


def _sides(numbers: dict[str, Any]) -> bool | None:
    """Return whether the arm's two sides are alike, None where that is hard to tell."""
    apart = max(abs(numbers["shoulder"]), abs(numbers["lateral"]), abs(numbers["lean_s"]), abs(numbers["tilt_s"]))
    if apart <= SIDES_ALIKE:
        return True
    return False if apart >= SIDES_DIFFERENT else None


def prepare(chain: Chain, found: Match) -> KernelSpec:
    """Return the kernel's numbers.

    The last joint's angle is the unknown of one trigonometric polynomial: of degree 8, at most 16 solutions; of
    degree 4 with two solutions a root where shoulder, elbow and forearm lie in the plane of axis 1. It degenerates
    where P lies on axis 1, the elbow is straight, or two roots merge; such poses are solved by the general solver,
    whose model is part of the numbers.
    """
    seen = chain.reversed() if found.backward else chain
    numbers = _measured(seen)
    even = bool(_sides(numbers))
    if even:
        numbers.update(shoulder=0.0, lateral=0.0, lean_s=0.0, tilt_s=0.0)
    return KernelSpec(
        _kernel.OffsetWrist(
            length=seen.length,
            links=seen.links,
            backward=found.backward,
            alike=even,
            general=general_model(chain),
            **numbers,
        ),
        facts=(
            f"It has at most {'8 roots, each with two solutions' if even else '16 roots, each with one solution'}.",
            *(("The wrist is at the base: the arm is solved from its tool backwards.",) if found.backward else ()),
        ),
    )


FAMILY = Family(
    name="offset_wrist",
    arrangement="parallel second and third axes and a wrist of which only two neighbouring axes meet",
    words=(
        "With the last joint's angle chosen, the point where axes 4 and 5 meet is known, and with it shoulder"
        " and elbow: two sides, two shapes of the triangle. That axes 4 and 5 meet under their own angle is "
        "then one equation for the last joint, a trigonometric polynomial, of which every real root is "
        "isolated."
    ),
    match=match,
    prepare=prepare,
    eliminating=True,
)


def _measured(chain: Chain) -> dict[str, Any]:
    """Return the arm at zero, seen from axes 1 and 2, lengths per characteristic length (see offset_wrist.hpp)."""
    u, p = chain.axes, chain.points
    z, y = u[0], _across(u[1], u[0])
    x = np.cross(y, z)
    to_base = np.stack([x, y, z])
    base = p[0] + ((p[1] - p[0]) @ z) * z
    axes = u @ to_base.T
    points = (p - base) @ to_base.T / chain.length
    tool = to_base @ (chain.home[:3, 3] - base) / chain.length
    meeting = to_base @ (look(chain, SHORTEST_LINK).common_point((3, 4))[0] - base) / chain.length
    foot = points[5] + ((meeting - points[5]) @ axes[5]) * axes[5]
    lever = meeting - foot
    plane = [0, 2]
    shoulder = points[1][0]
    elbow = points[2][plane] - [shoulder, 0.0]
    forearm = meeting[plane] - points[2][plane]
    in_plane = axes[3][plane]
    tilt = np.array([np.linalg.norm(in_plane), axes[3][1]])
    upper, fore = np.linalg.norm(elbow), np.linalg.norm(forearm)
    elbow, forearm, along = (v / max(float(np.linalg.norm(v)), TINY) for v in (elbow, forearm, in_plane))
    lean = np.array([forearm @ along, forearm[0] * along[1] - forearm[1] * along[0]])
    part = (axes[4] @ axes[5]) * axes[5]
    # over the sine, so that a direction's products with these and with what they are crossed to are a sine and a cosine
    across4, across5 = (_across(axes[k + 1], axes[k]) / np.linalg.norm(np.cross(axes[k], axes[k + 1])) for k in (3, 4))
    return {
        "to_base": to_base,
        "base": base,
        "from_tool": chain.home[:3, :3].T @ to_base.T,
        "sixth": foot - tool,
        "lever": lever,
        "lever_turned": np.cross(axes[5], lever),
        "fifth": np.stack([part, axes[4] - part, np.cross(axes[5], axes[4])]),
        "axis6": axes[5],
        "shoulder": float(shoulder),
        "lateral": float(meeting[1]),
        "upper": float(upper),
        "fore": float(fore),
        "elbow_c": elbow[0],
        "elbow_s": elbow[1],
        "fore_c": forearm[0],
        "fore_s": forearm[1],
        "lean_c": lean[0],
        "lean_s": lean[1],
        "tilt_c": tilt[0],
        "tilt_s": tilt[1],
        "bend": float(axes[3] @ axes[4]),
        "sense3": 1.0 if u[2] @ u[1] > 0 else -1.0,
        "axis4": axes[3],
        "across4": across4,
        "over4": np.cross(axes[3], across4),
        "across5": across5,
        "over5": np.cross(axes[4], across5),
    }


def _across(v: Array, axis: Array) -> Array:
    """Return the direction (3,) of v's part across an axis of length one."""
    part = v - (v @ axis) * axis
    return part / np.linalg.norm(part)
