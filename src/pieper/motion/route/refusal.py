"""Why there is no route: everything that could be reached, with room for what lies between the rows that were solved.

Around each row lies a cell, half way to its neighbours in the turn and along the path. What lies in the cell differs
from the row by no more than a bound that is taken from how far its neighbours are, or at a fold its partner; a row
counts as closed only where a joint is outside its limit by more than that. What is reached from the first pose over
cells that are not closed is more than any motion can reach; where that ends before the last pose on two grids, one
twice as fine as the other, there is no route. The bounds of the cells at the edge, which are what stops it, can be
proved one by one by Newton's method on finer parts (Kantorovich); `Blocked.proved` does so and says of how many.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.joints import TURN
from pieper.motion.route.cells import certified, looseness
from pieper.motion.route.closed import blocked_at
from pieper.motion.route.freedom import Verdict
from pieper.motion.route.grid import Grid, grid
from pieper.motion.route.ladder import STEP, Rungs, climb, rungs
from pieper.motion.route.result import Blocked
from pieper.motion.route.search import Task
from pieper.motion.route.setting import Setting

#: How much finer than the first ladder the grids are on which a proof is tried, and the stations of each at least.
FINER, STATIONS = (1, 2, 4), (100, 200, 400)
#: Rows that a grid may have in all.
MOST_ROWS = 6_000_000


@dataclass(frozen=True, eq=False)
class Ruled:
    """How far everything reaches that is not ruled out.

    Attributes:
        grid: The cells.
        rungs: The rows.
        loose: (M, C, B) what each may be outside by.
        open: Last station that is reached over rows inside the limits.
        furthest: Last station reached.
        reached: (M, C, B).
    """

    grid: Grid
    rungs: Rungs
    loose: Array
    open: int
    furthest: int
    reached: Bools


def refusal(task: Task) -> tuple[Verdict, Blocked | None, str]:
    """Return the verdict where no route was found, where it is blocked, and the reason in a sentence."""
    setting = task.setting
    if setting.spare > 1:
        return _nothing_proved(task)
    before: Ruled | None = None
    for finer, count in zip(FINER, STATIONS, strict=True):
        cells = grid(setting, finer if setting.spare else 1)
        s = _dense(setting.s, count if setting.spare else 4 * count)
        if len(s) * len(cells.cells) * 8 > MOST_ROWS:
            break
        ruled = _ruled(task, cells, rungs(setting, cells, s, np.ones(len(s) - 1)))
        if ruled is not None and before is not None:
            return _told(task, ruled)
        before = ruled
    if task.keep.anything:
        return (
            Verdict.UNCERTAIN,
            None,
            "Uncertain: no route was found that keeps the clearance and the distance to singular postures asked for; "
            "without these none could be ruled out.",
        )
    return (
        Verdict.UNCERTAIN,
        None,
        "Uncertain: no route was found, and none could be ruled out: at the finest grid tried cells that may be "
        "feasible still lead from the first pose to the last. More points, or a little more room, decide it.",
    )


def _told(task: Task, ruled: Ruled) -> tuple[Verdict, Blocked, str]:
    blocked = blocked_at(task, ruled.rungs, ruled.open, ruled.furthest, Proof(task, ruled))
    where = f"gets past {blocked.s[1]:.4g} of the path" if ruled.furthest >= 0 else "begins at the first pose"
    turns = f", {len(ruled.grid.cells)} turns each" if task.setting.spare else ""
    reason = (
        f"Impossible: no motion {where}, whatever the branch and the whole turns. From the first pose "
        f"{int(ruled.reached.sum())} cells may be reached ({len(ruled.rungs.s)} stations{turns}); each cell beside "
        "them has a joint outside its limits throughout, or no solution."
    )
    return Verdict.IMPOSSIBLE, blocked, reason


def _nothing_proved(task: Task) -> tuple[Verdict, Blocked | None, str]:
    return (
        Verdict.UNCERTAIN,
        None,
        f"Uncertain: no route was found with {task.setting.spare} coordinates free; a route can be ruled out "
        "for one free coordinate only.",
    )


def _ruled(task: Task, cells: Grid, ladder: Rungs) -> Ruled | None:
    """Return how far everything reaches that is not ruled out, where that is not the end."""
    loose = looseness(task.setting, cells, ladder)
    for all_turns in (False, True):
        way = climb(task.setting, cells, ladder, on_the_spot=True, ends=task.ends, all_turns=all_turns, loose=loose)
        if way.furthest < len(ladder.s) - 1:
            sure = climb(
                task.setting,
                cells,
                ladder,
                on_the_spot=True,
                ends=task.ends,
                all_turns=all_turns,
                loose=np.zeros_like(loose),
            )
            return Ruled(cells, ladder, loose, sure.furthest, way.furthest, way.reached)
    return None


@dataclass(frozen=True, eq=False)
class Proof:
    """Proves the bounds of the cells that stop everything, when asked: how many of how many."""

    task: Task
    ruled: Ruled

    def __call__(self) -> tuple[int, int]:
        """Return how many cells at the edge have a proved bound, and how many there are."""
        ruled, setting = self.ruled, self.task.setting
        edge = _edge(setting, ruled.grid, ruled.rungs, ruled.reached)
        if self.task.ends[0] is None:
            edge[0] |= ruled.rungs.valid[0] & ~ruled.reached[0]
        proved = certified(setting, ruled.grid, ruled.rungs, ruled.loose, edge)
        return int(proved.sum()), len(proved)


def _edge(setting: Setting, cells: Grid, ladder: Rungs, reached: Bools) -> Bools:
    """Return rows (M, C, B) that were not reached, in cells beside reached rows and no farther than a step from one."""
    near = cells.near(1)
    n, unit = setting.n, setting.chain.joints.unit[: setting.n]
    turning = ~setting.plan.prismatic
    edge = np.zeros_like(reached)
    rung, cell, row = np.nonzero(reached)
    if not len(rung):
        return edge
    x = ladder.x[rung, cell, row, :n]
    for shift in (-1, 0, 1):
        to = np.clip(rung + shift, 0, len(ladder.s) - 1)
        for column in near[cell].T:
            ok = (column >= 0) & (to == rung + shift)
            other = np.where(ok, column, 0)
            candidate = ladder.valid[to, other] & ~reached[to, other] & ok[:, None]
            which, b = np.nonzero(candidate)
            gap = ladder.x[to[which], other[which], b, :n] - x[which]
            gap = np.where(turning, gap - TURN * np.round(gap / TURN), gap / unit)
            close = np.abs(gap).max(1) <= STEP
            edge[to[which[close]], other[which[close]], b[close]] = True
    return edge


def _dense(s: Array, count: int) -> Array:
    """Return the points of a path with as many between each two as make `count` stations."""
    each = max(1, -(-(count - 1) // (len(s) - 1)))
    part = np.arange(each) / each
    return np.append((s[:-1, None] + np.diff(s)[:, None] * part).ravel(), s[-1])
