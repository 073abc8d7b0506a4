"""The best continuous joint path along poses that leave something free; see docs/routes.md."""

from __future__ import annotations

import numpy as np

from pieper import arguments
from pieper.errors import InputError
from pieper.kinematics.arrays import Array, ArrayLike
from pieper.kinematics.forward import checked_joints
from pieper.kinematics.joints import inside
from pieper.kinematics.newton import newton
from pieper.kinematics.pose import PoseLike
from pieper.motion.path import checked_path
from pieper.motion.route.along_front import search_on_front
from pieper.motion.route.bound import least_motion
from pieper.motion.route.freedom import Freedom, Verdict
from pieper.motion.route.front import can_be_followed
from pieper.motion.route.grid import grid
from pieper.motion.route.keep import Keep
from pieper.motion.route.others import Others
from pieper.motion.route.refusal import refusal
from pieper.motion.route.result import Route
from pieper.motion.route.search import Found, Task, far_apart, search, search_between
from pieper.motion.route.setting import Setting, setting
from pieper.motion.route.swarm import search_by_swarm
from pieper.solver.plan.plan import Plan
from pieper.tolerances import POSTURE_ON_PATH, ROUTE_SAME_POSE, SAME_SOLUTION

MOTION, TIME = "motion", "time"


def route(
    plan: Plan,
    turned: Plan,
    curves: Plan,
    path: PoseLike,
    *,
    free: Freedom,
    start: ArrayLike | None = None,
    end: ArrayLike | None = None,
    cost: str = MOTION,
    turn_rate: float | None = None,
    keep: Keep | None = None,
) -> Route:
    """Find the cheapest continuous route along a path, or say what closes every way.

    Args:
        plan: How the arm is solved for its own task.
        turned: The same with the axis meant as the tool's z.
        curves: How for the task that is left: of "position+axis", its axis the tool's z, where the turn is free.
        path: (N, 4, 4) poses, m; between two of them lies the line of `pieper.line`.
        free: What of the tool's orientation does not matter.
        start: (n,) posture to begin with, on the first pose; any where left out.
        end: (n,) posture to end with.
        cost: "motion" or "time"; see `Route.cost`.
        turn_rate: Largest change of the turn, rad per metre that the tool's point travels.
        keep: What it must keep beside limits.

    Raises:
        InputError: What was given is impossible; the message says what, what is allowed, and the cure.
        PlanError: The arm's joints are coupled in parts of turns, or it cannot tilt its tool.
    """
    asked = _checked_points(checked_path(path), plan.chain.length)
    arguments.word(cost, "cost", (MOTION, TIME))
    s = np.linspace(0.0, 1.0, len(asked))
    world = setting(turned, curves, free, asked, s)
    step = _turn_step(world, turn_rate)
    ends = (_end(world, start, 0, "start"), _end(world, end, -1, "end"))
    kept = Keep() if keep is None else keep
    for posture, what in zip(ends, ("start", "end"), strict=True):
        if posture is not None and kept.anything:
            kept.check(world, posture[: plan.n], what)
    task = Task(world, cost == TIME, ends, step, kept)
    found = search_by_swarm(task) if world.thin else None
    found = search(task) if found is None else found
    if far_apart(world) and not world.thin:
        # sooner looked between them than refused, or held to what rows at them alone lead to
        between = search_between(task, 1)
        found = between if found is None or (between is not None and between.cost < found.cost) else found
    bound = least_motion(world, cost == TIME)
    if found is None:
        verdict, blocked, reason = refusal(task, thorough=False)
        if verdict is Verdict.UNCERTAIN and can_be_followed(world):
            found = search_on_front(task)
            if found is None:
                verdict, blocked, reason = refusal(task, thorough=True)
        if verdict is Verdict.UNCERTAIN and found is None and world.tilts and not world.thin:
            found = search_by_swarm(task)
        if verdict is Verdict.UNCERTAIN and found is None:
            found = search_between(task)
        if found is not None:
            return _found(task, asked, plan, free, found)
        none = np.zeros(0)
        return Route(
            asked, s, np.zeros((0, plan.n)), none, none, verdict, blocked, np.inf, bound, 0.0, reason, free, plan, world
        )
    return _found(task, asked, plan, free, found)


def _found(task: Task, asked: Array, plan: Plan, free: Freedom, found: Found) -> Route:
    world = task.setting
    bound = least_motion(world, task.largest)
    reason = (
        f"Found: {len(asked)} points, every joint inside its limits, and no jump between points however often a "
        "stretch that is not plainly straight is halved."
    )
    return Route(
        asked,
        world.s,
        found.x[:, : plan.n],
        world.turn_of(found.x),
        world.tilt_of(found.x),
        Verdict.FOUND,
        None,
        found.cost,
        min(bound, found.cost),
        found.slope,
        reason,
        free,
        plan,
        world,
        Others(task, found.grid, found.rungs, found.x),
    )


def _checked_points(poses: Array, length: float) -> Array:
    if len(poses) < 2:
        raise InputError(
            "a route needs at least two points, where it begins and where it ends; this path has one.", given=len(poses)
        )
    move = np.linalg.norm(np.diff(poses[:, :3, 3], axis=0), axis=1) / length
    turn = np.abs(np.diff(poses[:, :3, :3], axis=0)).max((1, 2))
    same = np.flatnonzero((move < ROUTE_SAME_POSE) & (turn < ROUTE_SAME_POSE))
    if len(same):
        k = int(same[0])
        raise InputError(
            f"points {k + 1} and {k + 2} of the path are the same pose, a segment of no length; leave one out.",
            index=k + 1,
        )
    return poses


def _turn_step(world: Setting, rate: float | None) -> Array | None:
    if rate is None:
        return None
    value = arguments.number(rate, "turn_rate", "rad/m (turn=(a, a) holds the turn)", above=0.0)
    if not world.turns:
        raise InputError("a turn_rate needs a turn that is free; say free=pieper.Freedom(...).", given=value)
    return value * np.linalg.norm(np.diff(world.path[:, :3, 3], axis=0), axis=1)


def _end(world: Setting, q: ArrayLike | None, at: int, what: str) -> Array | None:
    """Return all coordinates (m,) of a posture that the route is to begin or end with."""
    if q is None:
        return None
    plan = world.plan
    joints = checked_joints(q, plan.n, what, plan.prismatic)
    if joints.ndim != 1:
        raise InputError(f"{what} must be one joint vector ({plan.n},), got shape {joints.shape}.", given=joints.shape)
    outside = ~inside(joints, plan.limits)
    if outside.any():
        j = int(np.argmax(outside))
        scale, unit = (1e3, "mm") if plan.prismatic[j] else (180 / np.pi, "deg")
        low, high = plan.limits[j] * scale
        raise InputError(
            f"{what} has {plan.names[j]} at {joints[j] * scale:.6g} {unit}, outside its limits of {low:.6g} to "
            f"{high:.6g} {unit}.",
            joint=plan.names[j],
        )
    T = world.path[at]
    x = world.whole(joints, T)
    if world.turns:
        # where the axis is not free to tilt, what it is tilted by counts as missed below
        angle = -x[plan.n]
        low, high = world.limits[plan.n]
        turns = np.arange(-2, 3) * 2 * np.pi
        fits = x[plan.n] + turns
        good = fits[(fits >= low - POSTURE_ON_PATH) & (fits <= high + POSTURE_ON_PATH)]
        if not len(good):
            raise InputError(
                f"{what} has the tool turned by {np.degrees(angle):.4g} degrees, outside the turn's interval of "
                f"{np.degrees(-high):.6g} to {np.degrees(-low):.6g} degrees.",
                given=float(angle),
            )
        x[plan.n] = good[int(np.argmin(np.abs(good)))] if np.isfinite(low) else -angle
    elif world.m > plan.n:
        x = _nearest_row(world, x, at)
    there = newton(world.chain, x, T)
    if (
        np.abs((there - x) / world.chain.joints.unit).max() > POSTURE_ON_PATH
        or world.tilt_of(x) > world.free.cone + POSTURE_ON_PATH
    ):
        gap = plan.chain.native.fk(joints)[:3, 3] - T[:3, 3]
        which = "first" if at == 0 else "last"
        raise InputError(
            f"{what} is not on the path: its tool is {np.linalg.norm(gap) * 1e3:.4g} mm off the {which} pose, or "
            "turned in a way that is not free. Leave it out, or give a solution of that pose.",
            metres=float(np.linalg.norm(gap)),
        )
    there[: plan.n] = np.where(np.abs(there[: plan.n] - joints) < SAME_SOLUTION, there[: plan.n], joints)
    return there


def _nearest_row(world: Setting, x: Array, at: int) -> Array:
    """Return the row of a pose whose arm joints are nearest to those of x, the virtual joints as they come."""
    rows, valid = grid(world).rows(world.path[at][None])
    flat = rows[valid]
    if not len(flat):
        return x
    n = world.n
    gap = np.abs(world.chain.joints.first(n).difference(flat[:, :n], x[:n])).max(1)
    best = flat[int(np.argmin(gap))].copy()
    best[:n] = x[:n]
    return best
