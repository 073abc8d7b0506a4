"""Other routes than the cheapest: one a posture label of the first point, sought when they are asked for."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from pieper.kinematics.arrays import Array
from pieper.motion.route.grid import Grid
from pieper.motion.route.ladder import Rungs
from pieper.motion.route.result import Alternative
from pieper.motion.route.search import Task, climbed_and_carried
from pieper.solver.words.labels import posture_words


@dataclass(frozen=True, eq=False)
class Others:
    """What is needed to look for other routes.

    Attributes:
        task: What a route is to be like.
        grid: The cells of the ladder.
        rungs: Its rows.
        x: (N, m) the route that was found.
    """

    task: Task
    grid: Grid
    rungs: Rungs
    x: Array

    def __call__(self) -> tuple[Alternative, ...]:
        """Return the cheapest route of every other posture label at the first point, cheapest first."""
        setting = self.task.setting
        first = self.rungs.x[0]
        valid = self.rungs.valid[0]
        cell, row = np.nonzero(valid)
        labels = np.array(posture_words(setting.plan, first[cell, row, : setting.n]))
        own = posture_words(setting.plan, self.x[:1, : setting.n])[0]
        out: list[Alternative] = []
        for label in dict.fromkeys(labels.tolist()):
            if label == own or self.task.ends[0] is not None:
                continue
            only = self.rungs.valid.copy()
            only[0] = False
            mine = labels == label
            only[0, cell[mine], row[mine]] = True
            found = climbed_and_carried(self.task, self.grid, replace(self.rungs, valid=only))
            if found is not None and posture_words(setting.plan, found.x[:1, : setting.n])[0] == label:
                q = found.x[:, : setting.n]
                out.append(Alternative(label, q, setting.turn_of(found.x), found.cost))
        return tuple(sorted(out, key=lambda other: other.cost))
