"""The cell around each row of a ladder: how much what lies in it can differ from the row, guessed and then proved."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace

import numpy as np

from pieper import _kernel
from pieper.kinematics.arrays import Array, Bools, Indices
from pieper.kinematics.newton import pose_difference, scaled_jacobian
from pieper.kinematics.pose import rotation_vector
from pieper.motion.route.grid import Grid
from pieper.motion.route.ladder import Rungs
from pieper.motion.route.setting import Setting
from pieper.tolerances import CELL_DAMPING, CELL_ON_POSE, CLOSES, TINY

#: Neighbours farther than this (rad; lengths) are not known to be one branch, and partners at a fold at most this.
LINKED, PARTNERS = 0.45, 1.2
#: Part of the distance to the farther neighbour, each way, that a cell may differ from its row by; a line needs half.
MARGIN = 0.8
#: How often a cell is quartered for the proof, parts looked at at once, and at most in one round.
DEPTH, CHUNK, MOST_PARTS = 4, 4000, 60_000


def looseness(setting: Setting, grid: Grid, ladder: Rungs) -> Array:
    """Return by how much (M, C, B) what is in the cell of a row may differ from it, infinite where that is unknown."""
    n = setting.n
    cyclic = bool(grid.coordinates) and grid.coordinates[0].cyclic
    gaps = _kernel.nearest_beside(
        q=ladder.x,
        valid=ladder.valid,
        unit=setting.chain.joints.unit[:n],
        circle=~setting.plan.prismatic,
        cyclic=cyclic,
    )
    own, worst = gaps[..., 0], np.zeros(ladder.valid.shape)
    count = ladder.valid.sum(-1)
    fewer = np.zeros((*ladder.valid.shape[:2], 4), bool)
    for side, (axis, shift) in enumerate(((1, 1), (1, -1), (0, 1), (0, -1))):
        fewer[..., side] = np.roll(count, shift, axis) < count
    for pair in ((0, 1), (2, 3)):
        wide = np.zeros(ladder.valid.shape)
        for side in pair:
            d = gaps[..., side + 1]
            # where rows end in pairs a branch turns back: what lies there is no farther than the partner
            fold = np.where(fewer[..., None, side] & (own <= PARTNERS), own, np.inf)
            wide = np.maximum(wide, np.where(d < 0, 0.0, np.where(d <= LINKED, MARGIN * d, fold)))
        # half way to the neighbours in the turn and half way to those along the path, both at once
        worst += wide
    return np.where(ladder.valid, worst, 0.0)


def certified(setting: Setting, grid: Grid, ladder: Rungs, loose: Array, rows: Bools) -> Bools:
    """Return which of the marked rows (in order) differ by no more than their bound from all that is in their cells.

    In the middle of a cell Newton's method from the row finds a point of the path's solutions. With beta the size of
    the inverse Jacobian there, eta the step that the half cell asks for and k a bound of the Jacobian's slope, beta k
    eta of at most a half proves that all solutions that hang together with this one over the cell lie within
    (1 - sqrt(1 - 2 beta k eta)) / (beta k) of it (Kantorovich). Where it is more, the cell is quartered.
    """
    at, bound = np.argwhere(rows), loose[rows]
    proved = np.ones(len(at), bool)
    turn = setting.n if setting.turn_on_grid and len(grid.cells) > 1 else None
    held = [j for j in range(setting.m) if j != turn]
    if len(held) != 6:
        return np.zeros(len(at), bool)
    # where nothing is known nothing is claimed; the row counts as open
    some = np.flatnonzero(np.isfinite(bound))
    if not len(some):
        return proved
    width = 0.0
    if turn is not None:
        values = grid.coordinates[0].values
        width = float(values[1] - values[0])
    M, i, x = len(ladder.s), at[some, 0], ladder.x[tuple(at[some].T)]
    low = (ladder.s[np.maximum(i - 1, 0)] + ladder.s[i]) / 2
    high = (ladder.s[np.minimum(i + 1, M - 1)] + ladder.s[i]) / 2
    work = _Parts(some, low, high, np.full(len(some), -width / 2), np.full(len(some), width / 2), x)
    for depth in range(DEPTH + 1):
        failed: list[_Parts] = []
        for begin in range(0, len(work.row), CHUNK):
            part = work.some(np.arange(begin, min(begin + CHUNK, len(work.row))))
            good, y = _proved(setting, part, ladder.x[tuple(at[part.row].T)], bound[part.row], turn, held)
            failed.append(replace(part, y=y).some(np.flatnonzero(~good)))
        work = _Parts.all(failed)
        if not len(work.row):
            break
        if depth == DEPTH or len(work.row) > MOST_PARTS:
            proved[work.row] = False
            break
        work = work.quartered(turn is not None)
    return proved


@dataclass(frozen=True, eq=False)
class _Parts:
    """Parts of cells: of which row (k,), from and to where on the path and in the turn, and where to begin (k, m)."""

    row: Indices
    low: Array
    high: Array
    left: Array
    right: Array
    y: Array

    def some(self, which: Indices) -> _Parts:
        return _Parts(*(getattr(self, f.name)[which] for f in fields(self)))

    @staticmethod
    def all(parts: list[_Parts]) -> _Parts:
        return _Parts(*(np.concatenate([getattr(p, f.name) for p in parts]) for f in fields(_Parts)))

    def quartered(self, in_turn: bool) -> _Parts:
        s, t = (self.low + self.high) / 2, (self.left + self.right) / 2
        halves = [replace(self, high=s), replace(self, low=s)]
        return _Parts.all([p for h in halves for p in ([replace(h, right=t), replace(h, left=t)] if in_turn else [h])])


def _proved(
    setting: Setting, part: _Parts, x: Array, bound: Array, turn: int | None, held: list[int]
) -> tuple[Bools, Array]:
    """Return which parts are proved, and the points (k, m) found in their middles."""
    chain, unit = setting.chain, setting.chain.joints.unit
    s = (part.low + part.high) / 2
    T, y = setting.at(s), part.y.copy()
    if turn is not None:
        y[:, turn] = x[:, turn] + (part.left + part.right) / 2
    for _ in range(4):
        e = pose_difference(chain, y, T)
        if np.abs(e).max(initial=0.0) < CELL_ON_POSE:
            break
        square = scaled_jacobian(chain, y)[:, :, held]
        step = np.linalg.solve(square + CELL_DAMPING * np.eye(6), e[..., None])[..., 0]
        step *= np.minimum(1.0, 0.3 / np.maximum(np.linalg.norm(step, axis=1, keepdims=True), TINY))
        y[:, held] += step * unit[held]
    J = scaled_jacobian(chain, y)
    left = np.linalg.norm(pose_difference(chain, y, T), axis=1)
    back = np.asarray(np.linalg.inv(J[:, :, held] + CELL_DAMPING * np.eye(6)), np.float64)
    beta = np.linalg.norm(back, axis=(1, 2))  # Frobenius: not less than the largest singular value
    ends = [_twist(chain.length, T, setting.at(end), back) for end in (part.low, part.high)]
    eta = np.maximum(*ends) + beta * left
    if turn is not None:
        by_turn = np.linalg.norm(np.einsum("kij,kj->ki", back, J[:, :, turn]), axis=1)
        eta += by_turn * (part.right - part.left) / 2
    k = slope_of_jacobian(setting)
    h = beta * k * eta
    radius = np.where(h <= 0.5, (1 - np.sqrt(np.maximum(1 - 2 * h, 0.0))) / (beta * k), np.inf)
    away = np.abs((y - x) / unit)[:, held].max(1)
    good = (left < CLOSES) & (away + radius <= bound)
    lost = ~(left < CLOSES) | (away > bound)
    return good, np.where(lost[:, None], x, y)


def _twist(length: float, T: Array, other: Array, inverse: Array) -> Array:
    """Return the size (k,) of the joint step that a change of pose asks for, to first order."""
    move = (other[:, :3, 3] - T[:, :3, 3]) / length
    turn = rotation_vector(other[:, :3, :3] @ np.swapaxes(T[:, :3, :3], 1, 2))
    return np.linalg.norm(np.einsum("kij,kj->ki", inverse, np.concatenate([move, turn], 1)), axis=1)


def slope_of_jacobian(setting: Setting) -> float:
    """Return a bound of how fast the Jacobian without units changes with the joints, in the Frobenius norm.

    Moving joint m turns the columns of joints behind it and moves the tool against those before it: each column changes
    by no more than one part of turning and one lever, with levers at most the links behind, added up.
    """
    chain = setting.chain
    lengths = np.linalg.norm(chain.links[:, :3, 3], axis=1) / chain.length
    slides = np.where(chain.prismatic, np.abs(setting.limits).max(1) / chain.length, 0.0)
    lengths[1:] += slides
    lever = np.cumsum(lengths[::-1])[::-1][1:]  # from joint j to the tool at most
    column = np.where(chain.prismatic, 1.0, np.hypot(1.0, lever))
    later = np.minimum.outer(column, column)  # of two joints the one behind counts
    return float(np.sqrt(np.sum(later**2)))
