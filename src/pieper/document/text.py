"""A page as plain text, formulas indented."""

from __future__ import annotations

import textwrap

from pieper.document import blocks as b
from pieper.document.writer import Typesetter

INDENT = "    "


def fragment(document: b.Document) -> str:
    """Return a document as plain text."""
    lines = [document.title, "=" * len(document.title)] if document.title else []
    lines += [words for words in (document.subtitle, document.summary) if words]
    return "\n".join([*lines, *map(_WRITER.block, document.blocks)]) + "\n"


def plain(*pieces: b.Piece) -> str:
    """Return pieces of a sentence as plain text."""
    return _WRITER.line(*pieces)


def equation(*sides: b.Formula) -> str:
    """Return sides joined by equals signs; rows of a matrix stand below each other behind the sign."""
    first, *rest = (side.text() for side in sides)
    for side in rest:
        margin = " " * (len(first.rsplit("\n", 1)[-1]) + 3)
        first = f"{first} = " + side.replace("\n", "\n" + margin)
    return first


class _Writer(Typesetter):
    def _words(self, words: str) -> str:
        return words

    _code = _emphasis = _words

    def _formula(self, formula: b.Formula) -> str:
        return formula.text()

    def _heading(self, item: b.Heading) -> str:
        return "\n" + self.line(*item.pieces)

    def _equation(self, item: b.Equation) -> str:
        number = f"    ({item.number})" if item.number is not None else ""
        return textwrap.indent(equation(*item.sides) + number, INDENT)

    def _equations(self, item: b.Equations) -> str:
        return "\n".join(map(self._equation, item.rows))

    def _lines(self, item: b.Lines) -> str:
        return self.marked(item)

    def _table(self, item: b.Table) -> str:
        cells = [[self.piece(cell) for cell in row] for row in (item.head, *item.rows)]
        widths = [max(len(row[c]) for row in cells) for c in range(len(item.head))]
        lines = [
            "  ".join(
                cell.ljust(width) if c in item.left else cell.rjust(width)
                for c, (cell, width) in enumerate(zip(row, widths, strict=True))
            ).rstrip()
            for row in cells
        ]
        return "\n".join([*([item.caption] if item.caption else []), *lines])

    def _picture(self, item: b.Picture) -> str:
        return f"[Figure {item.name}: {item.caption}]"

    def _listing(self, item: b.Listing) -> str:
        return textwrap.indent(item.lines.rstrip("\n"), INDENT)


_WRITER = _Writer()
