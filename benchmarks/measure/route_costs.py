"""The cost of a route by another way: a ladder of 1,440 turns, made short by Newton's method on the turns alone."""

from __future__ import annotations

from typing import Any

import numpy as np

import pieper
from pieper import Arm
from pieper.kinematics.pose import rotation_z

#: Turns of the ladder, and by how many of them the tool may turn from point to point.
TURNS, NEAR = 1440, 24
#: The largest step of a joint from point to point, and how far it may swing with the turn from there, rad.
STEP, SWING = 0.6, 1.0
#: Places between two points where a chain is looked at.
BETWEEN = 10
#: How many times as many where a joint seems to jump.
NEARER = 8
#: How far a joint may be beyond its limits between points, and how far it may go on a tenth of the way (rad).
BEYOND, JUMP = 2e-3, 0.25


def ladder(arm: Arm, path: np.ndarray, most: float) -> tuple[np.ndarray, np.ndarray] | None:
    """Return the cheapest chain (N, n) over the grid and its turns (N,), whole turns of wide joints apart.

    What costs more than `most` is let go on the way.
    """
    N = len(path)
    low, high = arm.limits.T
    Rz = rotation_z(np.arange(TURNS) * 2 * np.pi / TURNS)
    wide = high - low >= 2 * np.pi - 1e-9
    rows, costs, came = [], [], []
    for i, T in enumerate(path):
        many = arm.ik_many(T @ Rz)
        q = np.where(many.in_limits[..., None], many.q, np.nan)
        keep = many.in_limits.any(0)
        q = q[:, keep]
        if not q.size:
            return None
        cost = np.where(np.isnan(q[..., 0]), np.inf, 0.0 if i == 0 else np.inf)
        origin = np.full((*cost.shape, 2), -1)
        if i:
            last, before = rows[-1], costs[-1]
            for d in np.flatnonzero(np.isfinite(before).any(0)).tolist():
                source = np.flatnonzero(np.isfinite(before[:, d]))
                # rows that are never near one without a turn are of other branches
                gap = q[source] - last[source, None, d]
                gap = np.where(wide, gap - 2 * np.pi * np.round(gap / (2 * np.pi)), gap)
                near = np.flatnonzero(np.nanmin(np.abs(gap).max(-1), axis=0, initial=np.inf) < STEP + SWING)
                for shift in range(-NEAR, NEAR + 1):
                    k = (source + shift) % TURNS
                    gap = q[k][:, near] - last[source, None, d]
                    gap = np.where(wide, gap - 2 * np.pi * np.round(gap / (2 * np.pi)), gap)
                    step = np.where(np.abs(gap).max(-1) > STEP, np.inf, (gap**2).sum(-1)) + before[source, None, d]
                    at, row = np.nonzero((step < cost[k][:, near]) & (step <= most))
                    cost[k[at], near[row]] = step[at, row]
                    origin[k[at], near[row]] = np.stack([source[at], np.full(len(at), d)], -1)
        rows.append(q)
        costs.append(cost)
        came.append(origin)
    if not np.isfinite(np.nanmin(costs[-1])):
        return None
    k, r = np.unravel_index(int(np.nanargmin(costs[-1])), costs[-1].shape)
    chain, turn = [], []
    for i in reversed(range(N)):
        chain.append(rows[i][k, r])
        turn.append(k * 2 * np.pi / TURNS)
        k, r = came[i][k, r]
    q, t = np.array(chain[::-1]), np.unwrap(np.array(turn[::-1]))
    steps = np.diff(q, axis=0)
    steps = np.where(wide, steps - 2 * np.pi * np.round(steps / (2 * np.pi)), steps)
    return q[0] + np.vstack([np.zeros(arm.n), np.cumsum(steps, axis=0)]), t


def shortened(arm: Arm, path: np.ndarray, q: np.ndarray, turn: np.ndarray) -> tuple[float, np.ndarray]:
    """Return the cost of a chain made short, and it: Gauss-Newton on the turns, steps cut so that limits are kept."""
    low, high = arm.limits.T
    wide = high - low >= 2 * np.pi - 1e-9
    low, high = np.where(wide, -np.inf, low), np.where(wide, np.inf, high)
    cost = float((np.diff(q, axis=0) ** 2).sum())
    for _ in range(60):
        axis = (path @ rotation_z(turn))[:, :3, 2]
        rate = np.zeros((len(q), 6))
        rate[:, 3:] = axis
        v = (np.linalg.pinv(arm.jacobian(q), rcond=1e-10) @ rate[..., None])[..., 0]
        # minimise the sum over steps of |q_i+1 + v_i+1 t_i+1 - q_i - v_i t_i|^2
        e = np.diff(q, axis=0)
        g = np.zeros(len(q))
        g[1:] += (v[1:] * e).sum(1)
        g[:-1] -= (v[:-1] * e).sum(1)
        H = np.diag((v**2).sum(1) * np.where(np.isin(np.arange(len(q)), (0, len(q) - 1)), 1.0, 2.0))
        off = -(v[1:] * v[:-1]).sum(1)
        H += np.diag(off, 1) + np.diag(off, -1)
        # what stands at a limit and is pushed out stays
        step = -np.linalg.lstsq(H + 1e-12 * np.eye(len(q)), g, rcond=None)[0]
        out = (((q + 1e-9 >= high) & (v * step[:, None] > 0)) | ((q - 1e-9 <= low) & (v * step[:, None] < 0))).any(1)
        if out.any():
            free = ~out
            step = np.zeros(len(q))
            step[free] = -np.linalg.lstsq(H[np.ix_(free, free)], g[free], rcond=None)[0]
        for part in 0.5 ** np.arange(12):
            trial = turn + part * step
            moved = _followed(arm, path @ rotation_z(trial), q + part * v * step[:, None])
            if moved is not None and (moved >= low - 1e-9).all() and (moved <= high + 1e-9).all():
                now = float((np.diff(moved, axis=0) ** 2).sum())
                if now < cost:
                    break
        else:
            return cost, q
        gained, q, turn, cost = cost - now, moved, trial, now
        if gained < 1e-10 * cost:
            return cost, q
    return cost, q


def fits(arm: Arm, q: np.ndarray) -> bool:
    """Whether a chain (N, n), continuous, fits the limits with some whole turns."""
    low, high = arm.limits.T
    turn = 2 * np.pi
    return bool((np.ceil((low - 1e-6 - q.min(0)) / turn) <= np.floor((high + 1e-6 - q.max(0)) / turn)).all())


def torn(arm: Arm, path: np.ndarray, q: np.ndarray, limits: np.ndarray) -> str:
    """Return where a chain (N, n) with the turn free does not go on between its points; nothing where it does.

    A joint that goes far from one point to the next passes JUMP on a tenth of the way as it is: what seems to jump is
    looked at nearer, by steps an eighth as long of which each may be a quarter as large.
    """
    for k in range(len(q) - 1):
        how = _torn(arm, path[k : k + 2], q[k : k + 2], limits, BETWEEN, JUMP)
        if how.startswith("jumps"):
            how = _torn(arm, path[k : k + 2], q[k : k + 2], limits, NEARER * BETWEEN, JUMP / 4)
        if how:
            return f"{how} between points {k + 1} and {k + 2}"
    return ""


def _torn(arm: Arm, path: np.ndarray, q: np.ndarray, limits: np.ndarray, places: int, jump: float) -> str:
    """Return how a chain of two points is torn, looked at at so many places between; nothing where it is not."""
    low, high = limits.T
    a, b = q
    before = a
    part = np.arange(1, places) / places
    for T, s in zip(pieper.line(path[0], path[1], places + 1)[1:-1], part, strict=True):
        # from the straight joint line, the turn as it comes: what is left free is free between points too
        now, on = _onto(arm, T, a + s * (b - a))
        beyond = (now < low) | (now > high)
        if on and beyond.any():
            # a joint that would leave its limits stands still at them: the turn gives way
            now, on = _onto(arm, T, np.clip(now, low, high), ~beyond)
        if not on:
            return "not continued"
        if ((now < low - BEYOND) | (now > high + BEYOND)).any():
            return "outside the limits"
        if np.abs(now - before).max() > jump:
            return "jumps"
        before = now
    return "jumps" if np.abs(b - before).max() > jump else ""


def ladder_cost(arm: Arm, path: np.ndarray, free: pieper.Freedom) -> dict[str, Any]:
    """Return the route's cost, the shortened ladder's (None where it leads nowhere), and whether that is a route.

    The ladder takes joints that can turn all the way round as if they had no limits, and steps from point to point
    from branch to branch: what costs less than the route and does not fit, or is torn between its points, says nothing.
    """
    route = arm.route(path, free=free)
    # a chain on the grid costs a little more than made short, never half as much again
    found = ladder(arm, path, 1.5 * route.cost)
    if found is None:
        return {"cost": route.cost, "ladder": None}
    cost, q = shortened(arm, path, *found)
    told = {"cost": route.cost, "ladder": cost, "fits": fits(arm, q)}
    if told["fits"]:
        told["torn"] = torn(arm, path, q, np.tile([-np.inf, np.inf], (arm.n, 1)))
    return told


def _followed(arm: Arm, T: np.ndarray, q: np.ndarray) -> np.ndarray | None:
    for _ in range(12):
        now = arm.fk(q)
        R = T[:, :3, :3] @ np.swapaxes(now[:, :3, :3], 1, 2)
        turn = np.stack([R[:, 2, 1] - R[:, 1, 2], R[:, 0, 2] - R[:, 2, 0], R[:, 1, 0] - R[:, 0, 1]], -1) / 2
        off = np.concatenate([T[:, :3, 3] - now[:, :3, 3], turn], 1)
        if np.abs(off).max() < 1e-11:
            return q
        q = q + (np.linalg.pinv(arm.jacobian(q), rcond=1e-10) @ off[..., None])[..., 0]
    return q if np.abs(off).max() < 1e-8 else None


def _onto(arm: Arm, T: np.ndarray, q: np.ndarray, moves: np.ndarray | None = None) -> tuple[np.ndarray, bool]:
    """Return the posture near q (n,) at which the tool has the place and z axis of T, and whether it was reached."""
    for _ in range(30):
        now = arm.fk(q)
        off = np.concatenate([T[:3, 3] - now[:3, 3], np.cross(now[:3, 2], T[:3, 2])])
        if np.abs(off).max() < 1e-9:
            return q, True
        J = arm.jacobian(q)
        z = now[:3, 2]
        J[3:] -= np.outer(z, z @ J[3:])
        J = J if moves is None else J * moves
        step = np.linalg.lstsq(J, off, rcond=1e-7)[0]
        q = q + step * min(1.0, 0.3 / max(np.abs(step).max(), 1e-300))
    return q, False
