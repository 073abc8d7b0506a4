"""Data that cannot be meant as they are read: degrees, millimetres, a mirror, a joint's sense, shuffled rows."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from pieper.calibration.frames import frame_and_tool, frame_between, tool_between
from pieper.calibration.measurements import Measurements, spread
from pieper.calibration.model import AxesModel
from pieper.calibration.reading import Reading
from pieper.calibration.strange_rows import in_part, misses_of_rows
from pieper.calibration.units import of_one_size, units_of
from pieper.errors import InputError
from pieper.kinematics.arrays import Array
from pieper.kinematics.pose import inverse
from pieper.tolerances import CURED, LEAST_NOISE, MISREAD, SUSPICIOUS, TINY

#: Rows by which joints and measurements may be out of step.
LAGS = (1, -1, 2, -2, 3, -3, 4, -4, 5, -5)
#: A reading that aligned a frame first must be this many times better than one that did not.
ALIGNED = 3.0
#: The same of one that aligned a frame and a tool.
BOTH = 2 * ALIGNED
#: Whole quarters of a turn, deg, that a joint's zero is often off by; how much better readings of which there are
#: several must be than others.
QUARTERS, SEVERAL = (90, -90, 180), 1.5
#: The same of two joints' senses: to positions of many arms a mirror looks just as they do, and is likelier.
TWO = 4.0
#: Rows that are compared each with each when they may be shuffled.
COMPARED = 400


def refuse_misreadings(model: AxesModel, q: Array, data: Measurements, names: tuple[str, ...], length: float) -> None:
    """Raise where another reading of the data explains them and the one that was said does not.

    Args:
        model: The nominal arm.
        q: (N, n) joint vectors as given.
        data: Measurements as given.
        names: Joint names.
        length: The arm's length, m.

    Raises:
        InputError: The message says what was probably meant, and how to say it.
    """
    now = misfit(model, q, data, length)
    if not now > SUSPICIOUS:
        _refuse_all_shrunk(model, q, data, length)
        return
    best, least_by = None, MISREAD * now
    for reading in _readings(model, q, data, names, length):
        # data without noise say no more than these: which of several is nearer is rounding then
        left = max(misfit(model, reading.q, reading.data, length), LEAST_NOISE)
        # an arm that is itself off leaves that much in any reading
        if not (left < max(SUSPICIOUS, MISREAD**2 * now) and left * reading.freedom < least_by):
            continue
        most = SUSPICIOUS if "unit" in reading.facts else CURED
        if left < most or (reading.units_alone and of_one_size(model.fk(reading.q), reading.data, left)):
            best, least_by = reading, left * reading.freedom
    if best is not None:
        best = _or_another_joint(model, best, _readings(model, q, data, names, length), least_by, length)
        best = in_part(model, q, data, best, length)
        before, after = missed(model, q, data), missed(model, best.q, best.data)
        raise InputError(
            f"the data miss the nominal arm by {_said(before)} (median), and by {_said(after)} if "
            f"{best.words}. {best.cure}",
            misfit=before[0],
            left=after[0],
            **best.facts,
        )


def _refuse_all_shrunk(model: AxesModel, q: Array, data: Measurements, length: float) -> None:
    """Raise where joints that hardly move are beside small measurements, and other units explain both as they vary.

    An arm that is said to move by a degree misses little, whatever was measured: it is compared with its own places.
    """
    now = _beside_spread(model, q, data)
    if not now > SUSPICIOUS:
        return
    best, least = None, min(SUSPICIOUS, MISREAD * now)
    for reading in units_of(model, q, data, length):
        left = _beside_spread(model, reading.q, reading.data)
        if left < least:
            best, least = reading, left
    if best is not None:
        raise InputError(
            f"the data miss the nominal arm by {now:.0%} of how far its tool moves (median), and by {least:.1%} if "
            f"{best.words}. {best.cure}",
            misfit=missed(model, q, data)[0],
            left=missed(model, best.q, best.data)[0],
            **best.facts,
        )


def _beside_spread(model: AxesModel, q: Array, data: Measurements) -> float:
    """Return the median miss of the nominal arm as a part of how far its tool usually is from its places' middle."""
    return missed(model, q, data)[0] / max(spread(model.fk(q)[:, :3, 3]), TINY)


def _or_another_joint(
    model: AxesModel, best: Reading, others: Iterator[Reading], left: float, length: float
) -> Reading:
    """Return the reading with all joints named whose sense explains the data as well: distances show no mirror."""
    if best.data.kind not in ("distance", "plane") or not best.words.endswith("the other way"):
        return best
    alike = [
        str(other.facts["joint"])
        for other in others
        if "joint" in other.facts
        and other.words.endswith("the other way")
        and misfit(model, other.q, other.data, length) < max(SEVERAL * left, SUSPICIOUS / 10)
    ]
    if len(alike) < 2:
        return best
    either = " or ".join(alike)
    cure = "What was measured does not show which: see it at the arm, and give that joint's values with the other sign."
    return replace(
        best, words=f"{either} moves the other way", cure=cure, facts={"joint": best.facts["joint"], "alike": alike}
    )


def missed(model: AxesModel, q: Array, data: Measurements) -> tuple[float, float | None]:
    """Return the median miss of the nominal arm, m, and of poses that of the turn, rad."""
    metres, radians = misses_of_rows(model, q, data)
    return float(np.median(metres)), None if radians is None else float(np.median(radians))


def misfit(model: AxesModel, q: Array, data: Measurements, length: float) -> float:
    """Return the median miss of the nominal arm, per length of the arm; of poses the turns (rad) are added."""
    metres, radians = missed(model, q, data)
    return metres / length + (radians or 0.0)


def _said(miss: tuple[float, float | None]) -> str:
    metres, radians = miss
    # none at all: orientations were not measured, or not compared
    return f"{metres:.3g} m" + (f" and {radians:.2g} rad" if radians else "")


def _readings(
    model: AxesModel, q: Array, data: Measurements, names: tuple[str, ...], length: float
) -> Iterator[Reading]:
    turning = ~model.prismatic
    for reading in units_of(model, q, data, length):
        yield reading
        if data.kind in ("pose", "position"):
            for other in _readings_of_places(model, reading.q, reading.data):
                yield replace(
                    other,
                    words=f"{reading.words}, and {other.words}",
                    cure=f"{reading.cure} {other.cure}",
                    facts=reading.facts | other.facts,
                    freedom=2 * other.freedom,
                    units_alone=False,
                )
    for i, name in enumerate(names):
        other = q.copy()
        other[:, i] = -other[:, i]
        yield Reading(
            f"{name} turns the other way" if turning[i] else f"{name} slides the other way",
            f"Give its values with the other sign, or describe the arm with sign = -1 for {name}.",
            other,
            data,
            {"joint": name},
        )
    for i, j in itertools.combinations(range(len(names)), 2):
        if turning[i] != turning[j]:
            continue
        other = q.copy()
        other[:, [i, j]] = -other[:, [i, j]]
        both = f"{names[i]} and {names[j]}"
        cure = f"Give their values with the other sign, or describe the arm with sign = -1 for {both}."
        yield Reading(f"{both} move the other way", cure, other, data, {"joints": (names[i], names[j])}, TWO)
        other = q.copy()
        other[:, [i, j]] = other[:, [j, i]]
        cure = "Give the joints in the arm's order."
        yield Reading(f"{both} are exchanged", cure, other, data, {"joints": (names[i], names[j])}, SEVERAL)
    for i, name in enumerate(names):
        for quarter in QUARTERS if turning[i] else ():
            moved = q.copy()
            moved[:, i] += np.radians(quarter)
            yield Reading(
                f"the zero of {name} lies {quarter:+d} deg away",
                f"Add {quarter} deg to its values, or describe the arm with that offset for {name}.",
                moved,
                data,
                {"joint": name, "offset": float(np.radians(quarter))},
                SEVERAL,
            )
    for lag in LAGS:
        if len(q) > 4 * abs(lag):
            yield Reading(
                f"joints and measurements are {abs(lag)} row{'s' if abs(lag) > 1 else ''} out of step",
                "Pair each measurement with the joints it was taken at.",
                q[max(lag, 0) : len(q) + min(lag, 0)],
                data.rows(np.arange(max(-lag, 0), len(q) + min(-lag, 0))),
                {"lag": lag},
            )
    if data.kind in ("pose", "position"):
        yield from _readings_of_places(model, q, data)


def _readings_of_places(model: AxesModel, q: Array, data: Measurements) -> Iterator[Reading]:
    T = model.fk(q)
    if (order := _matched(T[:, :3, 3], data.positions)) is not None:
        yield Reading(
            "the rows are shuffled",
            "Pair each measurement with the joints it was taken at.",
            q[: len(order)],
            data.rows(order),
            {},
        )
    if data.kind == "pose":
        back = replace(data, values=inverse(data.values))
        yield Reading("the poses are of the base seen from the tool", "Give their inverses.", q, back, {})
        turned = data.values.copy()
        turned[:, :3, :3] = np.swapaxes(turned[:, :3, :3], 1, 2)
        transposed = replace(data, values=turned)
        tool = tool_between(T, data.values)
        yield Reading(
            "another point or frame of the tool was measured",
            "Calibrate arm.with_tool(arm.tool @ error.tool): error.tool is what was measured in the arm's tool frame.",
            q,
            replace(data, values=data.values @ inverse(tool)),
            {"tool": tool},
            ALIGNED,
        )
        yield Reading("the rotations are transposed", "Transpose their 3 by 3 parts.", q, transposed, {})
    for mirrored in (False, True):
        X = frame_between(T[:, :3, 3], data.positions, mirrored)
        if mirrored:
            words = "they are said in a left-handed frame"
            cure = "Turn one axis of the measuring frame over."
        else:
            words, cure = (
                "they are measured in another frame",
                "Calibrate arm.with_base(error.frame @ arm.base): error.frame is the base in the measuring frame.",
            )
        places = (data.positions - X[:3, 3]) @ X[:3, :3]
        if data.kind == "pose":
            values = data.values.copy()
            values[:, :3, 3] = places
            # what a mirror does to orientations depends on who made them: positions alone must say it
            values[:, :3, :3] = T[:, :3, :3] if mirrored else X[:3, :3].T @ data.values[:, :3, :3]
        else:
            values = places
        yield Reading(words, cure, q, replace(data, values=values), {} if mirrored else {"frame": X}, ALIGNED)
    X, Y = frame_and_tool(T, data.values)
    back = inverse(X)
    values = back @ data.values @ inverse(Y) if data.kind == "pose" else _less(T, data.values, back, Y)
    yield Reading(
        "they are measured in another frame and of another point or frame of the tool",
        "Calibrate arm.with_base(error.frame @ arm.base).with_tool(arm.tool @ error.tool): error.frame is the base in "
        "the measuring frame, error.tool what was measured in the arm's tool frame.",
        q,
        replace(data, values=values),
        {"frame": X, "tool": Y},
        BOTH,
    )


def _less(T: Array, places: Array, back: Array, Y: Array) -> Array:
    """Return positions (N, 3) in the arm's frame, of the arm's own point of the tool."""
    return places @ back[:3, :3].T + back[:3, 3] - T[:, :3, :3] @ Y[:3, 3]


def _matched(expected: Array, measured: Array) -> np.ndarray | None:
    """Return the order (N,) in which measured positions are nearest to the expected ones, one to one; None if not."""
    if len(expected) > COMPARED:
        expected, measured = expected[:COMPARED], measured[:COMPARED]
    gap = np.linalg.norm(expected[:, None] - measured[None], axis=2)
    order = np.argmin(gap, axis=1)
    return order if len(np.unique(order)) > 0.8 * len(order) else None
