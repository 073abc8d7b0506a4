"""A route made as short as it can be: Newton's method on all its points at once, held off the limits by a barrier.

At each point the coordinates move along what the pose leaves free and are pulled back onto the pose. The cost is a
chain of neighbouring points, so that a step solves a chain of small blocks. Limits are kept by a logarithmic barrier
that is continued as a parabola below a margin, so that a start outside them is allowed; the barrier is made weaker
stage by stage.

Source:
    Feller and Ebenbauer (2017), Relaxed logarithmic barrier function based model predictive control of linear systems.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from pieper import _kernel
from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.newton import scaled_jacobian
from pieper.motion.route.on_edge import along_edge, cone_bend, cone_slope, onto_edge
from pieper.motion.route.setting import Setting
from pieper.tolerances import (
    BARRIER_WEIGHTS,
    CLEAR_START,
    FREEDOM_PROBE,
    NO_LENGTH,
    ROUNDING,
    SLOPE_COUNTS,
    SMOOTH_BEND,
    SMOOTH_DAMPING,
    SMOOTH_FLAT,
    SMOOTH_MAY_RISE,
    SMOOTH_NO_GAIN,
    SMOOTH_ROUGH,
    SMOOTH_STALLED,
    SMOOTH_TINY_STEP,
    SMOOTH_UNDAMPED,
    TINY,
)

#: Below its weight over so many mean steps the barrier is a parabola, steep enough that no point rests outside.
STEEP = 8.0
#: Most Newton steps of a stage.
STEPS = 40
#: How often points are put on the edge of a cone, or let go.
EDGES = 12
#: Stages of the barrier where a route is made short roughly.
ROUGH = 4


@dataclass(frozen=True, eq=False)
class Shape:
    """What is made small, and what is kept.

    Attributes:
        setting: What is solved.
        T: (N, 4, 4) the poses.
        parts: (N - 1,) how many steps of the path each step is.
        power: 2 for the sum of squares, more where the largest joint difference counts.
        fixed: (N,) 1 where a point may move, else 0.
        turn_step: (N - 1,) largest change of the turn, rad; None for any.
        edge: (N,) which points rest on the edge of the cone; None for none.
    """

    setting: Setting
    T: Array
    parts: Array
    power: int
    fixed: Array
    turn_step: Array | None
    edge: Bools | None = None

    def on(self, x: Array) -> tuple[Array, Bools]:
        """Return points (N, m) moved onto the poses, and whether that was reached."""
        return self.setting.on(x, self.T) if self.edge is None else onto_edge(self.setting, x, self.T, self.edge)


@dataclass(frozen=True, eq=False)
class Smoothed:
    """A route at rest: its points (N, m), its cost, and the largest slope of the cost along what poses leave free."""

    x: Array
    cost: float
    slope: float


def smooth(shape: Shape, x: Array, rough: bool = False) -> Smoothed:
    """Return the route nearest by (N, m) that costs least inside the limits; a rough one keeps off them a little."""
    mean = max(_value(replace(shape, power=2), x, 0.0, 1.0), NO_LENGTH) / max(len(x) - 1, 1)
    scale = mean if shape.power == 2 else float(np.sqrt(mean))
    room = min((float((side * at).min(initial=np.inf)) for at, side in _margins(shape, x)), default=np.inf)
    clear = room > CLEAR_START and shape.turn_step is None and not shape.setting.tilts
    weights = BARRIER_WEIGHTS[-1:] if clear else BARRIER_WEIGHTS
    for part in weights[:ROUGH] if rough else weights:
        weight = part * scale
        x = _stage(shape, x, weight, weight / (STEEP * (np.sqrt(mean) if shape.power == 2 else 1.0)), rough)
    if rough:
        return Smoothed(x, _value(shape, x, 0.0, 1.0), np.inf)
    edge = _room(shape, x) <= SLOPE_COUNTS
    shape = replace(shape, fixed=shape.fixed * (_room(shape, x, cone=False) > SLOPE_COUNTS))
    if shape.setting.tilts:
        x, shape = _on_the_edge(shape, x, edge & (shape.fixed > 0))
    else:
        x = _without_barrier(shape, x)
    g, Z, _ = _along(shape, x, 0.0, 1.0)
    along = np.abs(np.einsum("kma,km->ka", Z, g)) * shape.fixed[:, None]
    return Smoothed(x, _value(shape, x, 0.0, 1.0), float(along.max(initial=0.0)))


def _without_barrier(shape: Shape, x: Array) -> Array:
    """Return a route at rest (N, m) without what the weakest barrier leaves of its slope, if that is inside as well.

    What has met a limit stays where it is: the points that may move are those of `shape.fixed`.
    """
    moved = _stage(shape, x, 0.0, 1.0, False)
    least = np.minimum(_room(shape, x), 0.0)
    inside = bool((_room(shape, moved) >= least).all())
    return moved if inside and _value(shape, moved, 0.0, 1.0) <= _value(shape, x, 0.0, 1.0) else x


def _on_the_edge(shape: Shape, x: Array, edge: Bools) -> tuple[Array, Shape]:
    """Return a route at rest (N, m) some of whose points lie on the edge of the cone, and the shape that says which.

    Points that would leave the cone rest on its edge from then on; those that its edge pulls outwards are let go.
    """
    best, now = x, replace(shape, edge=edge if edge.any() else None)
    for _ in range(EDGES):
        moved = _stage(now, _snapped(now, x), 0.0, 1.0, False)
        _, _, multiplier = _along(now, moved, 0.0, 1.0)
        inside = shape.setting.inside_cone(moved)
        left, pulled = (inside < -ROUNDING) & ~edge, edge & (multiplier > ROUNDING)
        if not left.any() and not pulled.any():
            least = np.minimum(_room(shape, x), 0.0) - ROUNDING
            better = _value(shape, moved, 0.0, 1.0) <= _value(shape, best, 0.0, 1.0) * (1 + ROUNDING)
            return (moved, now) if (_room(shape, moved) >= least).all() and better else (best, now)
        edge = (edge | left) & ~pulled
        x, now = moved, replace(shape, edge=edge if edge.any() else None)
    return best, now


def _snapped(shape: Shape, x: Array) -> Array:
    moved, on = shape.on(x)
    return moved if on.all() else x


def _room(shape: Shape, x: Array, cone: bool = True) -> Array:
    """Return by how much each point (N,) is off what bounds it: limits, the cone, and what the turn may change."""
    room: Array = np.min([(side * at).min(1, initial=np.inf) for at, side in _margins(shape, x)], axis=0)
    if shape.setting.tilts and cone:
        room = np.minimum(room, shape.setting.inside_cone(x))
    if shape.turn_step is not None:
        left = shape.turn_step - np.abs(np.diff(x[:, shape.setting.n]))
        room = np.minimum(room, np.minimum(np.append(left, np.inf), np.append(np.inf, left)))
    return room


def _stage(shape: Shape, x: Array, weight: float, margin: float, rough: bool) -> Array:
    damp, value = 0.0, _value(shape, x, weight, margin)
    for _ in range(STEPS):
        g, Z, edge = _along(shape, x, weight, margin)
        along = np.einsum("kma,km->ka", Z, g) * shape.fixed[:, None]
        if np.abs(along).max(initial=0.0) < SMOOTH_FLAT:
            break
        D, E = _bend(shape, x, Z, g, edge, weight, margin)
        done, tried, new, length = False, x, value, 0.0
        for _ in range(12):
            size = np.abs(np.einsum("kaa->ka", D)).mean()
            step, positive = _kernel.chain_of_blocks(D + damp * size * np.eye(D.shape[1]), E, -along)
            if positive:
                length = float(np.abs(step).max())
                step *= min(1.0, 0.3 / max(length, TINY))
                tried, ok = shape.on(x + np.einsum("kma,ka->km", Z, step))
                new = _value(shape, tried, weight, margin) if ok.all() else np.inf
                if new < value or (new <= value + SMOOTH_MAY_RISE * abs(value) and length < SMOOTH_TINY_STEP):
                    done = True
                    break
            damp = max(4 * damp, SMOOTH_DAMPING)
        if not done:
            break
        gained = value - new
        stalled = gained <= SMOOTH_NO_GAIN * abs(value) and length < SMOOTH_STALLED
        stalled |= rough and gained <= SMOOTH_ROUGH * abs(value)
        x, value, damp = tried, new, damp / 8 if damp > SMOOTH_UNDAMPED else 0.0
        if stalled:
            break
    return x


def _value(shape: Shape, x: Array, weight: float, margin: float) -> float:
    w, e = shape.setting.weights, np.diff(x, axis=0)
    if shape.power == 2:
        cost = float(np.sum(w * e * e / shape.parts[:, None]))
    else:
        cost = float(np.sum(np.sum((w * e * e) ** (shape.power / 2), axis=1) ** (1 / shape.power)))
    if weight:
        for at, side in _margins(shape, x):
            cost += weight * float(np.sum(_barrier(side * at, margin)))
        if shape.setting.tilts:
            cost += weight * float(np.sum(_barrier(shape.setting.inside_cone(x), margin)))
        if shape.turn_step is not None:
            left = shape.turn_step[:, None] - np.array([1.0, -1.0]) * e[:, shape.setting.n, None]
            cost += weight * float(np.sum(_barrier(left, margin)))
    return cost


def _margins(shape: Shape, x: Array) -> list[tuple[Array, float]]:
    """Return by how much each bounded coordinate is off its limits (N, b), and the sense in which that counts."""
    setting = shape.setting
    low, high = setting.limits[setting.bounded].T
    at = x[:, setting.bounded]
    return [(at - low, 1.0), (at - high, -1.0)]


def _barrier(d: Array, margin: float) -> Array:
    """Return the barrier's values at distances d, nothing where there is no limit."""
    value = -np.log(np.maximum(d, margin))
    outside = d <= margin
    if outside.any():
        u = (d[outside] - 2 * margin) / margin
        value[outside] = 0.5 * (u * u - 1) - np.log(margin)
    value[np.isinf(d)] = 0.0
    return value


def _barrier_slope(d: Array, margin: float) -> Array:
    """Return the slopes of the barrier at distances d, nothing where there is no limit."""
    slope = -1 / np.maximum(d, margin)
    outside = d <= margin
    if outside.any():
        slope[outside] = (d[outside] - 2 * margin) / margin**2
    return slope


def _barrier_bend(d: Array, margin: float) -> Array:
    """Return the bends of the barrier at distances d, nothing where there is no limit."""
    return 1 / np.maximum(d, margin) ** 2


def _weights_of_steps(shape: Shape, x: Array) -> tuple[Array, Array]:
    """Return the slope (N - 1, m) of the cost by each step's differences, and its bend (N - 1, m), the diagonal."""
    w, e = shape.setting.weights, np.diff(x, axis=0)
    if shape.power == 2:
        c = 2 * w / shape.parts[:, None]
        return c * e, np.broadcast_to(c, e.shape)
    p, a = shape.power, np.sqrt(w) * np.abs(e)
    top = np.maximum(a.max(1, keepdims=True), NO_LENGTH)
    r = a / top
    total = np.sum(r**p, axis=1, keepdims=True)
    slope = np.sqrt(w) * np.sign(e) * r ** (p - 1) * total ** (1 / p - 1)
    # the bend without what the others take off it, which keeps it positive
    bend = w * (p - 1) * r ** (p - 2) * total ** (1 / p - 1) / top + SMOOTH_BEND * w / top
    return slope, bend


def _slope(shape: Shape, x: Array, weight: float, margin: float) -> tuple[Array, Array]:
    """Return the slope (N, m) of the cost, and what each pose leaves free (N, m, d)."""
    setting = shape.setting
    by_step, _ = _weights_of_steps(shape, x)
    g = np.zeros_like(x)
    g[1:] += by_step
    g[:-1] -= by_step
    if weight:
        for at, side in _margins(shape, x):
            g[:, setting.bounded] += weight * side * _barrier_slope(side * at, margin)
        if setting.tilts:
            g[:, -2:] += weight * _barrier_slope(setting.inside_cone(x), margin)[:, None] * cone_slope(setting, x)
        if shape.turn_step is not None:
            e = np.diff(x[:, setting.n])
            for side in (1.0, -1.0):
                slope = weight * _barrier_slope(shape.turn_step - side * e, margin) * -side
                g[1:, setting.n] += slope
                g[:-1, setting.n] -= slope
    return g, _free(setting, x)


def _along(shape: Shape, x: Array, weight: float, margin: float) -> tuple[Array, Array, Array]:
    """Return the slope (N, m), what is free (N, m, d), and what the cone's edge counts with (N,)."""
    g, Z = _slope(shape, x, weight, margin)
    if shape.edge is None:
        return g, Z, np.zeros(len(x))
    return along_edge(shape.setting, x, g, Z, shape.edge)


def _free(setting: Setting, x: Array) -> Array:
    """Return what each pose leaves free (N, m, d), rad or m: directions in which it does not change."""
    J = scaled_jacobian(setting.chain, x)
    if setting.m - setting.spare == J.shape[1]:
        # of full rank: what is across all rows, for half of what singular values cost
        free: Array = np.linalg.qr(np.swapaxes(J, 1, 2), mode="complete")[0][:, :, J.shape[1] :]
    else:
        free = np.swapaxes(np.linalg.svd(J)[2][:, setting.m - setting.spare :], 1, 2)
    return np.asarray(free * setting.chain.joints.unit[:, None], np.float64)


def _pulled(setting: Setting, J: Array, g: Array) -> Array:
    """Return the slope (N, 6) of a cost whose slope by the coordinates is g (N, m), as the pose is moved."""
    if setting.m - setting.spare == J.shape[1]:
        square = J @ np.swapaxes(J, 1, 2)
        try:
            return np.asarray(np.linalg.solve(square, np.einsum("kij,kj->ki", J, g)[..., None])[..., 0], np.float64)
        except np.linalg.LinAlgError:
            pass  # a point is singular with all that is free
    return np.asarray(np.einsum("kji,kj->ki", np.linalg.pinv(J), g), np.float64)


def _bend(shape: Shape, x: Array, Z: Array, g: Array, edge: Array, weight: float, margin: float) -> tuple[Array, Array]:
    """Return the blocks (N, d, d) and (N - 1, d, d) of the second derivative along what poses leave free."""
    setting = shape.setting
    chain, unit = setting.chain, setting.chain.joints.unit
    _, by_step = _weights_of_steps(shape, x)
    H = np.zeros_like(x)
    H[1:] += by_step
    H[:-1] += by_step
    between = by_step.copy()
    if weight:
        for at, side in _margins(shape, x):
            H[:, setting.bounded] += weight * _barrier_bend(side * at, margin)
        if shape.turn_step is not None:
            e = np.diff(x[:, setting.n])
            for side in (1.0, -1.0):
                bend = weight * _barrier_bend(shape.turn_step - side * e, margin)
                H[1:, setting.n] += bend
                H[:-1, setting.n] += bend
                between[:, setting.n] += bend
    bent = np.einsum("kma,km,kmb->kab", Z, H, Z)
    if weight and setting.tilts:
        inside = setting.inside_cone(x)
        slope, bend = _barrier_slope(inside, margin), _barrier_bend(inside, margin)
        out = np.einsum("km,kma->ka", cone_slope(setting, x), Z[:, -2:])
        bent += weight * bend[:, None, None] * out[:, :, None] * out[:, None, :]
        bent -= (
            weight
            * (slope / np.tan(setting.free.cone))[:, None, None]
            * np.einsum("kma,kmb->kab", Z[:, -2:], Z[:, -2:])
        )
    if shape.edge is not None:
        bent += edge[:, None, None] * np.einsum("kma,kmn,knb->kab", Z[:, -2:], cone_bend(setting, x), Z[:, -2:])
    E = -np.einsum("kma,km,kmb->kab", Z[:-1], between, Z[1:])
    # what is free is bent: a step along it leaves the pose to second order, and coming back costs slope
    J = scaled_jacobian(chain, x)
    pull = _pulled(setting, J, g * unit)
    d = Z.shape[2]
    for a in range(d):
        ahead = scaled_jacobian(chain, x + FREEDOM_PROBE * Z[:, :, a])
        behind = scaled_jacobian(chain, x - FREEDOM_PROBE * Z[:, :, a])
        turned = np.einsum("kim,kmb->kib", (ahead - behind) / (2 * FREEDOM_PROBE), Z / unit[:, None])
        bent[:, a, :] -= np.einsum("ki,kib->kb", pull, turned)
    bent = (bent + np.swapaxes(bent, 1, 2)) / 2
    if shape.edge is not None:
        bent[shape.edge, 0, 0] = 1.0  # of the direction that is none
    held = shape.fixed == 0
    if held.any():
        bent[held] = np.eye(d)
        E[held[:-1]] = 0.0
        E[held[1:]] = 0.0
    return bent, E
