"""What closes a route at a place: the joints and limits of each branch there."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.joints import TURN
from pieper.motion.route.ladder import Rungs
from pieper.motion.route.opening import Opening
from pieper.motion.route.proof import Proof
from pieper.motion.route.result import Blocked, Closed
from pieper.motion.route.search import Task
from pieper.motion.route.setting import Setting
from pieper.motion.route.windows import backwards
from pieper.solver.words.labels import posture_words


def blocked_at(task: Task, ladder: Rungs, reached: int, proof: Proof) -> Blocked:
    """Return where and why nothing goes on: what a grid reaches lies before, what is proved to be the end behind.

    Of a proof that goes backwards the path is counted from its end, and what is returned from its beginning again.

    Args:
        task: What the route was to be like.
        ladder: Rows at stations.
        reached: Last station that is reached over rows inside the limits, below zero for none.
        proof: Where nothing is left.
    """
    setting, begun, proved = task.setting, proof.begun, proof.s
    forth = backwards(task) if proof.back else task
    first = min(float(ladder.s[max(reached, 0)]), proved)
    # the joints are told at a station that was not reached and lies in what is proved
    behind = int(np.searchsorted(ladder.s, proved, side="left"))
    at = min(max(min(reached + 1, behind), int(np.searchsorted(ladder.s, begun, side="left"))), len(ladder.s) - 1)
    last = max(proved, first)
    here = float(ladder.s[at])
    valid = ladder.valid[at]
    if not valid.any():
        turned = ", however the tool is turned" if setting.turns else ""
        why = f"{_place(proof.along(here))} the pose is out of reach{turned}."
        return Blocked(proof.between(first, last), (), why, proof.along(begun), Opening(forth, ()))
    closed = _closed(setting, ladder.x[at], valid)
    if not closed:
        why = (
            f"{_place(proof.along(here))} there are postures inside all limits, but none "
            f"{'from which the last pose is reached' if proof.back else 'that is reached from the first pose'} without "
            "leaving limits on the way: the passages are closed."
        )
        closed = _closed(setting, ladder.x[at], valid & (_excess(setting, ladder.x[at])[0] > 0), every=True)
    else:
        why = f"{_place(proof.along(here))} every branch is closed:"
    return Blocked(proof.between(first, last), closed, why, proof.along(begun), Opening(forth, closed))


def _place(s: float) -> str:
    ends = {0.0: "At the first point of the path", 1.0: "At the last point of the path"}
    return ends.get(s, f"At {s:.4g} of the path")


def _excess(setting: Setting, x: Array) -> tuple[Array, Array, Array]:
    """Return by how much rows (..., m) pass a limit at best, without units, and the coordinate and side that do."""
    low, high = setting.limits.T
    unit = setting.chain.joints.unit
    turning = ~setting.chain.prismatic
    # of all whole turns the one that is least outside
    both = np.isfinite(low) & np.isfinite(high)
    middle = np.where(both, (np.where(both, low, 0) + np.where(both, high, 0)) / 2, 0.0)
    near = np.where(turning & both, x - TURN * np.round((x - middle) / TURN), x)
    free = turning & ~both
    over = np.stack([np.where(free, -np.inf, low - near), np.where(free, -np.inf, near - high)], -1) / unit[:, None]
    flat = over.reshape(*over.shape[:-2], -1)
    which = np.argmax(flat, axis=-1)
    size = np.take_along_axis(flat, which[..., None], -1)[..., 0]
    return np.maximum(size, 0.0), which // 2, which % 2


def _closed(setting: Setting, x: Array, valid: Bools, every: bool = False) -> tuple[Closed, ...]:
    """Return for each branch of a pose what closes it at its best turn; nothing where one branch is open."""
    size, joint, side = _excess(setting, x)
    cell, row = np.nonzero(valid)
    if not len(cell) or (not every and (size[cell, row] <= 0).any()):
        return ()
    labels = np.array(posture_words(setting.plan, x[cell, row, : setting.n]))
    out: list[Closed] = []
    for label in dict.fromkeys(labels.tolist()):
        mine = np.flatnonzero(labels == label)
        best = mine[int(np.argmin(size[cell[mine], row[mine]]))]
        j, end = int(joint[cell[best], row[best]]), int(side[cell[best], row[best]])
        unit = float(setting.chain.joints.unit[j])
        out.append(
            Closed(
                label,
                setting.names[j],
                ("lower", "upper")[end],
                float(setting.limits[j, end]),
                float(size[cell[best], row[best]] * unit),
            )
        )
    return tuple(sorted(out, key=lambda c: c.excess))
