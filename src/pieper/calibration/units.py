"""Degrees, millimetres and others: in which units joints, slides and measurements may have been meant."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from pieper.calibration.measurements import Measurements
from pieper.calibration.model import AxesModel
from pieper.calibration.reading import Reading
from pieper.calibration.turned_less import as_degrees
from pieper.kinematics.arrays import Array
from pieper.kinematics.joints import TURN
from pieper.tolerances import MISREAD

#: How much better readings without degrees must be than those with them, where most angles are more than a turn.
LIKELIER = 2.0
#: A slide that is said to be this many times as long as the arm is said in another unit.
FAR = 10.0
#: What is shorter than this part of the arm, all of it, may have been metres that were taken for millimetres.
NOTHING = 0.01


@dataclass(frozen=True)
class _Unit:
    """What numbers may have been meant in: by which factor they are SI, in words, and what to do about it."""

    factor: float
    words: str = ""
    short: str = ""
    cure: str = ""


_AS_GIVEN = _Unit(1.0)
_DEGREES = _Unit(np.pi / 180, "in degrees", "deg", "Give radians: numpy.radians{of}.")
_RADIANS = _Unit(
    180 / np.pi, "in radians that were taken for degrees", "rad", "Give radians: numpy.degrees{of} undoes that."
)
_MILLIMETRES = _Unit(1 / 1000, "in millimetres", "mm", "Give metres: divide {what} by 1000.")
_METRES = _Unit(1000.0, "in metres that were taken for millimetres", "m", "Give metres: multiply {what} by 1000.")
#: Units that lengths larger than the arm may be in.
_LARGER = (
    _MILLIMETRES,
    _Unit(1 / 1_000_000, "in micrometres", "um", "Give metres: divide {what} by 1,000,000."),
    _Unit(1 / 100, "in centimetres", "cm", "Give metres: divide {what} by 100."),
    _Unit(0.0254, "in inches", "in", "Give metres: multiply {what} by 0.0254."),
)


def units_of(model: AxesModel, q: Array, data: Measurements, length: float) -> Iterator[Reading]:
    """Return the readings in other units: each of the three that the numbers allow, and all of their combinations.

    Args:
        model: The nominal arm.
        q: (N, n) joint vectors as given.
        data: Measurements as given.
        length: The arm's length, m.
    """
    turning = ~model.prismatic
    # numbers as small as radians and metres are would be shrunk to a point, which any arm explains
    angle, slide = _largest(q[:, turning]), _largest(q[:, ~turning])
    place = _largest(data.positions if data.kind == "pose" else data.values)
    sure = bool(turning.any()) and float(np.median(np.abs(q[:, turning]))) > TURN
    angles = _allowed((angle > TURN, _DEGREES), (0 < angle <= np.radians(TURN), _RADIANS))
    slides = _allowed(*((slide > FAR * length, unit) for unit in _LARGER), (0 < slide < NOTHING * length, _METRES))
    small = 0 < place < NOTHING * length
    places = _allowed(*((place > length, unit) for unit in _LARGER), (small, _METRES))
    turned = [None, *(as_degrees(data.values[:, :3, :3]) if data.kind == "pose" else [])]
    for d, s, m, R in itertools.product(angles, slides, places, turned):
        changed = [unit for unit in (d, s, m) if unit is not _AS_GIVEN]
        if not changed and R is None:
            continue
        words = [f"the joint angles are {d.words}"] * (d is not _AS_GIVEN)
        cures = [d.cure.format(of="(q)" if turning.all() else " of the joints that turn")] * (d is not _AS_GIVEN)
        if R is not None:
            too = ["the joint angles and those of the measured poses"] * (d is _RADIANS)
            words = [f"{(too or ['the angles of the measured poses'])[0]} are {_RADIANS.words}", *words[len(too) :]]
            cures.append("Make the poses of their angles as they are.")
        for unit in dict.fromkeys(changed):
            lengths = ["the slides"] * (s is unit) + ["what was measured"] * (m is unit)
            if lengths:
                words.append(f"{' and '.join(lengths)} {'are' if s is unit else 'is'} {unit.words}")
                cures.append(
                    unit.cure.format(what=" and ".join(lengths).replace("what was measured", "the measured lengths"))
                )
        told = q * np.where(turning, d.factor, s.factor)
        scaled = data if m is _AS_GIVEN and R is None else _scaled(data, m.factor, R)
        shorts = [unit.short for unit in changed] + [_RADIANS.short] * (R is not None)
        facts: dict[str, object] = {"unit": ", ".join(dict.fromkeys(shorts))}
        # with something else wrong beside them several miss alike: angles of more than a turn are likelier degrees
        freedom = 1 / LIKELIER if d is _DEGREES and sure else 1.0
        yield Reading(" and ".join(words), " ".join(cures), told, scaled, facts, freedom, units_alone=True)


def _allowed(*units: tuple[bool, _Unit]) -> list[_Unit]:
    return [_AS_GIVEN, *(unit for allowed, unit in units if allowed)]


def of_one_size(T: Array, data: Measurements, left: float) -> bool:
    """Return whether measurements are as large as an arm's poses T (N, 4, 4), and no further off than the arm is long.

    Args:
        T: Poses of the nominal arm.
        data: Measurements, in the units that are tried.
        left: By how much the arm misses them, in its lengths.
    """
    if not left < 1.0 or data.kind not in ("pose", "position"):
        return left < 1.0
    own, seen = (float(np.linalg.norm(p - p.mean(0))) for p in (T[:, :3, 3], data.positions))
    return MISREAD * own < seen and MISREAD * seen < own


def _largest(numbers: Array) -> float:
    return float(np.abs(numbers).max(initial=0.0))


def _scaled(data: Measurements, factor: float, R: Array | None) -> Measurements:
    values = data.values * factor
    if data.kind == "pose":
        values = data.values.copy()
        values[:, :3, 3] *= factor
        if R is not None:
            values[:, :3, :3] = R
    return replace(data, values=values)
