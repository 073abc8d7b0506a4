"""How far anything inside the limits can come along a path, followed with proof.

`kernels/route/self_motion.hpp` says why it is one.
"""

from __future__ import annotations

import enum
import itertools
from dataclasses import dataclass

import numpy as np

from pieper import _kernel
from pieper.kinematics.arrays import Array, Bools, Indices
from pieper.kinematics.joints import TURN, turned_from
from pieper.motion.route.grid import grid
from pieper.motion.route.setting import Setting
from pieper.solver.plan.six_joints import generic_rank
from pieper.solver.redundant.stops import stops
from pieper.tolerances import LIMIT_SLACK

#: How much finer than a route's first grid the turns are at which a pose is solved beside its limits.
FINER = 5


class Ended(enum.Enum):
    """How a front ended."""

    DIED = 0
    ARRIVED = 1
    SINGULAR = 2
    TIRED = 3


@dataclass(frozen=True, eq=False)
class Front:
    """How far it came.

    Attributes:
        ended: How.
        begun: Where on the path it began.
        s: Where it ended.
        told: Where its points are: behind s where it lost its grip or grew tired.
        q: (k, m) its points.
        within: (k,) what each of them stands for (rad; lengths).
        stretch: (r,) how many of the points, one after the other, are one stretch of a curve; below zero: a closed one.
        looked: Points looked at.
        narrowest: Least distance met in which the Jacobian could change by as much as itself (rad; lengths).
    """

    ended: Ended
    begun: float
    s: float
    told: float
    q: Array
    within: Array
    stretch: Indices
    looked: int
    narrowest: float


def can_be_followed(setting: Setting) -> bool:
    """Whether the bounds hold for what is solved: six coordinates decided, of a short arm some by standing at zero."""
    whole, C = setting.filled.uncoupled, setting.coupling
    slides = setting.plan.prismatic
    if C is not None and not np.array_equal(C[slides], np.eye(setting.n)[slides]):
        return False
    # what is free of a thin set is not met by solving for it
    return not setting.tilts and setting.spare <= 1 and whole.n - setting.spare == 6 and generic_rank(whole) == 6


def follow(setting: Setting, limits: Array, seeds: Array, s: tuple[float, float], fine: float, most: int) -> Front:
    """Follow what may be reached from joint vectors (k, m) at one place of the path to another.

    Args:
        setting: What is solved.
        limits: (m, 2) that are kept, `setting.limits` or `modulo_turns(setting)`.
        seeds: What is reached at the first place.
        s: The places.
        fine: Part of the largest steps that the bounds allow; what may be reached is told the sharper.
        most: Points that may be looked at.
    """
    knots = np.unique(np.concatenate([s, setting.s[(setting.s > s[0]) & (setting.s < s[1])]]))
    axis, angle = setting.twists(knots)
    still = setting.filled.n - setting.m
    # what joints are at where axes are: limits are of the joints, the bounds of the axes
    inverse = np.eye(setting.filled.n)
    inverse[: setting.m, : setting.m] = setting.joints_at(np.eye(setting.m)).T
    ended, at, told, q, within, stretch, looked, narrowest = _kernel.front(
        setting.filled.plain,
        limits=np.vstack([limits, np.zeros((still, 2))]),
        joints=inverse,
        poses=setting.at(knots),
        axis=axis,
        angle=angle,
        seeds=np.hstack([setting.axes_at(seeds), np.zeros((len(seeds), still))]),
        fine=fine,
        most=most,
    )
    counted = np.arange(len(knots))
    place, place_told = np.interp([at, told], counted, knots).tolist()
    return Front(
        Ended(ended),
        s[0],
        place,
        place_told,
        setting.joints_at(q[:, : setting.m]),
        within,
        stretch,
        looked,
        narrowest,
    )


def modulo_turns(setting: Setting) -> Array:
    """Return the limits (m, 2) without those of joints that can turn all the way round."""
    limits = setting.limits
    wide = ~setting.chain.prismatic & (limits[:, 1] - limits[:, 0] >= TURN - LIMIT_SLACK)
    return np.where(wide[:, None], [-np.inf, np.inf], limits)


def everything_at(setting: Setting, limits: Array, s: float) -> Array:
    """Return joint vectors (k, m) on everything inside the limits at a place: where limits are met, and between."""
    T = setting.at(np.array([s]))
    found = [np.zeros((0, setting.m))]
    if setting.spare:
        found.append(setting.joints_at(stops(setting.curves, T, every_turn=limits is setting.limits).q))
    rows, valid = grid(setting, FINER).rows(T)
    found.append(rows[valid])
    x = np.concatenate(found)
    return every_winding(setting, limits, x)


def every_winding(setting: Setting, limits: Array, x: Array) -> Array:
    """Return joint vectors (k, m) in every set of whole turns that fits the limits."""
    one = ~setting.chain.prismatic & np.isfinite(limits).all(1)
    low, high = limits.T
    start = np.where(one, low, 0.0) - LIMIT_SLACK
    x = np.where(one, turned_from(start, x), x)
    every = [x]
    for j in np.flatnonzero(one & (high - low >= TURN - LIMIT_SLACK)).tolist():
        turns = np.arange(int((high[j] - low[j] + 2 * LIMIT_SLACK) // TURN) + 1)
        every = [np.where(np.arange(setting.m) == j, y + TURN * w, y) for y, w in itertools.product(every, turns)]
    x = np.concatenate(every)
    return x[_inside(x, limits)]


def _inside(x: Array, limits: Array) -> Bools:
    ok = (x >= limits[:, 0] - LIMIT_SLACK) & (x <= limits[:, 1] + LIMIT_SLACK)
    return np.asarray(ok.all(1), np.bool_)
