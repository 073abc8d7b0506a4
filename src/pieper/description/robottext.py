"""Descriptions as the text of robot files: new text, or an existing file changed only where its meaning changes."""

from __future__ import annotations

import math

import numpy as np

from pieper.description.bodyfield import body_tables
from pieper.description.dh import Actuator, Check, Description
from pieper.description.keys import pose_keys, quantity_key
from pieper.description.quantity import best_unit, in_unit, same_bits
from pieper.tolerances import TYPED_DIGITS

#: Texts longer than this are folded.
_LONG_TEXT = 110


def contents(description: Description) -> dict:
    """Return a description as the tables of a robot file, in the units people choose where those are exact."""
    top: dict = {"name": description.name}
    for key in ("manufacturer", "source", "notes"):
        if getattr(description, key):
            top[key] = getattr(description, key)
    if description.payload is not None:
        top["payload_kg"] = in_unit(description.payload, "m")
    if description.reach is not None:
        top |= quantity_key("reach", [description.reach], "length", single=True)
    if description.departures:
        top["departures"] = list(description.departures)
    top["convention"] = description.convention
    top["joints"] = [_joint(description, index) for index in range(len(description.rows))]
    if base := pose_keys(description.base):
        top["base"] = base
    tool = pose_keys(description.tool)
    if description.actuator is not None:
        tool["actuator"] = _actuator(description.actuator)
    if tool:
        top["tool"] = tool
    if description.coupling is not None:
        top["coupling"] = [[in_unit(float(value), "m") for value in row] for row in description.coupling]
    for key, poses in (("tools", description.tools), ("frames", description.frames)):
        if poses:
            top[key] = {name: pose_keys(T) for name, T in poses.items()}
    if description.postures:
        top["postures"] = {name: _joint_vector(q, description.joint_types) for name, q in description.postures.items()}
    from pieper.description.tree_bodies import known_bodies  # reads meshes of URDFs; most arms have none

    if bodies := known_bodies(description)[0]:
        top["bodies"] = body_tables(bodies, description.axis_names)
    if description.allowed:
        top["collision"] = {"allowed": [list(pair) for pair in description.allowed]}
    if description.checks:
        top["checks"] = [_check(check, description.joint_types) for check in description.checks]
    return top


def dumps(description: Description) -> str:
    """Return the text of a robot file; reading it gives every number back to the last bit."""
    return text_of(contents(description))


def text_of(top: dict) -> str:
    """Return the tables of a robot file as its text."""
    lines: list[str] = []
    for key, value in top.items():
        if not isinstance(value, dict) and not _is_tables(value):
            lines.append(f"{key} = {_value(value)}")
    for key, value in top.items():
        if _is_tables(value):
            for table in value:
                lines += ["", f"[[{key}]]", *_table(table)]
        elif isinstance(value, dict):
            plain = {k: v for k, v in value.items() if not isinstance(v, dict)}
            if plain:
                lines += ["", f"[{key}]", *_table(plain)]
            for name, table in value.items():
                if isinstance(table, dict):
                    lines += ["", f"[{key}.{_key(name)}]", *_table(table)]
    return "\n".join(lines) + "\n"


def _joint(description: Description, index: int) -> dict:
    revolute = description.axis_types[index] == "R"
    own, row = ("angle" if revolute else "length"), description.rows[index]
    table: dict = {"name": description.axis_names[index], "type": "revolute" if revolute else "prismatic"}
    joint = description.own_axes.index(index) if index in description.own_axes else None
    if joint is None:
        table["linked"] = True
    for column, kind in (("a", "length"), ("alpha", "angle"), ("d", "length"), ("theta", "angle")):
        value = getattr(row, column)
        if column != ("theta" if revolute else "d") or not same_bits(value, 0.0):
            table |= quantity_key(column, [value], kind, single=True)
    if description.sign[index] != 1:
        table["sign"] = -1
    if not same_bits(float(description.offset[index]), 0.0):
        table |= quantity_key("offset", [float(description.offset[index])], own, single=True)
    limits = [-math.inf, math.inf] if joint is None else [float(v) for v in description.limits[joint]]
    if limits != [-math.inf, math.inf]:
        table |= quantity_key("limits", limits, own)
    return table


def _actuator(actuator: Actuator) -> dict:
    kind = "angle" if actuator.unit == "rad" else "length"
    unit = best_unit([actuator.lower, actuator.upper, actuator.value], kind)
    lower, upper, value = (in_unit(v, unit) for v in (actuator.lower, actuator.upper, actuator.value))
    return {"name": actuator.name, f"limits_{unit}": [lower, upper], f"value_{unit}": value}


def _joint_vector(q: np.ndarray, kinds: str) -> dict:
    words: list[str] = []
    said: list[float | int | None] = [0.0] * len(kinds)
    for letter, kind in (("R", "angle"), ("P", "length")):
        joints = [i for i, other in enumerate(kinds) if other == letter]
        if joints:
            unit = best_unit([float(q[i]) for i in joints], kind)
            words.append(unit)
            for i in joints:
                said[i] = in_unit(float(q[i]), unit)
    return {f"q_{'_'.join(words)}": said}


def _check(check: Check, kinds: str) -> dict:
    table = {"source": check.source, **_joint_vector(check.q, kinds)}
    table |= pose_keys(check.T, unsaid="unknown")
    if check.tolerance != TYPED_DIGITS:
        table |= quantity_key("tolerance", [check.tolerance], "length", single=True)
    return table


def _is_tables(value: object) -> bool:
    return isinstance(value, list) and bool(value) and isinstance(value[0], dict)


def _table(table: dict) -> list[str]:
    return [f"{_key(key)} = {_value(value)}" for key, value in table.items()]


def _folded(text: str) -> str:
    """Return a long line as a TOML string broken at single spaces; a backslash joins the lines again."""
    lines = [""]
    for word in _string(text)[1:-1].split(" "):
        # a break may only stand before a word: white space after it would be swallowed
        if word and lines[-1].strip() and len(lines[-1]) + len(word) > _LONG_TEXT:
            lines.append("")
        lines[-1] += word + " "
    return '"""\\\n' + "\\\n".join(lines)[:-1] + '"""'


def _key(name: str) -> str:
    bare = name.isascii() and name.replace("_", "a").replace("-", "a").isalnum()
    return name if bare else _string(name)


def _value(value: object) -> str:
    if isinstance(value, str):
        if "\n" in value:
            return _multiline(value)
        return _string(value) if len(value) < _LONG_TEXT or value.startswith(" ") else _folded(value)
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, list):
        nested = bool(value) and isinstance(value[0], (list, str))
        items = [_value(item) for item in value]
        return "[\n" + "".join(f"    {item},\n" for item in items) + "]" if nested else f"[{', '.join(items)}]"
    return repr(value)


def _string(text: str) -> str:
    out = text.replace("\\", "\\\\").replace('"', '\\"').replace("\t", "\\t")
    return '"' + "".join(c if c >= " " and c != "\x7f" else f"\\u{ord(c):04x}" for c in out) + '"'


def _multiline(text: str) -> str:
    lines = (_string(line)[1:-1] for line in text.split("\n"))
    return '"""\n' + "\n".join(lines) + '"""'
