"""A page as data: headings, sentences, tables, figures and formulas in reading order; the look is decided elsewhere."""

from __future__ import annotations

import html
import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class Heading:
    """A heading; level 1 is a section, 2 a subsection."""

    text: str
    level: int = 1


@dataclass(frozen=True)
class Text:
    """A paragraph. `code` and *emphasis* are marked as here; everything else is plain Unicode."""

    text: str


@dataclass(frozen=True)
class Lines:
    """A list of short items."""

    items: tuple[str, ...]
    numbered: bool = False


@dataclass(frozen=True)
class Table:
    """A table with its caption.

    Attributes:
        head: Column headings, units included.
        rows: Cells as text.
        caption: One sentence.
        left: Columns (0-based) aligned left; the others are aligned right.
        strong: Rows (0-based) to be set off.
    """

    head: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    caption: str = ""
    left: tuple[int, ...] = (0,)
    strong: tuple[int, ...] = ()


@dataclass(frozen=True, eq=False)
class Picture:
    """A figure with its caption.

    Attributes:
        figure: A matplotlib figure.
        caption: What one sees.
        name: A file name without a suffix.
        width: Share of the text's width, 0 to 1; above 1 it may stand out into the margins.
    """

    figure: Figure
    caption: str
    name: str
    width: float = 1.0

    @cached_property
    def svg(self) -> str:
        """The figure as SVG text, drawn once."""
        from pieper.presentation.style import svg

        return svg(self.figure)


@dataclass(frozen=True)
class Formula:
    """A displayed formula, or several with words between them, in two notations.

    Attributes:
        mathml: One or more <math> elements; <p> elements between them are allowed.
        latex: LaTeX source that sets the same, displays included.
    """

    mathml: str
    latex: str


@dataclass(frozen=True)
class Formulas:
    """Several small displayed formulas that may stand side by side."""

    formulas: tuple[Formula, ...]


@dataclass(frozen=True)
class Code:
    """Lines as they are typed or printed."""

    text: str


@dataclass
class Document:
    """A page.

    Attributes:
        title: Its title.
        subtitle: A line under the title.
        summary: What a hurried reader needs: one paragraph.
        blocks: The rest in reading order.
    """

    title: str
    subtitle: str = ""
    summary: str = ""
    blocks: list[object] = field(default_factory=list)

    def add(self, *blocks: object) -> None:
        """Append blocks; a bare string is a paragraph."""
        self.blocks += [Text(b) if isinstance(b, str) else b for b in blocks]

    def section(self, text: str, *blocks: object) -> None:
        """Begin a section."""
        self.add(Heading(text), *blocks)

    def table(self, head: Sequence[str], rows: Sequence[Sequence[str]], caption: str = "", **options: object) -> None:
        """Append a table."""
        self.add(Table(tuple(head), tuple(tuple(r) for r in rows), caption, **options))


_MARK = re.compile(r"`([^`]+)`|\*([^*\s][^*]*)\*")


def marked(text: str) -> list[tuple[str, str]]:
    """Return a paragraph as pieces (kind, text), kind "plain", "code" or "emphasis"."""
    out, at = [], 0
    for match in _MARK.finditer(text):
        if match.start() > at:
            out.append(("plain", text[at : match.start()]))
        out.append(("code", match.group(1)) if match.group(1) else ("emphasis", match.group(2)))
        at = match.end()
    if at < len(text):
        out.append(("plain", text[at:]))
    return out


def escaped(text: str) -> str:
    """Return text safe inside HTML elements and attributes."""
    return html.escape(text, quote=True)
