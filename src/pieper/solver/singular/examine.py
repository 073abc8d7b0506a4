"""The careful look at one pose: isolated solutions, merged roots and self-motions told apart, none lost.

A pose on a singularity is approached from generic directions: every isolated solution is the limit of solutions of
nearby poses, and every self-motion curve is met by some of them. What is found is pulled back onto the pose, and each
point is asked whether the pose can be held while moving along the null direction of its Jacobian. Where it can almost,
the curve is followed all the same, and the solutions that hide on it are where what is missed changes sign.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import lru_cache

import numpy as np

from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.chain import Chain
from pieper.kinematics.newton import missed, newton, null_space, singular_values, size_of
from pieper.kinematics.pose import rotation_about
from pieper.solver.redundant.coaxial import joined
from pieper.solver.singular import four_parallel, near_curve
from pieper.solver.singular.at_limits import LINE_STEPS, at_limits, drawn_in, leads_away, met_inside, way_of_slides
from pieper.solver.singular.examined import Examined, told
from pieper.solver.singular.in_one_line import LineMotion
from pieper.solver.singular.line_of_slides import SlideLine
from pieper.solver.singular.meetings import meetings, put_in_line
from pieper.solver.singular.merged_roots import all_into_limits, distinct_roots, merged_root
from pieper.solver.singular.self_motion import SelfMotion
from pieper.solver.singular.trace import MOST_STEPS, crossings, dimension_of, second_smallest, steps_along, trace
from pieper.solver.singular.traced_motion import TracedMotion
from pieper.tolerances import (
    APART_SINGULAR,
    APPROACH_SIZES,
    CURVE_FAR,
    CURVE_RANK,
    DOUBLES_FROM_CURVE,
    ENDS_ON_CURVE,
    FLAT_REST,
    HOLDS,
    HOLDS_EXACTLY,
    ISOLATED_FROM_CURVE,
    LINE_OF_SLIDES,
    NEARLY_SINGULAR,
    ON_CURVE,
    ON_NEAR_POLYLINE,
    ON_POLYLINE,
    OPEN_DIRECTION,
    PRECISE_RANK,
    PROBE_REST,
    SAME_SOLUTION,
    SINGULAR_EXAMINED,
    SLOW_RANK,
    TINY,
)

#: How many side steps of each size a singular pose is approached from.
APPROACHES = 6
#: Directions tried where curves cross, and the most curves followed at one pose.
FAN, MOST_MOTIONS = 12, 24
#: Where a second direction stays open the solutions form a surface: lines followed on it.
MOST_LINES = 4
#: How far along the null direction a point is asked whether the pose can be held (rad; per length).
PROBE = 0.05
#: Newton steps at merged roots, where each only halves what is left.
SLOW_STEPS = 40


@dataclass(eq=False)
class _Curves:
    """What has been followed at the pose so far."""

    chain: Chain
    T: Array
    limits: Array
    names: tuple[str, ...]
    shown: int
    hiding: bool
    closed: list[SelfMotion] = field(default_factory=list[SelfMotion])
    open_ended: list[SelfMotion] = field(default_factory=list[SelfMotion])
    near: list[SelfMotion] = field(default_factory=list[SelfMotion])
    lines: int = 0

    def meet(self, q: Array, within: float) -> bool:
        return any(motion.distance(q) < within for motion in self.closed)

    def on_line(self, q: Array) -> bool:
        return any(isinstance(motion, LineMotion) and motion.distance(q) < ON_POLYLINE for motion in self.closed)


def examine(
    chain: Chain,
    T: Array,
    candidates: Array,
    solve: Callable[[Array], Array],
    limits: Array,
    names: tuple[str, ...],
    *,
    shown: int | None = None,
    hiding: bool = True,
    most: int | None = None,
) -> Examined:
    """Find every isolated solution and every self-motion of a pose.

    Args:
        chain: The arm, as many joints as task freedoms.
        T: (4, 4) the pose.
        candidates: (k, n) solutions already known.
        solve: Maps poses (N, 4, 4) to all candidate solutions of all of them, (m, n).
        limits: (n, 2).
        names: Joint names.
        shown: Number of joints that are the arm's own; all if None.
        hiding: Whether the kernel may have lost solutions next to a self-motion, so that they are looked for.
        most: How many solutions the pose can have, where that is known.
    """
    curves = _Curves(chain, T, limits, names, chain.n if shown is None else shown, hiding)
    aside = solve(side_steps(chain, T)).reshape(-1, chain.n)
    moving, stuck = four_parallel.linkages(chain, T, np.concatenate([candidates, aside]), limits, names, curves.shown)
    curves.closed += moving
    regular, singular = _split(chain, candidates)
    # kernels stop where Newton's method is slow: the last digits of a merged root are fetched here
    singular = newton(chain, singular, T, steps=SLOW_STEPS, cutoff=PRECISE_RANK)
    singular = four_parallel.elsewhere(chain, singular, T, moving, stuck)
    pulled = newton(chain, aside, T, steps=30, cutoff=SLOW_RANK)
    near_regular, near_singular = _split(chain, pulled[missed(chain, pulled, T) < HOLDS])
    flat = aside[:0]
    if hiding:
        found = near_curve.onto(chain, aside, T, 6)
        flat = found.q[(found.sigma < NEARLY_SINGULAR) & (np.abs(found.miss) < CURVE_FAR) & (found.rest < FLAT_REST)]
    # the kernel's own rows are points of the pose itself; side steps only lead to curves and to what it overlooked
    beside = four_parallel.elsewhere(chain, np.concatenate([near_singular, flat]), T, moving, stuck)
    starts = np.concatenate([singular, _distinct(chain, beside, APART_SINGULAR)])
    starts = np.array([drawn_in(chain, q, T) for q in starts]).reshape(-1, chain.n)
    doubles, hidden = _followed(curves, starts, len(singular))
    extra = np.array([*hidden, *near_singular]).reshape(-1, chain.n)
    extra = newton(chain, extra, T, steps=SLOW_STEPS, cutoff=PRECISE_RANK)
    extra = extra[missed(chain, extra, T) < HOLDS_EXACTLY * size_of(chain, T)]
    hidden_regular, hidden_singular = _split(chain, four_parallel.elsewhere(chain, extra, T, moving, stuck))
    isolated = _distinct(chain, np.concatenate([regular, near_regular, hidden_regular]), SAME_SOLUTION)
    isolated = [q for q in isolated if not curves.meet(q, ISOLATED_FROM_CURVE)]
    doubles = [q for q in doubles if not curves.meet(q, DOUBLES_FROM_CURVE)]
    # closed forms give every merged root themselves: what else nearly holds the pose there is the foot of a fold
    merged = list(_distinct(chain, hidden_singular, SAME_SOLUTION)) if hiding else []
    merged = [q for q in merged if not curves.meet(q, ON_POLYLINE)]
    if curves.lines:
        merged = [q for q in merged if second_smallest(chain, q) > SINGULAR_EXAMINED]
    placed = distinct_roots(chain, [merged_root(chain, q, T) for q in (*stuck, *doubles, *merged)], T)
    placed = [root for root in placed if not _any_near(chain, root[0], isolated)]
    if most is not None and len(placed) + len(isolated) > most:
        placed = _exact_ones(curves, placed, most - len(isolated))
    doubles = all_into_limits(chain, [q for q, _ in placed], T, limits)
    pairs = [count for _, count in placed]
    motions = met_inside([at_limits(motion) for motion in _without_surfaces_blur(curves.closed)])
    return told(chain, isolated, doubles, pairs, motions)


def _without_surfaces_blur(motions: list[SelfMotion]) -> list[SelfMotion]:
    """Return self-motions without curves that run on a surface told beside them.

    From a row that is known to half the digits a curve runs so far beside the surface that it seems to be one alone.
    """
    surfaces = [motion for motion in motions if motion.dimension > 1]
    return [m for m in motions if m.dimension > 1 or not any(joined(over, m.samples).all() for over in surfaces)]


def _exact_ones(curves: _Curves, placed: list[tuple[Array, int]], room: int) -> list[tuple[Array, int]]:
    """Return no more than `room` of singular solutions, where others on the curves that nearly hold the pose remain.

    A point of such a curve misses the pose by so little that it looks like a solution; more than the pose can have
    are none, and those that miss it by most are points near a better one.
    """
    doubles = np.array([q for q, _ in placed])
    worst_first = np.argsort(-missed(curves.chain, doubles, curves.T), kind="stable")
    kept = set(range(len(doubles)))
    for k in map(int, worst_first):
        if len(kept) <= room:
            break
        along = [near for near in curves.near if near.distance(doubles[k]) < ON_NEAR_POLYLINE]
        if any(near.distance(doubles[m]) < ON_NEAR_POLYLINE for near in along for m in kept - {k}):
            kept.remove(k)
    return [placed[k] for k in sorted(kept)]


def _followed(curves: _Curves, starts: Array, own: int) -> tuple[list[Array], list[Array]]:
    """Follow every curve through the starts (N, n), of which the first `own` are solutions for certain.

    Returns:
        Solutions on no self-motion, and starts for Newton where a solution hides on a curve that nearly holds the pose.
    """
    doubles: list[Array] = []
    hidden: list[Array] = []
    miss, several, blurred = _probed(curves, starts)
    for q in starts[several | blurred]:
        _lines_through(curves, q, alone=True)
    for index, q in enumerate(starts):
        on_curve = curves.lines >= MOST_LINES if several[index] else curves.meet(q, ENDS_ON_CURVE)
        if not on_curve and (several[index] or blurred[index] or miss[index] < 10 * ON_CURVE):
            on_curve = _grow(curves, q)
        if curves.hiding and not on_curve and miss[index] < CURVE_FAR:
            hidden += _hiding(curves, q)
        if not on_curve and index < own:
            doubles.append(q)
    known = [curves.lines > 0 or curves.meet(q, DOUBLES_FROM_CURVE) for q in doubles]
    doubles = [q for q, some in zip(doubles, known, strict=True) if some or not _lines_through(curves, q)]
    return doubles, hidden


def _probed(curves: _Curves, starts: Array) -> tuple[Array, Bools, Bools]:
    """Return how well the pose can be held a little way along each start's null direction (N,), all at once.

    And whether two directions vanish there (N,), and whether they nearly do (N,): a point may be so far off then that
    the pose is not held beside it where it is beside the true one.
    """
    chain = curves.chain
    if not len(starts):
        return np.zeros(0), np.zeros(0, bool), np.zeros(0, bool)
    s, Vt = null_space(chain, starts)
    unit, last = chain.joints.unit, min(chain.n, 6) - 1
    second = s[:, last - 1] / s[:, 0] if last else np.ones(len(starts))
    step = PROBE * Vt[:, last] * unit
    probes = np.concatenate([starts + step, starts - step])
    there = near_curve.onto(chain, probes, curves.T, 5)
    gone = np.linalg.norm((there.q - np.concatenate([starts, starts])) / unit, axis=1)
    held = (gone > 0.5 * PROBE) & (there.rest < np.maximum(PROBE_REST * np.abs(there.miss), HOLDS))
    miss = np.where(held, np.abs(there.miss), np.inf).reshape(2, -1).min(0)
    return miss, second <= SINGULAR_EXAMINED, second <= NEARLY_SINGULAR


def _hiding(curves: _Curves, q: Array) -> list[Array]:
    """Return starts for Newton at the solutions that hide on the curve through q that nearly holds the pose."""
    if len(curves.near) >= MOST_MOTIONS or any(near.distance(q) < ON_NEAR_POLYLINE for near in curves.near):
        return []
    curve = near_curve.follow(curves.chain, q, curves.T)
    curves.near.append(
        TracedMotion(curves.chain, curves.T, curve.q, curve.closed, 1, curves.limits, curves.names, curves.shown)
    )
    return list(near_curve.hiding(curves.chain, curves.T, curve))


def _grow(curves: _Curves, q: Array) -> bool:
    """Add every curve through q, and every curve that crosses those, to the self-motions; say whether q lies on one."""
    chain, T = curves.chain, curves.T
    found = curves.meet(q, ENDS_ON_CURVE)
    waiting = [q]
    while waiting and len(curves.closed) < MOST_MOTIONS:
        point = waiting.pop()
        for further in steps_along(chain, point, T, _directions(chain, point), PROBE):
            if further is None:
                continue
            if curves.on_line(further):
                found = True
                continue
            if second_smallest(chain, further) < OPEN_DIRECTION:
                # a surface has no list of curves: a few lines on it show the way, and `dimension` says the rest
                found = True
                if curves.lines < MOST_LINES:
                    curves.lines += 1
                    curves.closed.append(_line(curves, point, further))
                break
            if curves.meet(further, ON_POLYLINE):
                found = True
                continue
            if any(other.distance(further) < ON_POLYLINE for other in curves.open_ended):
                continue
            motion = _slides(curves, point, further) or _line(curves, point, further, MOST_STEPS)
            # only slides lead away without end: what does not close otherwise only came near a singular pose
            if not motion.closed and not isinstance(motion, SlideLine) and not leads_away(motion):
                curves.open_ended.append(motion)
                continue
            found = True
            curves.closed.append(motion)
            waiting += crossings(motion)
    return found


def _lines_through(curves: _Curves, q: Array, *, alone: bool = False) -> bool:
    """Add the lines of two joints that come to turn about one line at a row, and what crosses them; say whether one is.

    Where branches merge as well more than two directions are free to first order, and the line is a mixture of all.

    Args:
        curves: What is known so far.
        q: (n,) the row.
        alone: Whether only lines count that are no part of a surface.
    """
    chain, T, found = curves.chain, curves.T, False
    for at in meetings(chain):
        through = put_in_line(chain, at, q, T)
        if through is None:
            continue
        found = True
        if curves.meet(through, ISOLATED_FROM_CURVE):
            continue
        pair = at.between - 1, at.between + 1
        line = LineMotion(chain, T, curves.limits, curves.names, curves.shown, through, pair, at.sense)
        if alone and dimension_of(chain, T, line.samples) > 1:
            continue
        curves.closed.append(line)
        if second_smallest(chain, line.samples).max() < OPEN_DIRECTION:
            continue  # more is open all along it, and no place shows where another crosses
        for crossing in crossings(line):
            _grow(curves, crossing)
    return found


def _slides(curves: _Curves, point: Array, further: Array) -> SlideLine | None:
    """Return the line through two points that hold the pose where slides alone move between them."""
    chain, unit = curves.chain, curves.chain.joints.unit
    way, gone = way_of_slides(chain, point), (further - point) / unit
    if way is None or abs(gone @ way) < (1 - LINE_OF_SLIDES) * np.linalg.norm(gone):
        return None
    nearest = newton(chain, point - float(way @ (point / unit)) * way * unit, curves.T, steps=12, cutoff=CURVE_RANK)
    if missed(chain, nearest, curves.T) > ON_CURVE:
        return None
    return SlideLine(chain, curves.T, curves.limits, curves.names, curves.shown, nearest, way)


def _line(curves: _Curves, point: Array, further: Array, steps: int = LINE_STEPS) -> SelfMotion:
    """Return the curve through two points that hold the pose."""
    set_out = (further - point) / curves.chain.joints.unit
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


def _directions(chain: Chain, q: Array) -> Array:
    """Return directions (k, n) in which a pose might be held at q; where two vanish at once, a fan of mixtures too."""
    s, Vt = null_space(chain, q)
    # near a crossing the second direction is only nearly free, and the curve's own tangent may be it
    null = Vt[s <= max(NEARLY_SINGULAR * s[0], TINY)]
    if len(null) < 2:
        return null
    # a curve's own tangent at a crossing is found by Newton from the nearest of the fan
    angles = np.arange(FAN) * np.pi / FAN
    return np.concatenate([null, np.outer(np.cos(angles), null[0]) + np.outer(np.sin(angles), null[1])])


@lru_cache(maxsize=8)
def _generic_steps(sizes: tuple[float, ...]) -> tuple[Array, Array]:
    """Return turns (k, 3, 3) and ways (k, 3), lengths, of generic small steps, the same ones every time."""
    rng = np.random.default_rng(20)
    turns, ways = np.empty((len(sizes) * APPROACHES, 3, 3)), np.empty((len(sizes) * APPROACHES, 3))
    for k in range(len(ways)):
        twist = rng.standard_normal(6)
        twist *= sizes[k // APPROACHES] / np.linalg.norm(twist)
        angle = float(np.linalg.norm(twist[3:]))
        turns[k], ways[k] = rotation_about(twist[3:] / angle, angle), twist[:3]
    return turns, ways


def side_steps(chain: Chain, T: Array, sizes: tuple[float, ...] = APPROACH_SIZES) -> Array:
    """Return poses (..., k, 4, 4) at generic small side steps about T (..., 4, 4)."""
    turns, ways = _generic_steps(sizes)
    moved = np.repeat(T[..., None, :, :], len(ways), axis=-3)
    moved[..., :3, :3] = turns @ T[..., None, :3, :3]
    moved[..., :3, 3] += ways * chain.length
    return moved


def _split(chain: Chain, q: Array) -> tuple[Array, Array]:
    """Part joint vectors (k, n) into those with a well-conditioned Jacobian and those without."""
    q = np.asarray(q, float).reshape(-1, chain.n)
    if not len(q):
        return q, q
    s = singular_values(chain, q)
    smallest = s[:, -1] if chain.n <= 6 else np.zeros(len(s))
    poor = smallest <= SINGULAR_EXAMINED * s[:, 0]
    return q[~poor], q[poor]


def _distinct(chain: Chain, q: Array, tolerance: float) -> Array:
    """Return the rows of q (k, n) without those that repeat an earlier one."""
    q = np.asarray(q, float).reshape(-1, chain.n)
    return q[chain.joints.distinct(q, tolerance)]


def _any_near(chain: Chain, q: Array, rows: list[Array]) -> bool:
    return bool(len(rows) and (chain.joints.apart(np.array(rows), q) < SAME_SOLUTION).any())
