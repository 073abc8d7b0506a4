"""Tracing self-motions: along the null direction of the Jacobian and back onto the pose, until the curve closes."""

from __future__ import annotations

import numpy as np

from pieper import _kernel
from pieper.kinematics.arrays import Array
from pieper.kinematics.chain import Chain
from pieper.kinematics.golden_section import least_at
from pieper.kinematics.newton import missed, newton, newton_on_planes, null_space, singular_values
from pieper.solver.singular.along_folds import along_folds, ways_gone
from pieper.solver.singular.beside_curve import one_free
from pieper.solver.singular.self_motion import SelfMotion
from pieper.solver.singular.traced_motion import TracedMotion
from pieper.tolerances import (
    CROSSING_CHANGE,
    CROSSING_FOUND,
    CURVE_STEP,
    HOLDS,
    ON_CURVE,
    OPEN_WAYS,
    TINY,
)

#: The most steps a trace may take, and the cosine by which a step may depart from the tangent it sets out along.
MOST_STEPS, STRAIGHT = 1500, 0.95
#: Steps of the golden section that places a crossing between two samples.
HALVINGS = 30


def steps_along(chain: Chain, q: Array, T: Array, directions: Array, probe: float = 0.05) -> list[Array | None]:
    """Return a point on the pose about `probe` (rad or lengths) from q along each of directions (k, n), or None."""
    unit, k = chain.joints.unit, len(directions)
    ahead = np.concatenate([q + probe * directions * unit, q - probe * directions * unit])
    points, held = newton_on_planes(chain, ahead, T, np.concatenate([directions, directions]), holds=ON_CURVE)
    held &= np.linalg.norm((points - q) / unit, axis=1) > 0.5 * probe
    return [points[i] if held[i] else points[k + i] if held[k + i] else None for i in range(k)]


def trace(
    chain: Chain,
    q: Array,
    T: Array,
    limits: Array,
    names: tuple[str, ...],
    direction: Array | None = None,
    *,
    shown: int | None = None,
    most_steps: int = MOST_STEPS,
) -> SelfMotion:
    """Trace the self-motion curve through q both ways until it closes or ends.

    Args:
        chain: The arm.
        q: (n,) a joint vector on the pose.
        T: (4, 4) the pose.
        limits: (n, 2).
        names: Joint names.
        direction: (n,) the direction to set out in; the null vector of the Jacobian if None.
        shown: Number of joints that are the arm's own; all if None.
        most_steps: Steps each way at the most.

    Returns:
        The SelfMotion; bounded by `most_steps`.
    """
    set_out = null_space(chain, q)[1][-1] if direction is None else direction
    samples, closed = _both_ways(chain, q, T, set_out, most_steps)
    if not closed and direction is None and one_free(chain) and not chain.prismatic.any() and most_steps == MOST_STEPS:
        # where curves cross, the way to set out is known badly: begun where it is known best they close
        best = samples[int(np.argmax(second_smallest(chain, samples)))]
        again, closed = _both_ways(chain, best, T, null_space(chain, best)[1][-1], most_steps)
        samples = again if closed else samples
    elif not closed and direction is None:
        again, closed = along_folds(chain, q, T, most_steps)
        samples = again if closed or len(again) > len(samples) else samples
    arm_joints = chain.n if shown is None else shown
    return TracedMotion(chain, T, samples, closed, dimension_of(chain, T, samples), limits, names, arm_joints)


def _both_ways(chain: Chain, q: Array, T: Array, direction: Array, most_steps: int) -> tuple[Array, bool]:
    """Return the points (k, n) of the curve through q (n,), followed both ways where it does not close, and whether."""
    forward, closed = _walk(chain, q, T, direction, most_steps)
    if closed:
        return forward, True
    backward, _ = _walk(chain, q, T, -direction, most_steps)
    return np.concatenate([backward[:0:-1], forward]), False


def dimension_of(chain: Chain, T: Array, samples: Array) -> int:
    """Return how many degrees of freedom the self-motion has that a line of samples (k, n) lies on.

    Where the Jacobian has full rank it is the number of spare joints. Elsewhere the null directions are too many where
    some of them only lead nowhere to first order: counted are the independent ways that steps along them really go.
    """
    s, _ = null_space(chain, samples)
    ways = np.count_nonzero(s <= OPEN_WAYS * np.maximum(s[:, :1], TINY), axis=1)
    plainest = int(np.argmin(ways))
    least = int(ways[plainest])
    if least <= max(1, chain.n - 6):
        return max(1, least)
    # along the solutions a step stays; across them, where the pose is left to second order, it is taken back
    return max(1, len(ways_gone(chain, samples[plainest], T, least)))


def crossings(motion: SelfMotion) -> list[Array]:
    """Return points of a curve where a second self-motion direction opens: other curves cross there."""
    chain, samples = motion.chain, motion.samples
    second = second_smallest(chain, samples)
    found: list[Array] = []
    last = len(samples) - 1
    index = np.arange(len(samples))[:, None] + np.array([-2, -1, 1, 2])
    around = second[index % last if motion.closed else np.clip(index, 0, last)]
    # at a crossing the value falls to zero like |s - s0|: less than one and a half times what a step changes
    change = np.maximum(np.abs(around[:, 0] - around[:, 1]), np.abs(around[:, 3] - around[:, 2]))
    low_enough = (second <= around.min(1)) & (second <= 1.5 * change + CROSSING_CHANGE)
    for i in np.flatnonzero(low_enough):
        low, high = float(motion.u[max(i - 1, 0)]), float(motion.u[min(i + 1, last)])
        u = least_at(lambda u: float(second_smallest(chain, motion.point(u))), low, high, HALVINGS)
        point = motion.point(u)
        if second_smallest(chain, point) < CROSSING_FOUND:
            found.append(point)
    return found


def second_smallest(chain: Chain, q: Array) -> Array:
    """Return the size (...) of the second self-motion direction's singular value, relative to the largest."""
    s = singular_values(chain, q)
    # n joints have n singular values, of which those beyond the sixth are zero
    k = chain.n - 2
    return (s[..., k] if k < s.shape[-1] else np.zeros(s.shape[:-1])) / s[..., 0]


def _walk(chain: Chain, q: Array, T: Array, direction: Array, most_steps: int) -> tuple[Array, bool]:
    """Return the points (k, n) from q on along a direction, and whether the curve closed.

    Of axes that a linkage moves the curve is one of theirs, as far as the linkage holds its points.
    """
    values, along = q, direction
    if chain.coupling is not None:
        values, along = chain.coupling @ q, chain.coupling @ direction
        along = along / np.linalg.norm(along)
    points, closed = _kernel.follow_curve(
        chain.plain,
        q=values,
        T=T,
        direction=along,
        step=CURVE_STEP,
        straight=STRAIGHT,
        most_steps=most_steps,
    )
    if chain.coupling is None:
        return points, closed
    on = newton(chain, chain.numbers(points), T)
    held = missed(chain, on, T) < HOLDS
    kept = len(held) if held.all() else int(np.argmin(held))
    return on[:kept], closed and kept == len(held)
