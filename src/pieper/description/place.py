"""Where in a robot file something stands, so that a message can name file, line, joint and key."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import NoReturn

from pieper.errors import InputError


@dataclass(frozen=True)
class Place:
    """A spot in a robot file.

    Args:
        file: What to call the file.
        text: Its text, to find the line in.
        section: The table: "" for the top, "joints", "base", "tool", "tool.actuator", "postures.home", "checks".
        index: 0-based position in an array of tables, None elsewhere.
        joint: Name of the joint, if the table is one of a joint.
    """

    file: str
    text: str = ""
    section: str = ""
    index: int | None = None
    joint: str | None = None

    def at(self, section: str, index: int | None = None, joint: str | None = None) -> Place:
        """Return the place of another table of the same file."""
        return replace(self, section=section, index=index, joint=joint)

    def line(self, key: str | None = None) -> int | None:
        """Return the 1-based line of a key of this table (of its header when key is None), None if not found."""
        header = re.compile(r"^\s*\[+\s*([^\[\]]+?)\s*\]+\s*(#.*)?$")
        inside, seen, start = self.section == "", -1, None
        for number, text in enumerate(self.text.splitlines(), 1):
            match = header.match(text)
            if match:
                if start is not None:
                    break
                inside = match.group(1).replace('"', "") == self.section
                if inside:
                    seen += 1
                    inside = self.index is None or seen == self.index
                    start = number if inside else None
                if inside and key is None:
                    return number
            elif inside and key is not None and re.match(rf'^\s*"?{re.escape(key)}"?\s*=', text):
                return number
        return start if key is not None else None

    def fail(self, message: str, key: str | None = None, **data: object) -> NoReturn:
        """Raise an InputError that names file, line, table or joint, and key.

        Args:
            message: What was given, what is allowed.
            key: The key it is about.
            **data: Attributes of the error.
        """
        line = self.line(key)
        parts = [self.file if line is None else f"{self.file}, line {line}"]
        if self.section == "joints" and self.index is not None:
            named = f" ({self.joint!r})" if self.joint else ""
            parts.append(f"joint {self.index + 1}{named}")
        elif self.index is not None:
            parts.append(f"{self.section} entry {self.index + 1}")
        elif self.section:
            parts.append(f"[{self.section}]")
        if key is not None:
            parts.append(key)
        raise InputError(
            f"{', '.join(parts)}: {message}",
            file=self.file,
            line=line,
            key=key,
            joint=self.joint,
            index=self.index,
            **data,
        )

    def table(self, value: object, key: str) -> dict:
        """Return value if it is a table, or say that it must be one."""
        if not isinstance(value, dict):
            self.fail(f"this must be a table, got {kind_of(value)}.", key)
        return value

    def text_of(self, table: dict, key: str, default: str | None = None) -> str:
        """Return a string of the table; without a default the key must be there."""
        if key not in table:
            if default is None:
                self.fail(f"the key {key!r} is missing; it must be a text in quotes.", None, missing=key)
            return default
        value = table[key]
        if not isinstance(value, str):
            self.fail(f"must be a text in quotes, got {kind_of(value)}.", key, given=value)
        return value

    def only(self, table: dict, allowed: Iterable[str]) -> None:
        """Refuse keys other than the allowed ones, with the nearest allowed key as a suggestion."""
        allowed = list(allowed)
        for key in table:
            if key in allowed:
                continue
            hint = wrong_unit(key, allowed)
            if not hint:
                import difflib

                close = difflib.get_close_matches(key, allowed, n=1, cutoff=0.6)
                hint = f"Did you mean {close[0]!r}? " if close else ""
            self.fail(f"this key is unknown. {hint}Allowed here: {', '.join(allowed)}.", key, allowed=allowed)


def wrong_unit(key: str, allowed: Iterable[str]) -> str:
    """Return what to say of a key whose stem is known but whose unit is wrong or missing, else an empty text."""
    stem, _, unit = key.rpartition("_")
    for name in (stem, key):
        units = [other for other in allowed if other.rpartition("_")[0] == name and name]
        if units:
            wrong = (
                f"The unit {unit!r} is not one of {name!r}" if name == stem else f"{name!r} needs its unit in the key"
            )
            return f"{wrong}: use {' or '.join(units)}. "
    return ""


def kind_of(value: object) -> str:
    """Return what people call a TOML value: a text, a number, a table ..., with the value where it is short."""
    if isinstance(value, bool):
        return f"the truth value {str(value).lower()}"
    if isinstance(value, str):
        return f"the text {value[:40]!r}"
    if isinstance(value, (int, float)):
        return f"the number {value}"
    if isinstance(value, list):
        return f"a list of {len(value)}"
    if isinstance(value, dict):
        return "a table"
    return f"a {type(value).__name__}"
