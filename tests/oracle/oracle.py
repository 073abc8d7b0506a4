"""Find every inverse solution of any serial chain by brute force: many random starts, damped Newton, clustering.

Written without sight of the library's solvers, and sharing nothing with them: its own product of DH matrices, its own
derivatives, its own comparison of joint vectors around the circle. It is slow, and it says how sure it is: `fewest`
is the number of starts that reached the rarest solution, so a solution with the same basin of attraction would have
been missed with a probability of about exp(-fewest).
"""

from __future__ import annotations

import ctypes
from dataclasses import dataclass

import numpy as np

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
    links = np.stack(links)
    unit = float(sum(np.linalg.norm(L[:3, 3]) for L in links[1:])) or 1.0
    links[:, :3, 3] /= unit
    offset = np.where(slides, np.asarray(d.offset) / unit, d.offset)
    return Machine(links, slides, np.asarray(d.sign, float), offset, unit)


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


def damped_newton(m: Machine, T, v, task=0, iterations=60):
    """Return the starts (c, n) that converged, by Levenberg-Marquardt on all of them at once."""
    v = v.copy()
    done = []
    damping = np.full(len(v), 1e-2)
    r, J = equations(m, v, T, task)
    for _ in range(iterations):
        cost = (r * r).sum(1)
        there = cost < 1e-20
        if there.any():
            done.append(v[there])
            v, r, J, damping, cost = v[~there], r[~there], J[~there], damping[~there], cost[~there]
        if not len(v):
            break
        H = np.swapaxes(J, 1, 2) @ J + damping[:, None, None] * np.eye(m.n)
        d = np.linalg.solve(H, -np.swapaxes(J, 1, 2) @ r[..., None])[..., 0]
        d /= np.maximum(1.0, np.linalg.norm(d, axis=1))[:, None]
        r2, J2 = equations(m, v + d, T, task)
        better = (r2 * r2).sum(1) < cost
        v, r = np.where(better[:, None], v + d, v), np.where(better[:, None], r2, r)
        J = np.where(better[:, None, None], J2, J)
        damping = np.where(better, np.maximum(damping * 0.15, 1e-13), damping * 5)
    return np.concatenate(done) if done else np.zeros((0, m.n))


def compiled_newton(library, m: Machine, T, v, task=0, iterations=100):
    """Do the same by the compiled search of starts.cpp."""
    v = np.ascontiguousarray(v)
    out = np.empty_like(v)
    links, T = np.ascontiguousarray(m.links), np.ascontiguousarray(T)
    slides = m.slides.astype(np.uint8)
    pointer = [a.ctypes.data_as(ctypes.c_void_p) for a in (links, slides, T, v, out)]
    enough = ctypes.c_double(1e-27)
    count = library.search(m.n, *pointer[:3], task, pointer[3], len(v), iterations, enough, pointer[4])
    return out[:count].copy()


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
    return np.abs(np.where(m.slides, d, (d + np.pi) % (2 * np.pi) - np.pi)).max(-1)


@dataclass(frozen=True)
class Found:
    """What the search found at one pose.

    Attributes:
        q: (k, n) isolated or representative solutions, rad and m.
        hits: (k,) how many starts ended there.
        sigma: (k,) smallest singular value of the equations there (0 at a double root or a family).
        residual: (k,) what is left of the equations, lengths by the arm's size.
        crowded: Whether more clusters were found than `at_most`: a continuous family.
    """

    q: np.ndarray
    hits: np.ndarray
    sigma: np.ndarray
    residual: np.ndarray
    crowded: bool

    @property
    def fewest(self) -> int:
        """Hits of the rarest solution."""
        return int(self.hits.min()) if len(self.hits) else 0


def _clusters(m, ends, apart, at_most):
    """Return the first point of each cluster, the clusters' sizes and the points left over after at_most clusters."""
    reps, hits = [], []
    while len(ends) and len(reps) < at_most:
        near = gap(m, ends, ends[0]) < apart
        reps.append(ends[0])
        hits.append(int(near.sum()))
        ends = ends[~near]
    return reps, hits, ends


def search(arm, T, *, task="pose", starts=1500, rng=None, library=None, at_most=40, apart=1e-4, m=None) -> Found:
    """Find the solutions of pose T (4, 4) from random starts.

    Args:
        arm: Anything with a DH `description`.
        T: Pose.
        task: What the pose asks for.
        starts: Number of random starts.
        rng: Random numbers.
        library: The compiled search, or None for the one in NumPy.
        at_most: Number of clusters from which a continuous family is assumed.
        apart: Distance below which two answers are the same; a cluster gets wider where the equations are singular.
        m: The arm's machine, if it has been made already; arm may then be None.
    """
    rng = rng or np.random.default_rng(0)
    m = m or machine(arm)
    pose, code = m.pose(T), TASKS[task]
    span = np.where(m.slides, 1.5 + np.linalg.norm(pose[:3, 3]), np.pi)
    v = rng.uniform(-1, 1, (starts, m.n)) * span
    ends = compiled_newton(library, m, pose, v, code) if library else damped_newton(m, pose, v, code)
    reps, hits, ends = _clusters(m, ends, apart, at_most)
    if len(ends):
        # a continuous family: look through what is left for solutions that stand alone
        alone = polish(m, pose, ends, code, rounds=2)[2] > 1e-4
        more, counts, _ = _clusters(m, ends[alone], apart, at_most)
        reps, hits = reps + more, hits + counts
    if not reps:
        return Found(np.zeros((0, m.n)), np.zeros(0, int), np.zeros(0), np.zeros(0), False)
    v, residual, sigma = polish(m, pose, np.array(reps), code)
    keep = residual < 1e-11
    v, residual, sigma, hits = v[keep], residual[keep], sigma[keep], np.array(hits)[keep]
    crowded = len(ends) > 0
    out, total = [], []
    for i in np.argsort(-sigma, kind="stable"):
        # near a double root Newton stops short: points closer than their blur are the same root
        wide = max(1e-6, min(1e-3, 1e-12 / max(sigma[i], 1e-300)))
        same = [j for j, k in enumerate(out) if gap(m, v[i], v[k]) < wide]
        if same:
            total[same[0]] += hits[i]
        else:
            out.append(i)
            total.append(int(hits[i]))
    return Found(m.outer(v[out]), np.array(total, int), sigma[out], residual[out], crowded)


def load(path) -> ctypes.CDLL:
    """Return the compiled search."""
    library = ctypes.CDLL(str(path))
    library.search.restype = ctypes.c_int
    return library


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
