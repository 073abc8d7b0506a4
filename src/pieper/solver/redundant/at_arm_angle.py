"""Seven-joint arms at a chosen arm angle: in closed form where shoulder and wrist are spherical, else by a sweep."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arm_angle import ArmAngle
from pieper.kinematics.arrays import Array, Bits, Bools, Indices
from pieper.kinematics.joints import short_way, wrapped
from pieper.kinematics.newton import missed, pose_difference, scaled_jacobian, settled
from pieper.kinematics.pose import rotation_about
from pieper.solver.kernel_rows import without_repeats
from pieper.solver.plan.plan import Plan
from pieper.solver.redundant.approach import from_anywhere
from pieper.solver.redundant.sweep import Sweep, sweep, unknown
from pieper.solver.rows import Flag, Rows
from pieper.tolerances import (
    ALL_BUT_ZERO,
    ARM_ANGLE_DAMPING,
    ARM_ANGLE_POLISH,
    ARM_ANGLE_TOUCHING,
    ARM_STRETCHED,
    CLOSES,
    TINY,
)

#: Newton steps onto pose and arm angle, and the longest of them, rad.
STEPS, LONGEST = 25, 0.3
#: Starts of the free approach beside the sweep; how much of the last change an ending branch may still change by.
FREE_STARTS, AT_ENDS = 64, 8.0
#: Poses that are solved together by a sweep each.
TOGETHER = 32


def rows_at_arm_angle(plan: Plan, angle: ArmAngle, T: Array, angles: Array) -> Rows:
    """Solve poses T (N, 4, 4) with the arm angle at angles (N,), rad.

    Returns:
        The rows, the arm angle's `max_solutions` a pose. Where the angle is undefined at a pose there are no rows, and
        the flags say so.
    """
    if angle.spherical and not plan.snapped:
        q, valid, undefined = _closed_form(angle, T, angles)
        flags = np.where(undefined, Flag.UNCERTAIN | Flag.NO_ARM_ANGLE, 0).astype(np.uint8)
    else:
        starts = range(0, max(len(T), 1), TOGETHER)
        parts = [by_sweep(plan, angle, T[i : i + TOGETHER], angles[i : i + TOGETHER]) for i in starts]
        q, valid = np.concatenate([part[0] for part in parts]), np.concatenate([part[1] for part in parts])
        flags = np.concatenate([part[2] for part in parts])
    q, inside = plan.chain.joints.inside_limits(np.where(valid[..., None], wrapped(q), 0.0), plan.limits)
    return Rows(q, valid, inside & valid, flags | np.uint8(Flag.AT_ARM_ANGLE))


def _closed_form(angle: ArmAngle, T: Array, angles: Array) -> tuple[Array, Bools, Bools]:
    """Return rows (N, 8, 7), valid (N, 8) and whether the arm angle is undefined (N,) at poses T.

    The distance S-W gives two elbows. For each, the line S-W and the elbow's direction across it say how joints 1 to 3
    are turned, and what is left of the tool's turn is joints 5 to 7: two ways each.
    """
    chain, u, o = angle.chain, angle.chain.axes, angle.chain.points
    line, (x, y, defined) = angle.line(T), angle.frame(T)
    wrist = (chain.home @ [*angle.wrist, 1.0])[:3]
    elbow = o[3] + angle.along * u[3] - angle.shoulder
    arm, fore = o[3] - angle.shoulder, wrist - o[3]
    flat = fore - (fore @ u[3]) * u[3]
    # |S-W|^2 = constant + a cos q4 + b sin q4
    a, b = 2 * arm @ flat, 2 * arm @ np.cross(u[3], flat)
    rest = arm @ arm + fore @ fore + 2 * (arm @ u[3]) * (fore @ u[3])
    q4, ok4 = _two(a, b, np.sum(line * line, -1) - rest)  # (N, 2)
    turn4 = rotation_about(u[3], q4)
    before = arm + turn4 @ fore  # S-W as the elbow makes it, joints 1 to 3 at zero
    across, size = _across(before, elbow)
    stretched = size <= ARM_STRETCHED * chain.length
    wanted = np.cos(angles)[:, None] * x + np.sin(angles)[:, None] * y
    to = np.broadcast_to(_frame(line, wanted)[:, None], (*q4.shape, 3, 3))
    R = to @ np.swapaxes(_frame(before, across), -1, -2)
    first, ok1 = _three_turns(u[0], u[1], u[2], R)  # (N, 2, 2, 3)
    left = np.swapaxes(R @ turn4, -1, -2) @ (T[:, :3, :3] @ chain.home[:3, :3].T)[:, None]
    last, ok5 = _three_turns(u[4], u[5], u[6], left)
    shape = (*q4.shape, 2, 2)
    q = np.empty((*shape, 7))
    q[..., :3], q[..., 3], q[..., 4:] = first[:, :, :, None], q4[..., None, None], last[:, :, None]
    good = (ok4 & ~stretched & defined[:, None])[..., None, None] & ok1[..., :, None] & ok5[..., None, :]
    q, good = q.reshape(-1, 8, 7), good.reshape(-1, 8)
    undefined = ~defined | (ok4 & stretched).any(1)
    q, good = _closing(angle, q, good, T, angles, x, y)
    return q, good, undefined


def _closing(
    angle: ArmAngle, q: Array, good: Bools, T: Array, angles: Array, x: Array, y: Array
) -> tuple[Array, Bools]:
    """Polish what does not close to rounding, and drop what does not close at all, and what repeats."""
    error = missed(angle.chain, q, T[:, None])
    pose, row = np.nonzero(good & (error > ARM_ANGLE_POLISH))
    if len(pose):
        q[pose, row], error[pose, row] = onto(angle, q[pose, row], T[pose], angles[pose], x[pose], y[pose])
    good = good & (error < CLOSES)
    return q, without_repeats(angle.chain, q, good)


def by_sweep(plan: Plan, angle: ArmAngle, T: Array, wanted: Array) -> tuple[Array, Bools, Bits]:
    """Solve poses T (N, 4, 4) at arm angles wanted (N,) by searching each branch over the redundant joint for them.

    Returns:
        q (N, M, 7), valid (N, M) and flag bits (N,).
    """
    chain = plan.chain
    x, y, defined = angle.frame(T)
    q = np.zeros((len(T), angle.max_solutions, 7))
    valid, flag = np.zeros(q.shape[:2], bool), np.zeros(len(T), np.uint8)
    flag[~defined] = Flag.UNCERTAIN | Flag.NO_ARM_ANGLE
    starts, of = [np.zeros((0, 7))], [np.zeros(0, int)]
    free = from_anywhere(plan, T, FREE_STARTS)
    for i in np.flatnonzero(defined):
        found, somewhere = _starts(plan, angle, T[i], wanted[i], x[i], y[i], free[i])
        # there are solutions, but on none of them is the elbow off the line
        flag[i] = 0 if somewhere or not len(found) else Flag.UNCERTAIN | Flag.NO_ARM_ANGLE
        starts.append(found if somewhere else found[:0])
        of.append(np.full(len(starts[-1]), i))
    of = np.concatenate(of)
    rows, error = onto(angle, np.concatenate(starts), T[of], wanted[of], x[of], y[of])
    good = (error < CLOSES) & angle.about(rows, x[of], y[of], defined[of])[1]
    for i in np.unique(of[good]):
        own = rows[good & (of == i)]
        own = own[without_repeats(chain, own[None], np.ones((1, len(own)), bool))[0]]
        own = wrapped(own)
        own = own[np.lexsort(np.round(own, 6).T[::-1])]
        flag[i] |= Flag.UNCERTAIN if len(own) > q.shape[1] else 0
        own = own[: q.shape[1]]
        q[i, : len(own)], valid[i, : len(own)] = own, True
    return q, valid, flag


def _starts(
    plan: Plan, angle: ArmAngle, T: Array, wanted: float, x: Array, y: Array, free: Array
) -> tuple[Array, bool]:
    """Return rows (m, 7) of one pose from which Newton's method is to set out, and whether any has an arm angle."""
    swept = sweep(plan, T, 0, plan.defaults)
    now, known = angle.about(swept.q, x, y, np.ones((), bool))
    off = np.where(known, short_way(now - wanted), 0.0)
    free = unknown(plan, swept, 0, free)
    has = angle.about(free, x, y, np.ones((), bool))[1]
    if not (swept.valid & known).any() and not has.any():
        return np.concatenate([swept.q[swept.valid], free]), False
    return np.concatenate([swept.q[swept.valid & known & _may_cross(swept, off)], free[has]]), True


def _may_cross(swept: Sweep, off: Array) -> Bools:
    """Return (V, M): rows from which the wanted angle may be reached before the next slice, either way.

    That is so where the angle passes the wanted one before the next slice; where it comes near and turns back, which
    it may do between slices; and at the end of a branch, which turns round within the part of a slice left there.
    """
    change = [np.full_like(off, np.nan), np.full_like(off, np.nan)]
    for side, here, there, links in ((0, off[:-1], off[1:], swept.after), (1, off[1:], off[:-1], swept.before)):
        beyond = np.take_along_axis(there, np.maximum(links, 0), 1)
        step = short_way(beyond - here)
        change[side][slice(None, -1) if side == 0 else slice(1, None)] = np.where(links >= 0, step, np.nan)
    ahead, before = change
    passes = off * (off + ahead) <= 0
    passes &= np.abs(ahead) < np.pi
    most = np.fmax(np.abs(ahead), np.abs(before))
    turns = (np.abs(off) <= most) & (ahead * off >= 0) & (before * off >= 0)
    ends = (np.isnan(ahead) | np.isnan(before)) & (np.isnan(most) | (np.abs(off) <= AT_ENDS * most))
    return passes | turns | ends


def onto(angle: ArmAngle, q: Array, T: Array, wanted: Array, x: Array, y: Array) -> tuple[Array, Array]:
    """Move joint vectors q (m, 7) onto poses T and arm angles (m,) by Newton steps; also return what is left (m,)."""
    chain = angle.chain

    def miss(at: Array, index: Indices) -> Array:
        now, known = angle.about(at, x[index], y[index], np.ones(len(at), bool))
        gap = np.where(known, short_way(wanted[index] - now), np.inf)
        return np.concatenate([pose_difference(chain, at, T[index]), gap[:, None]], -1)

    def slope(at: Array, index: Indices) -> Array:
        return np.concatenate([scaled_jacobian(chain, at), angle.gradient(at, x[index], y[index])[:, None]], 1)

    return settled(miss, slope, q, chain.joints.unit, steps=STEPS, longest=LONGEST, step=_square)


def _square(A: Array, e: Array) -> Array:
    # a millionth of a millionth keeps it solvable where pose and angle do not fix the joints
    return np.asarray(np.linalg.solve(A + ARM_ANGLE_DAMPING * np.eye(7), e[..., None])[..., 0], np.float64)


def _two(a: Array, b: Array, c: Array) -> tuple[Array, Bools]:
    """Return the two angles (..., 2) with a cos + b sin = c, and whether they are real (..., 2)."""
    size = np.hypot(a, b)
    real = np.abs(c) <= size * (1 + ARM_ANGLE_TOUCHING)
    half = np.arctan2(np.sqrt(np.maximum((size - c) * (size + c), 0.0)), c)
    middle = np.arctan2(b, a)
    return np.stack([middle + half, middle - half], -1), np.stack([real & (size > 0)] * 2, -1)


def _three_turns(u1: Array, u2: Array, u3: Array, R: Array) -> tuple[Array, Bools]:
    """Return the two ways (..., 2, 3) in which turns about three axes in turn make R, and whether real (..., 2).

    Where the outer axes line up, only the sum of their turns counts, and the first is zero.
    """
    # a spherical triangle: the sides between the axes are known, and the one between the outer axes as R puts them
    flat, end = u3 - (u3 @ u2) * u2, R @ u3
    side = np.arctan2(np.linalg.norm(np.cross(u1, end), axis=-1), end @ u1)
    first, second = (np.arctan2(np.linalg.norm(np.cross(u2, u)), u2 @ u) for u in (u1, u3))
    low = 2 * np.sin((side + first - second) / 2) * np.sin((side - first + second) / 2)
    high = 2 * np.sin((first + second + side) / 2) * np.sin((first + second - side) / 2)
    half = np.arctan2(np.sqrt(np.maximum(low * high, 0.0)), (high - low) / 2)
    middle = np.arctan2(u1 @ np.cross(u2, flat), u1 @ flat)
    q2 = np.stack([middle + half, middle - half], -1)
    real = np.stack([np.minimum(low, high) > -ARM_ANGLE_TOUCHING] * 2, -1)
    turned = rotation_about(u2, q2)
    third = turned @ u3
    q1 = _about(u1, third, end[..., None, :])
    left = np.swapaxes(rotation_about(u1, q1) @ turned, -1, -2) @ R[..., None, :, :]
    across = np.asarray(np.cross(u3, np.eye(3)[np.argmin(np.abs(u3))]), np.float64)
    q3 = _about(u3, np.broadcast_to(across, third.shape), left @ across)
    return np.stack([q1, q2, q3], -1), real


def _about(axis: Array, start: Array, end: Array) -> Array:
    """Return the angles (...) about an axis that bring start nearest to end (..., 3); zero where both lie along it."""
    # what is across the axis first: it may be small, and differences of products of the whole would lose it
    a, b = np.cross(axis, start), np.cross(axis, end)
    small = ALL_BUT_ZERO * np.linalg.norm(start, axis=-1)
    none = (np.linalg.norm(a, axis=-1) <= small) | (np.linalg.norm(b, axis=-1) <= small)
    return np.where(none, 0.0, np.arctan2(np.cross(a, b) @ axis, np.sum(a * b, -1)))


def _across(line: Array, v: Array) -> tuple[Array, Array]:
    """Return v's part across lines (..., 3) and its size."""
    part = v - (line @ v / np.maximum(np.sum(line * line, -1), TINY))[..., None] * line
    return part, np.linalg.norm(part, axis=-1)


def _frame(line: Array, across: Array) -> Array:
    """Return rotations (..., 3, 3) whose columns stand along lines, along what is across them, and along the normal."""
    first = line / np.maximum(np.linalg.norm(line, axis=-1, keepdims=True), TINY)
    second = across / np.maximum(np.linalg.norm(across, axis=-1, keepdims=True), TINY)
    return np.stack([first, second, np.asarray(np.cross(first, second), np.float64)], -1)
