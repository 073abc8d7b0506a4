"""The careful look at one pose: isolated solutions, merged roots and continuous families told apart, none lost.

A pose on a singularity is approached from generic directions: every isolated solution is the limit of solutions of
nearby poses, and every self-motion curve is met by some of them. What is found is pulled back onto the pose, and each
point is asked whether the pose can be held while moving along the null direction of its Jacobian. Where it can almost,
the curve is followed all the same, and the solutions that hide on it are where what is missed changes sign.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from pieper.kinematics.chain import Chain
from pieper.kinematics.newton import newton, pose_difference, scaled_jacobian
from pieper.kinematics.pose import rotation_about
from pieper.solver.results import TURN
from pieper.solver.singular import nearcurve
from pieper.solver.singular.merged_roots import merged, null_direction, told_apart
from pieper.solver.singular.selfmotion import MOST_STEPS, ON_CURVE, Family, crossings, moved, second_smallest, trace
from pieper.tolerances import SINGULAR_EXAMINED

#: Sizes of the side steps (per length; rad) from which a singular pose is approached, and how many each.
APPROACHES, APPROACH_SIZES = 6, (1e-4, 1e-7)
#: Rows of the kernel closer than this are one (rad; per length); a double root is known to about 1e-8.
SAME = 1e-7
#: A point this near a traced curve is on it; samples lie 0.12 apart, so the polyline cuts corners by about 2e-3.
ON_POLYLINE = 5e-3
#: The same for curves that nearly hold the pose, whose samples lie 0.2 apart and whose points are less exact.
ON_NEAR_POLYLINE = 3e-2
#: Directions tried where curves cross, and the most curves followed at one pose.
FAN, MOST_FAMILIES = 12, 24
#: Where a second direction stays open the solutions form a surface: lines followed on it, and how far each way.
MOST_LINES, LINE_STEPS, OPEN = 4, 60, 1e-7
#: How far along the null direction a point is asked whether the pose can be held (rad; per length).
PROBE = 0.05
#: Relative sigma_min below which a point may lie on a curve that nearly holds the pose.
NEARLY = 1e-3
#: Newton steps at merged roots, where each only halves what is left.
SLOW_STEPS = 40
#: A solution must hold the pose this well (per length; rad). At a double root this fixes q to its square root only.
HOLDS = 1e-11
#: A solution that the kernel did not give must hold it this well, so that poses just out of reach get none.
HOLDS_EXACTLY = 2e-15


@dataclass(frozen=True, eq=False)
class Examined:
    """All there is at one pose.

    Args:
        q: (m, n) isolated solutions and one representative a family.
        family: (m,) index of the family each row represents, or -1.
        multiplicity: (m,) branches that merge in the row.
        direction: (m, n) unit null direction of a row on a singularity, along which branches merge or the arm moves by
            itself; zeros for the others.
        families: The curves.
    """

    q: np.ndarray
    family: np.ndarray
    multiplicity: np.ndarray
    direction: np.ndarray
    families: tuple[Family, ...]


@dataclass(eq=False)
class _Curves:
    """What has been followed at the pose so far."""

    chain: Chain
    T: np.ndarray
    limits: np.ndarray
    names: tuple[str, ...]
    shown: int
    hiding: bool
    families: list[Family] = field(default_factory=list)
    open_ended: list[Family] = field(default_factory=list)
    near: list[Family] = field(default_factory=list)
    lines: int = 0

    def on_family(self, q: np.ndarray, within: float) -> bool:
        return any(f.distance(q) < within for f in self.families)


def examine(
    chain: Chain,
    T: np.ndarray,
    candidates: np.ndarray,
    solve: Callable[[np.ndarray], np.ndarray],
    limits: np.ndarray,
    names: tuple[str, ...],
    *,
    shown: int | None = None,
    hiding: bool = True,
) -> Examined:
    """Find every isolated solution and every family of a pose.

    Args:
        chain: The arm, as many joints as task freedoms.
        T: (4, 4) the pose.
        candidates: (k, n) solutions already known.
        solve: Maps poses (N, 4, 4) to all candidate solutions of all of them, (m, n).
        limits: (n, 2).
        names: Joint names.
        shown: Number of joints that are the arm's own; all if None.
        hiding: Whether the kernel may have lost solutions next to a self-motion, so that they are looked for.
    """
    curves = _Curves(chain, T, limits, names, chain.n if shown is None else shown, hiding)
    regular, singular = _split(chain, candidates)
    # kernels stop where Newton's method is slow: the last digits of a merged root are fetched here
    singular = newton(chain, singular, T, steps=SLOW_STEPS, cutoff=1e-13)
    aside = solve(side_steps(chain, T)).reshape(-1, chain.n)
    pulled = newton(chain, aside, T, steps=30, cutoff=1e-9)
    good = np.linalg.norm(pose_difference(chain, pulled, T), axis=-1) < HOLDS
    near_regular, near_singular = _split(chain, pulled[good])
    flat = aside[:0]
    if hiding:
        found = nearcurve.onto(chain, aside, T, 6)
        flat = found.q[(found.sigma < NEARLY) & (np.abs(found.miss) < nearcurve.FAR) & (found.rest < 1e-9)]
    # the kernel's own rows are points of the pose itself; side steps only lead to curves and to what it overlooked
    starts = np.concatenate([singular, _distinct(chain, np.concatenate([near_singular, flat]), 1e-3)])
    doubles, hidden = _followed(curves, starts, len(singular))
    extra = newton(chain, np.array([*hidden, *near_singular]).reshape(-1, chain.n), T, steps=SLOW_STEPS, cutoff=1e-13)
    extra = extra[np.linalg.norm(pose_difference(chain, extra, T), axis=-1) < HOLDS_EXACTLY * _size(chain, T)]
    hidden_regular, hidden_singular = _split(chain, extra)
    isolated = _distinct(chain, np.concatenate([regular, near_regular, hidden_regular]), SAME)
    isolated = [q for q in isolated if not curves.on_family(q, 1e-5)]
    doubles = [q for q in doubles if not curves.on_family(q, 1e-4)]
    # closed forms give every merged root themselves: what else nearly holds the pose there is the foot of a fold
    hidden_singular = _distinct(chain, hidden_singular, SAME) if hiding else []
    hidden_singular = [q for q in hidden_singular if not curves.on_family(q, ON_POLYLINE)]
    if curves.lines:
        hidden_singular = [q for q in hidden_singular if second_smallest(chain, q) > SINGULAR_EXAMINED]
    doubles = told_apart(chain, [*doubles, *hidden_singular], T)
    doubles = [d for d in doubles if not _any_near(chain, d, isolated)]
    return _told(curves, isolated, doubles)


def _told(curves: _Curves, isolated: list[np.ndarray], doubles: list[np.ndarray]) -> Examined:
    chain, families = curves.chain, curves.families
    rows = [*isolated, *doubles, *(f._representative for f in families)]
    family = [-1] * (len(isolated) + len(doubles)) + list(range(len(families)))
    pairs = [merged(chain, q, curves.T) for q in doubles]
    multiplicity = [1] * len(isolated) + pairs + [1] * len(families)
    null = [null_direction(chain, q) for q in rows[len(isolated) :]]
    direction = np.array([*np.zeros((len(isolated), chain.n)), *null]).reshape(-1, chain.n)
    q = np.array(rows).reshape(-1, chain.n)
    wrapped = np.where(chain.prismatic, q, -((np.pi - q) % TURN) + np.pi)
    order = np.lexsort(np.round(wrapped, 6).T[::-1]) if len(q) else np.zeros(0, int)
    return Examined(
        wrapped[order],
        np.array(family, int)[order],
        np.array(multiplicity, int)[order],
        direction[order],
        tuple(families),
    )


def _followed(curves: _Curves, starts: np.ndarray, own: int) -> tuple[list[np.ndarray], list[np.ndarray]]:
    """Follow every curve through the starts (N, n), of which the first `own` are solutions for certain.

    Returns:
        Solutions on no family, and starts for Newton where a solution hides on a curve that nearly holds the pose.
    """
    doubles: list[np.ndarray] = []
    hidden: list[np.ndarray] = []
    miss, several = _probed(curves, starts)
    for index, q in enumerate(starts):
        on_curve = curves.lines >= MOST_LINES if several[index] else curves.on_family(q, 2e-3)
        if not on_curve and (several[index] or miss[index] < 10 * ON_CURVE):
            on_curve = _grow(curves, q)
        if curves.hiding and not on_curve and miss[index] < nearcurve.FAR:
            hidden += _hiding(curves, q)
        if not on_curve and index < own:
            doubles.append(q)
    return doubles, hidden


def _probed(curves: _Curves, starts: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return how well the pose can be held a little way along each start's null direction (N,), all at once.

    And whether two directions vanish there (N,).
    """
    chain = curves.chain
    if not len(starts):
        return np.zeros(0), np.zeros(0, bool)
    _, s, Vt = np.linalg.svd(scaled_jacobian(chain, starts), full_matrices=False)
    several = s[:, -2] <= SINGULAR_EXAMINED * s[:, 0] if s.shape[1] > 1 else np.zeros(len(starts), bool)
    step = PROBE * Vt[:, -1] * _unit(chain)
    probes = np.concatenate([starts + step, starts - step])
    there = nearcurve.onto(chain, probes, curves.T, 5)
    gone = np.linalg.norm((there.q - np.concatenate([starts, starts])) / _unit(chain), axis=1)
    held = (gone > 0.5 * PROBE) & (there.rest < np.maximum(1e-2 * np.abs(there.miss), 1e-11))
    miss = np.where(held, np.abs(there.miss), np.inf).reshape(2, -1).min(0)
    return miss, several


def _hiding(curves: _Curves, q: np.ndarray) -> list[np.ndarray]:
    """Return starts for Newton at the solutions that hide on the curve through q that nearly holds the pose."""
    if len(curves.near) >= MOST_FAMILIES or any(f.distance(q) < ON_NEAR_POLYLINE for f in curves.near):
        return []
    curve = nearcurve.followed(curves.chain, q, curves.T)
    curves.near.append(
        Family(curves.chain, curves.T, curve.q, curve.closed, 1, curves.limits, curves.names, curves.shown)
    )
    return list(nearcurve.hiding(curves.chain, curves.T, curve))


def _grow(curves: _Curves, q: np.ndarray) -> bool:
    """Add every curve through q, and every curve that crosses those, to the families; say whether q lies on one."""
    chain, T = curves.chain, curves.T
    found = curves.on_family(q, 2e-3)
    waiting = [q]
    while waiting and len(curves.families) < MOST_FAMILIES:
        point = waiting.pop()
        for direction in _directions(chain, point):
            further = moved(chain, point, T, direction, PROBE)
            if further is None:
                continue
            if second_smallest(chain, further) < OPEN:
                # a surface has no list of curves: a few lines on it show the way, and `dimension` says the rest
                found = True
                if curves.lines < MOST_LINES:
                    curves.lines += 1
                    curves.families.append(_line(curves, point, further))
                break
            if curves.on_family(further, ON_POLYLINE):
                found = True
                continue
            if any(f.distance(further) < ON_POLYLINE for f in curves.open_ended):
                continue
            family = _line(curves, point, further, MOST_STEPS)
            # joint space without sliding joints has no ends: what does not close only came near a singular pose
            if not family.closed and not chain.prismatic.any():
                curves.open_ended.append(family)
                continue
            found = True
            curves.families.append(family)
            waiting += crossings(family)
    return found


def _line(curves: _Curves, point: np.ndarray, further: np.ndarray, steps: int = LINE_STEPS) -> Family:
    """Return the curve through two points that hold the pose."""
    set_out = (further - point) / _unit(curves.chain)
    set_out /= np.linalg.norm(set_out)
    return trace(
        curves.chain,
        point,
        curves.T,
        curves.limits,
        curves.names,
        set_out,
        shown=curves.shown,
        most_steps=steps,
    )


def _directions(chain: Chain, q: np.ndarray) -> list[np.ndarray]:
    """Return directions in which a pose might be held at q; where two vanish at once, a fan of their mixtures."""
    _, s, Vt = np.linalg.svd(scaled_jacobian(chain, q))
    s = np.concatenate([s, np.zeros(chain.n - len(s))])
    null = Vt[s <= max(SINGULAR_EXAMINED * s[0], 1e-300)]
    if len(null) < 2:
        return list(null)
    angles = np.arange(FAN) * np.pi / FAN
    fan = [np.cos(t) * null[0] + np.sin(t) * null[1] for t in angles]
    # a curve's own tangent at a crossing is found by Newton from the nearest of the fan
    return [*null, *fan]


def _unit(chain: Chain) -> np.ndarray:
    return np.where(chain.prismatic, chain.length, 1.0)


def _size(chain: Chain, T: np.ndarray) -> float:
    """Return how much larger than one the numbers are that forward kinematics rounds."""
    return 1.0 + float(np.linalg.norm(T[:3, 3])) / chain.length


def side_steps(chain: Chain, T: np.ndarray, sizes: tuple[float, ...] = APPROACH_SIZES) -> np.ndarray:
    """Poses at generic small side steps about T, the same ones every time."""
    rng = np.random.default_rng(20)
    poses = []
    for size in sizes:
        for _ in range(APPROACHES):
            twist = rng.standard_normal(6)
            twist *= size / np.linalg.norm(twist)
            moved = T.copy()
            angle = float(np.linalg.norm(twist[3:]))
            moved[:3, :3] = rotation_about(twist[3:] / angle, angle) @ T[:3, :3]
            moved[:3, 3] += twist[:3] * chain.length
            poses.append(moved)
    return np.array(poses)


def _split(chain: Chain, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Part joint vectors (k, n) into those with a well-conditioned Jacobian and those without."""
    q = np.asarray(q, float).reshape(-1, chain.n)
    if not len(q):
        return q, q
    s = np.linalg.svd(scaled_jacobian(chain, q), compute_uv=False)
    smallest = s[:, -1] if chain.n <= 6 else np.zeros(len(s))
    poor = smallest <= SINGULAR_EXAMINED * s[:, 0]
    return q[~poor], q[poor]


def _distinct(chain: Chain, q: np.ndarray, tolerance: float) -> np.ndarray:
    """Return the rows of q (k, n) without those that repeat an earlier one."""
    q = np.asarray(q, float).reshape(-1, chain.n)
    near = _apart(chain, q[:, None], q[None]) < tolerance
    keep: list[int] = []
    for i in range(len(q)):
        if not near[i, keep].any():
            keep.append(i)
    return q[keep]


def _any_near(chain: Chain, q: np.ndarray, rows: list[np.ndarray]) -> bool:
    return bool(len(rows) and (_apart(chain, np.array(rows), q) < SAME).any())


def _apart(chain: Chain, a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Return the largest joint difference (...), angles around the circle, prismatic joints per length."""
    gap = np.where(chain.prismatic, (a - b) / chain.length, (a - b + np.pi) % TURN - np.pi)
    return np.max(np.abs(gap), axis=-1)
