"""What of an arm stands in the way where it degenerates, in words: stretched, folded, a wrist in line, an axis met."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.kinematics.chain import Chain
from pieper.kinematics.forward import fk
from pieper.kinematics.geometry import axes_at, look
from pieper.kinematics.newton import scaled_jacobian
from pieper.solver.plan.plan import Plan
from pieper.tolerances import GEOMETRY_EXACT, NEAR_ARRANGEMENT, ON_FIRST_AXIS, TINY

#: A joint takes part in a self-motion by at least this part of the one that moves most.
TAKES_PART = 0.05


@dataclass(frozen=True)
class InTheWay:
    """A special arrangement of an arm.

    Attributes:
        name: "wrist", "elbow", "shoulder", or "" for one without a name.
        words: What it is, a clause with its number.
        off: How far the posture is from it, rad or per length.
    """

    name: str
    words: str
    off: float


def in_the_way(plan: Plan, q: Array) -> InTheWay:
    """Return the special arrangement that a posture q (n,) at or next to a singularity is in."""
    chain = plan.chain.uncoupled
    values = q if plan.chain.coupling is None else plan.chain.coupling @ q
    axes, points = axes_at(chain, values)
    found = _cylinder(chain, values, axes, points)
    found += [*_in_line(plan, axes, points), *_elbow(chain, values, axes, points, _own(plan))]
    found = [one for one in found if one.off < NEAR_ARRANGEMENT]
    if found:
        # of several that are there to rounding the first, whatever the last digits of the posture
        return min(found, key=lambda one: max(one.off, GEOMETRY_EXACT))
    return _by_null_space(plan, q)


def _in_line(plan: Plan, axes: Array, points: Array) -> list[InTheWay]:
    """Pairs of turning axes, not neighbours, that lie on one line, or are parallel where three meet or are parallel."""
    found: list[InTheWay] = []
    chain, length = plan.chain.uncoupled, plan.chain.length
    turning = [j for j in np.flatnonzero(~chain.prismatic).tolist() if j in _own(plan)]
    for i in turning:
        for j in turning:
            if j < i + 2:
                continue
            cross = np.cross(axes[i], axes[j])
            off = float(np.linalg.norm(cross))
            apart = float(np.linalg.norm(np.cross(points[j] - points[i], axes[i]))) / length
            names = f"axes {i + 1} and {j + 1}"
            if max(off, apart) < NEAR_ARRANGEMENT and not _always_parallel(plan, i, j):
                kind = "wrist" if j == chain.n - 1 and i >= chain.n - 3 else "shoulder" if i == 0 else ""
                words = f"{names} lie on one line ({_two(plan, i, j)} turn the same)"
                found.append(InTheWay(kind, words, max(off, apart)))
            elif off < NEAR_ARRANGEMENT and j == chain.n - 1 and i == j - 2 and not _always_parallel(plan, i, j):
                words = f"{names} are parallel ({plan.description.axis_names[i + 1]} is where they become so)"
                found.append(InTheWay("wrist", words, off))
    return found


def _always_parallel(plan: Plan, i: int, j: int) -> bool:
    """Whether two axes are parallel in every posture: they are in one that nobody would choose."""
    axes, _ = axes_at(plan.chain.uncoupled, 0.3719 + 0.1 * np.arange(plan.chain.axis_count))
    return bool(np.linalg.norm(np.cross(axes[i], axes[j])) < GEOMETRY_EXACT)


def _two(plan: Plan, i: int, j: int) -> str:
    names = plan.description.axis_names
    return f"{names[i]} and {names[j]}"


def _carried(chain: Chain, values: Array, axes: Array, points: Array, after: int) -> tuple[Array, str] | None:
    """Return the point that the joints behind `after` leave where it is, and its name; None where there is none."""
    geometry = look(chain, GEOMETRY_EXACT)
    for group in geometry.spherical:
        if group.joints[-1] == chain.n - 1 and group.joints[0] > after:
            return _meeting(axes[list(group.joints)], points[list(group.joints)]), "the wrist centre"
    if after + 1 == chain.n:
        return fk(chain, values)[:3, 3], "the tool point"
    behind = range(after + 1, chain.n)
    turning = [j for j in behind if not chain.prismatic[j]]
    if turning and np.linalg.norm(np.cross(axes[turning[0]], axes[after])) < GEOMETRY_EXACT:
        last = turning[0]
        for group in geometry.parallel:
            last = max(last, group.joints[-1]) if {after, last} <= set(group.joints) else last
        return points[last], f"axis {last + 1}"
    return None


def _meeting(axes: Array, points: Array) -> Array:
    """Return the point (3,) nearest to lines with directions and points (k, 3)."""
    N = np.eye(3) - axes[:, :, None] * axes[:, None, :]
    return np.asarray(np.linalg.lstsq(N.sum(0), (N @ points[:, :, None])[..., 0].sum(0), rcond=None)[0], np.float64)


def _own(plan: Plan) -> set[int]:
    """Return the axes (0-based) that have a joint of their own."""
    return set(plan.chain.own or range(plan.n))


def _elbow(chain: Chain, values: Array, axes: Array, points: Array, own: set[int]) -> list[InTheWay]:
    """Two neighbouring parallel axes of joints with what they carry in one plane: stretched, or folded."""
    found: list[InTheWay] = []
    for pair in look(chain, GEOMETRY_EXACT).pairs:
        i = pair.first
        if pair.relation != "parallel" or chain.prismatic[i : i + 2].any() or not {i, i + 1} <= own:
            continue
        carried = _carried(chain, values, axes, points, i + 1)
        if carried is None:
            continue
        P, what = carried
        z = axes[i]
        first, second = (v - (v @ z) * z for v in (points[i + 1] - points[i], P - points[i + 1]))
        size = float(np.linalg.norm(first) * np.linalg.norm(second))
        if size < TINY * chain.length**2:
            continue
        off = float(np.linalg.norm(np.cross(first, second))) / size
        far = float(np.linalg.norm(first + second)) * 1e3
        if first @ second > 0:
            words = f"the arm is stretched: {what} cannot get farther from axis {i + 1} than {far:.4g} mm"
        else:
            words = f"the arm is folded: {what} cannot come nearer to axis {i + 1} than {far:.4g} mm"
        found.append(InTheWay("elbow", words, off))
    return found


def _cylinder(chain: Chain, values: Array, axes: Array, points: Array) -> list[InTheWay]:
    """A wrist centre as near to axis 1 as the arm lets it come."""
    if chain.n < 3 or chain.prismatic[:3].any():
        return []
    relations = [pair.relation for pair in look(chain, GEOMETRY_EXACT).pairs]
    if relations[0] == "parallel" or relations[1] != "parallel":
        return []
    carried = _carried(chain, values, axes, points, 2)
    if carried is not None and carried[1] == "the wrist centre":
        point, what = carried
    elif chain.n == 6 and relations[2] == "parallel" and relations[4] == "intersecting":
        point, what = _meeting(axes[4:], points[4:]), "the point where axes 5 and 6 meet"
    else:
        return []
    gap = point - points[0]
    radial = gap - (gap @ axes[0]) * axes[0]
    near = float(np.linalg.norm(radial))
    # the plane in which joints 2 and 3 move the wrist touches the cylinder where its normal is radial
    at_axis = near < NEAR_ARRANGEMENT * chain.length
    off = near / chain.length if at_axis else float(np.linalg.norm(np.cross(radial / near, axes[1])))
    if near < ON_FIRST_AXIS * chain.length:
        return [InTheWay("shoulder", f"{what} lies on axis 1", off)]
    return [InTheWay("shoulder", f"{what} cannot come nearer to axis 1 than {near * 1e3:.4g} mm", off)]


def _by_null_space(plan: Plan, q: Array) -> InTheWay:
    J = scaled_jacobian(plan.chain, q)
    _, s, rows = np.linalg.svd(J[:3] if plan.task == "position" else J)
    part = np.abs(rows[-1])
    joints = [plan.names[j] for j in np.flatnonzero(part > TAKES_PART * part.max())]
    listed = joints[0] if len(joints) == 1 else f"{', '.join(joints[:-1])} and {joints[-1]}"
    words = (
        f"{listed} move there without moving the tool"
        if len(joints) > 1
        else f"{listed} moves there without moving the tool"
    )
    return InTheWay("", words, float(s[-1] / max(s[0], TINY)))
