"""The parameters of ortho-parallel arms with a spherical wrist (OPW), as many industrial arms are published."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from pieper import arguments
from pieper.description.axes import described_by_axes
from pieper.description.dh import Description
from pieper.errors import InputError
from pieper.kinematics.meant import remark_long, remark_turned


def from_opw(
    *,
    a1: float,
    a2: float,
    b: float,
    c1: float,
    c2: float,
    c3: float,
    c4: float,
    offsets: Sequence[float] = (0.0,) * 6,
    signs: Sequence[float] = (1.0,) * 6,
    limits: Sequence[Sequence[float | None] | None] | ArrayLike | None = None,
    name: str = "arm",
    joint_names: Sequence[str] | None = None,
) -> Description:
    """Describe an arm by its seven OPW lengths.

    All joints at zero, the arm stands upright: axis 1 is z of the base; axes 2, 3 and 5 are parallel to y; axes 4 and 6
    point up, as the tool's z does. Angles about the axes are signs * q - offsets.

    Args:
        a1: From axis 1 forward to axis 2, m.
        a2: From axis 3 forward to axis 4, m (negative on most arms: the forearm stands higher than the elbow).
        b: Sideways offset of the wrist, m.
        c1: Height of axis 2, m.
        c2: Upper arm, axis 2 to axis 3, m.
        c3: Forearm, axis 3 to the wrist centre, m.
        c4: Wrist centre to the flange, m.
        offsets: (6,) rad.
        signs: (6,) +1 or -1.
        limits: As in `describe`.
        name: Name of the arm.
        joint_names: As in `describe`.

    Raises:
        InputError: A length is not a finite number, or offsets and signs are not six.

    Source: Brandstötter, Angerer and Hofbaur (2014), An Analytical Solution of the Inverse Kinematics Problem of
        Industrial Serial Manipulators with an Ortho-parallel Basis and a Spherical Wrist.
    """
    lengths = {"a1": a1, "a2": a2, "b": b, "c1": c1, "c2": c2, "c3": c3, "c4": c4}
    for key, value in lengths.items():
        arguments.number(value, key, "a length in m")
    remark_long(max(abs(value) for value in lengths.values()), "the arm's longest part is")
    for key, values in (("offsets", offsets), ("signs", signs)):
        if arguments.numbers(values, key, "six numbers, one a joint").shape != (6,):
            raise InputError(f"{key} must be six numbers, one a joint, got {values!r}.", given=values)
    remark_turned(np.asarray(offsets, float), "offsets")
    y, z = [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]
    wrist = [a1 + a2, b, c1 + c2 + c3]
    home = np.eye(4)
    home[:3, 3] = wrist[0], wrist[1], wrist[2] + c4
    return described_by_axes(
        np.array([z, y, y, z, y, z]),
        np.array([[0.0, 0.0, 0.0], [a1, b, c1], [a1, b, c1 + c2], wrist, wrist, wrist]),
        home,
        sign=signs,
        offset=[-float(value) for value in offsets],
        limits=limits,
        name=name,
        joint_names=joint_names,
        source="OPW parameters " + ", ".join(f"{key} = {value:g} m" for key, value in lengths.items()),
    )
