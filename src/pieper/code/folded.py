"""Blocks of C that differ in nothing but the values they begin with, written once, in a loop."""

from __future__ import annotations

import re
from collections.abc import Sequence

_NAME = re.compile(r"\b(?:v[0-9A-Z]+|w[0-9A-Z]+_[0-9A-Z]+)\b")
_ROW = re.compile(r"\b(rows|valid)\[(\d+)\]")
_FOUND = re.compile(r"(?:const )?(?:double|int) (.*);$")


def folded(blocks: Sequence[Sequence[str]], margin: str) -> list[str] | None:
    """Return a loop that does what blocks of lines do one after the other; None where they are not alike.

    Args:
        blocks: Two or more, a definition a line.
        margin: What lines begin with.
    """
    texts = ["\n".join(block) for block in blocks]
    inner = [_defined(block) for block in blocks]
    shapes, outer, rows = zip(*map(_shape, texts, inner), strict=True)
    if len(set(shapes)) > 1:
        return None
    step = rows[1][0] - rows[0][0] if rows[0] else 0
    if any(row != [first + step * k for first in rows[0]] for k, row in enumerate(rows)):
        return None
    # a place in the text -> its name in each block; what is called alike everywhere keeps its name
    places: dict[tuple[str, ...], int] = {}
    for names in zip(*outer, strict=True):
        if len(set(names)) > 1:
            places.setdefault(names, len(places))
    said: list[str] = []
    at, row_at = iter(zip(*outer, strict=True)), iter(rows[0])

    def name(found: re.Match[str]) -> str:
        if found[0] in inner[0]:
            return found[0]
        names = next(at)
        return f"its[{places[names]}]" if names in places else found[0]

    def row(found: re.Match[str]) -> str:
        return f"{found[1]}[{step} * each + {next(row_at)}]"

    for line in blocks[0]:
        said.append(" " + _ROW.sub(row, _NAME.sub(name, line)))
    table = ", ".join("{" + ", ".join(names[k] for names in places) + "}" for k in range(len(blocks)))
    room = f"{margin} const double given_to[{len(blocks)}][{len(places)}]"
    return [
        f"{margin}for (each = 0; each < {len(blocks)}; ++each) {{",
        *_wrapped(f"{room} = {{{table}}}, *const its = given_to[each];", margin),
        *said,
        f"{margin}}}",
    ]


def _wrapped(line: str, margin: str, width: int = 112) -> list[str]:
    out, rest = [], line
    while len(rest) > width and (cut := rest.rfind(", ", len(margin) + 4, width)) > 0:
        out.append(rest[: cut + 1])
        rest = f"{margin}   {rest[cut + 2 :]}"
    return [*out, rest]


def _defined(block: Sequence[str]) -> set[str]:
    """Return the names that a block finds itself."""
    return {found[1].split(" = ")[0] for line in block if (found := _FOUND.match(line.strip())) and " = " in found[1]}


def _shape(text: str, inner: set[str]) -> tuple[str, list[str], list[int]]:
    """Return a text without names, the names from outside in their order, and the rows it speaks of."""
    outer: list[str] = []
    rows: list[int] = []
    numbers: dict[str, int] = {}

    def name(found: re.Match[str]) -> str:
        if found[0] in inner:
            return f"n{numbers.setdefault(found[0], len(numbers))}"
        outer.append(found[0])
        return "o"

    def row(found: re.Match[str]) -> str:
        rows.append(int(found[2]))
        return found[1]

    return _ROW.sub(row, _NAME.sub(name, text)), outer, rows
