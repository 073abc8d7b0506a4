"""The lines of a claims file: where its tables and keys stand, so that a reason can say which line to mend."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager

from pieper.errors import InputError

#: The names and numbers that lead to a value: ("claim", 3, "is"), the third [[claim]] from 1, or ("symbols", "k1").
Place = tuple[str | int, ...]

_KEY = r"""(?:[\w-]+|"[^"\n]*"|'[^'\n]*')"""
_PATH = rf"{_KEY}(?:\s*\.\s*{_KEY})*"
_HEADER = re.compile(rf"\s*(\[\[?)\s*({_PATH})\s*\]")
_ENTRY = re.compile(rf"\s*({_PATH})\s*=")
#: What decides where a value ends: strings whole (an escaped quote belongs to them), comments, brackets.
_TOKEN = re.compile(r'"""|\'\'\'|"(?:\\.|[^"\\\n])*"|\'[^\'\n]*\'|#[^\n]*|[\[\]{}]')


@contextmanager
def standing(*place: str | int) -> Iterator[None]:
    """Note on an error where in the file the cause stands, unless the error knows already; its key comes last."""
    try:
        yield
    except InputError as error:
        key = error.data.get("key")
        error.data.setdefault("place", (*place, key) if isinstance(key, str) else place)
        raise


def in_its_line(error: InputError, name: str, text: str) -> InputError:
    """The same error with the line behind the file's name, as far as the line is known."""
    line = _line_of(error.data.get("place"), _places(text))
    said = str(error)
    if line is None or not said.startswith(f"{name}: "):
        return error
    return type(error)(f"{name}, line {line}{said[len(name) :]}", **{**error.data, "line": line})


def _line_of(place: object, known: dict[Place, int]) -> int | None:
    """The line of a place, or of the nearest table around it that has one."""
    path = place if isinstance(place, tuple) else ()
    return next((known[path[:n]] for n in range(len(path), 0, -1) if path[:n] in known), None)


def _places(text: str) -> dict[Place, int]:
    """The line, from 1, on which every table and every key of a TOML text that can be read stands first."""
    out: dict[Place, int] = {}
    counts: dict[Place, int] = {}
    table: Place = ()
    quote, depth = "", 0
    for line, words in enumerate(text.split("\n"), 1):
        at = 0
        if not quote and not depth:
            header, entry = _HEADER.match(words), _ENTRY.match(words)
            if header:
                table = _counted(_names(header[2]), counts, again=header[1] == "[[")
                for n in range(1, len(table) + 1):  # the first of several stands for all of them too
                    out.setdefault(table[:n], line)
                continue
            if entry:
                path = (*table, *_names(entry[1]))
                for n in range(len(table) + 1, len(path) + 1):
                    out.setdefault(path[:n], line)
                at = entry.end()
        quote, depth = _left_open(words, at, quote, depth)
    return out


def _left_open(words: str, at: int, quote: str, depth: int) -> tuple[str, int]:
    """Whether a long string is open at the end of a line, and how many brackets are."""
    while at < len(words):
        if quote:
            end = words.find(quote, at)
            if end < 0:
                return quote, depth
            at, quote = end + 3, ""
            continue
        token = _TOKEN.search(words, at)
        if not token:
            break
        at = token.end()
        if token[0] in ('"""', "'''"):
            quote = token[0]
        elif token[0] in "[{":
            depth += 1
        elif token[0] in "]}":
            depth -= 1
    return quote, depth


def _names(path: str) -> list[str]:
    return [name.strip("\"'") for name in re.findall(_KEY, path)]


def _counted(names: list[str], counts: dict[Place, int], *, again: bool) -> Place:
    """The place of a table: a name of [[several]] is followed by the number of the one that is meant."""
    place: Place = ()
    for k, name in enumerate(names, 1):
        place = (*place, name)
        if again and k == len(names):
            counts[place] = counts.get(place, 0) + 1
        if place in counts:
            place = (*place, counts[place])
    return place
