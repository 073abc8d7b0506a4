"""Find every inverse solution of any serial chain by brute force: many random starts, damped Newton, clustering.

It is slow, and it says how sure it is: `fewest` is the number of starts that reached the rarest solution, so a solution
with the same basin of attraction would have been missed with a probability of about exp(-fewest). The search is in
NumPy; the same in C++ (starts.cpp), compiled by `build`, is for long hunts.
"""

from __future__ import annotations

import ctypes
import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

from oracle.model import TASKS, Machine, equations, gap, machine, polish

Array = npt.NDArray[np.float64]


def damped_newton(m: Machine, T: Array, v: Array, task: int = 0, iterations: int = 60) -> Array:
    """Return the starts (c, n) that converged, by Levenberg-Marquardt on all of them at once."""
    v = v.copy()
    done: list[Array] = []
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


@dataclass(frozen=True)
class Found:
    """What the search found at one pose.

    Attributes:
        q: (k, n) isolated or representative solutions, rad and m.
        hits: (k,) how many starts ended there.
        sigma: (k,) smallest singular value of the equations there (0 at a double root or a family).
        residual: (k,) what is left of the equations, lengths by the arm's size.
        crowded: Whether more clusters were found than `at_most`: a self-motion.
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
        at_most: Number of clusters from which a self-motion is assumed.
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
        # a self-motion: look through what is left for solutions that stand alone
        alone = polish(m, pose, ends, code, rounds=2)[2] > 1e-4
        more, counts, _ = _clusters(m, ends[alone], apart, at_most)
        reps, hits = reps + more, hits + counts
    if not reps:
        return Found(np.zeros((0, m.n)), np.zeros(0, int), np.zeros(0), np.zeros(0), False)
    v, residual, sigma = polish(m, pose, np.array(reps), code)
    keep = residual < 1e-11
    v, residual, sigma, hits = v[keep], residual[keep], sigma[keep], np.array(hits)[keep]
    crowded = len(ends) > 0
    return distinct(m, v, hits, sigma, residual, crowded)


def distinct(m, v, hits, sigma, residual, crowded) -> Found:
    """Return what was found with each root once, the best known one of those that are the same.

    At a double root Newton stops short of it: what lies closer than that is the same root.
    """
    out, total = [], []
    for i in np.argsort(-sigma, kind="stable"):
        wide = max(1e-6, min(1e-3, 1e-12 / max(sigma[i], 1e-300)))
        same = [j for j, k in enumerate(out) if gap(m, v[i], v[k]) < wide]
        if same:
            total[same[0]] += hits[i]
        else:
            out.append(i)
            total.append(int(hits[i]))
    return Found(m.outer(v[out]), np.array(total, int), sigma[out], residual[out], crowded)


def build(folder) -> object:
    """Compile starts.cpp into folder and return the compiled search."""
    target = Path(folder) / "starts.so"
    source = Path(__file__).with_name("starts.cpp")
    if not target.exists() or target.stat().st_mtime < source.stat().st_mtime:
        flags = ["-O3", "-march=native", "-ffast-math", "-shared", "-fPIC", "-Wno-psabi"]
        subprocess.run(["g++", *flags, str(source), "-o", str(target)], check=True)
    return load(target)


def load(path) -> ctypes.CDLL:
    """Return the compiled search."""
    library = ctypes.CDLL(str(path))
    library.search.restype = ctypes.c_int
    return library
