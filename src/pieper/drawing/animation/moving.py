"""What a moving picture needs of a motion."""

from __future__ import annotations

from typing import Protocol

from pieper.kinematics.arrays import Array, ArrayLike


class Moving(Protocol):
    """Postures over time, and what happens on the way; a `Motion` has it all."""

    @property
    def duration(self) -> float:
        """Total time, s."""
        ...

    @property
    def events(self) -> tuple[tuple[float, str, object], ...]:
        """(time, kind, value), in order of time."""
        ...

    def between(self, times: ArrayLike) -> Array:
        """Return the postures (k, n) at times (k,), s."""
        ...
