"""An existing robot file brought up to date with a description; comments and layout stay."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from typing import Any

from pieper.description.dh import Description
from pieper.description.keys import POSE_STEMS
from pieper.description.quantity import UNITS, in_unit
from pieper.description.robotparse import parse
from pieper.description.robottext import contents, dumps
from pieper.errors import InputError


def rewritten(text: str, description: Description, file: str) -> str:
    """Return the text of a robot file with only that changed whose meaning has changed.

    Args:
        text: The existing file, a valid robot file.
        description: What it has to say.
        file: What messages call the file.

    Raises:
        InputError: tomlkit, which keeps the comments, is not installed.
    """
    try:
        import tomlkit
    except ImportError:
        raise InputError(
            f"{file!r} exists, and keeping its comments needs the package tomlkit: pip install tomlkit, "
            "or write to a new file name.",
            file=file,
        ) from None
    old_plain = contents(parse(text.encode(), file))
    if _same(old_plain, contents(description)):
        return text
    document = tomlkit.parse(text)
    _update(document, old_plain, contents(description), "", tomlkit)
    out = tomlkit.dumps(document)
    # the layout is a courtesy, the numbers are a promise: where tomlkit cannot keep both, the numbers win
    return out if _says(out, description, file) else dumps(description)


def _says(text: str, description: Description, file: str) -> bool:
    try:
        return _same(contents(parse(text.encode(), file)), contents(description))
    except (InputError, tomllib.TOMLDecodeError):
        return False


def _update(table: Any, old: dict, new: dict, section: str, tomlkit: Any) -> None:
    """Change a tomlkit table from what it says (old, in standard form) to what it should say (new)."""
    for key in _ordered(old, new):
        before, after = old.get(key), new.get(key)
        if _same(before, after):
            continue
        if key == "joints" and before and after and _names(before) == _names(after):
            for item, old_joint, new_joint in zip(table["joints"], before, after, strict=True):
                _replace_stems(item, old_joint, new_joint, _stem)
        elif key in ("base", "tool") and isinstance(before, dict) and isinstance(after, dict):
            _replace_stems(table[key], _flat(before), _flat(after), _pose_stem)
            if before.get("actuator") != after.get("actuator"):
                _put(table[key], "actuator", after.get("actuator"), tomlkit)
        elif key == "postures" and before and after:
            for name in _ordered(before, after):
                if not _same(before.get(name), after.get(name)):
                    _put(table[key], name, after.get(name), tomlkit)
        else:
            _put(table, key, after, tomlkit)


def _replace_stems(item: Any, old: dict, new: dict, stem: Callable[[str], str]) -> None:
    """Replace in a tomlkit table the keys of every stem whose meaning differs between old and new."""
    changed = {stem(k) for k in (*old, *new) if not _same(_of(old, stem, stem(k)), _of(new, stem, stem(k)))}
    for name in changed:
        present = [key for key in item if stem(key) == name]
        wanted = _of(new, stem, name)
        if len(present) == len(wanted) == 1:
            wanted = _in_unit_of(present[0], *wanted.items())
        stale = [key for key in present if key not in wanted]
        comments = [item.value.item(key).trivia.comment for key in stale]
        for key in stale:
            del item[key]
        for key, value in wanted.items():
            item[key] = value
        if any(comments) and wanted:
            item.value.item(next(iter(wanted))).comment(next(filter(None, comments)).lstrip("# "))


def _in_unit_of(key: str, said: tuple[str, object]) -> dict:
    """Return {key: value} in the unit the file already uses, where that is exact, else what was said."""
    units = [name.rpartition("_")[2] for name in (key, said[0])]
    # of another notation (a position against a whole matrix) the unit says nothing
    if _stem(key) != _stem(said[0]) or said[0].startswith("matrix"):
        return dict([said])
    if units[0] == units[1] or not all(unit in UNITS for unit in units):
        return dict([said])
    values = said[1] if isinstance(said[1], list) else [said[1]]
    converted = [in_unit(UNITS[units[1]][1](value), units[0]) for value in values]
    if None in converted:
        return dict([said])
    return {key: converted if isinstance(said[1], list) else converted[0]}


def _of(table: dict, stem: Callable[[str], str], name: str) -> dict:
    return {key: value for key, value in table.items() if stem(key) == name}


def _stem(key: str) -> str:
    return key.rpartition("_")[0] or key


def _pose_stem(key: str) -> str:
    return "pose" if any(key.startswith(stem) for stem in POSE_STEMS) else key


def _flat(table: dict) -> dict:
    return {key: value for key, value in table.items() if key != "actuator"}


def _names(joints: object) -> list | None:
    return [(joint["name"], joint["type"]) for joint in joints] if isinstance(joints, list) else None


def _same(a: object, b: object) -> bool:
    """Return whether two values print alike: 0 and -0.0 differ, nan equals nan."""
    return repr(a) == repr(b)


def _ordered(old: dict, new: dict) -> list[str]:
    return [*old, *(key for key in new if key not in old)]


def _put(table: Any, key: str, value: object, tomlkit: Any) -> None:
    """Set, replace or remove a key of a tomlkit table."""
    if value is None:
        if key in table:
            del table[key]
        return
    if isinstance(value, list) and value and isinstance(value[0], dict):
        tables = tomlkit.aot()
        for entry in value:
            tables.append(_as_table(entry, tomlkit))
        value = tables
    elif isinstance(value, dict):
        value = _as_table(value, tomlkit)
    elif isinstance(value, str) and "\n" in value:
        value = tomlkit.string(value, multiline=True)
    table[key] = value


def _as_table(content: dict, tomlkit: Any) -> Any:
    table = tomlkit.table()
    for key, value in content.items():
        table[key] = _as_table(value, tomlkit) if isinstance(value, dict) else value
    return table
