"""Degrees and millimetres: in which units joints, slides and measurements may have been meant."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from pieper.calibration.measurements import Measurements
from pieper.calibration.model import AxesModel
from pieper.calibration.reading import Reading
from pieper.kinematics.arrays import Array
from pieper.kinematics.joints import TURN
from pieper.tolerances import MISREAD

#: How much better readings without degrees must be than those with them, where most angles are more than a turn.
LIKELIER = 2.0
#: A slide that is said to be this many times as long as the arm is said in another unit.
FAR = 10.0


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
    degrees = _largest(q[:, turning]) > TURN
    sure = bool(turning.any()) and float(np.median(np.abs(q[:, turning]))) > TURN
    slides = _largest(q[:, ~turning]) > FAR * length
    measured = _largest(data.positions if data.kind == "pose" else data.values) > length
    for d, s, m in itertools.product((False, True), repeat=3):
        if not (d or s or m) or d > degrees or s > slides or m > measured:
            continue
        lengths = ["the slides"] * s + ["what was measured"] * m
        words = ["the joint angles are in degrees"] * d
        words += [f"{' and '.join(lengths)} {'are' if s else 'is'} in millimetres"] if lengths else []
        divided = ["the slides"] * s + ["the measured lengths"] * m
        cures = [f"Give radians: numpy.radians{'(q)' if turning.all() else ' of the joints that turn'}."] * d
        cures += [f"Give metres: divide {' and '.join(divided)} by 1000."] if lengths else []
        told = np.where(turning, np.radians(q) if d else q, q / 1000 if s else q)
        units = ["deg"] * d + ["mm"] * bool(lengths)
        shorter, unit = _shorter(data) if m else data, ", ".join(units)
        # with something else wrong beside them several miss alike: angles of more than a turn are likelier degrees
        freedom = 1 / LIKELIER if d and sure else 1.0
        yield Reading(" and ".join(words), " ".join(cures), told, shorter, {"unit": unit}, freedom, units_alone=True)


def of_one_size(T: Array, data: Measurements, left: float) -> bool:
    """Return whether measurements are as large as an arm's poses T (N, 4, 4), wherever and however they lie.

    Args:
        T: Poses of the nominal arm.
        data: Measurements, in the units that are tried.
        left: By how much the arm misses them, in its lengths.
    """
    if data.kind not in ("pose", "position"):
        return left < 1.0
    own, seen = (float(np.linalg.norm(p - p.mean(0))) for p in (T[:, :3, 3], data.positions))
    return MISREAD * own < seen and MISREAD * seen < own


def _largest(numbers: Array) -> float:
    return float(np.abs(numbers).max(initial=0.0))


def _shorter(data: Measurements) -> Measurements:
    values = data.values / 1000
    if data.kind == "pose":
        values = data.values.copy()
        values[:, :3, 3] /= 1000
    return replace(data, values=values)
