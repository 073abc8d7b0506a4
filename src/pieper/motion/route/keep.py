"""What a route must keep beside limits: a distance to singular postures, and clear of itself and of a scene."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from pieper import arguments
from pieper.errors import InputError
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
        nearest: What is nearest to what at a joint vector (n,), in words; None without a scene.
        at_most: Upper bounds (k,) of the distance at all postures whose axes are within (k,), or each within (k, axes),
            of joint vectors (k, n); None without a scene.
    """

    singularity: float = 0.0
    clearance: float = 0.0
    distance: Callable[[Array], Array] | None = None
    clear: Callable[[Array], bool] | None = None
    nearest: Callable[[Array], str] | None = None
    at_most: Callable[[Array, Array], Array] | None = None

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

    def check(self, setting: Setting, q: Array, what: str) -> None:
        """Say what is wrong with a posture (n,) that a route was told to begin or end with.

        Raises:
            InputError: It is in collision, nearer than the clearance, or nearer to singular than what is kept.
        """
        cure = f"Leave {what} out, or give another posture of that pose."
        if self.distance is not None and self.nearest is not None:
            room = float(np.asarray(self.distance(q)))
            if room < self.clearance:
                said = f"in collision, {-room * 1e3:.4g} mm deep" if room < 0 else f"{room * 1e3:.4g} mm from touching"
                asked = f"; a clearance of {self.clearance * 1e3:.4g} mm is asked for" if self.clearance else ""
                raise InputError(f"{what} is {said}: {self.nearest(q)}{asked}. {cure}", given=q, metres=room)
        if self.singularity > 0 and not replace(self, distance=None).holds_alone(setting, q):
            raise InputError(
                f"{what} is nearer to a singular posture than the {self.singularity:g} that is asked for. {cure}",
                given=q,
            )

    def holds_alone(self, setting: Setting, q: Array) -> bool:
        """Whether one posture (n,) keeps it."""
        return bool(self._holds(setting, q[None])[0])

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
