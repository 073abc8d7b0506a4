"""Six revolute joints with a spherical wrist at the end, parallel second and third axes, the first across them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from pieper import _kernel
from pieper.kinematics.arrays import Array
from pieper.kinematics.chain import Chain
from pieper.kinematics.geometry import Geometry
from pieper.solver.families.family import Family, KernelSpec
from pieper.tolerances import SWP_IN_PLANE, SWP_SHORTEST, SWP_TILTED, SWP_ZERO

#: What each slot of the kernel means; the words of a posture are read off its geometry (see inverse/posture.py).
SLOTS = tuple(
    f"shoulder {side}, elbow {elbow}, wrist {wrist}" for side in "+-" for elbow in ("above", "below") for wrist in "+-"
)


@dataclass(frozen=True)
class Match:
    """The family recognised.

    Args:
        margin: How far the wrist axes miss one point, m.
        angle: How far the perpendicular and parallel axes are from that, rad.
    """

    margin: float
    angle: float


def match(chain: Chain, geometry: Geometry) -> Match | None:
    """Return the family's match of a six-joint chain, or None."""
    if chain.n != 6 or chain.prismatic.any():
        return None
    wrist = [group for group in geometry.spherical if group.joints == (3, 4, 5)]
    pairs = geometry.pairs
    if not wrist or pairs[1].relation != "parallel":
        return None
    off = max(pairs[1].angle, *(abs(pairs[i].angle - np.pi / 2) for i in (0, 3, 4)))
    if off > geometry.tolerance:
        return None
    u = chain.axes[1]
    reach = np.array(wrist[0].point) - chain.points[2]
    forearm = np.linalg.norm(reach - (reach @ u) * u)
    if forearm <= SWP_SHORTEST * chain.length or pairs[1].distance <= SWP_SHORTEST * chain.length:
        return None
    return Match(wrist[0].margin, off)


def prepare(chain: Chain, found: Match) -> KernelSpec:
    """Return the kernel's numbers, free of the table's gauge: only axes, points and the tool at zero count.

    Solves, with everything seen from a base frame on the first two axes, x^2 = wx^2 + wy^2 - b^2 for the shoulder, the
    two-link triangle (L2, L3) for the elbow and Rz(th4) Ry(th5) Rz(th6) = M for the wrist: at most eight solutions. It
    degenerates where the wrist centre meets axis 1 or 2, at the edges of the triangle's reach, and at sin th5 = 0; the
    pose is then flagged and one representative of each family or double root is returned.

    Source: D. L. Pieper, The kinematics of manipulators under computer control, 1968.
    """
    u, p = chain.axes, chain.points
    z = u[0]
    x = _unit(np.cross(z, u[1]))
    B = np.stack([x, np.cross(z, x), z])  # rows: world -> base frame of the family
    origin = p[0] + ((p[1] - p[0]) @ z) * z
    center = _meeting_point(u[3:], p[3:])
    elbow, wrist = B @ (p[2] - p[1]), B @ (center - p[2])
    offset2 = np.arctan2(elbow[2], elbow[0])
    forearm = np.arctan2(wrist[2], wrist[0])
    sign3 = 1.0 if u[2] @ u[1] > 0 else -1.0
    # the forearm frame: its z along axis 4 where that lies in the arm's plane, else tilted out of it by tau
    fourth = B @ u[3]
    tau = np.arctan2(fourth[1], np.hypot(fourth[0], fourth[2]))
    in_plane = np.hypot(fourth[0], fourth[2]) > SWP_IN_PLANE
    direction = np.arctan2(fourth[2], fourth[0]) - np.pi / 2 if in_plane else 0.0
    tilted = abs(tau) > SWP_TILTED
    S = _turn_x_to_z(direction) @ (_tilt(tau) if tilted else np.eye(3))
    fifth = S.T @ B @ u[4]
    offset4 = np.arctan2(-fifth[0], fifth[1])
    W = S @ _rotation_z(offset4)
    sixth = W.T @ B @ u[5]
    offset5 = np.arctan2(sixth[0], sixth[2])
    end = W @ _rotation_y(offset5)
    tool = chain.home[:3, :3].T @ B.T @ end
    psi = direction - forearm
    L2, L3 = np.hypot(elbow[0], elbow[2]), np.hypot(wrist[0], wrist[2])
    a1, b = (B @ (p[1] - origin))[0], (B @ (center - origin))[1]
    center_in_tool = tool.T @ chain.home[:3, :3].T @ (center - chain.home[:3, 3])
    scale = L2 + L3 + abs(a1) + abs(b) + np.linalg.norm(center_in_tool) + np.linalg.norm(origin)
    numbers: dict[str, Any] = {
        "base": B,
        "tool": tool,
        "origin": -B @ origin,
        "centre": center_in_tool,
        "a1": a1,
        "b": b,
        "upper": L2,
        "fore": L3,
        "cos_psi": np.cos(psi),
        "sin_psi": np.sin(psi),
        "cos_tau": np.cos(tau),
        "sin_tau": np.sin(tau),
        "offset2": offset2,
        "offset3": forearm - offset2,
        "offset4": offset4,
        "offset5": offset5,
        "sign3": sign3,
        "cos_offset4": np.cos(offset4),
        "sin_offset4": np.sin(offset4),
        "scale": scale,
    }
    rounding = SWP_ZERO * max(1.0, scale)
    clean: dict[str, Any] = {name: np.where(np.abs(value) < rounding, 0.0, value) for name, value in numbers.items()}
    return KernelSpec(
        _kernel.SphericalWristParallel(**clean, tilted=tilted),
        facts=(f"Upper arm {1e3 * L2:.6g} mm; forearm, from the elbow's axis to the wrist centre, {1e3 * L3:.6g} mm.",),
        slot_labels=SLOTS,
        closed_form=True,
    )


FAMILY = Family(
    name="spherical_wrist_parallel",
    arrangement="a spherical wrist and parallel second and third axes",
    words=(
        "The wrist centre fixes the first three joints: two ways to face it, two ways to bend the elbow. The "
        "last three then turn the tool, in two ways."
    ),
    match=match,
    prepare=prepare,
)


def _meeting_point(axes: np.ndarray, points: np.ndarray) -> np.ndarray:
    N = np.eye(3) - axes[:, :, None] * axes[:, None, :]
    normal: Array = N.sum(0)
    side: Array = (N @ points[:, :, None])[..., 0].sum(0)
    return np.asarray(np.linalg.lstsq(normal, side, rcond=None)[0], np.float64)


def _unit(v: np.ndarray) -> np.ndarray:
    return v / np.linalg.norm(v)


def _rotation_z(a: float) -> np.ndarray:
    c, s = np.cos(a), np.sin(a)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])


def _rotation_y(a: float) -> np.ndarray:
    c, s = np.cos(a), np.sin(a)
    return np.array([[c, 0, s], [0, 1.0, 0], [-s, 0, c]])


def _turn_x_to_z(a: float) -> np.ndarray:
    return _rotation_y(-a)


def _tilt(a: float) -> np.ndarray:
    c, s = np.cos(a), np.sin(a)
    return np.array([[1.0, 0, 0], [0, c, s], [0, -s, c]])
