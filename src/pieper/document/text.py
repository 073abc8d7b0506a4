"""A page as plain text, formulas indented."""

from __future__ import annotations

import textwrap

from pieper.document.blocks import (
    Block,
    Code,
    Document,
    Emphasis,
    Equation,
    Equations,
    Formula,
    Heading,
    Lines,
    Listing,
    Note,
    Paragraph,
    Picture,
    Piece,
    Step,
    Table,
)

INDENT = "    "


def fragment(document: Document) -> str:
    """Return a document as plain text."""
    lines = [document.title, "=" * len(document.title)] if document.title else []
    lines += [words for words in (document.subtitle, document.summary) if words]
    return "\n".join([*lines, *map(block, document.blocks)]) + "\n"


def plain(*pieces: Piece) -> str:
    """Return pieces of a sentence as plain text."""
    return "".join(
        piece if isinstance(piece, str) else piece.words if isinstance(piece, (Code, Emphasis)) else piece.text()
        for piece in pieces
    )


def block(item: Block) -> str:
    """Return one block as plain text."""
    match item:
        case Heading():
            return "\n" + plain(*item.pieces)
        case Step():
            return block(item.heading)
        case Paragraph() | Note():
            return plain(*item.pieces)
        case Equation():
            return _equation(item)
        case Equations():
            return "\n".join(map(_equation, item.rows))
        case Lines():
            marks = [f"{k + 1}." if item.numbered else "-" for k in range(len(item.items))]
            return "\n".join(f"{mark} {plain(words)}" for mark, words in zip(marks, item.items, strict=True))
        case Table():
            return _table(item)
        case Picture():
            return f"[Figure {item.name}: {item.caption}]"
        case Listing():
            return textwrap.indent(item.lines.rstrip("\n"), INDENT)


def equation(*sides: Formula) -> str:
    """Return sides joined by equals signs; rows of a matrix stand below each other behind the sign."""
    first, *rest = (side.text() for side in sides)
    for side in rest:
        margin = " " * (len(first.rsplit("\n", 1)[-1]) + 3)
        first = f"{first} = " + side.replace("\n", "\n" + margin)
    return first


def _equation(item: Equation) -> str:
    number = f"    ({item.number})" if item.number is not None else ""
    return textwrap.indent(equation(*item.sides) + number, INDENT)


def _table(item: Table) -> str:
    cells = [[plain(cell) for cell in row] for row in (item.head, *item.rows)]
    widths = [max(len(row[c]) for row in cells) for c in range(len(item.head))]
    lines = [
        "  ".join(
            cell.ljust(width) if c in item.left else cell.rjust(width)
            for c, (cell, width) in enumerate(zip(row, widths, strict=True))
        ).rstrip()
        for row in cells
    ]
    return "\n".join([*([item.caption] if item.caption else []), *lines])
