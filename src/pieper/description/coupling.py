"""Coupled joints: what a controller calls the joints against the values of the chain, values = C @ joints.

A palletizer has more axes than joints: a linkage turns some of them as the joints move, and its coupling is taller
than wide.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt
from numpy.typing import ArrayLike

from pieper import arguments
from pieper.errors import InputError
from pieper.tolerances import MOVES_NOTHING, WORST_CONDITION
from pieper.words_by_number import plural


def checked_coupling(coupling: ArrayLike | None, names: tuple[str, ...], axes: int) -> npt.NDArray[np.float64] | None:
    """Return a coupling (axes, n) of n joints, read-only; None where it is the identity.

    Raises:
        InputError: Not so many finite numbers, or singular: a joint that moves nothing, or two that move the same.
    """
    if coupling is None:
        return None
    n = len(names)
    wanted = f"{plural(axes, 'row')} of {plural(n, 'finite number')}"
    C = np.array(arguments.numbers(coupling, "coupling", wanted))
    if C.shape != (axes, n) or not np.isfinite(C).all():
        raise InputError(
            f"coupling must be {wanted} (chain values = coupling @ joint values), got "
            f"{'shape ' + str(C.shape) if C.size else repr(coupling)}.",
            given=coupling,
        )
    for i, name in enumerate(names):
        if not C[:, i].any():
            raise InputError(
                f"the coupling is singular: {name} moves nothing (its column is zero). Write in column {i + 1} what "
                f"{name} does to the axes; a joint that is not coupled has a 1 in its own row there.",
                joint=name,
            )
    condition = float(np.linalg.cond(C))
    if not condition < WORST_CONDITION:
        size = np.abs(C).max(0)
        most = np.abs(C / size).max(1, keepdims=True)
        level = C / size / np.where(most > 0, most, 1.0)
        if np.linalg.cond(level) < WORST_CONDITION:
            small, large = names[int(np.argmin(size))], names[int(np.argmax(size))]
            raise InputError(
                f"the coupling is badly scaled: one unit of {large} moves an axis {size.max() / size.min():.3g} times "
                f"as far as one of {small}, at most {WORST_CONDITION:g} is told from nothing. Give both in rad or m, "
                "not in steps of a motor.",
                condition=condition,
                given=C,
            )
        still = np.linalg.svd(C)[2][-1]
        who = [
            f"{value / np.abs(still).max():.3g} of {name}"
            for name, value in zip(names, still, strict=True)
            if abs(value) > MOVES_NOTHING * np.abs(still).max()
        ]
        raise InputError(
            f"the coupling is singular: {', '.join(who)} together move nothing, so no pose says what they are. "
            "Change a row of these joints: each says what one axis turns by, and none may follow from the others.",
            condition=condition,
            given=C,
        )
    if C.shape == (n, n) and np.array_equal(C, np.eye(n)):
        return None
    C.setflags(write=False)
    return C


def numbers_of(coupling: ArrayLike | None, axes: int) -> int:
    """Return how many joints a coupling of so many axes speaks of: fewer where a linkage moves some of them."""
    try:
        shape = np.shape(coupling) if coupling is not None else ()
    except ValueError:
        return axes  # of unequal rows; what is wrong is said when they are read
    return shape[1] if len(shape) == 2 and shape[0] == axes and 0 < shape[1] < axes else axes


def linked_axes(coupling: npt.NDArray[np.float64] | None) -> tuple[int, ...]:
    """Return the axes (0-based) that have no joint of their own: what moves them follows from the axes before."""
    if coupling is None or coupling.shape[0] == coupling.shape[1]:
        return ()
    own: list[int] = []
    level = coupling / np.abs(coupling).max(0)
    for i in range(len(level)):
        if len(own) < level.shape[1] and np.linalg.matrix_rank(level[[*own, i]]) > len(own):
            own.append(i)
    return tuple(i for i in range(len(level)) if i not in own)


def chain_values(q: npt.NDArray[np.float64], coupling: npt.NDArray[np.float64] | None) -> npt.NDArray[np.float64]:
    """Return the values (..., n) of the chain's joints at joint vectors q (..., n), rad or m."""
    return q if coupling is None else q @ coupling.T


def joint_values(values: npt.NDArray[np.float64], coupling: npt.NDArray[np.float64] | None) -> npt.NDArray[np.float64]:
    """Return the joint vectors (..., n) at which the chain's joints have these values (..., n), rad or m."""
    if coupling is None:
        return values
    own = [i for i in range(len(coupling)) if i not in linked_axes(coupling)]
    return np.asarray(np.linalg.solve(coupling[own], values[..., own, None])[..., 0], np.float64)


def moved_by(row: npt.NDArray[np.float64], names: Sequence[str], sign: float = 1.0) -> str:
    """Return what moves an axis in words, "q2 + q3": its row (n,) of the coupling, and the joints' names."""
    text = ""
    for k in np.flatnonzero(row).tolist():
        by = float(row[k] * sign)
        joiner = ("-" if by < 0 else "") if not text else (" - " if by < 0 else " + ")
        text += joiner + ("" if abs(by) == 1 else f"{abs(by):.9g} ") + names[k]
    return text
