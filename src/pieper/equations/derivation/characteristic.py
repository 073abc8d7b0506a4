"""The characteristic polynomial of a six-revolute arm at a pose: degree 16 at most, its roots, and the other joints.

Cut the closed loop of the arm and the wanted pose so that joints 3, 4, 5 (in any cyclic numbering) are on one side. The
axis l and the point p of joint 6 seen from both sides, and p.p, p.l, p x l, (p.p) l - 2 (p.l) p, are fourteen equations
that are linear in the sines and cosines of every joint (Raghavan & Roth 1990). Six combinations are free of joints 1
and 2; with half-angle tangents for joints 4 and 5 and their multiples by one of them they make a 12 x 12 matrix whose
determinant is a trigonometric polynomial in the angle of joint 3 alone. It is sampled on the circle and Fourier
transformed, which is exact for such a polynomial.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.kinematics.joints import wrapped
from pieper.tolerances import (
    CUT_RANK,
    NO_LENGTH,
    ON_UNIT_CIRCLE,
    POLISH_ENOUGH,
    POLISH_FAILED,
    POLYNOMIAL_CLEAN,
    POLYNOMIAL_ENDS,
    POLYNOMIAL_VANISHES,
    QUOTIENT_STEP,
    ROUNDING,
    SHARED_ANGLE,
    TWO_POSTURES,
)

SAMPLES = 32  # more than 2*12 + 1: the determinant has no harmonic above 12
PENCIL_TURN = 0.7  # rad, none that an angle of a known posture is likely to make singular
HARMONIC = 8  # after the factor (1 + t^2)^4 that every such determinant has, 8 harmonics remain
GRID = (0.0, np.pi / 2, np.pi)
#: (f(0), f(pi/2), f(pi)) -> coefficients of sine, cosine and 1.
FROM_GRID = np.array([[-0.5, 1.0, -0.5], [0.5, 0.0, -0.5], [0.5, 0.0, 0.5]])
#: sine, cosine, 1 times (1 + x^2), by powers x^2, x, 1 of the half-angle tangent.
HALF_ANGLE = np.array([[0.0, 2.0, 0.0], [-1.0, 0.0, 1.0], [1.0, 0.0, 1.0]])


@dataclass(frozen=True)
class CharacteristicPolynomial:
    """The polynomial of one pose.

    Attributes:
        joint: The joint (1-based) whose angle it is in.
        harmonics: (17,) complex coefficients of exp(i m theta), m = -8 .. 8, largest of size 1.
        coefficients: (degree + 1,) real, by falling powers of t = tan(theta/2), largest of size 1.
        degree: Its degree.
        roots: All complex roots t.
        angles: Real roots, as angles theta in (-pi, pi], ascending.
        solutions: (m, 6) joint vectors that follow from the real roots.
        noise: Size of the harmonics that must vanish, against the largest; how exact the elimination was.
    """

    joint: int
    harmonics: np.ndarray
    coefficients: np.ndarray
    degree: int
    roots: np.ndarray
    angles: np.ndarray
    solutions: np.ndarray
    noise: float


def characteristic_polynomial(
    links: np.ndarray, T: np.ndarray, fk: Callable[[Array], Array]
) -> CharacteristicPolynomial | None:
    """Eliminate all but one joint of a six-revolute chain at a pose.

    Args:
        links: (7, 4, 4) constant links, T(q) = L0 Z(q1) L1 .. Z(q6) L6.
        T: (4, 4) pose.
        fk: q (..., 6) -> (..., 4, 4), to polish and confirm the solutions.

    Returns:
        The elimination with the least noise of the six cyclic ways to cut the loop; None when all of them vanish.
    """
    size = max(float(np.linalg.norm(links[1:6, :3, 3], axis=1).sum()), NO_LENGTH)
    scaled = links.copy()
    scaled[:, :3, 3] /= size
    target = T.copy()
    target[:3, 3] /= size
    closing = scaled[6] @ np.linalg.inv(target) @ scaled[0]
    loop = [*scaled[1:6], closing]
    ways = []
    for shift in range(6):
        cut = _Cut([loop[(shift + k) % 6] for k in range(6)], shift)
        if not cut.usable:
            continue
        harmonics = np.fft.fftshift(np.fft.fft(cut.samples()) / SAMPLES)
        middle = SAMPLES // 2
        peak = np.abs(harmonics).max()
        if not peak > 0:
            continue
        kept = harmonics[middle - HARMONIC : middle + HARMONIC + 1] / peak
        outside = (
            np.abs(np.concatenate([harmonics[: middle - HARMONIC], harmonics[middle + HARMONIC + 1 :]])).max() / peak
        )
        if outside < POLYNOMIAL_CLEAN:
            ways.append((outside, cut, kept))
    ways.sort(key=lambda way: way[0])
    return _finish(ways, fk, T) if ways else None


class _Cut:
    """One way to cut the loop Z1 m1 Z2 m2 .. Z6 m6 = I."""

    def __init__(self, m: list[np.ndarray], shift: int) -> None:
        self.m, self.shift = m, shift
        back = [np.linalg.inv(x) for x in m]
        right = np.zeros((14, 3, 3))
        for a, t1 in enumerate(GRID):
            for b, t2 in enumerate(GRID):
                B = back[1] @ _turn(-t2) @ back[0] @ _turn(-t1) @ back[5]
                right[:, a, b] = _fourteen(B)
        self.right = np.einsum("ia,jb,nab->nij", FROM_GRID, FROM_GRID, right).reshape(14, 9)
        U, s, _ = np.linalg.svd(self.right[:, :8])
        self.usable = bool(s[-1] > CUT_RANK * s[0])
        self.free = U[:, 8:].T

    def left(self, t3: float) -> np.ndarray:
        """(14, 9) coefficients by s4 s5, s4 c5, s4, c4 s5, c4 c5, c4, s5, c5, 1."""
        values = np.zeros((14, 3, 3))
        for a, t4 in enumerate(GRID):
            for b, t5 in enumerate(GRID):
                A = _turn(t3) @ self.m[2] @ _turn(t4) @ self.m[3] @ _turn(t5) @ self.m[4]
                values[:, a, b] = _fourteen(A)
        return np.einsum("ia,jb,nab->nij", FROM_GRID, FROM_GRID, values).reshape(14, 9)

    def matrix(self, t3: float) -> np.ndarray:
        """The 12 x 12 matrix in x4^3 .. 1 times x5^2 .. 1."""
        P = self.left(t3)
        P[:, 8] -= self.right[:, 8]
        E = np.einsum("nij,ia,jb->nab", (self.free @ P).reshape(6, 3, 3), HALF_ANGLE, HALF_ANGLE)
        M = np.zeros((12, 4, 3))
        M[:6, 1:] = E
        M[6:, :3] = E
        return M.reshape(12, 12)

    def samples(self) -> np.ndarray:
        return np.array([np.linalg.det(self.matrix(2 * np.pi * k / SAMPLES)) for k in range(SAMPLES)])

    def others(self, t3: float) -> list[np.ndarray]:
        """All six joints, in the arm's own numbering, of each posture with this angle of the cut's third joint."""
        _, s, vh = np.linalg.svd(self.matrix(t3))
        left, m = self.left(t3), self.m
        found = []
        for v in _split(vh[-max(1, int((s < SHARED_ANGLE * s[0]).sum())) :]):
            x4 = _ratio(v, axis=0)
            x5 = _ratio(v, axis=1)
            t4, t5 = 2 * np.arctan2(*x4), 2 * np.arctan2(*x5)
            mono = np.outer([np.sin(t4), np.cos(t4), 1], [np.sin(t5), np.cos(t5), 1]).reshape(9)
            wanted = left @ mono - self.right[:, 8]
            y = np.linalg.lstsq(self.right[:, :8], wanted, rcond=None)[0]
            t1, t2 = np.arctan2(y[2], y[5]), np.arctan2(y[6], y[7])
            before = _turn(t1) @ m[0] @ _turn(t2) @ m[1] @ _turn(t3) @ m[2] @ _turn(t4) @ m[3] @ _turn(t5) @ m[4]
            last = np.linalg.inv(m[5] @ before)
            t6 = np.arctan2(last[1, 0], last[0, 0])
            found.append(np.roll([t1, t2, t3, t4, t5, t6], self.shift))
        return found


def _split(null: np.ndarray) -> list[np.ndarray]:
    """Return of a null space (k, 12) the vectors (4, 3) of powers in it, real ones: k postures share the angle.

    In each the upper neighbours of x4 are x4 times the lower ones, and those of x5 likewise: two k by k matrices show
    that, which have the postures' vectors in common. The pencils are turned so that no x is at infinity.
    """
    if len(null) == 1:
        return [null[0].reshape(4, 3)]
    N = null.reshape(-1, 4, 3)
    c, s = np.cos(PENCIL_TURN), np.sin(PENCIL_TURN)
    shown = np.zeros((len(N), len(N)))
    for weight, upper, lower in ((1.0, N[:, :3], N[:, 1:]), (PENCIL_TURN, N[:, :, :2], N[:, :, 1:])):
        over, under = upper.reshape(len(N), -1).T, lower.reshape(len(N), -1).T
        shown += weight * np.linalg.lstsq(c * over + s * under, c * under - s * over, rcond=None)[0]
    values, vectors = (np.asarray(part, np.complex128) for part in np.linalg.eig(shown))
    real = np.abs(values.imag) < ON_UNIT_CIRCLE * (1 + np.abs(values))
    return [np.einsum("k,kij->ij", way, N) for way in vectors.real.T[real]]


def _finish(ways: list, fk: Callable[[Array], Array], T: np.ndarray) -> CharacteristicPolynomial:
    noise, cut, harmonics = ways[0]
    joint = (2 + cut.shift) % 6 + 1
    t = np.zeros(1, complex)
    for m in range(-HARMONIC, HARMONIC + 1):
        t = np.polyadd(t, harmonics[m + HARMONIC] * np.poly(_powers(HARMONIC + m, HARMONIC - m)) * _lead(m))
    t = t * np.exp(-1j * np.angle(t[np.argmax(np.abs(t))]))
    real = t.real / np.abs(t.real).max()
    trailing = np.flatnonzero(np.abs(real) > POLYNOMIAL_ENDS)
    degree = len(real) - 1 - trailing[0]
    # Two postures may share this joint's angle; another cut then tells them apart.
    found: list[np.ndarray] = []
    for _, other, others_harmonics in ways[:2]:
        circle = np.roots(_trimmed(others_harmonics[::-1]))
        for z in circle[np.abs(np.abs(circle) - 1) < ON_UNIT_CIRCLE]:
            for rough in other.others(float(np.angle(z))):
                q = _polished(rough, fk, T)
                if q is not None and all(
                    np.abs(np.angle(np.exp(1j * (q - known)))).max() > TWO_POSTURES for known in found
                ):
                    found.append(q)
    solutions = np.array(sorted(found, key=lambda q: q[joint - 1])).reshape(-1, 6)
    roots = np.roots(real[trailing[0] :])
    return CharacteristicPolynomial(
        joint, harmonics, real[trailing[0] :], degree, roots, solutions[:, joint - 1], solutions, noise
    )


def _powers(plus: int, minus: int) -> list[complex]:
    """Roots of (1 + i t)^plus (1 - i t)^minus."""
    return [1j] * plus + [-1j] * minus


def _lead(m: int) -> complex:
    return (1j) ** (HARMONIC + m) * (-1j) ** (HARMONIC - m)


def _trimmed(harmonics: np.ndarray) -> np.ndarray:
    size = np.abs(harmonics).max()
    kept = np.flatnonzero(np.abs(harmonics) > POLYNOMIAL_VANISHES * size)
    return harmonics[kept[0] : kept[-1] + 1]


def _ratio(v: np.ndarray, axis: int) -> tuple[float, float]:
    """The value (over, under) of a null vector of powers: the neighbouring powers with the largest entries."""
    if axis == 0:
        upper, lower = v[:-1].ravel(), v[1:].ravel()
    else:
        upper, lower = v[:, :-1].ravel(), v[:, 1:].ravel()
    place = int(np.argmax(np.abs(upper) + np.abs(lower)))
    sign = 1.0 if lower[place] >= 0 else -1.0
    return sign * upper[place], sign * lower[place]


def _polished(q: np.ndarray, fk: Callable[[Array], Array], T: np.ndarray) -> np.ndarray | None:
    """Newton steps on the pose; None when they do not arrive."""
    scale = max(1.0, float(np.abs(T[:3, 3]).max()))
    for _ in range(12):
        here = fk(q)
        step = QUOTIENT_STEP
        J = np.array([(fk(q + step * e) - fk(q - step * e))[:3].ravel() / (2 * step) for e in np.eye(6)]).T
        gap = (T - here)[:3].ravel()
        if np.abs(gap).max() < POLISH_ENOUGH * scale:
            break
        q = wrapped(q + np.linalg.lstsq(J, gap, rcond=ROUNDING)[0])
    if np.abs((T - fk(q))[:3]).max() > POLISH_FAILED * scale:
        return None
    return wrapped(q)


def _fourteen(A: np.ndarray) -> np.ndarray:
    """The fourteen quantities of the axis l (third column) and the point p (fourth) of a pose."""
    axis, p = A[:3, 2], A[:3, 3]
    pp, pl = p @ p, p @ axis
    return np.concatenate([p, axis, [pp, pl], np.cross(p, axis), pp * axis - 2 * pl * p])


def _turn(angle: float) -> np.ndarray:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1.0]])
