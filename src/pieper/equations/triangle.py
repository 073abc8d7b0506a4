"""The triangle of the law of cosines: two links between parallel axes, seen along them, and the angle between them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from pieper.equations.arm import Arm
from pieper.kinematics.geometry import look
from pieper.kinematics.joints import wrapped
from pieper.tolerances import ALIGNED, ROUNDING

Vectors = npt.NDArray[np.float64]
POSTURES = 7  # at which the lengths and the constant turn must be the same


@dataclass(frozen=True)
class Triangle:
    """An arm's two links across parallel axes.

    Attributes:
        shoulder: The joint (1-based) whose axis is the first corner.
        elbow: The joint at the second corner.
        end: What the third corner is, in words.
        first: Length from the first corner to the second, m, across the axes.
        second: Length from the second corner to the third, m.
        constant: What is added to the elbow joint's value for the turn from the first side's line to the second's, rad.
    """

    shoulder: int
    elbow: int
    end: str
    first: float
    second: float
    constant: float

    def bend(self, q: Vectors) -> float:
        """The turn from the first side's line to the second's at a joint vector (n,), rad, in (-pi, pi]."""
        return float(wrapped(np.asarray(q, dtype=float)[self.elbow - 1] + self.constant))

    def inner(self, q: Vectors) -> float:
        """The angle inside the triangle at the elbow, rad."""
        return float(np.pi - abs(self.bend(q)))

    def third(self, q: Vectors) -> float:
        """The third side, m: by the law of cosines from the angle inside."""
        square = self.first**2 + self.second**2 - 2 * self.first * self.second * np.cos(self.inner(q))
        return float(np.sqrt(max(square, 0.0)))

    @property
    def reach(self) -> tuple[float, float]:
        """The least and the greatest third side, m."""
        return abs(self.first - self.second), self.first + self.second


def triangle_of(arm: Arm) -> Triangle | None:
    """The first pair of neighbouring parallel axes whose links make a triangle with a point that follows; None without.

    Args:
        arm: The arm.

    Returns:
        The triangle, its lengths the same at every posture that was looked at.
    """
    if arm.description.coupling is not None:
        return None
    rng = np.random.default_rng(90_01)
    postures = [rng.uniform(-1, 1, arm.n) for _ in range(POSTURES)]
    for shoulder in range(1, arm.n):
        elbow = shoulder + 1
        if arm.joint_types[shoulder - 1] != "R" or arm.joint_types[elbow - 1] != "R":
            continue
        for end in ("axis", "wrist", "tool"):
            found = [_corners(arm, q, shoulder, end) for q in postures]
            made = _made(found, postures, elbow)
            if made is not None:
                words = _words(arm, postures[0], shoulder, end)
                return Triangle(shoulder, elbow, words, *made)
    return None


def _made(
    found: list[tuple[Vectors, Vectors, Vectors, Vectors] | None], postures: list[Vectors], elbow: int
) -> tuple[float, float, float] | None:
    """Both lengths and the constant turn, where they are the same at every posture."""
    rows: list[tuple[float, float, float]] = []
    for corners, q in zip(found, postures, strict=True):
        if corners is None:
            return None
        a, b, c, z = corners
        one, two = (v - z * (z @ v) for v in (b - a, c - b))
        bend = np.arctan2(z @ np.cross(one, two), one @ two)
        rows.append((float(np.linalg.norm(one)), float(np.linalg.norm(two)), float(wrapped(bend - q[elbow - 1]))))
    first, second, constant = (np.array([row[k] for row in rows]) for k in range(3))
    size = max(first[0], second[0])
    same = np.ptp(first) + np.ptp(second) < ROUNDING * size and np.abs(wrapped(constant - constant[0])).max() < ALIGNED
    return (first[0], second[0], constant[0]) if same and min(first[0], second[0]) > ALIGNED * size else None


def _axis(arm: Arm, frames: Vectors, joint: int) -> tuple[Vectors, Vectors]:
    """Direction of a joint's positive turn and a point on its axis, base frame."""
    frame = frames[joint if arm.description.convention == "modified" else joint - 1]
    return frame[:3, 2] * float(arm.description.sign[joint - 1]), frame[:3, 3]


def _corners(arm: Arm, q: Vectors, shoulder: int, end: str) -> tuple[Vectors, Vectors, Vectors, Vectors] | None:
    """The three corners and the elbow's axis at a posture; None where there is no such triangle."""
    frames = np.asarray(arm.frames(q))
    (z1, a), (z, b) = _axis(arm, frames, shoulder), _axis(arm, frames, shoulder + 1)
    if np.linalg.norm(np.cross(z1, z)) > ALIGNED:
        return None
    if end == "axis":
        after = _next_parallel(arm, frames, shoulder + 1, z)
        return None if after is None else (a, b, _axis(arm, frames, after)[1], z)
    if end == "wrist":
        centre = _wrist(arm, frames) if shoulder + 1 <= arm.n - 3 else None
        return None if centre is None else (a, b, centre, z)
    # the tool's point, where nothing after the elbow moves it across the axes
    if shoulder + 1 < arm.n and any(k == "R" for k in arm.joint_types[shoulder + 1 :]):
        return None
    return a, b, frames[-1][:3, 3], z


def _next_parallel(arm: Arm, frames: Vectors, joint: int, z: Vectors) -> int | None:
    """The next turning joint after one, if its axis is parallel and only slides along it stand between."""
    for after in range(joint + 1, arm.n + 1):
        axis = _axis(arm, frames, after)[0]
        if np.linalg.norm(np.cross(axis, z)) > ALIGNED:
            return None
        if arm.joint_types[after - 1] == "R":
            return after
    return None


def _wrist(arm: Arm, frames: Vectors) -> Vectors | None:
    """The point in which the last three axes meet, None where they do not."""
    last = range(arm.n - 2, arm.n + 1)
    if any(arm.joint_types[j - 1] != "R" for j in last):
        return None
    if look(arm.chain, ALIGNED).common_point((arm.n - 3, arm.n - 2, arm.n - 1))[1] > ALIGNED:
        return None
    sides, at = np.zeros((3, 3)), np.zeros(3)
    for joint in last:
        axis, point = _axis(arm, frames, joint)
        across = np.eye(3) - np.outer(axis, axis)
        sides, at = sides + across, at + across @ point
    return np.asarray(np.linalg.solve(sides, at), np.float64)


def _words(arm: Arm, q: Vectors, shoulder: int, end: str) -> str:
    if end == "wrist":
        return "the wrist centre"
    if end == "tool":
        return "the tool's point"
    frames = np.asarray(arm.frames(q))
    return f"axis {_next_parallel(arm, frames, shoulder + 1, _axis(arm, frames, shoulder + 1)[0])}"
