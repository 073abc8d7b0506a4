"""Tables and sentences that fit the terminal: columns are stacked where they do not fit, and no cell is ever cut."""

from __future__ import annotations

import math
import os
import sys
import textwrap
import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TextIO

GAP = 2
#: The narrowest a last column of words may become before all columns are stacked.
NARROW_WORDS = 24


@dataclass(frozen=True)
class Column:
    """A column: its heading, and whether it holds words (aligned left, may be broken between words) or numbers."""

    head: str
    words: bool = False


def terminal_width(stream: TextIO | None = None) -> int | None:
    """Return the width of the terminal that is written to; None for a pipe or a file, which have all the width.

    Args:
        stream: What is written to; standard output when left out.
    """
    if not (stream or sys.stdout).isatty():
        return None
    import shutil

    return max(20, shutil.get_terminal_size().columns)


def bold(text: str) -> str:
    """Return text in bold where the terminal can do that."""
    plain = not sys.stdout.isatty() or os.environ.get("TERM") == "dumb" or "NO_COLOR" in os.environ
    return text if plain or not text else f"\x1b[1m{text}\x1b[0m"


def sentences(text: str, width: int | None) -> str:
    """Return text with its long lines broken between words; the lines of a paragraph keep their indent."""
    if width is None:
        return text
    out = []
    for line in text.split("\n"):
        indent = line[: len(line) - len(line.lstrip())]
        out += _broken(line.strip(), width - len(indent), indent) or [""]
    return "\n".join(out)


def table(
    title: str,
    columns: Sequence[Column],
    rows: Sequence[Sequence[str]],
    width: int | None,
    *,
    strong: int | None = None,
) -> str:
    """Return a table as text.

    Where it is too wide, its last column is broken between words if it holds words; where that does not do, the columns
    after the first are stacked, in the same way for the headings and for every row.

    Args:
        title: A line above it.
        columns: Its columns; one that is empty in every row is left out.
        rows: Cells as text.
        width: Of the terminal; None where everything fits.
        strong: Number of a row to be set in bold.
    """
    kept = [j for j, c in enumerate(columns) if c.head or any(row[j] for row in rows)]
    columns, rows = [columns[j] for j in kept], [[row[j] for j in kept] for row in rows]
    widths = [max([_cells(c.head), *(_cells(row[j]) for row in rows)]) for j, c in enumerate(columns)]
    total = sum(widths) + GAP * (len(widths) - 1)
    rest = math.inf if width is None else width - (total - widths[-1])
    alone = False
    if width is None or total <= width:
        places = [list(range(len(columns)))]
    elif columns[-1].words and rest >= NARROW_WORDS:
        widths[-1], places = int(rest), [list(range(len(columns)))]
    else:
        longest = max((_longest(c, [row[j] for row in rows]) for j, c in enumerate(columns) if j), default=0)
        must = widths[0] + GAP + longest > width
        # under a long first column the others may need more lines than beneath it
        ways = [(a, *_evenly_stacked(columns, widths, width, a)) for a in ((True,) if must else (False, True))]
        alone, places, widths = min(ways, key=lambda way: _lines(columns, rows, *way[1:]))
    indent = GAP if alone else widths[0] + GAP
    head = _row([c.head for c in columns], columns, places, widths, indent)
    rule = "─" * max(len(line) for line in head) if width is None else "─" * min(width, _widest(places, widths, indent))
    lines = [bold(part) for part in sentences(title, width).splitlines()] + head + [rule]
    for i, row in enumerate(rows):
        printed = _row(row, columns, places, widths, indent)
        lines += [bold(line) for line in printed] if i == strong else printed
    return "\n".join(lines)


def _longest(column: Column, cells: Sequence[str]) -> int:
    """Return how wide a column must be at least: its longest word, or its longest number."""
    texts = [column.head, *cells]
    return max((_cells(word) for text in texts for word in (text.split() if column.words else [text])), default=0)


def _lines(columns: Sequence[Column], rows: Sequence[Sequence[str]], places: list[list[int]], widths: list[int]) -> int:
    """Return how many lines the headings and all rows take."""
    cells = [[c.head for c in columns], *rows]
    return sum(len(_row(row, columns, places, widths, 0)) for row in cells)


def _evenly_stacked(
    columns: Sequence[Column], widths: list[int], width: int, alone: bool
) -> tuple[list[list[int]], list[int]]:
    """Return which columns stand on which line, and their new widths, the lines as even as their number allows.

    What stands on a line of its own only because the one before is full reads as something left over; so the lines are
    made as narrow as they can be without one more of them, or a column broken that was whole.
    """
    room = max(1, width - (GAP if alone else widths[0] + GAP))
    best = _stacked(columns, widths, room, alone)
    for narrower in range(room - 1, 0, -1):
        other = _stacked(columns, widths, narrower, alone)
        if len(other[0]) > len(best[0]) or other[1] != best[1] or _split(columns, other[0]) > _split(columns, best[0]):
            break
        best = other
    return best


def _split(columns: Sequence[Column], places: list[list[int]]) -> int:
    """Return how many groups of columns stand on more than one line."""
    line = {j: k for k, at in enumerate(places) for j in at}
    return sum(line[group[0]] != line[group[-1]] for group in _groups(columns))


def _stacked(columns: Sequence[Column], widths: list[int], room: int, alone: bool) -> tuple[list[list[int]], list[int]]:
    """Return which columns stand on which line, and their new widths; the first may be so wide that it stands alone.

    Neighbouring columns of numbers get one width and, where one line does not hold them, lines of equal length. What
    fits beside what stands before it goes there.
    """
    widths = list(widths)
    places: list[list[int]] = []
    open_line = False
    for group in _groups(columns):
        each = max(widths[j] for j in group)
        each = min(each, room) if columns[group[0]].words else each
        most = max(1, (room + GAP) // (each + GAP))
        count = math.ceil(len(group) / most)
        per_line = math.ceil(len(group) / count)
        for j in group:
            widths[j] = each
        pieces = [group[i : i + per_line] for i in range(0, len(group), per_line)]
        used = sum(widths[j] + GAP for j in places[-1]) if open_line else 0
        if open_line and count == 1 and used + len(group) * (each + GAP) - GAP <= room:
            places[-1] += group
        else:
            places += pieces
        open_line = count == 1
    places = places or [[]]
    return ([[0], *places] if alone else [[0, *places[0]], *places[1:]]), widths


def _groups(columns: Sequence[Column]) -> list[list[int]]:
    """Return the columns after the first: neighbouring ones of numbers together, each one of words alone."""
    out: list[list[int]] = []
    for j in range(1, len(columns)):
        if out and not columns[j].words and not columns[j - 1].words and j > 1:
            out[-1].append(j)
        else:
            out.append([j])
    return out


def _row(
    cells: Sequence[str], columns: Sequence[Column], places: list[list[int]], widths: list[int], indent: int
) -> list[str]:
    """Return the lines of one row (or of the headings)."""
    out = []
    for k, line in enumerate(places):
        broken = {j: _broken(cells[j], widths[j], "") if columns[j].words else [cells[j]] for j in line}
        if k and not any(cells[j] for j in line):
            continue
        for i in range(max(1, *(len(b) for b in broken.values()))):
            parts = [_padded(b[i] if i < len(b) else "", widths[j], columns[j].words) for j, b in broken.items()]
            out.append(((" " * indent if k else "") + (" " * GAP).join(parts)).rstrip())
    return out


def _widest(places: list[list[int]], widths: list[int], indent: int) -> int:
    return max(
        sum(widths[j] for j in line) + GAP * (len(line) - 1) + (indent if k else 0) for k, line in enumerate(places)
    )


def _padded(text: str, width: int, left: bool) -> str:
    space = " " * max(0, width - _cells(text))
    return text + space if left else space + text


def _broken(text: str, width: int, indent: str) -> list[str]:
    return textwrap.wrap(
        text,
        max(width, 1) + len(indent),
        initial_indent=indent,
        subsequent_indent=indent,
        break_long_words=False,
        break_on_hyphens=False,
    )


def _cells(text: str) -> int:
    """Return how many places of a terminal a text takes: two for a wide character, none for a combining one."""
    if text.isascii():
        return len(text)
    return sum(0 if unicodedata.combining(c) else 2 if unicodedata.east_asian_width(c) in "WF" else 1 for c in text)
