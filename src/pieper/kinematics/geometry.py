"""Which axes are parallel, meet or coincide, each with its margin; and chains made anew from axes alone."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from pieper.kinematics.arrays import Array, ArrayLike, Bools
from pieper.kinematics.chain import Chain
from pieper.kinematics.pose import inverse
from pieper.tolerances import GEOMETRY_EXACT


@dataclass(frozen=True)
class Pair:
    """How two neighbouring joint axes lie; it does not change when the arm moves.

    Args:
        first: Index (0-based) of the first of the two joints.
        angle: Angle between the axes as lines, 0 to pi/2, rad.
        distance: Length of their common normal, m.
        relation: "parallel", "coincident", "intersecting" or "skew", within the tolerance.
    """

    first: int
    angle: float
    distance: float
    relation: str


@dataclass(frozen=True)
class Group:
    """Three or more neighbouring revolute axes that meet in a point, or are parallel.

    Args:
        kind: "spherical" or "parallel".
        joints: 0-based, in order.
        margin: How far they miss at worst: metres for a spherical group, radians for a parallel one.
        point: Where a spherical group meets, all joints at zero, world frame, m.
    """

    kind: str
    joints: tuple[int, ...]
    margin: float
    point: tuple[float, float, float] | None = None


@dataclass(frozen=True, eq=False)
class Geometry:
    """The arrangement of a chain's axes, independent of table, base, tool and sense.

    Args:
        chain: The chain looked at.
        tolerance: Angles (rad) and distances (per characteristic length) taken for zero.
    """

    chain: Chain
    tolerance: float

    @cached_property
    def pairs(self) -> tuple[Pair, ...]:
        """The n - 1 pairs of neighbouring axes."""
        u, v = self.chain.axes[:-1], self.chain.axes[1:]
        w = self.chain.points[1:] - self.chain.points[:-1]
        cross = _cross(u, v)
        sine = np.sqrt(np.sum(cross * cross, 1))
        angle = np.arctan2(sine, np.abs(np.sum(u * v, 1)))
        parallel = angle <= self.tolerance
        across = w - np.sum(w * u, 1)[:, None] * u
        apart: Array = np.sqrt(np.sum(across * across, 1))
        skew: Array = np.abs(np.sum(w * cross, 1)) / np.where(parallel, 1.0, sine)
        distance: Array = np.where(parallel, apart, skew)
        return tuple(self._pair(i, float(angle[i]), float(distance[i])) for i in range(self.chain.n - 1))

    def _pair(self, i: int, angle: float, distance: float) -> Pair:
        parallel = angle <= self.tolerance
        near = distance <= self.tolerance * self.chain.length
        # a prismatic axis is a direction alone: it has no place, so it neither meets nor coincides
        if self.chain.prismatic[i] or self.chain.prismatic[i + 1]:
            relation = "parallel" if parallel else "skew"
        elif parallel:
            relation = "coincident" if near else "parallel"
        else:
            relation = "intersecting" if near else "skew"
        return Pair(i, angle, distance, relation)

    def common_point(self, joints: tuple[int, ...]) -> tuple[Array, float]:
        """Return the point (3,) closest to the axes of joints at zero, and the largest distance to them, m."""
        U, P = self.chain.axes[list(joints)], self.chain.points[list(joints)]
        N = np.eye(3) - U[:, :, None] * U[:, None, :]
        normal: Array = N.sum(0)
        side: Array = (N @ P[:, :, None])[..., 0].sum(0)
        point = np.asarray(np.linalg.lstsq(normal, side, rcond=None)[0], np.float64)
        off = np.linalg.norm((N @ (point - P)[:, :, None])[..., 0], axis=1)
        return point, float(off.max())

    @cached_property
    def spherical(self) -> tuple[Group, ...]:
        """Every three neighbouring revolute axes that meet in one point and do not lie along two lines only."""
        found: list[Group] = []
        for i in range(self.chain.n - 2):
            joints = (i, i + 1, i + 2)
            if self.chain.prismatic[list(joints)].any():
                continue
            if self.pairs[i].angle <= self.tolerance or self.pairs[i + 1].angle <= self.tolerance:
                continue
            # axes that pass each other by more than twice a distance have no point within that distance of both
            apart = max(self.pairs[i].distance, self.pairs[i + 1].distance)
            if apart > 2.01 * self.tolerance * self.chain.length:
                continue
            point, margin = self.common_point(joints)
            if margin <= self.tolerance * self.chain.length:
                found.append(Group("spherical", joints, margin, tuple(point)))
        return tuple(found)

    @cached_property
    def parallel(self) -> tuple[Group, ...]:
        """Maximal runs of two or more neighbouring revolute axes that are parallel and not all coincident."""
        found: list[Group] = []
        i, n = 0, self.chain.n
        while i < n - 1:
            j = i
            while (
                j < n - 1
                and self.pairs[j].angle <= self.tolerance
                and not self.chain.prismatic[j]
                and not self.chain.prismatic[j + 1]
            ):
                j += 1
            if j > i:
                margin = max(self.pairs[k].angle for k in range(i, j))
                found.append(Group("parallel", tuple(range(i, j + 1)), margin))
            i = max(j, i + 1)
        return tuple(found)

    @cached_property
    def coincident(self) -> tuple[Pair, ...]:
        """Neighbouring revolute joints about one and the same line: only their sum moves anything."""
        return tuple(pair for pair in self.pairs if pair.relation == "coincident")

    def sentences(self, names: tuple[str, ...]) -> list[str]:
        """Say the arrangement in words, one sentence a fact, with the margin where it is more than rounding."""

        def within_mm(metres: float) -> str:
            return f" (within {metres * 1e3:.2g} mm)" if metres > GEOMETRY_EXACT * self.chain.length else ""

        def within_rad(angle: float) -> str:
            return f" (within {angle:.2g} rad)" if angle > GEOMETRY_EXACT else ""

        said: list[str] = []
        for pair in self.pairs:
            a, b = names[pair.first], names[pair.first + 1]
            if pair.relation == "coincident":
                said.append(f"{a} and {b} turn about one line{within_mm(pair.distance)}{within_rad(pair.angle)}.")
            elif pair.relation == "parallel":
                apart = (
                    ""
                    if self.chain.prismatic[pair.first : pair.first + 2].any()
                    else f", {pair.distance * 1e3:.6g} mm apart"
                )
                said.append(f"{a} and {b} are parallel{within_rad(pair.angle)}{apart}.")
            elif pair.relation == "intersecting":
                said.append(f"{a} and {b} meet{within_mm(pair.distance)} at {np.degrees(pair.angle):.6g} deg.")
            elif self.chain.prismatic[pair.first] or self.chain.prismatic[pair.first + 1]:
                said.append(f"{a} and {b} are {np.degrees(pair.angle):.6g} deg from parallel; one of them slides.")
            else:
                said.append(f"{a} and {b} pass {pair.distance * 1e3:.6g} mm apart at {np.degrees(pair.angle):.6g} deg.")
        for group in self.spherical:
            said.append(f"{_and([names[j] for j in group.joints])} meet in one point{within_mm(group.margin)}.")
        return said


def look(chain: Chain, tolerance: float) -> Geometry:
    """Return the geometry of a chain's axes within a tolerance (rad, and per characteristic length)."""
    return Geometry(chain, tolerance)


def from_axes(axes: Array, points: Array, prismatic: Bools, home: Array, scale: float = 0.0) -> Chain:
    """Make a chain of axes and points (n, 3) at zero and the tool's pose (4, 4) at zero; `scale` as of a chain."""
    frames = np.stack([_frame_on(axis, point) for axis, point in zip(axes, points, strict=True)])
    links = [
        frames[0],
        *(inverse(a) @ b for a, b in zip(frames[:-1], frames[1:], strict=True)),
        inverse(frames[-1]) @ home,
    ]
    return Chain.of(np.stack(links), np.array(prismatic, bool), scale=scale)


def snapped(chain: Chain, tolerance: float) -> tuple[Chain, list[str], float]:
    """Return the chain with nearly parallel axes made parallel and nearly meeting ones made to meet.

    Args:
        chain: The chain as described.
        tolerance: What counts as nearly: rad, and per characteristic length.

    Returns:
        The nominal chain (the same object when nothing was near), what was moved in words, the largest move in metres.
    """
    geometry = look(chain, tolerance)
    axes, points = chain.axes.copy(), chain.points.copy()
    said: list[str] = []
    for group in geometry.parallel:
        members = list(group.joints)
        if group.margin <= 0.0:
            continue
        senses = np.sign(axes[members] @ axes[members[0]])
        mean = (senses[:, None] * axes[members]).sum(0)
        axes[members] = senses[:, None] * (mean / np.linalg.norm(mean))
        if group.margin > GEOMETRY_EXACT:
            said.append(
                f"joints {_and([str(j + 1) for j in members])} made parallel (they were {group.margin:.2g} rad off)"
            )
    nominal = look(from_axes(axes, points, chain.prismatic, chain.home, chain.scale), tolerance)
    moved = 0.0
    in_group: set[int] = set()
    for group in nominal.spherical:
        if in_group & set(group.joints):
            continue
        in_group |= set(group.joints)
        target = np.array(group.point)
        for j in group.joints:
            points[j] = target
        moved = max(moved, group.margin)
        if group.margin > GEOMETRY_EXACT * chain.length:
            said.append(
                f"joints {_and([str(j + 1) for j in group.joints])} made to meet in one point "
                f"(they missed it by {group.margin * 1e3:.3g} mm)"
            )
    for pair in nominal.pairs:
        i, j = pair.first, pair.first + 1
        if pair.relation == "intersecting" and not {i, j} <= in_group and pair.distance > 0:
            free = j if j not in in_group else i
            if free not in in_group:
                other = i + j - free
                cross = np.cross(axes[i], axes[j])
                cross /= np.linalg.norm(cross)
                points[free] = points[free] - ((points[free] - points[other]) @ cross) * cross
            moved = max(moved, pair.distance)
            if pair.distance > GEOMETRY_EXACT * chain.length:
                said.append(f"joints {i + 1} and {j + 1} made to meet (they missed by {pair.distance * 1e3:.3g} mm)")
    if not said:
        return chain, [], 0.0
    return from_axes(axes, points, chain.prismatic, chain.home, chain.scale), said, moved


def _cross(u: Array, v: Array) -> Array:
    """Return u x v of vectors (n, 3); NumPy's own is made for any axis and much slower on few vectors."""
    return u[:, [1, 2, 0]] * v[:, [2, 0, 1]] - u[:, [2, 0, 1]] * v[:, [1, 2, 0]]


def _frame_on(axis: Array, point: Array) -> Array:
    z = axis / np.linalg.norm(axis)
    seed = np.eye(3)[np.argmin(np.abs(z))]
    x = seed - (seed @ z) * z
    x /= np.linalg.norm(x)
    T = np.eye(4)
    T[:3, 0], T[:3, 1], T[:3, 2], T[:3, 3] = x, np.cross(z, x), z, point
    return T


def _and(words: list[str]) -> str:
    return words[0] if len(words) == 1 else ", ".join(words[:-1]) + " and " + words[-1]


def axes_at(chain: Chain, q: ArrayLike) -> tuple[Array, Array]:
    """Return the joint axes and a point on each, (..., n, 3), where joint vectors q (..., n) put them, world frame."""
    joints = chain.native_axes.frames(np.asarray(q, float), np.eye(4))[..., 1:-1, :, :]
    return joints[..., :3, 2], joints[..., :3, 3]
