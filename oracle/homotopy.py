"""Find every isolated solution of a six-revolute arm by following sixteen complex paths from a generic arm.

A generic arm of six revolute joints has sixteen complex solutions (Primrose, 1986; Lee and Liang, 1988). Once all
sixteen of one random complex arm are known, the straight line from it to any other arm and pose carries them to all
isolated solutions there (coefficient-parameter homotopy: Morgan and Sommese, 1989): nothing is drawn at random except
the start, so nothing can be overlooked in a small basin. Nothing here is shared with the library's solvers, nor with
the multi-start search but the reading of a DH table.
"""

from __future__ import annotations

import json
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from oracle.model import Machine

Array = npt.NDArray[np.float64]
Complex = npt.NDArray[np.complex128]
Bools = npt.NDArray[np.bool_]
Indices = npt.NDArray[np.int64]

GENERIC = 16
#: A path whose angles' imaginary parts grow beyond this has left for infinity.
FAR = 22.0
#: A path that stops before this has not left for infinity: it only came close to it.
HALFWAY = 0.99


@dataclass(frozen=True)
class Line:
    """A straight line in the space of arms and poses: start and end of everything, complex.

    Attributes:
        p: (2, 18) d, a, alpha of six standard rows, at both ends.
        q: (2, k, 6) joint vectors whose poses, along the line, are the goal.
        u: (2, 6) turn (three angles) and shift that are put behind that goal.
    """

    p: Complex
    q: Complex
    u: Complex

    def at(self, t: Array, which: Indices) -> tuple[Complex, Complex]:
        """Return rows (k, 18) and goals (k, 3, 4) at t (k,) of the poses `which` (k,)."""
        s = t[:, None]
        p = (1 - s) * self.p[0] + s * self.p[1]
        q = (1 - s) * self.q[0, which] + s * self.q[1, which]
        goal = forward(p, q)[0]
        u = (1 - s) * self.u[0] + s * self.u[1]
        if np.any(self.u):
            _turn(goal, np.cos(u[:, :1]), np.sin(u[:, :1]), 0, 1)
            _turn(goal, np.cos(u[:, 1:2]), np.sin(u[:, 1:2]), 1, 2)
            _turn(goal, np.cos(u[:, 2:3]), np.sin(u[:, 2:3]), 0, 1)
            goal[:, :, 3] += (goal[:, :, :3] * u[:, None, 3:]).sum(2)
        return p, goal


def _turn(T: Complex, c: Complex, s: Complex, i: int, j: int) -> None:
    """Turn the columns i and j of T in place."""
    x, y = T[:, :, i].copy(), T[:, :, j].copy()
    T[:, :, i], T[:, :, j] = x * c + y * s, y * c - x * s


def forward(p: Complex, q: Complex) -> tuple[Complex, Complex, Complex]:
    """Return poses (k, 3, 4), axes and points (k, 6, 3) of complex rows p (k, 18) and joint vectors q (k, 6)."""
    k = len(q)
    T = np.zeros((k, 3, 4), complex)
    T[:, [0, 1, 2], [0, 1, 2]] = 1
    axes, points = np.empty((k, 6, 3), complex), np.empty((k, 6, 3), complex)
    c, s = np.cos(q), np.sin(q)
    ca, sa = np.cos(p[:, 12:]), np.sin(p[:, 12:])
    for i in range(6):
        axes[:, i], points[:, i] = T[:, :, 2], T[:, :, 3]
        _turn(T, c[:, i : i + 1], s[:, i : i + 1], 0, 1)
        T[:, :, 3] += T[:, :, 2] * p[:, i : i + 1] + T[:, :, 0] * p[:, 6 + i : 7 + i]
        _turn(T, ca[:, i : i + 1], sa[:, i : i + 1], 1, 2)
    return T, axes, points


def newton(p: Complex, goal: Complex, x: Complex) -> tuple[Complex, Array]:
    """Return the Newton step (k, 6) at x and what is left of the equations (k,)."""
    T, z, o = forward(p, x)
    move = np.cross(z, T[:, None, :, 3] - o)
    J = np.swapaxes(np.concatenate([move, z], 2), 1, 2)
    e = np.empty((len(x), 6), complex)
    e[:, :3] = goal[:, :, 3] - T[:, :, 3]
    e[:, 3:] = 0.5 * np.cross(T[:, :, :3], goal[:, :, :3], axisa=1, axisb=1, axisc=1).sum(2)
    left = np.abs(T - goal).max((1, 2)) / (1 + np.abs(goal).max((1, 2)))
    # a path on its way to infinity overflows: its step becomes nan, and is refused
    lost = ~(np.isfinite(J).all((1, 2)) & np.isfinite(e).all(1))
    J[lost], e[lost] = np.eye(6), np.nan
    try:
        step = np.linalg.solve(J, e[..., None])
    except np.linalg.LinAlgError:
        step = np.linalg.solve(J + 1e-14 * np.eye(6), e[..., None])
    return step[..., 0].astype(complex, copy=False), left


@dataclass(frozen=True)
class Paths:
    """Where the paths that are still on their way stand, and their last two points before that.

    Attributes:
        alive: (k,) which paths they are.
        t: (k,) how far each came; x (k, 6) the solution there.
        dt: (k,) the next step.
        ta: (k,) where each was two steps ago; xa (k, 6) the solution there; tb, xb one step ago.
    """

    alive: Indices
    t: Array
    x: Complex
    dt: Array
    ta: Array
    xa: Complex
    tb: Array
    xb: Complex

    def foretold(self, now: Array) -> Complex:
        """Return the parabola through the last three points, at `now` (k,)."""
        t, ta, tb = self.t, self.ta, self.tb
        la = (now - tb) * (now - t) / ((ta - tb) * (ta - t))
        lb = (now - ta) * (now - t) / ((tb - ta) * (tb - t))
        lc = (now - ta) * (now - tb) / ((t - ta) * (t - tb))
        return la[:, None] * self.xa + lb[:, None] * self.xb + lc[:, None] * self.x

    def stepped(self, line: Line, which: Indices, careful: float) -> Paths:
        """Try one step of each; three Newton steps must contract, else the path stays and its next step is shorter."""
        now = np.minimum(self.t + self.dt, 1.0)
        p, goal = line.at(now, which[self.alive])
        guess = self.foretold(now)
        d, _ = newton(p, goal, guess)
        first: Array = np.abs(d).max(1)
        guess = guess + d
        d, _ = newton(p, goal, guess)
        guess = guess + d
        d, left = newton(p, goal, guess)
        guess = guess + d
        size = np.abs(d).max(1)
        good = np.isfinite(size) & (first < 0.05 * careful) & (size < 1e-8 + 1e-3 * first) & (left < 1e-4)
        row = good[:, None]
        return Paths(
            self.alive,
            t=np.where(good, now, self.t),
            x=np.where(row, guess, self.x),
            dt=np.where(good, np.where(first < 0.01 * careful, 1.7 * self.dt, self.dt), 0.35 * self.dt),
            ta=np.where(good, self.tb, self.ta),
            xa=np.where(row, self.xb, self.xa),
            tb=np.where(good, self.t, self.tb),
            xb=np.where(row, self.x, self.xb),
        )

    def only(self, keep: Bools) -> Paths:
        """Return those of them that are kept, (k,)."""
        return Paths(*(getattr(self, entry.name)[keep] for entry in fields(self)))


def follow(line: Line, x: Complex, which: Indices, careful: float = 1.0, steps: int = 4000) -> tuple[Complex, Array]:
    """Follow solutions x (k, 6) of the poses `which` (k,) along a line; return the ends and how far each came (k,)."""
    k = len(x)
    end, reached = x.copy(), np.zeros(k)
    t = np.zeros(k)
    paths = Paths(np.arange(k), t, x, np.full(k, 0.01 * careful), t - 2e-9, x, t - 1e-9, x)
    with np.errstate(all="ignore"):
        for _ in range(steps):
            if not len(paths.alive):
                break
            paths = paths.stepped(line, which, careful)
            gone = (paths.dt < 1e-12) | (np.abs(paths.x.imag).max(1) > FAR)
            stop = (paths.t >= 1.0) | gone
            if stop.any():
                end[paths.alive[stop]], reached[paths.alive[stop]] = paths.x[stop], paths.t[stop]
                paths = paths.only(~stop)
    if len(paths.alive):
        end[paths.alive], reached[paths.alive] = paths.x, paths.t
    return end, reached


def apart(a: Complex, b: Complex) -> Array:
    """Return the largest difference of complex joint vectors (..., 6), around the circle."""
    d = a - b
    return np.abs((d.real + np.pi) % (2 * np.pi) - np.pi + 1j * d.imag).max(-1)


@dataclass(frozen=True)
class Start:
    """A generic complex arm, a joint vector of its pose, and all sixteen solutions (16, 6) there."""

    p: Complex
    q: Complex
    roots: Complex


def start(seed: int = 3) -> Start:
    """Find all solutions of a random complex arm by carrying known ones around random loops until sixteen are there."""
    rng = np.random.default_rng(seed)

    def some(*shape: int) -> Complex:
        return rng.uniform(-1, 1, shape) + 1j * rng.uniform(-1, 1, shape)

    p, q = some(18), some(6)
    roots = q[None]
    for _ in range(60):
        corners = [(p, np.zeros(6)), (some(18), some(6)), (some(18), some(6)), (p, np.zeros(6))]
        x, ok = roots, np.ones(len(roots), bool)
        for (pa, ua), (pb, ub) in zip(corners, corners[1:], strict=False):
            line = Line(np.array([pa, pb]), np.stack([q[None], q[None]]), np.array([ua, ub]))
            x, reached = follow(line, x, np.zeros(len(x), int))
            ok &= reached == 1
        for end in x[ok]:
            if (apart(roots, end) > 1e-6).all():
                roots = np.vstack([roots, end])
        if len(roots) >= GENERIC:
            return Start(p, q, roots)
    raise RuntimeError(f"only {len(roots)} of {GENERIC} solutions of the generic arm were found")


def kept() -> tuple[Start, ...]:
    """Return the generic arms and their sixteen solutions from generic_starts.json, which `start` found."""
    out = []
    for one in json.loads(Path(__file__).with_name("generic_starts.json").read_text()):
        p, q, roots = (np.array(one[key])[..., 0] + 1j * np.array(one[key])[..., 1] for key in ("p", "q", "roots"))
        out.append(Start(p, q, roots))
    return tuple(out)


def standard_rows(arm: Any, m: Machine) -> tuple[Array, Array]:
    """Return d, a, alpha (18,) by the arm's size and theta (6,) as standard rows; base and tool are left out."""
    d = arm.description
    if d.convention == "standard":
        links = [(r.a, r.alpha) for r in d.rows]
    else:
        links = [(r.a, r.alpha) for r in d.rows[1:]] + [(0.0, 0.0)]
    a, alpha = np.array(links).T
    return np.concatenate([np.array([r.d for r in d.rows]) / m.unit, a / m.unit, alpha]), np.array(
        [r.theta for r in d.rows]
    )


def all_solutions(arm: Any, m: Machine, q: Array, begin: tuple[Start, ...]) -> tuple[Complex, Bools, Bools]:
    """Find the complex solutions of the poses of real joint vectors q (N, 6).

    Paths that stop halfway, where one passes close to infinity, and pairs of paths that end in one solution, because
    one has jumped, are followed again from the next generic arm, with smaller steps.

    Returns:
        x: (N, 16, 6) complex joint vectors (of the arm, rad).
        arrived: (N, 16) bool; False where the path left for infinity or met a singular solution at its end.
        doubtful: (N,) bool, poses with a path that stopped halfway in all attempts.
    """
    if m.slides.any() or m.n != 6:
        raise ValueError("six revolute joints only")
    rows, theta = standard_rows(arm, m)
    v = (m.inner(q) + theta).astype(complex)
    x, arrived = np.zeros((len(q), GENERIC, 6), complex), np.zeros((len(q), GENERIC), bool)
    todo = np.arange(len(q))
    for one, careful in zip(begin, (1.0, 0.4, 0.1), strict=False):
        if not len(todo):
            break
        ends, reached = _from_one(one, rows, v[todo], careful)
        x[todo], arrived[todo] = ends, reached == 1
        halfway = (reached < HALFWAY).any(1)
        todo = todo[halfway | collided(ends, reached == 1)]
    doubtful = np.isin(np.arange(len(q)), todo)
    return (m.sign * (x - theta - m.offset)).astype(complex), arrived, doubtful


def _from_one(one: Start, rows: Array, v: Complex, careful: float) -> tuple[Complex, Array]:
    """Follow the roots of one generic arm to the poses of v (N, 6); return ends (N, 16, 6) and how far they came."""
    N = len(v)
    p, q = np.array([one.p, rows.astype(complex)]), np.stack([np.broadcast_to(one.q, (N, 6)), v])
    line, which = Line(p, q, np.zeros((2, 6), complex)), np.repeat(np.arange(N), GENERIC)
    x, reached = follow(line, np.tile(one.roots, (N, 1)), which, careful, steps=int(4000 / careful))
    p, goal = line.at(np.ones(len(x)), which)
    with np.errstate(all="ignore"):
        for _ in range(3):
            d, left = newton(p, goal, x)
            x = np.where(((reached == 1) & (np.abs(d).max(1) < 0.1))[:, None], x + d, x)
        left = newton(p, goal, x)[1]
    # an end that does not close is as good as one at infinity
    reached = np.where((reached == 1) & ~(left < 1e-10), 1 - 1e-9, reached)
    return x.reshape(N, GENERIC, 6), reached.reshape(N, GENERIC)


def collided(x: Complex, arrived: Bools) -> Bools:
    """Return for each pose (N,) whether two of its paths arrived at one solution."""
    gap = np.where(arrived[:, :, None] & arrived[:, None], apart(x[:, :, None], x[:, None]), np.inf)
    return np.any(gap + np.where(np.eye(x.shape[1], dtype=bool), np.inf, 0.0) < 1e-7, (1, 2))
