"""A page as data: headings, sentences, formulas, tables, figures in reading order; how they look is decided elsewhere.

Nothing here is markup. A sentence with a formula or a typed word in it is a tuple of pieces; what one may want to count
with (the number of a step, of its solutions, of an equation) is a field.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol


class Formula(Protocol):
    """Anything that can be set as a formula: an expression, or a `formulas.Written`."""

    def text(self) -> str:
        """Return one line (a matrix: several) of plain text."""
        ...

    def latex(self) -> str:
        """Return LaTeX for math mode."""
        ...

    def mathml(self) -> str:
        """Return presentation MathML without the outer <math> element."""
        ...


class Drawing(Protocol):
    """A figure that can be written as a file."""

    def svg(self) -> str:
        """Return SVG text."""
        ...

    def pdf(self) -> bytes:
        """Return a PDF file."""
        ...

    def png(self) -> bytes:
        """Return a PNG file."""
        ...


@dataclass(frozen=True)
class Code:
    """Words inside a sentence as they are typed."""

    words: str


@dataclass(frozen=True)
class Emphasis:
    """Words inside a sentence that are set off."""

    words: str


#: A decimal number in a cell, with a unit behind it.
NUMBER = re.compile(r"([-−]?\d+)(\.\d+)?(°| mm| m)?")

#: What a sentence is made of.
Piece = str | Code | Emphasis | Formula


@dataclass(frozen=True)
class Heading:
    """A heading; level 1 is a section, 2 a subsection."""

    pieces: tuple[Piece, ...]
    level: int = 1
    numbered: bool = True


@dataclass(frozen=True)
class Step:
    """The heading of a step of a derivation.

    Attributes:
        number: 1, 2, ...
        solves: What it solves for.
        branches: How many solutions it has.
    """

    number: int
    solves: Formula
    branches: int = 1

    @property
    def heading(self) -> Heading:
        """The step as a heading without a number of the page's own."""
        return Heading((f"Step {self.number}: ", self.solves), level=2, numbered=False)


@dataclass(frozen=True)
class Paragraph:
    """Sentences; a `Formula` among the pieces stands inside the line."""

    pieces: tuple[Piece, ...]


@dataclass(frozen=True)
class Note:
    """Sentences beside the matter, such as why a part is missing."""

    pieces: tuple[Piece, ...]


@dataclass(frozen=True)
class Lines:
    """A list of short items."""

    items: tuple[Piece, ...]
    numbered: bool = False


@dataclass(frozen=True)
class Equation:
    """A formula on a line of its own.

    Attributes:
        sides: Joined by equals signs.
        number: The number by which it is referred to, in brackets at the margin.
        name: What it is, for programs (`p_x`); never printed.
    """

    sides: tuple[Formula, ...]
    number: int | None = None
    name: str = ""


@dataclass(frozen=True)
class Equations:
    """Several displayed formulas that belong together: below each other, or `beside` each other where they fit."""

    rows: tuple[Equation, ...]
    beside: bool = False


@dataclass(frozen=True)
class Table:
    """A table with its caption.

    Attributes:
        head: Column headings, units included.
        rows: Cells.
        caption: One sentence.
        left: Columns (0-based) aligned left; the others are aligned right.
        strong: Rows (0-based) to be set off.
    """

    head: tuple[Piece, ...]
    rows: tuple[tuple[Piece, ...], ...]
    caption: str = ""
    left: tuple[int, ...] = (0,)
    strong: tuple[int, ...] = ()


@dataclass(frozen=True, eq=False)
class Picture:
    """A figure with its caption.

    Attributes:
        drawing: The figure.
        caption: What one sees.
        name: A file name without a suffix.
        width: Share of the text's width, 0 to 1; above 1 it may stand out into the margins.
    """

    drawing: Drawing
    caption: str
    name: str
    width: float = 1.0


@dataclass(frozen=True)
class Listing:
    """Lines as they are typed or printed."""

    lines: str


Block = Heading | Step | Paragraph | Note | Lines | Equation | Equations | Table | Picture | Listing


def _blocks() -> list[Block]:
    return []


@dataclass
class Document:
    """A page in the making.

    Attributes:
        title: Its title.
        subtitle: A line under the title.
        summary: What a hurried reader needs: one paragraph.
        blocks: The rest in reading order.
        edition: Who made it and when, at the foot of every printed page.
    """

    title: str
    subtitle: str = ""
    summary: str = ""
    blocks: list[Block] = field(default_factory=_blocks)
    edition: str = ""

    def add(self, *blocks: Block | str) -> None:
        """Append blocks; a bare string is a paragraph."""
        self.blocks += [Paragraph((b,)) if isinstance(b, str) else b for b in blocks]

    def section(self, words: str, *blocks: Block | str) -> None:
        """Begin a section."""
        self.add(Heading((words,)), *blocks)

    def heading(self, *pieces: Piece) -> None:
        """Append a heading inside a section, without a number."""
        self.add(Heading(pieces, level=2, numbered=False))

    def say(self, *pieces: Piece) -> None:
        """Append a paragraph of pieces."""
        self.add(Paragraph(pieces))

    def show(self, *sides: Formula, number: int | None = None) -> None:
        """Append a displayed formula."""
        self.add(Equation(sides, number))

    def table(self, head: Sequence[Piece], rows: Sequence[Sequence[Piece]], caption: str = "", **options: Any) -> None:
        """Append a table, numbers of a column with as many decimals each; `options` are those of `Table`."""
        self.add(Table(tuple(head), tuple(tuple(r) for r in even(rows)), caption, **options))


def even(rows: Sequence[Sequence[Piece]]) -> list[list[Piece]]:
    """Return the cells of a table with the numbers of each column, units behind them, to as many decimals."""
    out: list[list[Piece]] = [list(row) for row in rows]
    for column in range(min(map(len, out), default=0)):
        found = [NUMBER.fullmatch(cell) if isinstance(cell, str) else None for cell in (row[column] for row in out)]
        most = max((len(m[2] or ".") - 1 for m in found if m), default=0)
        for row, m in zip(out, found, strict=True):
            if m and most:
                row[column] = f"{m[1]}.{(m[2] or '.')[1:]:0<{most}}{m[3] or ''}"
    return out


def listed(pieces: Sequence[Any], word: str = "and") -> tuple[Any, ...]:
    """Return a, b and c: pieces of a sentence with what stands between them."""
    out: list[Any] = []
    for place, piece in enumerate(pieces):
        if place:
            out.append(f" {word} " if place == len(pieces) - 1 else ", ")
        out.append(piece)
    return tuple(out)
