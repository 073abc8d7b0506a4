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


def remark_stands_inside(what: str, deep: float, most: float, name: str) -> bool:
    """Warn of a body in which an arm stands, deeper (m) than a floor is drawn about it; whether it was."""
    if deep <= most:
        return False
    warnings.warn(
        f"{what} holds the place where {name} stands, {deep * 1e3:.4g} mm inside: every posture may touch it. A box is "
        "said by the pose of its middle, not of its top.",
        PieperWarning,
        stacklevel=5,
    )
    return True


def remark_out_of_reach(what: str, away: float, reach: float, name: str) -> None:
    """Warn of a scene of which an arm can touch nothing: its nearest body, how far that is away (m), and the reach."""
    warnings.warn(
        f"nothing of the scene is within reach: {what} is the nearest, at least {away:.4g} m from where {name} stands, "
        f"and no part of the arm gets farther than {reach:.4g} m. Whatever it does is clear of it. Is its place right?",
        PieperWarning,
        stacklevel=5,
    )


def remark_fast(value: ArrayLike, what: str, unit: str, most: float, none: float, small: str) -> None:
    """Warn of a speed so high that it was probably said in a smaller unit, and not so high that it stands for none.

    Args:
        value: One number or several.
        what: Which limit.
        unit: Its unit.
        most: Up to this it is taken as it is.
        none: From this on it stands for no limit.
        small: The unit that was probably meant.
    """
    array = np.atleast_1d(np.asarray(value, np.float64))
    doubtful = array[(array > most) & (array < none)]
    if len(doubtful):
        warnings.warn(
            f"{what} is {doubtful[0]:g} {unit}, more than any arm has. Was it {small}? No limit is said by {none:g} "
            "or more, or where it may be left out by leaving it out.",
            PieperWarning,
            stacklevel=4,
        )


def remark_turned(angles: ArrayLike, what: str, cure: str = "numpy.radians(...)") -> None:
    """Warn of angles that make many whole turns; `cure` takes degrees there."""
    most = float(np.max(np.abs(angles), initial=0.0))
    if most > MOST_TURNED:
        warnings.warn(
            f"{what} has {most:.4g} rad, which looks like degrees: {cure} takes those.",
            PieperWarning,
            stacklevel=4,
        )
