"""The cheapest way up a ladder of poses: a dynamic programme over cells, rows and whole turns at stations."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper import _kernel
from pieper.kinematics.arrays import Array, Bools, Indices
from pieper.kinematics.joints import TURN, turned_from
from pieper.motion.route.grid import REACH, Grid
from pieper.motion.route.setting import Setting
from pieper.tolerances import LIMIT_SLACK, NO_DIRECTION, NO_LOOK_BETWEEN

#: The largest step of a joint from rung to rung and on the spot (rad; lengths of the arm).
STEP = 0.6


@dataclass(frozen=True, eq=False)
class Rungs:
    """All rows at stations of a path.

    Attributes:
        s: (M,) the stations.
        x: (M, C, B, m), bounded turning coordinates in the turn that begins at their lower limit.
        valid: (M, C, B), limits not applied.
        parts: (M - 1,) points of the path from station to station.
    """

    s: Array
    x: Array
    valid: Bools
    parts: Array


@dataclass(frozen=True, eq=False)
class Way:
    """A chain of joint vectors up the rungs.

    Attributes:
        x: (k, m), whole turns continuous.
        rung: (k,) station of each, not descending; a station may come several times.
        cost: What the ladder takes it to cost; infinite where the last rung is not reached.
        furthest: Last rung reached, -1 for none.
    """

    x: Array
    rung: Indices
    cost: float
    furthest: int


def rungs(setting: Setting, grid: Grid, s: Array, parts: Array) -> Rungs:
    """Return all rows at stations s (M,)."""
    x, valid = grid.rows(setting.at(s))
    return Rungs(s, _normal(setting, x), valid, parts)


def _normal(setting: Setting, x: Array, room: float = 0.0) -> Array:
    """Return x (..., m) with bounded turning coordinates in the turn from `room` below their lower limit."""
    low, high = setting.limits.T
    bounded = np.isfinite(low) & np.isfinite(high) & ~setting.chain.prismatic
    start = np.where(bounded, low, 0.0) - room
    return np.where(bounded, turned_from(start - LIMIT_SLACK, x), x)


def climb(
    setting: Setting,
    grid: Grid,
    rung: Rungs,
    *,
    largest: bool = False,
    on_the_spot: bool = False,
    turn_step: Array | None = None,
    ends: tuple[Array | None, Array | None] = (None, None),
    all_turns: bool = True,
    wider: float = 0.0,
) -> Way:
    """Return the cheapest way from the first rung to the last.

    Args:
        setting: What is solved.
        grid: The cells.
        rung: The rows.
        largest: Whether a step costs its largest joint difference instead of the sum of squares.
        on_the_spot: Whether coordinates may also change while the path stands.
        turn_step: (M - 1,) largest change of the turn from rung to rung, rad.
        ends: Joint vectors (m,) to begin and to end with.
        all_turns: Whether whole turns are carried along; else a joint that can turn all the way round counts as if it
            had no limits, which is quick, and the way found is to be looked at for whole turns that fit.
        wider: By how much all limits of joints are taken for wider (rad; lengths), for a way that is pulled in later.
    """
    M, limits = len(rung.s), widened(setting, wider)
    if not all_turns:
        wide = ~setting.chain.prismatic & (limits[:, 1] - limits[:, 0] >= TURN - LIMIT_SLACK)
        limits = np.where(wide[:, None], [-np.inf, np.inf], limits)
    unit = setting.chain.joints.unit
    longest = np.tile(STEP * unit, (M - 1, 1))
    if setting.turns:
        longest[:, setting.n] = np.inf if turn_step is None else turn_step
    longest[:, setting.n + setting.turns :] = np.inf
    x, valid = _normal(setting, rung.x, wider) if wider else rung.x, rung.valid
    lifts = np.full((2, setting.m), -1, np.int32)
    for at, end in zip((0, -1), ends, strict=True):
        if end is not None:
            start = _normal(setting, end, wider)
            # of a joint that counts as if it had no limits the ends are meant whatever their whole turns
            lifts[at] = np.where(np.isfinite(limits).all(1), np.round((end - start) / TURN), -1)
            x, valid = _only(setting, x, valid, at, start)
    cell = max((np.ptp(c.values) / max(len(c.values) - 1, 1) for c in grid.coordinates), default=1.0)
    near = grid.near(max(1, int(round(REACH / max(cell, NO_DIRECTION)))) if len(grid.coordinates) < 2 else 2)
    spot = grid.near(1)
    on_spot = np.full(setting.m, -1.0)
    if on_the_spot and turn_step is None and len(grid.cells) > 1:
        on_spot = np.where(np.arange(setting.m) < setting.n, STEP * unit, np.inf)
    q, at, cost, furthest, _ = _kernel.ladder(
        q=x,
        valid=valid,
        limits=limits,
        circle=~setting.chain.prismatic,
        weights=setting.weights,
        longest=longest,
        parts=rung.parts,
        near=near,
        spot=spot,
        on_spot=on_spot,
        largest=largest,
        slack=LIMIT_SLACK,
        first=lifts[0],
        last=lifts[-1],
    )
    return Way(_continuous(setting, q, limits), at, float(cost), int(furthest))


def widened(setting: Setting, by: float) -> Array:
    """Return the limits (m, 2) with those of the arm's joints wider (rad; lengths)."""
    room = np.where(np.arange(setting.m) < setting.n, by * setting.chain.joints.unit, 0.0)
    return setting.limits + room[:, None] * np.array([-1.0, 1.0])


def fitted(setting: Setting, x: Array, near: Array | None = None, wider: float = 0.0) -> Array | None:
    """Return a continuous chain (k, m) moved by whole turns into the limits, None where there are none that fit.

    Of several it is the nearest to a posture, or to the middle of the limits.
    """
    low, high = widened(setting, wider).T
    turning = ~setting.chain.prismatic
    least = np.where(turning, np.ceil((low - LIMIT_SLACK - x.min(0)) / TURN), 0.0)
    most = np.where(turning, np.floor((high + LIMIT_SLACK - x.max(0)) / TURN), 0.0)
    outside = ~turning & ((x.min(0) < low - LIMIT_SLACK) | (x.max(0) > high + LIMIT_SLACK))
    if (least > most).any() or outside.any():
        return None
    both = np.isfinite(low) & np.isfinite(high)
    middle = (np.where(both, low, 0.0) + np.where(both, high, 0.0)) / 2
    aim = middle if near is None else near
    spun = np.round(np.asarray((aim - x.mean(0)) / TURN, np.float64))
    turns = np.where(turning, spun, 0.0)
    return x + TURN * np.clip(turns, least, most)


def from_ends(setting: Setting, x: Array, ends: tuple[Array | None, Array | None], wider: float) -> Array | None:
    """Return a continuous chain (k, m) moved by whole turns to the ends that are told; None where it does not fit."""
    turning = ~setting.chain.prismatic
    for at, end in zip((0, -1), ends, strict=True):
        if end is not None:
            turns = np.asarray(np.round((end - x[at]) / TURN), np.float64)
            x = x + TURN * turns * turning
            break
    away = [np.abs(x[at] - end).max() for at, end in zip((0, -1), ends, strict=True) if end is not None]
    low, high = widened(setting, wider).T
    inside = ((x >= low - LIMIT_SLACK) & (x <= high + LIMIT_SLACK)).all()
    return x if inside and max(away) < NO_LOOK_BETWEEN else None


def _only(setting: Setting, x: Array, valid: Bools, at: int, end: Array) -> tuple[Array, Bools]:
    """Return rows of which one rung has nothing but a given joint vector, in the cell it lies nearest to."""
    x, valid = x.copy(), valid.copy()
    gap = setting.chain.joints.difference(x[at], end)
    away = np.abs(gap).max(-1)
    # the rows of one cell are a pose's solutions: the virtual coordinates say which cell it is
    cell = int(np.argmin(np.where(valid[at], away, np.inf).min(1))) if valid[at].any() else 0
    valid[at] = False
    x[at, cell, 0], valid[at, cell, 0] = end, True
    return x, valid


def _continuous(setting: Setting, q: Array, limits: Array) -> Array:
    """Return a chain (k, m) without jumps of whole turns in coordinates that have no limits."""
    if len(q) < 2:
        return q
    free = ~setting.chain.prismatic & ~np.isfinite(limits).all(1)
    steps = np.diff(q, axis=0)
    turns = np.where(free, -TURN * np.round(steps / TURN), 0.0)
    return q + np.vstack([np.zeros(setting.m), np.cumsum(turns, axis=0)])
