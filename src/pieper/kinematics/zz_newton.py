"""The one Newton's method: what misses a pose, its Jacobian without units, and the steps that are taken with them."""

from __future__ import annotations

from collections.abc import Callable

from pieper.kinematics.arrays import Array, Indices
from pieper.kinematics.chain import Chain
from pieper.tolerances import (
    NEWTON_CUTOFF,
)

#: From joint vectors (k, n) and their places in the batch (k,): what is missed (k, r), or its slope (k, r, n).
Equations = Callable[[Array, Indices], Array]
#: A step (k, n) without units from a slope (k, r, n) and what is missed (k, r).
Step = Callable[[Array, Array], Array]


def pose_difference(chain: Chain, q: Array, T: Array) -> Array:
    raise NotImplementedError


def missed(chain: Chain, q: Array, T: Array) -> Array:
    raise NotImplementedError


def scaled_jacobian(chain: Chain, q: Array) -> Array:
    raise NotImplementedError


def determinant(chain: Chain, q: Array) -> Array:
    raise NotImplementedError


def singular_values(chain: Chain, q: Array) -> Array:
    raise NotImplementedError


def null_space(chain: Chain, q: Array) -> tuple[Array, Array]:
    raise NotImplementedError


def bounded(step: Array, longest: float) -> Array:
    raise NotImplementedError


def shortest(cutoff: float, *, but: int | None = None) -> Step:
    raise NotImplementedError


def turned_back(s: Array, Vt: Array, along: Array, cutoff: float, but: int | None = None) -> Array:
    raise NotImplementedError


def damped(damping: Array | float) -> Step:
    raise NotImplementedError


def settled(
    miss: Equations, slope: Equations, q: Array, unit: Array, *, steps: int, longest: float, step: Step
) -> tuple[Array, Array]:
    raise NotImplementedError


def newton(
    chain: Chain,
    q: Array,
    T: Array,
    *,
    steps: int = 12,
    cutoff: float = NEWTON_CUTOFF,
    max_step: float = 0.5,
    rows: Array | None = None,
) -> Array:
    raise NotImplementedError


def newton_on_plane(
    chain: Chain, q: Array, T: Array, direction: Array, *, holds: float, steps: int = 12
) -> Array | None:
    raise NotImplementedError


def downhill(
    chain: Chain,
    q: Array,
    T: Array,
    *,
    steps: int,
    weights: Array,
    damping: tuple[float, float, float, float],
    relative: Callable[[Array, Array], Array],
) -> tuple[Array, Array]:
    raise NotImplementedError
