"""The spare coordinates of a path on a grid: which values, which cells lie near each other, and all rows of a pose."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from pieper.kinematics.arrays import Array, Bools, Indices
from pieper.kinematics.joints import TURN
from pieper.kinematics.pose import inverse, rotation_about, rotation_x, rotation_z
from pieper.motion.route.setting import Setting
from pieper.solver.arm_rows import arm_rows, full_rows
from pieper.tolerances import CONE_INSIDE, WHOLE_TURN

#: Values of a turning coordinate over a whole turn, by how many coordinates there are on the grid.
TURNS = {1: 72, 2: 36, 3: 24}
#: Values of a sliding coordinate.
SLIDES = 25
#: Rings and spokes of the tilt.
RINGS, SPOKES = 2, 8
#: How far a coordinate moves from rung to rung at most (rad).
REACH = 0.45


@dataclass(frozen=True, eq=False)
class Coordinate:
    """One spare coordinate on the grid: its values, and whether the last is beside the first."""

    values: Array
    cyclic: bool


@dataclass(frozen=True, eq=False)
class Grid:
    """Cells of spare coordinates.

    Attributes:
        setting: What is solved.
        turn: The turn about the tool's axis where it is on the grid; else None.
        held: The spare joints of the arm.
        tilts: (t, 2) tilts about y and about x, rad; the first is none.
    """

    setting: Setting
    turn: Coordinate | None
    held: tuple[Coordinate, ...]
    tilts: Array

    @cached_property
    def coordinates(self) -> tuple[Coordinate, ...]:
        """Those that are values on a line or a circle."""
        return ((self.turn,) if self.turn is not None else ()) + self.held

    @cached_property
    def cells(self) -> Array:
        """(C, k + 1) values of the coordinates in each cell, then the number of its tilt."""
        lists = [c.values for c in self.coordinates] + [np.arange(len(self.tilts), dtype=float)]
        return np.array(list(itertools.product(*lists)), float)

    def near(self, reach: int) -> Indices:
        """Return (C, r) cells at most `reach` steps away in each coordinate, itself first, -1 for none."""
        shape = [len(c.values) for c in self.coordinates]
        tilts = self._tilts_beside
        index = np.array(list(itertools.product(*(range(k) for k in shape))), np.int64).reshape(
            int(np.prod(shape)), len(shape)
        )
        steps = [sorted(range(-min(reach, k // 2), min(reach, k // 2) + 1), key=abs) for k in shape]
        out: list[Indices] = []
        for move in itertools.product(*steps):
            to, ok = index + np.array(move, np.int64), np.ones(len(index), bool)
            for axis, (k, coordinate) in enumerate(zip(shape, self.coordinates, strict=True)):
                if coordinate.cyclic:
                    to[:, axis] %= k
                else:
                    ok &= (to[:, axis] >= 0) & (to[:, axis] < k)
            flat = np.zeros(len(index), np.int64)
            for axis, k in enumerate(shape):
                flat = flat * k + np.where(ok, to[:, axis], 0)
            cell = flat[:, None, None] * len(self.tilts) + tilts
            out.append(np.where(ok[:, None, None] & (tilts >= 0), cell, -1).reshape(len(index) * len(self.tilts), -1))
        return np.ascontiguousarray(np.concatenate(out, axis=1), np.int32).astype(np.int64)

    @cached_property
    def _tilts_beside(self) -> Indices:
        """(t, r) tilts beside each, itself first."""
        gap = np.linalg.norm(self.tilts[:, None] - self.tilts[None], axis=-1)
        if len(self.tilts) == 1:
            return np.zeros((1, 1), np.int64)
        count = min(len(self.tilts), 7)
        return np.argsort(gap, axis=1, kind="stable")[:, :count]

    def rows(self, T: Array) -> tuple[Array, Bools]:
        """Return all rows x (M, C, B, m) of poses T (M, 4, 4), and which are solutions (M, C, B)."""
        setting, cells = self.setting, self.cells
        M, C, n = len(T), len(cells), setting.n
        tilt = self.tilts[cells[:, -1].astype(np.int64)]
        poses = np.broadcast_to(T[:, None], (M, C, 4, 4))
        if setting.tilts:
            poses = poses @ inverse(_tilt(tilt))
        held = cells[:, :-1]
        if self.turn is not None:
            poses = poses @ rotation_z(cells[:, 0])
            held = held[:, 1:]
        poses = np.ascontiguousarray(poses).reshape(-1, 4, 4)
        values = np.tile(held, (M, 1)) if held.shape[1] else np.zeros((M * C, 0))
        plan = setting.rows.uncoupled or setting.rows
        if plan.direct:
            q, valid, _, _ = plan.solver.many(poses, 1)
        elif plan.reduction.full.n > n:
            found = full_rows(plan, poses, values, 1)
            q, valid = found.q, found.valid
        else:
            found = arm_rows(plan, poses, values, 1)
            q, valid = found.q, found.valid
        B = q.shape[1]
        x = np.zeros((M, C, B, setting.m))
        x[..., : q.shape[-1]] = setting.joints_at(q.reshape(M, C, B, -1))
        if self.turn is not None:
            x[..., n] = -cells[:, 0, None]
        if setting.tilts:
            x[..., -2:] = tilt[:, None]
        return x, valid.reshape(M, C, B)


def _tilt(tilt: Array) -> Array:
    """Return the motions (..., 4, 4) of the two virtual joints at angles (..., 2) about y and x."""
    R = np.zeros((*tilt.shape[:-1], 4, 4))
    R[..., 3, 3] = 1.0
    R[..., :3, :3] = rotation_about(np.array([0.0, 1.0, 0.0]), tilt[..., 0])
    return R @ rotation_x(tilt[..., 1])


def grid(setting: Setting, finer: int = 1, offset: float = 0.0) -> Grid:
    """Return the grid of a setting, `finer` times as many values a coordinate, turned by a part of a cell."""
    rows = setting.rows
    limits = rows.full_limits
    count = len(rows.redundancy) + (1 if setting.turn_on_grid else 0) + (1 if setting.tilts else 0)
    turns = TURNS.get(count, 12) * finer
    turn = None
    if setting.turn_on_grid:
        low, high = setting.free.interval
        turn = _turning(low, high, turns, offset) if setting.free.turns else Coordinate(np.array([low]), False)
    held: list[Coordinate] = []
    for joint in rows.reduction.locked:
        low, high = limits[joint]
        if rows.reduction.full.prismatic[joint]:
            reach = 2 * rows.chain.length
            ends = (low if np.isfinite(low) else -reach), (high if np.isfinite(high) else reach)
            held.append(Coordinate(np.linspace(*ends, SLIDES * finer), False))
        else:
            held.append(_turning(low, high, turns, offset))
    tilts = np.zeros((1, 2))
    if setting.tilts:
        angle = np.arange(SPOKES) * TURN / SPOKES
        # a little inside the cone: the tilt's two angles make up one by the product of their cosines
        sizes = setting.free.cone * (1 - CONE_INSIDE) * np.arange(1, RINGS + 1) / RINGS
        tilts = np.vstack([tilts, *(_ring(size, angle) for size in sizes)])
    return Grid(setting, turn, tuple(held), tilts)


def _ring(size: float, angle: Array) -> Array:
    """Return tilts (k, 2) by one angle towards directions (k,): cos(y) cos(x) = cos(size)."""
    a = np.arcsin(np.sin(size) * np.cos(angle))
    b = np.arctan2(np.sin(size) * np.sin(angle), np.cos(size))
    return np.stack([a, b], -1)


def _turning(low: float, high: float, turns: int, offset: float) -> Coordinate:
    if not (np.isfinite(low) and np.isfinite(high)) or high - low >= TURN - WHOLE_TURN:
        start = low if np.isfinite(low) else 0.0
        return Coordinate(start + (np.arange(turns) + offset) * TURN / turns, True)
    if high == low:
        return Coordinate(np.array([low]), False)
    return Coordinate(np.linspace(low, high, max(3, int(np.ceil((high - low) / TURN * turns)) + 1)), False)
