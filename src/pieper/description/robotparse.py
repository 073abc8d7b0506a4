"""The tables of a robot file, checked one by one, become a Description."""

from __future__ import annotations

import math
import tomllib
from dataclasses import replace

import numpy as np

from pieper.description.axes import UNIT_SLACK
from pieper.description.bodyfield import allowed_of, bodies_of
from pieper.description.commonnormal import standard_table
from pieper.description.dh import CONVENTIONS, DH, Actuator, Check, Description
from pieper.description.fields import needed_key, number, numbers, one_key, quantity
from pieper.description.fold import frames_of
from pieper.description.place import Place, kind_of
from pieper.description.posefield import pose_of
from pieper.description.quantity import UNITS, UNITS_OF
from pieper.description.said import describe
from pieper.errors import InputError
from pieper.kinematics.pose import inverse
from pieper.tolerances import TYPED_DIGITS
from pieper.words_by_number import plural

#: Larger than any robot file by far; what is larger is not one and is not parsed.
LARGEST_FILE = 1_000_000

TOP_KEYS = (
    "name",
    "manufacturer",
    "source",
    "notes",
    "payload_kg",
    "reach_mm",
    "reach_m",
    "departures",
    "convention",
    "joints",
    "base",
    "tool",
    "home",
    "coupling",
    "tools",
    "frames",
    "postures",
    "checks",
    "bodies",
    "collision",
)
#: Ways to say the joints: two kinds of DH table, and axes with points on them.
WAYS = (*CONVENTIONS, "axes")
KIND = {"a": "length", "alpha": "angle", "d": "length", "theta": "angle"}


def parse(data: bytes, file: str) -> Description:
    """Return the arm that the bytes of a robot file describe; `file` is what messages call it."""
    if len(data) > LARGEST_FILE:
        raise InputError(f"{file}: larger than {LARGEST_FILE:,} bytes; this is not a robot file.", file=file)
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise InputError(
            f"{file}: not a text in UTF-8 (byte {error.start} is 0x{data[error.start]:02x}); this is not a robot file.",
            file=file,
        ) from None
    try:
        document = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise InputError(f"{file}: not valid TOML: {error}.", file=file) from None
    except RecursionError:
        raise InputError(f"{file}: nested too deeply for a robot file.", file=file) from None
    return _description(document, Place(file, text))


def _description(document: dict, top: Place) -> Description:
    top.only(document, TOP_KEYS)
    convention = top.text_of(document, "convention")
    if convention not in WAYS:
        top.fail(
            f'{convention!r} is unknown; say "standard" (distal DH), "modified" (proximal DH, Craig) or "axes" (joint '
            "axes and points on them, with the tool's pose at zero in [home]).",
            "convention",
            given=convention,
            allowed=WAYS,
        )
    if convention != "axes" and "home" in document:
        top.fail('belongs to convention = "axes"; a DH table says the tool at zero by itself.', "home")
    joints = _tables(document, "joints", top)
    if not joints:
        top.fail("the arm has no joints; each is a table [[joints]] in joint order.", None, missing="joints")
    names, types, rows, limits, signs, offsets = [], [], [], [], [], []
    linked: list[int] = []
    for index, table in enumerate(joints):
        name = table.get("name", f"joint_{index + 1}")
        place = top.at("joints", index, name if isinstance(name, str) else None)
        if place.text_of(table, "name", name) in names:
            place.fail(f"the name {name!r} is used twice; joint names must differ.", "name")
        names.append(name)
        if _linked(table, place):
            linked.append(index)
        kind, row, bounds, sign, offset = _joint(table, place, convention)
        types.append(kind)
        rows.append(row)
        if index not in linked:
            limits.append(bounds)
        signs.append(sign)
        offsets.append(offset)
    if linked and "coupling" not in document:
        top.fail(
            f"{names[linked[0]]} is linked, and no coupling says what moves it: {plural(len(names), 'row')} of "
            f"{plural(len(limits), 'number')}, angles of the axes = coupling x joint values.",
            None,
            missing="coupling",
        )
    kinds = "".join(kind for index, kind in enumerate(types) if index not in linked)
    base = said_base = pose_of(top.table(document.get("base", {}), "base"), top.at("base"))
    tool_table = top.table(document.get("tool", {}), "tool")
    said = {
        "name": top.text_of(document, "name"),
        **{key: top.text_of(document, key, "") for key in ("manufacturer", "source", "notes")},
        "departures": _departures(document, top),
        "coupling": _coupling(document, len(names), len(limits), top),
        "tools": _poses(document, "tools", top),
        "frames": _poses(document, "frames", top),
        "actuator": _actuator(tool_table, top),
        "postures": _postures(document, kinds, top),
        "checks": [
            _check(table, kinds, top.at("checks", index))
            for index, table in enumerate(_tables(document, "checks", top))
        ],
    }
    tool = pose_of(tool_table, top.at("tool"), also=("actuator",))
    if convention == "axes":
        home = pose_of(top.table(document.get("home", {}), "home"), top.at("home"))
        table = standard_table(np.array([axis for axis, _ in rows]), np.array([point for _, point in rows]), home)
        # what stands after the last row of the table is part of every tool
        said["tools"] = {name: table.tool @ T for name, T in said["tools"].items()}
        rows, base, tool, convention = table.rows, base @ table.base, table.tool @ tool, "standard"
    bodies = bodies_of(_tables(document, "bodies", top), names, top)
    allowed = allowed_of(document, [body.name for body in bodies], top)
    try:
        arm = describe(
            rows,
            convention=convention,
            base=base,
            tool=tool,
            joint_types="".join(types),
            joint_names=names,
            linked=linked,
            limits=limits,
            sign=signs,
            offset=offsets,
            **said,
        )
    except InputError as error:
        raise InputError(
            f"{top.file}: {error}", file=top.file, **{k: v for k, v in error.data.items() if k != "file"}
        ) from None
    if document["convention"] == "axes" and bodies:
        # where no table is said, neither are its frames: bodies are said in the base's, all joints at zero
        frames = frames_of(arm, np.zeros(arm.n))
        bodies = tuple(body.moved(inverse(frames[body.on]) @ said_base) for body in bodies)
    return replace(arm, bodies=bodies, allowed=allowed, payload=_payload(document, top), reach=_reach(document, top))


def _linked(table: dict, place: Place) -> bool:
    """Whether a table is of an axis that a linkage moves, which has no number of its own and no limits."""
    said = table.get("linked", False)
    if not isinstance(said, bool):
        place.fail(f"must be true or false, got {kind_of(said)}.", "linked", given=said)
    limits = [key for key in table if key.startswith("limits_")]
    if said and limits:
        place.fail("an axis that a linkage moves has no limits of its own; those of the joints hold it.", limits[0])
    return said


def _joint(
    table: dict, place: Place, convention: str
) -> tuple[str, DH | tuple[list[float], list[float]], tuple[float, float], float, float]:
    """Return type letter, DH row (or axis and point), limits, sign and offset of one joint, SI."""
    said = place.text_of(table, "type")
    letter = {"revolute": "R", "r": "R", "prismatic": "P", "p": "P"}.get(said.lower())
    if letter is None:
        place.fail(f'{said!r} is not a joint type; say "revolute" or "prismatic" (R or P).', "type", given=said)
    own = "angle" if letter == "R" else "length"
    variable = "theta" if letter == "R" else "d"
    allowed = ["name", "type", "linked"]
    if convention == "axes":
        allowed += ["axis", "point_mm", "point_m"]
    else:
        allowed += [f"{column}_{unit}" for column, kind in KIND.items() for unit in UNITS_OF[kind]]
    allowed += ["sign", *(f"{key}_{unit}" for key in ("offset", "limits") for unit in UNITS_OF[own])]
    place.only(table, allowed)
    if convention == "axes":
        row = _axis(table, place, letter)
    else:
        columns = {
            column: quantity(table, column, kind, place, default=0.0 if column == variable else None)
            for column, kind in KIND.items()
        }
        row = DH(**columns)
    sign = table.get("sign", 1)
    if isinstance(sign, bool) or sign not in (1, -1):
        place.fail(f"must be 1 or -1, got {kind_of(sign)}.", "sign", given=sign)
    offset = quantity(table, "offset", own, place, default=0.0)
    return letter, row, _limits(table, own, place), float(sign), offset


def _axis(table: dict, place: Place, letter: str) -> tuple[list[float], list[float]]:
    """Return the unit axis and a point on it, m, of a joint that is said that way."""
    if "axis" not in table:
        place.fail("the key 'axis' is missing: three numbers, the direction of the joint's axis at zero.", None)
    axis = numbers(table["axis"], "", 3, place, "axis")
    length = math.hypot(*axis)
    if abs(length - 1) > UNIT_SLACK:
        place.fail(f"must be of length 1 (within {UNIT_SLACK:g}), it is of length {length:.6g}.", "axis", given=axis)
    key, unit = one_key(table, "point", UNITS_OF["length"], place, required=letter == "R")
    point = [0.0, 0.0, 0.0] if key is None else numbers(table[key], unit, 3, place, key)
    return [x / length for x in axis], point


def _coupling(document: dict, axes: int, n: int, top: Place) -> list[list[float]] | None:
    if "coupling" not in document:
        return None
    value = document["coupling"]
    if not isinstance(value, list) or len(value) != axes:
        which = "an axis" if axes > n else "a joint"
        top.fail(
            f"must be {plural(axes, 'row')} of {plural(n, 'number')}, one {which}, got {kind_of(value)}.",
            "coupling",
            given=value,
        )
    return [numbers(row, "", n, top, "coupling") for row in value]


def _poses(document: dict, key: str, top: Place) -> dict[str, np.ndarray]:
    named = top.table(document.get(key, {}), key)
    return {name: pose_of(top.table(table, name), top.at(f"{key}.{name}")) for name, table in named.items()}


def _limits(table: dict, kind: str, place: Place) -> tuple[float, float]:
    key, unit = one_key(table, "limits", UNITS_OF[kind], place, required=False)
    if key is None:
        return -math.inf, math.inf
    lower, upper = numbers(table[key], unit, 2, place, key, infinite=True)
    if lower > upper:
        place.fail(
            f"the limits are swapped: lower {table[key][0]} is above upper {table[key][1]}.", key, given=table[key]
        )
    return lower, upper


def _payload(document: dict, top: Place) -> float | None:
    if "payload_kg" not in document:
        return None
    value = number(document["payload_kg"], "", top, "payload_kg")
    return _above_zero(value, "payload_kg", top)


def _reach(document: dict, top: Place) -> float | None:
    key, unit = one_key(document, "reach", UNITS_OF["length"], top, required=False)
    return None if key is None else _above_zero(number(document[key], unit, top, key), key, top)


def _above_zero(value: float, key: str, top: Place) -> float:
    if value <= 0:
        top.fail(f"must be above zero, got {value:g}; leave it out where it is not known.", key, given=value)
    return value


def _departures(document: dict, top: Place) -> tuple[str, ...]:
    value = document.get("departures", [])
    if not isinstance(value, list) or any(not isinstance(item, str) for item in value):
        top.fail(f"must be a list of texts, got {kind_of(value)}.", "departures")
    return tuple(value)


def _actuator(tool: dict, top: Place) -> Actuator | None:
    if "actuator" not in tool:
        return None
    place = top.at("tool.actuator")
    table = place.table(tool["actuator"], "actuator")
    place.only(table, ("name", *(f"{key}_{unit}" for key in ("limits", "value") for unit in UNITS)))
    key, unit = needed_key(table, "limits", UNITS, place)
    lower, upper = numbers(table[key], unit, 2, place, key)
    if lower > upper:
        place.fail(f"the limits are swapped: lower {table[key][0]} is above upper {table[key][1]}.", key)
    kind, si = UNITS[unit][0], UNITS_OF[UNITS[unit][0]][1]
    for other in UNITS:
        if UNITS[other][0] != kind and f"value_{other}" in table:
            place.fail(f"the value and the limits must both be an {kind} or both a length.", f"value_{other}")
    value = quantity(table, "value", kind, place, default=lower)
    if not lower <= value <= upper:
        place.fail("the value is outside the limits.", "value", given=value)
    return Actuator(place.text_of(table, "name"), lower, upper, value, si)


def q_units(kinds: str) -> tuple[str, ...]:
    """Return the unit words a joint vector's key may have: deg and rad, mm and m, or both where joints differ."""
    if "P" not in kinds:
        return UNITS_OF["angle"]
    if "R" not in kinds:
        return UNITS_OF["length"]
    return ("deg_mm", "rad_m", "deg_m", "rad_mm")


def _joint_vector(table: dict, kinds: str, place: Place) -> np.ndarray:
    key, unit = needed_key(table, "q", q_units(kinds), place)
    angle, _, length = unit.partition("_")
    units = [angle if kind == "R" or not length else length for kind in kinds]
    value = table[key]
    if not isinstance(value, list) or len(value) != len(kinds):
        place.fail(f"must be a list of {plural(len(kinds), 'number')}, one a joint, got {kind_of(value)}.", key)
    return np.array([number(item, unit, place, key) for item, unit in zip(value, units, strict=True)])


def _postures(document: dict, kinds: str, top: Place) -> dict[str, np.ndarray]:
    named = {}
    for name, table in top.table(document.get("postures", {}), "postures").items():
        place = top.at(f"postures.{name}")
        place.only(place.table(table, name), [f"q_{unit}" for unit in q_units(kinds)])
        named[name] = _joint_vector(table, kinds, place)
    return named


def _check(table: dict, kinds: str, place: Place) -> Check:
    q_keys = [f"q_{unit}" for unit in q_units(kinds)]
    also = (*q_keys, "source", "tolerance_m", "tolerance_mm")
    T = pose_of(table, place, also=also, unknown=True)
    if np.all(np.isnan(T[:3])):
        place.fail("nothing is said of the pose; give a position, a rotation or a matrix.")
    tolerance = quantity(table, "tolerance", "length", place, default=TYPED_DIGITS)
    if tolerance <= 0:
        place.fail("the tolerance must be above zero.", "tolerance_m")
    return Check(_joint_vector(table, kinds, place), T, place.text_of(table, "source"), tolerance)


def _tables(document: dict, key: str, top: Place) -> list[dict]:
    value = document.get(key, [])
    if not isinstance(value, list) or any(not isinstance(item, dict) for item in value):
        top.fail(f"must be an array of tables, each under [[{key}]], got {kind_of(value)}.", key)
    return value
