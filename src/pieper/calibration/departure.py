"""A fit that is no longer the arm it began with: another size, or axes that stand otherwise to each other."""

from __future__ import annotations

import numpy as np

from pieper.calibration.model import AxesModel
from pieper.errors import InputError
from pieper.kinematics.arrays import Array
from pieper.tolerances import ANOTHER_ANGLE, ANOTHER_SIZE, ONE_UNIT, SAID_AS_A_POINT

#: Units that lengths may be in beside those recognised before a fit (`units_of`), and how many of them a metre is.
UNITS = {"decimetres": 10.0, "feet": 1 / 0.3048}


def refuse_another_arm(nominal: AxesModel, fitted: AxesModel, q: Array) -> None:
    """Raise where a fit explains its data by an arm that the nominal one cannot have been built as.

    Zeros of joints, the base and a tool of moderate length are nobody's size: only how far the tool comes about, and
    the angles between neighbouring axes, are compared.

    Args:
        nominal: The arm as it was drawn.
        fitted: The arm that explains the data.
        q: (N, n) joint vectors that were fitted.

    Raises:
        InputError: The message says by how much, and what was probably meant.
    """
    larger = _spread(fitted, q) / max(_spread(nominal, q), np.finfo(np.float64).tiny)
    if not 1 / ANOTHER_SIZE < larger < ANOTHER_SIZE:
        unit = next((name for name, one in UNITS.items() if abs(larger / one - 1) < ONE_UNIT), None)
        cure = (
            f"Lengths are probably in {unit}. Give metres: divide them by {UNITS[unit]:.6g}."
            if unit
            else "Give lengths in metres, and the joints at which each was measured; of a plane, heights of a tool "
            "that really moved along it."
        )
        size = f"{larger:.3g} times as large as the nominal one" if larger > SAID_AS_A_POINT else "shrunk to a point"
        raise InputError(
            f"only an arm {size} explains the data. {cure}",
            larger=larger,
            unit=unit,
        )
    turned = np.abs(_angles(fitted) - _angles(nominal))
    if turned.max(initial=0.0) > ANOTHER_ANGLE:
        worst = int(np.argmax(turned))
        raise InputError(
            f"only an arm whose axes {worst + 1} and {worst + 2} stand {np.degrees(turned[worst]):.3g} deg otherwise "
            "to each other than in the nominal one explains the data. Several things may be meant otherwise at once "
            "(units, senses, zeros of joints, rows out of step), or it is another arm.",
            turned=float(turned[worst]),
        )


def _spread(model: AxesModel, q: Array) -> float:
    """Return how far the tool comes about: the root mean square distance of its positions from their middle, m."""
    p = model.fk(q)[:, :3, 3]
    return float(np.sqrt(np.mean(np.sum((p - p.mean(0)) ** 2, 1))))


def _angles(model: AxesModel) -> Array:
    """Return (n - 1,) the angles between neighbouring axes, whatever their senses, rad."""
    a, b = model.axes[:-1], model.axes[1:]
    return np.asarray(np.arctan2(np.linalg.norm(np.cross(a, b), axis=1), np.abs(np.sum(a * b, 1))), np.float64)
