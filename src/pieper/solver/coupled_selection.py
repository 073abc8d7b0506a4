"""Which row lies nearest to a joint vector, where whole turns of the arm's axes move several joints' numbers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.whole_turns import WholeTurns


class RowSelection(Protocol):
    """Chooses rows inside the limits near joint vectors; the kernels' own, or the one below."""

    def choose(self, q: Array, inside: Bools, near: Array, chosen: Array, has: Bools, /) -> None:
        """Of q (N, slots, n) and near (n,) or (N, n): writes chosen (N, n), has (N,)."""
        ...

    def in_turn(self, q: Array, inside: Bools, start: Array | None, chosen: Array, has: Bools, /) -> None:
        """The same, each near to the one chosen before it."""
        ...


@dataclass(frozen=True, eq=False, slots=True)
class CoupledSelection:
    """The selection of coupled joints.

    Args:
        turns: How whole turns move the joints.
        limits: (n, 2).
        weight: (n,) of the squared differences, the units of slides in it.
    """

    turns: WholeTurns
    limits: Array
    weight: Array

    def choose(self, q: Array, inside: Bools, near: Array, chosen: Array, has: Bools, /) -> None:
        """Of q (N, slots, n) and near (n,) or (N, n): writes chosen (N, n), zeros where there is none, and has."""
        pose, slot = np.nonzero(inside)
        to = np.broadcast_to(near, chosen.shape)
        rows = self.turns.nearest(q[pose, slot], to[pose], self.limits, self.weight)
        away = np.full(inside.shape, np.inf)
        away[pose, slot] = (self.weight * np.square(rows - to[pose])).sum(1)
        moved = np.zeros_like(q)
        moved[pose, slot] = rows
        has[:] = inside.any(1)
        best = np.argmin(away, axis=1)
        chosen[:] = np.where(has[:, None], moved[np.arange(len(q)), best], 0.0)

    def in_turn(self, q: Array, inside: Bools, start: Array | None, chosen: Array, has: Bools, /) -> None:
        """Choose each pose's row near the one before; the first row inside where nothing is before."""
        now = start
        for i in range(len(q)):
            has[i] = inside[i].any()
            if has[i] and now is None:
                chosen[i] = q[i, np.argmax(inside[i])]
            elif has[i] and now is not None:
                self.choose(q[i : i + 1], inside[i : i + 1], now, chosen[i : i + 1], has[i : i + 1])
            else:
                chosen[i] = 0.0 if now is None else now
                continue
            now = chosen[i].copy()
