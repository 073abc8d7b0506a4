"""The arm angle of a seven-joint arm: how far its elbow is turned about the line from shoulder to wrist.

Shoulder S stands still in the base, wrist W in the tool, so that a pose fixes the line S-W; the elbow E lies on the
fourth joint's axis. The angle of E about that line is counted from a reference direction that varies smoothly with
the line. On a sphere of directions no such reference can be smooth everywhere; the stereographic one chosen here
(Elias and Wen, Redundancy parameterization and inverse kinematics of 7-DOF revolute manipulators, 2023) fails in a
single direction, while a reference plane through a fixed axis (Shimizu et al., Analytical inverse kinematic
computation for 7-DOF redundant manipulators with joint limits, 2008) fails along both directions of that axis. The
direction that fails is put where the wrist hardly ever is: from the shoulder down into the base.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper.kinematics.arrays import Array, Bools, median
from pieper.kinematics.chain import Chain
from pieper.kinematics.geometry import axes_at, look
from pieper.kinematics.newton import null_space
from pieper.kinematics.pose import inverse
from pieper.tolerances import ARM_ANGLE_MOVES, ARM_ANGLE_POLE, ARM_STRETCHED, GEOMETRY_EXACT, TINY


@dataclass(frozen=True, eq=False)
class ArmAngle:
    """Where shoulder, elbow and wrist are on an arm, and from where the arm angle counts.

    Args:
        chain: The seven-joint arm.
        shoulder: (3,) S, world frame, m.
        along: Where E is on the fourth axis, from the joint frame's origin along its z, m.
        wrist: (3,) W in the tool frame, m.
        pole: (3,) unit; the angle is undefined where S-W points this way.
        reference: (3,) unit, across the pole; where the angle counts from when S-W points away from the pole.
        spherical: Whether the first three axes meet in S and the last three in W.
        words: What S, E and W are on this arm.
    """

    chain: Chain
    shoulder: Array
    along: float
    wrist: Array
    pole: Array
    reference: Array
    spherical: bool
    words: str

    @property
    def max_solutions(self) -> int:
        """The most solutions that are given for one pose and arm angle: 8 where shoulder and wrist are spherical."""
        return 8 if self.spherical else 32

    def of(self, q: Array) -> tuple[Array, Bools]:
        """Return the arm angles (...), rad in (-pi, pi], of joint vectors q (..., 7), and whether each is defined.

        An angle that is undefined (the elbow on the line S-W, the line along the pole, or W on S) is given as zero.
        """
        x, y, defined = self.frame(self.chain.native.fk(q))
        return self.about(q, x, y, defined)

    def about(self, q: Array, x: Array, y: Array, defined: Bools) -> tuple[Array, Bools]:
        """Return angles and whether defined, of q (..., 7) about lines whose references x, y (..., 3) are given."""
        elbow = self.elbow(q)
        across, up = np.sum(elbow * x, -1), np.sum(elbow * y, -1)
        defined = defined & (np.hypot(across, up) > ARM_STRETCHED * self.chain.length)
        angle = np.arctan2(np.where(defined, up, 0.0), np.where(defined, across, 1.0))
        return np.where(angle == -np.pi, np.pi, angle), defined

    def elbow(self, q: Array) -> Array:
        """Return E - S (..., 3) of joint vectors q (..., 7), world frame, m."""
        axes, points = axes_at(self.chain, q)
        return points[..., 3, :] + self.along * axes[..., 3, :] - self.shoulder

    def line(self, T: Array) -> Array:
        """Return W - S (..., 3) of poses T (..., 4, 4), world frame, m."""
        return T[..., :3, :3] @ self.wrist + T[..., :3, 3] - self.shoulder

    def frame(self, T: Array) -> tuple[Array, Array, Bools]:
        """Return unit vectors x, y (..., 3) across the line S-W of poses T: the angle counts from x towards y.

        The mirror that swaps the pole and the line's direction u carries the reference to x; y = u x x. Also returned:
        whether the line defines them (...).
        """
        line = self.line(T)
        size = np.linalg.norm(line, axis=-1)
        defined = size > ARM_STRETCHED * self.chain.length
        u = line / np.where(defined, size, 1.0)[..., None]
        u = np.where(defined[..., None], u, -self.pole)
        mirror = u - self.pole
        gap = np.linalg.norm(mirror, axis=-1)
        defined = defined & (gap > ARM_ANGLE_POLE)
        mirror = np.where(defined[..., None], mirror / np.where(defined, gap, 1.0)[..., None], -self.pole)
        u = np.where(defined[..., None], u, -self.pole)
        x = self.reference - 2 * (mirror @ self.reference)[..., None] * mirror
        return x, np.cross(u, x), defined

    def gradient(self, q: Array, x: Array, y: Array) -> Array:
        """Return d angle / d q (..., 7) with the line S-W held; zero where the elbow is on the line."""
        axes, points = axes_at(self.chain, q)
        elbow = points[..., 3, :] + self.along * axes[..., 3, :]
        across, up = np.sum((elbow - self.shoulder) * x, -1), np.sum((elbow - self.shoulder) * y, -1)
        size = np.maximum(across**2 + up**2, TINY)
        slope = (across[..., None] * y - up[..., None] * x) / size[..., None]
        moved = np.cross(axes[..., :3, :], elbow[..., None, :] - points[..., :3, :])
        out = np.zeros(q.shape)
        out[..., :3] = np.sum(moved * slope[..., None, :], -1)
        return out


def arm_angle(chain: Chain, base: Array) -> ArmAngle | str:
    """Return how the arm angle of a chain is defined, or in words why it has none.

    Args:
        chain: The arm.
        base: (4, 4) the frame its table stands in: the pole is its -z, the reference its x.
    """
    if chain.n != 7 or chain.prismatic.any():
        return "an arm angle needs seven revolute joints"
    geometry = look(chain, GEOMETRY_EXACT)
    joined = {group.joints: np.array(group.point) for group in geometry.spherical}
    shoulder: Array | None = joined.get((0, 1, 2))
    wrist: Array | None = joined.get((4, 5, 6))
    spherical = shoulder is not None and wrist is not None
    words = ["S where joints 1, 2 and 3 meet", "", "W where joints 5, 6 and 7 meet"]
    if shoulder is None:
        shoulder, words[0] = _foot(chain, 0, 1), "S on axis 1 where axis 2 comes nearest"
    if wrist is None:
        wrist, words[2] = _foot(chain, 6, 5), "W on axis 7 where axis 6 comes nearest"
    elbow, words[1] = _foot(chain, 3, 2), "E on axis 4 where axis 3 comes nearest"
    if elbow is None:
        elbow, words[1] = _foot(chain, 3, 4), "E on axis 4 where axis 5 comes nearest"
    if shoulder is None or elbow is None or wrist is None:
        a, b, what = (1, 2, "shoulder") if shoulder is None else (3, 4, "elbow") if elbow is None else (6, 7, "wrist")
        return f"joints {a} and {b} are parallel, so that no point stands out as the {what}"
    found = ArmAngle(
        chain=chain,
        shoulder=shoulder,
        along=float((elbow - chain.points[3]) @ chain.axes[3]),
        wrist=(inverse(chain.home) @ [*wrist, 1.0])[:3],
        pole=-base[:3, 2],
        reference=base[:3, 0],
        spherical=spherical,
        words=", ".join(words),
    )
    return found if _moves(found) else "the elbow does not turn about the line from shoulder to wrist in self-motion"


def _moves(angle: ArmAngle) -> bool:
    """Whether the arm angle is defined, and changes along the self-motion, at postures of no special kind."""
    steps = np.sqrt(np.array([2, 3, 5, 7, 11, 13, 17.0]))
    q = np.asarray(np.pi * (2 * (np.arange(1, 9)[:, None] * steps % 1.0) - 1), np.float64)
    x, y, defined = angle.frame(angle.chain.native.fk(q))
    _, defined = angle.about(q, x, y, defined)
    null = null_space(angle.chain, q)[1][:, -1]
    change = np.abs(np.sum(angle.gradient(q, x, y) * null, -1))
    return bool(median(np.where(defined, change, 0.0)) > ARM_ANGLE_MOVES)


def _foot(chain: Chain, on: int, towards: int) -> Array | None:
    """Return the point (3,) of one axis nearest to another, all joints at zero; None where they are parallel."""
    u, v = chain.axes[on], chain.axes[towards]
    normal = np.cross(u, v)
    size = float(normal @ normal)
    if size < GEOMETRY_EXACT**2:
        return None
    gap = chain.points[towards] - chain.points[on]
    return chain.points[on] + float(np.cross(gap, v) @ normal) / size * u
