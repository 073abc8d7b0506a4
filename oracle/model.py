"""A serial arm as the oracle sees it: its own product of DH matrices, derivatives and comparison of joint vectors.

Written without sight of the library's solvers, and sharing nothing with them but the reading of a DH table.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from oracle.joints import around

TASKS = {"pose": 0, "position": 1, "position+axis": 2}


@dataclass(frozen=True)
class Machine:
    """A serial chain as constant matrices and joints about or along z.

    Attributes:
        links: (n + 1, 4, 4), lengths divided by `unit`.
        slides: (n,) bool.
        sign, offset: (n,) joint value = sign * q + offset, a slide's offset divided by `unit`.
        unit: Length that makes the arm of size one, m.
    """

    links: np.ndarray
    slides: np.ndarray
    sign: np.ndarray
    offset: np.ndarray
    unit: float

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.slides)

    def inner(self, q: np.ndarray) -> np.ndarray:
        """Return joint values in the machine's own units."""
        return self.sign * np.where(self.slides, q / self.unit, q) + self.offset

    def outer(self, v: np.ndarray) -> np.ndarray:
        """Return joint vectors of inner values, angles in (-pi, pi]."""
        q = (v - self.offset) * self.sign
        return np.where(self.slides, q * self.unit, np.pi - (np.pi - q) % (2 * np.pi))

    def pose(self, T: np.ndarray) -> np.ndarray:
        """Return a pose with its position in the machine's units."""
        T = np.array(T, float)
        T[:3, 3] /= self.unit
        return T


def elementary(row, convention: str, value: float = 0.0):
    """Return the constant matrices before and after a joint's own motion, of one DH row."""
    ca, sa, ct, st = np.cos(row.alpha), np.sin(row.alpha), np.cos(row.theta), np.sin(row.theta)
    fixed = np.array([[ct, -st, 0, 0], [st, ct, 0, 0], [0, 0, 1, row.d], [0, 0, 0, 1]])
    link = np.array([[1, 0, 0, row.a], [0, ca, -sa, 0], [0, sa, ca, 0], [0, 0, 0, 1]])
    return (np.eye(4), fixed @ link) if convention == "standard" else (link, fixed)


def machine(arm) -> Machine:
    """Return the chain of an arm, from its DH table alone."""
    d = arm.description
    slides = np.array([t == "P" for t in d.joint_types])
    links = [np.array(d.base, float)]
    for row in d.rows:
        before, after = elementary(row, d.convention)
        links[-1] = links[-1] @ before
        links.append(after)
    links[-1] = links[-1] @ d.tool
    return of_links(np.stack(links), slides, np.asarray(d.sign, float), np.asarray(d.offset, float))


def machine_of(chain) -> Machine:
    """Return a chain that no table was written for, from its constant matrices."""
    return of_links(np.array(chain.links), np.asarray(chain.prismatic, bool), np.ones(chain.n), np.zeros(chain.n))


def of_links(links: np.ndarray, slides: np.ndarray, sign: np.ndarray, offset: np.ndarray) -> Machine:
    """Return the machine of size one of links (n + 1, 4, 4), m."""
    unit = float(sum(np.linalg.norm(L[:3, 3]) for L in links[1:])) or 1.0
    links[:, :3, 3] /= unit
    return Machine(links, slides, sign, np.where(slides, offset / unit, offset), unit)


def locked(m: Machine, joint: int, value: float) -> Machine:
    """Return the machine with a joint held at an inner value: one joint fewer."""
    c, s = np.cos(value), np.sin(value)
    Z = np.eye(4)
    if m.slides[joint]:
        Z[2, 3] = value
    else:
        Z[:2, :2] = [[c, -s], [s, c]]
    links = list(m.links)
    links[joint : joint + 2] = [links[joint] @ Z @ links[joint + 1]]
    rest = np.arange(m.n) != joint
    return Machine(np.stack(links), m.slides[rest], m.sign[rest], m.offset[rest], m.unit)


def forward(m: Machine, v: np.ndarray):
    """Return poses (k, 4, 4), joint axes (k, n, 3) and points (k, n, 3) of inner values v (k, n)."""
    T = np.broadcast_to(m.links[0], (len(v), 4, 4)).copy()
    axes, points = [], []
    for i in range(m.n):
        axes.append(T[:, :3, 2].copy())
        points.append(T[:, :3, 3].copy())
        if m.slides[i]:
            T[:, :3, 3] += T[:, :3, 2] * v[:, i, None]
        else:
            c, s = np.cos(v[:, i, None]), np.sin(v[:, i, None])
            x, y = T[:, :, 0].copy(), T[:, :, 1].copy()
            T[:, :, 0], T[:, :, 1] = x * c + y * s, y * c - x * s
        T = T @ m.links[i + 1]
    return T, np.stack(axes, 1), np.stack(points, 1)


def equations(m: Machine, v: np.ndarray, T: np.ndarray, task: int = 0):
    """Return residuals (k, r) and their derivatives (k, r, n) at inner values v (k, n)."""
    P, z, o = forward(m, v)
    turning = (~m.slides)[None, :, None]
    move = np.where(turning, np.cross(z, P[:, None, :3, 3] - o), z)
    spin = np.where(turning, z, 0.0)
    residual, slope = [P[:, :3, 3] - T[:3, 3]], [move]
    for column in {0: (0, 1, 2), 1: (), 2: (2,)}[task]:
        residual.append(P[:, :3, column] - T[:3, column])
        slope.append(np.cross(spin, P[:, None, :3, column]))
    return np.concatenate(residual, 1), np.concatenate([np.swapaxes(s, 1, 2) for s in slope], 1)


def polish(m: Machine, T, v, task=0, rounds=8):
    """Return v (k, n) after plain Newton steps, the residual norms (k,) and the smallest singular values (k,)."""
    for _ in range(rounds):
        r, J = equations(m, v, T, task)
        v = v - (np.linalg.pinv(J, rcond=1e-13) @ r[..., None])[..., 0]
    r, J = equations(m, v, T, task)
    s = np.linalg.svd(J, compute_uv=False)
    rank = min(m.n, {0: 6, 1: 3, 2: 5}[task])
    return v, np.linalg.norm(r, axis=1), s[:, rank - 1]


def gap(m: Machine, a, b):
    """Return the largest difference of inner values, angles around the circle."""
    d = a - b
    return np.abs(np.where(m.slides, d, around(d))).max(-1)


def exact_residual(arm, T, q, digits=50) -> float:
    """Return what is left of the pose equations at q after one Newton step in high precision (mpmath): the proof.

    The value is the size of the step, rad or arm lengths; a true simple solution moves by rounding only.
    """
    import mpmath as mp

    with mp.workdps(digits):
        m = machine(arm)
        v = [mp.mpf(float(x)) for x in m.inner(np.asarray(q, float))]
        target = mp.matrix(m.pose(T).tolist())

        def left(v):
            P = mp.matrix(m.links[0].tolist())
            for i in range(m.n):
                if m.slides[i]:
                    Z = mp.matrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, v[i]], [0, 0, 0, 1]])
                else:
                    c, s = mp.cos(v[i]), mp.sin(v[i])
                    Z = mp.matrix([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
                P = P * Z * mp.matrix(m.links[i + 1].tolist())
            D = P - target
            return mp.matrix([D[i, j] for i in range(3) for j in range(4)])

        r, h = left(v), mp.mpf(10) ** (-digits // 2)
        columns = []
        for i in range(m.n):
            moved = list(v)
            moved[i] += h
            columns.append((left(moved) - r) / h)
        J = mp.matrix(12, m.n)
        for i, column in enumerate(columns):
            for k in range(12):
                J[k, i] = column[k]
        step = mp.lu_solve(J.T * J, -(J.T * r))
        return float(max(abs(x) for x in step))
