"""Solutions marked by what stands around the arm: which rows touch something, which do not."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from pieper.errors import InputError
from pieper.kinematics.arrays import Array, Bools


class Marked:
    """What `ik(T, scene=)` adds to solutions; how far a posture is from touching is handed in."""

    __slots__ = ("_apart",)

    def keep_clear(self, apart: Callable[[Array], Array] | None) -> None:
        """Take up how far joint vectors (m, n) are from touching, (m,) m; None where nobody asked."""
        self._apart = apart

    @property
    def q(self) -> Array:
        """The rows (m, n) that are marked."""
        raise NotImplementedError

    @property
    def clearance(self) -> Array:
        """(m,) how far the arm is from touching itself or the scene at each row of q, m; negative where it does.

        Raises:
            InputError: No scene was given to `ik`.
        """
        if self._apart is None:
            raise InputError("nothing is known of what stands around the arm: say ik(T, scene=pieper.Scene([...])).")
        return np.array(self._apart(self.q))

    @property
    def clear(self) -> Bools:
        """(m,) whether a row of q touches nothing; see `clearance`."""
        return self.clearance > 0.0
