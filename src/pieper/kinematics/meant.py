"""Remarks on numbers that were probably meant in other units: warned of, since they may be right."""

from __future__ import annotations

import warnings
from math import sqrt

import numpy as np

from pieper.errors import PieperWarning
from pieper.kinematics.arrays import Array, ArrayLike, Bools
from pieper.tolerances import FAR_AWAY, LARGE_BODY, LONGEST_ARM, MOST_TURNED


def remark_far_away(p: Array, nowhere: Bools, base: Array, reach: float, name: str) -> None:
    """Warn where positions (N, 3), those without a solution, are so far away that millimetres were probably meant."""
    # the largest coordinate of all tells most batches, before anything is copied
    largest = max(max(column.max(), -column.min()) for column in p.T)
    if sqrt(3.0) * (largest + np.abs(base).max()) <= FAR_AWAY * reach:
        return
    p = p[nowhere]
    away = np.linalg.norm(p - base, axis=1)
    far = away > FAR_AWAY * reach
    if far.any():
        which = "the pose is" if len(p) == 1 else f"{far.sum():,} poses without a solution are up to"
        warnings.warn(
            f"{which} {away.max():.4g} m away and {name} reaches {reach:.3g} m; metres are meant. Were these "
            "millimetres? pieper.pose(..., mm=True) takes them.",
            PieperWarning,
            stacklevel=4,
        )


def remark_far_shape(what: str, away: float, across: float, reach: float, name: str, own: bool) -> bool:
    """Warn of a body so far away, or so large (m), that millimetres were probably meant; whether it was.

    A body of the arm's own is held to what arms are, any other one to the arm's reach.
    """
    far, large = (LONGEST_ARM, LONGEST_ARM) if own else (FAR_AWAY * reach, LARGE_BODY * reach)
    if away <= far and across <= large:
        return False
    where = f"at least {away:.4g} m away" if away > far else f"up to {across:.4g} m across"
    warnings.warn(
        f"{what} is {where} and {name} reaches {reach:.3g} m; metres are meant. Were these millimetres? "
        "Divide by 1000.",
        PieperWarning,
        stacklevel=5,
    )
    return True


def remark_long(metres: float, what: str) -> bool:
    """Warn of an arm, or of a part of one, that is longer than any that was built; whether it was."""
    if metres <= LONGEST_ARM:
        return False
    warnings.warn(
        f"{what} {metres:.4g} m; metres are meant. Were these millimetres? Divide by 1000.", PieperWarning, stacklevel=4
    )
    return True


def remark_turned(angles: ArrayLike, what: str) -> None:
    """Warn of angles that make many whole turns."""
    most = float(np.max(np.abs(angles), initial=0.0))
    if most > MOST_TURNED:
        warnings.warn(
            f"{what} has {most:.4g} rad, which looks like degrees: numpy.radians(...) or degrees=True takes those.",
            PieperWarning,
            stacklevel=4,
        )
