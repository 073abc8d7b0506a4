"""A joint vector said by the name of a posture."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from pieper.description.dh import Description
from pieper.errors import InputError


def posture(arm: Description, name: str, what: str = "q", also: tuple[str, ...] = ()) -> npt.NDArray[np.float64]:
    """Return the joint vector (n,) of a posture of the arm; "zero" is one of every arm.

    Args:
        arm: The arm.
        name: The posture's name.
        what: What is said by it, for messages.
        also: Words that may be said instead, for messages.

    Raises:
        InputError: The arm has no posture of that name.
    """
    known = {"zero": np.zeros(arm.n)} | arm.postures
    if name not in known:
        import difflib

        near = difflib.get_close_matches(name, (*known, *also), n=1)
        hint = f" Did you mean {near[0]!r}?" if near else ""
        raise InputError(
            f"{what}: {arm.name} has no posture {name!r}.{hint} It has {', '.join(known)}."
            + "".join(f' Or say "{word}".' for word in also),
            given=name,
            allowed=[*known, *also],
        )
    return np.array(known[name], float)
