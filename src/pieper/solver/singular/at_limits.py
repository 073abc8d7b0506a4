"""A self-motion that was followed, exact at the limits that it meets; and lines of slides, which have no end."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.kinematics.chain import Chain
from pieper.kinematics.golden_section import least_at
from pieper.kinematics.joints import short_way
from pieper.kinematics.newton import missed, newton, null_space, scaled_jacobian
from pieper.solver.redundant.bounded_motion import BESIDE_CHORD, bounded_motion
from pieper.solver.redundant.box import box, descended, spread
from pieper.solver.singular.self_motion import SelfMotion
from pieper.solver.singular.trace import trace
from pieper.solver.singular.traced_motion import TracedMotion
from pieper.tolerances import CLOSES, CURVE_RANK, LINE_OF_SLIDES, NO_END, ON_CURVE

#: Halvings of a golden section that place where a joint turns back: its value is exact to rounding then.
HALVINGS = 30
#: Where a second direction stays open the solutions form a surface: how far lines on it are followed each way (two
#: joints that turn against one another come round in 75),
LINE_STEPS = 80
#: and from how many postures inside the limits a part of it is sought that none of them crosses.
INSIDE_STARTS = 64


def at_limits(motion: SelfMotion) -> SelfMotion:
    """Return a self-motion whose intervals inside the limits are exact: a single point that is left is one of them."""
    if not isinstance(motion, TracedMotion) or len(motion.samples) < 2:
        return motion
    ends = [np.zeros((0, motion.chain.n))]
    for joint in motion.free if motion.dimension == 1 else ():
        for limit in motion.limits[joint][np.isfinite(motion.limits[joint])]:
            ends += [motion.points_at_joint(joint, float(limit)), _touching(motion, joint, float(limit))]
    return bounded_motion(motion, np.concatenate(ends))


def met_inside(motions: list[SelfMotion]) -> list[SelfMotion]:
    """Return self-motions with the first surface shown by a line inside the limits, where no line followed leads there.

    A surface is shown by a few lines on it, and limits may leave a part that none of them crosses: descents inside the
    limits meet it.
    """
    first = next((i for i, motion in enumerate(motions) if motion.dimension > 1), None)
    if first is None or any(motion.inside for motion in motions):
        return motions
    like = motions[first]
    chain, T, limits = like.chain, like.T, like.limits
    low, high = box(chain, limits)
    starts = spread(chain, low, high, INSIDE_STARTS)
    q, off = descended(chain, starts, np.broadcast_to(T, (len(starts), 4, 4)), low, high)
    for point in q[off <= CLOSES]:
        line = trace(chain, point, T, limits, like.names, shown=like.shown, most_steps=LINE_STEPS)
        if line.dimension > 1 and (shown := at_limits(line)).inside:
            return [*motions[:first], shown, *motions[first + 1 :]]
    return motions


def _touching(motion: SelfMotion, joint: int, limit: float) -> Array:
    """Return the points (m, n) at which a joint turns back about a limit, which it may reach without passing it."""
    slides = bool(motion.chain.prismatic[joint])
    value, room = motion.samples[:, joint], BESIDE_CHORD * float(motion.chain.joints.unit[joint])
    off = value - limit if slides else short_way(value - limit)
    inner = np.arange(1, len(value) - 1)
    rise = np.sign(np.diff(value))
    turns = inner[(rise[:-1] != rise[1:]) & (np.abs(off[1:-1]) < room)]
    found: list[Array] = []
    for i in turns:
        side = 1.0 if rise[i - 1] > 0 else -1.0
        low, high = float(motion.u[i - 1]), float(motion.u[i + 1])
        u = least_at(lambda u, side=side: -side * float(motion.point(u)[joint]), low, high, HALVINGS)
        found.append(motion.point(u))
    return np.array(found).reshape(-1, motion.chain.n)


def leads_away(motion: SelfMotion) -> bool:
    """Whether slides of a self-motion that does not close go so far that it has no end."""
    ways = (motion.samples / motion.chain.joints.unit)[:, motion.chain.prismatic]
    return bool(np.ptp(ways, axis=0).max(initial=0.0) > NO_END)


def slides_freely(chain: Chain, q: Array) -> bool:
    """Whether only slides move along what is free at q (n,): the self-motion is a straight line then."""
    free = null_space(chain, q)[1][-1]
    return bool(chain.prismatic.any() and np.abs(free[~chain.prismatic]).max(initial=0.0) < LINE_OF_SLIDES)


def way_of_slides(chain: Chain, q: Array) -> Array | None:
    """Return the unit direction (n,), without units, in which slides make up for each other at q (n,); None if none."""
    way, slides = np.zeros(chain.n), np.flatnonzero(chain.prismatic)
    if not len(slides):
        return None
    _, s, Vt = np.linalg.svd(scaled_jacobian(chain, q)[:3, slides], full_matrices=True)
    if len(slides) <= len(s) and s[-1] > LINE_OF_SLIDES:
        return None
    way[slides] = Vt[-1]
    return way * np.sign(way[np.argmax(np.abs(way))])


def drawn_in(chain: Chain, q: Array, T: Array) -> Array:
    """Return a point (n,) that holds a pose, or where it lies on a line of slides the one with the shortest ways.

    Such a line has no end: solutions of poses beside lead to points of it a thousand lengths away, where nothing is
    exact.
    """
    if not slides_freely(chain, q):
        return q
    unit = chain.joints.unit
    free = np.where(chain.prismatic, null_space(chain, q)[1][-1], 0.0)
    near = newton(chain, q - float(free @ (q / unit)) * free * unit, T, steps=12, cutoff=CURVE_RANK)
    return near if missed(chain, near, T) < ON_CURVE and slides_freely(chain, near) else q
