"""Redundant arms: every self-motion of a pose, over the whole range of the redundant coordinate."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.chain import Chain
from pieper.kinematics.joints import TURN
from pieper.kinematics.newton import at_least_as_strong, missed, newton
from pieper.solver.arm_rows import full_rows
from pieper.solver.kernel_rows import Solved
from pieper.solver.plan.plan import Plan
from pieper.solver.redundant import coaxial
from pieper.solver.redundant.approach import from_anywhere
from pieper.solver.redundant.bounded_motion import bounded_motion
from pieper.solver.redundant.stops import stops
from pieper.solver.redundant.surface import as_one
from pieper.solver.redundant.sweep import Sweep, beside, span, sweep
from pieper.solver.results import Solutions
from pieper.solver.singular.beside_curve import how_often_passed, on_followed, one_free
from pieper.solver.singular.meetings import all_put_in_line, meetings
from pieper.solver.singular.self_motion import SelfMotion
from pieper.solver.singular.trace import MOST_STEPS, dimension_of, trace
from pieper.solver.singular.traced_motion import TracedMotion
from pieper.tolerances import (
    CLOSES,
    CROSSED_BY,
    CURVE_STEP,
    HOLDS,
    PRECISE_RANK,
    SAME_VOUCHED,
    SEED_CROSSED,
    SEED_DOUBTFUL,
    SEED_IS_ON,
    SEED_ON_CURVE,
    SEED_ON_POLYLINE,
)

#: Starts from which the pose is approached freely, besides the sweep.
STARTS = 96
#: Draws of several redundant coordinates where the given values have no solution, and the most self-motions traced.
DRAWS, MOST_MOTIONS = 60, 24
#: Slides without limits make curves without end: how far these are followed; and the points of all curves together at
#: which tracing ends.
ENDLESS_STEPS, MOST_SAMPLES = 250, 12000
#: Lengths of the arm that slides of a seed may be drawn out at the most, where there are seeds with less.
ENDLESS_FAR = 20.0
#: Where several coordinates are redundant the solutions form a surface: lines followed on it, and how far.
MOST_LINES, LINE_STEPS = 8, 60
#: A self-motion that takes less than this part of the redundant coordinate's range is small.
SMALL = 0.05
#: How much less a line on a surface goes along each further way: no whole numbers, so that all joints turn.
SURFACE_WAY = 0.618
#: Newton steps at merged roots, where each only halves what is left.
SLOW_STEPS = 40
#: Samples of a curve that are all on another which holds it; by how much it may be longer, chords as they are.
COMPARED, LONGER = 40, 1.1
#: How often a curve is followed anew that went astray; at how many places it is asked how often it passes there.
BEGUN_ANEW, PASSED = 8, 12
#: Seeds whose distances to a curve are taken at once: it bounds the memory.
CHUNK = 256


def self_motions_of(
    plan: Plan, asked: Array, values: Array, one: Callable[[Plan, Array], Solutions], rows: Array
) -> tuple[SelfMotion, ...]:
    """Trace every self-motion of a pose of a redundant arm; of several joints to spare all that holds the pose is one.

    A sweep over the first redundant coordinate (the others stay) meets every curve that reaches over more than a
    slice's width. A curve that lies between two slices is small in that coordinate; it is met by free approach (see
    `from_anywhere`). Each point not on a traced curve starts a new one, and where a traced curve is small the pose is
    solved within its range too: what arms have by symmetry is often small there as well.

    Args:
        plan: A plan with redundancy.
        asked: (4, 4) the pose.
        values: (k,) the redundant coordinates asked for.
        one: Solves one pose of an arm that is left where joints are held.
        rows: (m, n) what is known to hold the pose, of the arm's own joints.
    """
    full = plan.exact.full
    spare = len(plan.redundancy)
    points = met(plan, asked, values)
    T, points = _as_it_can(full, asked, points) if plan.reduction.fill and len(points) else (asked, points)
    stopped = stops(plan, T[None], every_turn=True)
    ends = stopped.q[stopped.inside]
    seeds = np.concatenate([ends, points])
    if one_free(full):
        seeds = _regular_first(full, _onto(full, T, np.concatenate([seeds, rows]) if len(rows.T) == full.n else seeds))
    motions: list[SelfMotion] = []
    # of several joints to spare all is one surface, on which a line is as good as another
    through = coaxial.lines_through(full, T, seeds) if spare == 1 else []
    for point, way in (*coaxial.lines(plan, T, one), *through):
        if not any(_is_same(other, point, way) for other in motions):
            line = _once_round(plan, T, point, way)
            motions.append(_across(line, seeds) if line.dimension > 1 else line)
    lines = list(motions)
    if lines:
        # where solutions merge on a line, others are met beside it, as far as the root of what they miss the pose by
        seeds = newton(full, seeds, T, steps=SLOW_STEPS, cutoff=PRECISE_RANK)
        for at in meetings(full):
            # and much farther in joints that are nearly in line themselves: it is asked whether they belong on it
            seeds = all_put_in_line(full, at, seeds, T)[0]
        for motion in lines:
            seeds = seeds[~(on_curve(motion, seeds) | coaxial.joined(motion, seeds))]
    # a surface (of several spare joints, or of a singular pose) has no list of curves: one line through each solution
    # shows the way, and `dimension` says the rest
    endless = bool((full.prismatic & ~np.isfinite(plan.full_limits).all(1)).any())
    curve_steps = ENDLESS_STEPS if endless else MOST_STEPS
    seeds = _nearest_first(full, seeds, plan.full_limits) if full.prismatic.any() else seeds
    most, steps = (MOST_MOTIONS, curve_steps) if spare == 1 else (MOST_LINES, LINE_STEPS)
    traced = 0
    while len(seeds) and len(motions) < most and traced < MOST_SAMPLES:
        motion = trace(full, seeds[0], T, plan.full_limits, plan.full_names, shown=plan.n, most_steps=steps)
        seeds = seeds[1:]
        if _astray(motion, lines):
            motion = _begun_anew(motion, lines)
        if _is_known(motion, lines):
            traced += len(motion.samples)
            seeds = seeds[_away(lines, seeds) > SAME_VOUCHED]
            continue
        if motion.dimension == 1:
            motions = lines + [other for other in motions[len(lines) :] if not _covers(motion, other)]
        motions.append(motion)
        traced += len(motion.samples)
        if motion.dimension > 1:
            most, steps = MOST_LINES, LINE_STEPS
        if spare == 1:
            more = _within(plan, T, motion)
            for other in motions[:-1]:
                more = more[~on_curve(other, more)]
            seeds = np.concatenate([seeds, more])
        seeds = seeds[~(on_curve(motion, seeds) | coaxial.joined(motion, seeds))]
    bounded = tuple(bounded_motion(motion, ends) for motion in motions)
    # all of it is a surface where several joints are to spare, and at some poses of an arm with one
    return as_one(bounded) if spare > 1 or all(motion.dimension > 1 for motion in bounded) else bounded


def _is_same(line: SelfMotion, point: Array, way: Array) -> bool:
    """Whether the line through a point (n,) along a way (n,) is one that is known, or lies on a surface that is."""
    near = SEED_IS_ON if line.is_line else SEED_ON_POLYLINE
    both = np.array([point, point + way])
    return bool((line.distances(both) < near).all() or coaxial.joined(line, both)[0])


def _once_round(plan: Plan, T: Array, point: Array, way: Array) -> SelfMotion:
    """Return the line (n,) through a point along which two joints turn against one another, once round."""
    long = float(TURN * np.sqrt(2.0))
    gone = np.linspace(0.0, long, int(np.ceil(long / CURVE_STEP)) + 1)
    samples = np.asarray(point + np.multiply.outer(gone, way), np.float64)
    dimension = dimension_of(plan.exact.full, T, samples)
    return TracedMotion(plan.exact.full, T, samples, True, dimension, plan.full_limits, plan.full_names, plan.n)


def _across(line: SelfMotion, seeds: Array) -> SelfMotion:
    """Return a line on the same surface along which all joints turn that do there, inside the limits if a seed is."""
    chain = line.chain
    points, there = coaxial.within_plane(line, seeds)
    moved, inside = chain.joints.inside_limits(points[there], line.limits)
    start = moved[inside][0] if inside.any() else line.samples[0]
    plane = coaxial.plane(chain, start)
    if not len(plane):
        return line  # no two axes lie in one line: the surface is of another kind
    way = SURFACE_WAY ** np.arange(len(plane)) @ plane
    way /= np.linalg.norm(way)
    return trace(chain, start, line.T, line.limits, line.names, way, shown=line.shown, most_steps=LINE_STEPS)


def _onto(full: Chain, T: Array, seeds: Array) -> Array:
    """Return those seeds (m, n) that hold the pose to rounding, moved there: what nearly does lies off it."""
    on = newton(full, seeds, T, steps=SLOW_STEPS, cutoff=PRECISE_RANK)
    held = missed(full, on, T) < HOLDS
    return on[held] if held.any() else seeds


def _regular_first(full: Chain, seeds: Array) -> Array:
    """Return seeds (m, n), last those where curves nearly cross: which way one goes is known badly there."""
    return seeds[np.argsort(at_least_as_strong(full, seeds) < SEED_CROSSED, kind="stable")]


def _nearest_first(chain: Chain, seeds: Array, limits: Array) -> Array:
    """Return seeds (m, n) whose slides are drawn in the most first, without those that curves only pass far out.

    Of a curve without end slices of a turning joint meet ever farther points; told one by one as far as each is
    followed, they would be many curves and leave no room for others. Limits are no end of a curve.
    """
    ends = np.abs(limits[chain.prismatic])
    far = max(ENDLESS_FAR * chain.length, 2 * float(np.where(np.isfinite(ends), ends, 0.0).max()))
    out = np.abs(seeds[:, chain.prismatic]).max(1)
    near = out < far
    return seeds[np.argsort(out, kind="stable")[: int(near.sum()) or len(seeds)]]


def _as_it_can(full: Chain, T: Array, points: Array) -> tuple[Array, Array]:
    """Return the pose (4, 4) that a short arm takes where it is asked for T, and points (m, n) moved onto it.

    A pose written down with ten digits lies beside what such an arm can do: rows miss it by that, and no curve of
    them holds it as well as a curve is followed. What one row makes of it is held by a whole curve.
    """
    kept = newton(full, points, T[None].repeat(len(points), 0), steps=6)
    taken = np.asarray(full.native.fk(kept[np.argmin(missed(full, kept, T))][None])[0])
    return taken, newton(full, points, taken[None].repeat(len(points), 0), steps=6)


def _within(plan: Plan, T: Array, motion: SelfMotion) -> Array:
    """Return all solutions (m, n) at two values of the redundant coordinate that a small self-motion takes."""
    column = motion.samples[:, plan.reduction.locked[0]]
    low, high = column.min(), column.max()
    lower, upper = span(plan, plan.reduction.locked[0])
    if high - low > SMALL * (upper - lower):
        return np.zeros((0, plan.exact.full.n))
    within = low + np.array([0.38, 0.71]) * (high - low)
    return _holding(plan, T, full_rows(plan, np.tile(T, (2, 1, 1)), within[:, None], 1))


def met(plan: Plan, T: Array, values: Array) -> Array:
    """Return points (m, n) of the pose, the task's virtual joints included, on every self-motion."""
    swept = sweep(plan, T, 0, values)
    found = _holding(plan, T, swept)
    if not len(found) and len(values) > 1:
        low, high = np.array([span(plan, joint) for joint in plan.reduction.locked]).T
        drawn = np.random.default_rng(8).uniform(low, high, (DRAWS, len(values)))
        found = _holding(plan, T, full_rows(plan, np.tile(T, (DRAWS, 1, 1)), drawn, 1))
    hidden = beside(plan, T, 0, values, swept) if len(values) == 1 else found[:0]
    return np.concatenate([found, hidden, from_anywhere(plan, T[None], STARTS)[0]])


def _holding(plan: Plan, T: Array, found: Solved | Sweep) -> Array:
    """Return the valid rows (m, n) that hold the pose T (4, 4) well enough to set out from."""
    rows = found.q[found.valid]
    return rows[missed(plan.exact.full, rows, T) < CLOSES]


def _astray(motion: SelfMotion, lines: list[SelfMotion]) -> bool:
    """Whether a curve has turned into a line that it crosses, or goes round more than once."""
    if any(_covers(motion, line) for line in lines):
        return True
    steps = np.linalg.norm(np.diff(motion.samples, axis=0), axis=1)
    # only where curves cross are steps so short
    if not motion.is_line or not len(steps) or steps.min() > CROSSED_BY:
        return False
    places = np.linspace(0, len(steps) - 1, PASSED).astype(int)
    between = newton(motion.chain, (motion.samples[places] + motion.samples[places + 1]) / 2, motion.T)
    often = how_often_passed(motion.chain, motion.T, motion.samples, between, motion.closed, SEED_IS_ON)
    return bool(np.count_nonzero(often > 1) > len(places) / 3)


def _begun_anew(motion: SelfMotion, lines: list[SelfMotion]) -> SelfMotion:
    """Return a curve that went astray, followed anew from elsewhere on it.

    Where two curves run all but along each other to the place at which they cross, rounding decides which of the two is
    gone on: not so from wherever one comes.
    """
    off = motion.samples
    for line in lines:
        off = off[~on_curve(line, off)]
    limits, names, shown = motion.limits, motion.names, motion.shown
    for start in off[np.linspace(0, len(off) - 1, BEGUN_ANEW).astype(int)] if len(off) else off:
        again = trace(motion.chain, start, motion.T, limits, names, shown=shown)
        if again.closed and not _astray(again, lines):
            return again
    return motion


def _is_known(motion: SelfMotion, lines: list[SelfMotion]) -> bool:
    """Whether a curve that was followed runs along lines: beside a fold rounding hides which way it goes.

    All that turning joints hold a pose by closes: what does not is made of rounding, and farther off.
    """
    if not lines or not one_free(motion.chain) or motion.chain.prismatic.any():
        return False
    return bool(_away(lines, motion.samples).max() < (SAME_VOUCHED if motion.closed else SEED_DOUBTFUL))


def _away(lines: list[SelfMotion], q: Array) -> Array:
    """Return how far joint vectors (m, n) are from the nearest of lines (m,)."""
    return np.array([line.distances(q) for line in lines]).min(0)


def _covers(motion: SelfMotion, other: SelfMotion) -> bool:
    """Whether a curve holds another: one that was begun anew where the other had been left."""
    if other.dimension > 1 or not one_free(motion.chain) or _length(other) > LONGER * _length(motion):
        return False
    some = other.samples[np.linspace(0, len(other.samples) - 1, COMPARED).astype(int)]
    if not on_curve(motion, some[:2]).any():
        return False
    # where solutions all but merge along it a point here and there is known less well; a piece of its own is more
    off = ~on_curve(motion, some)
    return not np.any(off[1:] & off[:-1])


def _length(motion: SelfMotion) -> float:
    return float(np.linalg.norm(np.diff(motion.samples, axis=0), axis=1).sum())


def on_curve(motion: SelfMotion, seeds: Array) -> Bools:
    """Return which of the seeds (m, n) lie on a traced curve."""
    if motion.is_line:
        return on_followed(motion.chain, motion.T, motion.samples, seeds, motion.closed, SEED_IS_ON)
    parts = [motion.distances(seeds[i : i + CHUNK]) for i in range(0, len(seeds), CHUNK)]
    away = np.concatenate(parts) if parts else np.zeros(0)
    on = away < SEED_ON_POLYLINE
    for i in np.flatnonzero(~on & (away < SEED_DOUBTFUL)):
        on[i] = motion.contains(seeds[i][: motion.shown], SEED_ON_CURVE)
    return on
