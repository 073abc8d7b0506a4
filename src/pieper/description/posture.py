"""A joint vector said by the name of a posture."""

from __future__ import annotations

import difflib

import numpy as np
import numpy.typing as npt

from pieper.description.dh import Description
from pieper.errors import InputError


def posture(arm: Description, name: str, what: str = "q") -> npt.NDArray[np.float64]:
    """Return the joint vector (n,) of a posture of the arm; "zero" is one of every arm.

    Raises:
        InputError: The arm has no posture of that name.
    """
    known = {"zero": np.zeros(arm.n)} | arm.postures
    if name not in known:
        near = difflib.get_close_matches(name, known, n=1)
        hint = f" Did you mean {near[0]!r}?" if near else ""
        raise InputError(
            f"{what}: {arm.name} has no posture {name!r}.{hint} It has {', '.join(known)}.",
            given=name,
            allowed=list(known),
        )
    return np.array(known[name], float)
