"""Which equations tell solutions from combinations of signs that lead elsewhere, found by trying them on both."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from pieper.algebra.arithmetics import NumpyField
from pieper.algebra.expression import Expr, Trig
from pieper.equations.derivation.elimination import Eliminator
from pieper.equations.derivation.splits import Source
from pieper.tolerances import BRANCH_OTHER_ANGLE, BRANCH_SAME_ANGLE

MOST = 3  # equations on a page

Condition = tuple[Expr, Expr, Source]


def telling(
    e: Eliminator,
    renamed: Mapping[Any, Any],
    values: Mapping[Any, Any],
    right: npt.NDArray[np.bool_],
    wrong: npt.NDArray[np.bool_],
    slack: float = 1.0,
) -> tuple[Condition, ...]:
    """Return the shortest equations that hold wherever `right` and fail, together, wherever `wrong`; () where none do.

    Args:
        e: A finished elimination.
        renamed: Its names -> those of the page.
        values: Every letter of the page, (branches, N) or less.
        right: (branches, N) which branches lead back to their pose.
        wrong: (branches, N) which are real and do not.
        slack: How much more than rounding the right ones may miss, as where roots vanish.
    """
    chosen: list[Condition] = []
    for equation in sorted(e.splits.spare_equations(), key=lambda q: len(q.left.terms) + len(q.right.terms)):
        if not wrong.any() or len(chosen) == MOST:
            break
        left, right_side = (p.expr().substitute(renamed) for p in (equation.left, equation.right))
        atoms = left.atoms() | right_side.atoms()
        if not atoms <= set(values) | {t for t in atoms if isinstance(t, Trig)}:
            continue
        with np.errstate(all="ignore"):
            gap = np.abs(left.evaluate(values, NumpyField) - right_side.evaluate(values, NumpyField))
        gap = np.broadcast_to(gap, right.shape)
        if (gap[right] < BRANCH_SAME_ANGLE * slack).all() and (gap[wrong] > BRANCH_OTHER_ANGLE).any():
            chosen.append((left, right_side, equation.source))
            wrong = wrong & ~(gap > BRANCH_OTHER_ANGLE)
    return tuple(chosen)
