"""An arm as its joint axes (product of exponentials), complete and minimal: what may move, and how the tool follows.

T(q) = exp(S1 v1) ... exp(Sn vn) M with v = C q + harmonics. An axis may move in four directions (a slide's in two, of
which only its direction counts), the tool in six, so that 4 r + 2 p + 6 numbers say every arm near the nominal one
once, also where axes are parallel.

Source: Okamura and Park (1996); Chen, Yang, Tan and Yeo (2001).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from pieper.calibration.parameters import Parameters
from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.chain import Chain
from pieper.kinematics.pose import skew
from pieper.tolerances import EXPONENTIAL_SERIES


def screw_motion(twist: Array) -> Array:
    """Return the poses (..., 4, 4) exp(twist) of twists (..., 6): turn first, rad, then way, m."""
    w, v = twist[..., :3], twist[..., 3:]
    angle = np.linalg.norm(w, axis=-1)[..., None, None]
    small = angle < EXPONENTIAL_SERIES
    safe = np.where(small, 1.0, angle)
    square = angle * angle
    a = np.where(small, 1 - square / 6, np.sin(safe) / safe)
    b = np.where(small, 0.5 - square / 24, 2 * (np.sin(safe / 2) / safe) ** 2)  # 1 - cos would lose digits
    c = np.where(small, 1 / 6, (safe - np.sin(safe)) / safe**3)  # times two small turns: no more of it is seen
    K = skew(w)
    K2 = K @ K
    T = np.zeros((*twist.shape[:-1], 4, 4))
    T[..., :3, :3] = np.eye(3) + a * K + b * K2
    T[..., :3, 3] = ((np.eye(3) + b * K + c * K2) @ v[..., None])[..., 0]
    T[..., 3, 3] = 1.0
    return T


def adjoint(T: Array) -> Array:
    """Return the matrices (..., 6, 6) that take twists (turn, way) through poses (..., 4, 4)."""
    R = T[..., :3, :3]
    A = np.zeros((*T.shape[:-2], 6, 6))
    A[..., :3, :3] = A[..., 3:, 3:] = R
    A[..., 3:, :3] = skew(T[..., :3, 3]) @ R
    return A


@dataclass(frozen=True, eq=False)
class AxesModel:
    """The arm that is fitted.

    Args:
        screws: (n, 6) axes as twists, turn first: (w, p x w) of a revolute joint, (0, w) of a slide.
        home: (4, 4) the tool with all joints at zero, m.
        prismatic: (n,) bool.
        gears: (n, n) C: values of the chain = C @ joint values.
        harmonics: (n, 2) what is added to them: a sin q + b (cos q - 1), rad.
    """

    screws: Array
    home: Array
    prismatic: Bools
    gears: Array
    harmonics: Array

    @staticmethod
    def of(chain: Chain) -> AxesModel:
        """Return the model of a chain."""
        turning = ~chain.prismatic[:, None]
        w = np.where(turning, chain.axes, 0.0)
        v = np.where(turning, _cross(chain.points, chain.axes), chain.axes)
        gears = np.eye(chain.n) if chain.coupling is None else np.array(chain.coupling)
        return AxesModel(np.concatenate([w, v], 1), chain.home.copy(), chain.prismatic, gears, np.zeros((chain.n, 2)))

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.prismatic)

    @property
    def axes(self) -> Array:
        """(n, 3) unit directions of the joints' axes at zero."""
        return np.where(self.prismatic[:, None], self.screws[:, 3:], self.screws[:, :3])

    @property
    def points(self) -> Array:
        """(n, 3) a point on each axis, the nearest to the base frame's origin, m; zero for slides."""
        return _cross(self.screws[:, :3], self.screws[:, 3:])

    def values(self, q: Array) -> Array:
        """Return the values (..., n) of the chain's joints at joint vectors q (..., n), rad or m."""
        return q @ self.gears.T + self.harmonics[:, 0] * np.sin(q) + self.harmonics[:, 1] * (np.cos(q) - 1)

    def fk(self, q: Array) -> Array:
        """Return the tool's poses (N, 4, 4) at joint vectors q (N, n)."""
        steps = screw_motion(self.values(q)[..., None] * self.screws)
        P = steps[:, 0]
        for i in range(1, self.n):
            P = P @ steps[:, i]
        return P @ self.home

    @property
    def beside(self) -> Array:
        """(n, 2, 3) two unit directions across each axis, a and b, in the base frame, all joints at zero."""
        return np.linalg.svd(self.axes[:, None])[2][:, 1:]

    def directions(self, about: Array) -> list[Array]:
        """Return of each joint the twists (6, 4 or 2) that move its axis: two tilts about a point and two shifts.

        Args:
            about: (3,) a place amid the arm, m: an axis tilts about its own point nearest to that.
        """
        out = []
        for w, p, slides, others in zip(self.axes, self.points, self.prismatic, self.beside, strict=True):
            across = others.T
            foot = p + ((about - p) @ w) * w
            B = np.zeros((6, 2 if slides else 4))
            B[:3, :2], B[3:, :2] = across, skew(foot) @ across
            if not slides:
                B[3:, 2:] = across
            out.append(B)
        return out

    def moved(self, step: Array, parameters: Parameters) -> AxesModel:
        """Return the model a step (k,) away along its parameters, in SI units."""
        screws, gears, harmonics = self.screws.copy(), self.gears.copy(), self.harmonics.copy()
        for i, B in enumerate(self.directions(parameters.about)):
            screws[i] = adjoint(screw_motion(B @ step[parameters.of_axis[i]])) @ screws[i]
        w = np.where(self.prismatic[:, None], screws[:, 3:], screws[:, :3])
        screws /= np.linalg.norm(w, axis=1, keepdims=True)
        for k, i, j in parameters.gears:
            gears[i] += step[k] * parameters.nominal_gears[i] * (i == j)
            gears[i, j] += step[k] * (i != j)
        for k, i, phase in parameters.harmonics:
            harmonics[i, phase] += step[k]
        home = _about(parameters.about, step[parameters.of_tool]) @ self.home
        return replace(self, screws=screws, home=home, gears=gears, harmonics=harmonics)

    def pose_and_jacobian(self, q: Array, parameters: Parameters) -> tuple[Array, Array]:
        """Return poses (N, 4, 4) and how they move with the parameters: twists (N, 6, k), turn first, base frame."""
        values = self.values(q)
        N, turning = len(q), np.zeros((len(q), 6, parameters.count))
        T, before = np.broadcast_to(np.eye(4), (N, 4, 4)), np.broadcast_to(np.eye(6), (N, 6, 6))
        by_value, steps = np.empty((N, 6, self.n)), screw_motion(values[..., None] * self.screws)
        for i, B in enumerate(self.directions(parameters.about)):
            by_value[..., i] = before @ self.screws[i]
            T = T @ steps[:, i]
            after = adjoint(T)
            turning[:, :, parameters.of_axis[i]] = (before - after) @ B
            before = after
        turning[:, :, parameters.of_tool] = before @ _carried(parameters.about)
        for k, i, j in parameters.gears:
            rate = q @ parameters.nominal_gears[i] if i == j else q[:, j]
            turning[:, :, k] = by_value[..., i] * rate[:, None]
        for k, i, phase in parameters.harmonics:
            rate = np.cos(q[:, i]) - 1 if phase else np.sin(q[:, i])
            turning[:, :, k] = by_value[..., i] * rate[:, None]
        return T @ self.home, turning


def _cross(a: Array, b: Array) -> Array:
    return (skew(a) @ b[..., None])[..., 0]


def _carried(about: Array) -> Array:
    """Return the twists (6, 6) of turns about the axes of the base frame through a place, and of ways along them."""
    A = np.eye(6)
    A[3:, :3] = skew(about)
    return A


def _about(about: Array, step: Array) -> Array:
    return screw_motion(_carried(about) @ step)
