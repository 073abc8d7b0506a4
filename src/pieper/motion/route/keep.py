"""What a route must keep beside limits: a distance to singular postures, and clear of itself and of a scene."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from pieper import arguments
from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.newton import singular_values
from pieper.motion.route.setting import Setting
from pieper.tolerances import TINY


@dataclass(frozen=True, eq=False)
class Keep:
    """What must be kept.

    Attributes:
        singularity: Least sigma_min / sigma_max of the arm's Jacobian without units; 0 for any.
        clearance: Least distance to everything, m.
        distance: Distances (k,) of joint vectors (k, n), m; None without a scene.
        clear: Whether joint moves through (N, n) are proved clear by the clearance; None without a scene.
    """

    singularity: float = 0.0
    clearance: float = 0.0
    distance: Callable[[Array], Array] | None = None
    clear: Callable[[Array], bool] | None = None

    @property
    def anything(self) -> bool:
        """Whether there is anything to keep."""
        return self.singularity > 0 or self.distance is not None

    def rows(self, setting: Setting, x: Array, valid: Bools) -> Bools:
        """Return which of the valid rows (...) keep it."""
        if not self.anything:
            return valid
        out = valid.copy()
        out[valid] = self._holds(setting, x[valid])
        return out

    def holds(self, setting: Setting, x: Array) -> bool:
        """Whether a route (N, m) keeps it: at its points, and for a scene between them too."""
        if not self.anything:
            return True
        if not bool(self._holds(setting, x).all()):
            return False
        return self.clear is None or self.clear(x[:, : setting.n])

    def _holds(self, setting: Setting, x: Array) -> Bools:
        ok = np.ones(len(x), bool)
        if self.singularity > 0:
            s = singular_values(setting.plan.chain, x[:, : setting.n])
            rank = setting.plan.rank
            ok &= s[:, min(rank, s.shape[1]) - 1] >= self.singularity * np.maximum(s[:, 0], TINY)
        if self.distance is not None and len(x):
            ok[ok] &= np.asarray(self.distance(x[ok, : setting.n]), float) >= self.clearance
        return ok


def checked_number(value: object, what: str, unit: str, most: float = np.inf) -> float:
    """Return a number that is zero or more, or say that it is none."""
    return arguments.number(value, what, unit, least=0.0, below=most)
