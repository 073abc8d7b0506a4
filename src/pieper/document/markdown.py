"""A page as Markdown, formulas between dollars, its figures as SVG files beside it."""

from __future__ import annotations

from pieper.document.blocks import (
    Block,
    Code,
    Document,
    Emphasis,
    Equation,
    Equations,
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
from pieper.document.formulas import equals

_MARKS = str.maketrans({c: "\\" + c for c in "\\`*_[]<>$|#"})


def source(document: Document, folder: str = "figures") -> tuple[str, dict[str, bytes]]:
    """Return a document as Markdown and the figures it names: relative file name to content."""
    parts = [f"# {_piece(document.title)}"] if document.title else []
    parts += [f"*{_piece(document.subtitle)}*"] if document.subtitle else []
    parts += [f"**{_piece(document.summary)}**"] if document.summary else []
    parts += [block(item, folder) for item in document.blocks]
    pictures = [item for item in document.blocks if isinstance(item, Picture)]
    return "\n\n".join(parts) + "\n", {f"{folder}/{p.name}.svg": p.drawing.svg().encode() for p in pictures}


def fragment(document: Document) -> str:
    """Return a document as Markdown."""
    return source(document)[0]


def block(item: Block, folder: str = "figures") -> str:
    """Return one block as Markdown."""
    match item:
        case Heading():
            return f"{'#' * (item.level + 1)} {line(*item.pieces)}"
        case Step():
            return block(item.heading)
        case Paragraph():
            return line(*item.pieces)
        case Note():
            return f"> {line(*item.pieces)}"
        case Equation():
            number = rf" \tag{{{item.number}}}" if item.number is not None else ""
            return f"$$\n{equals(*item.sides).latex()}{number}\n$$"
        case Equations():
            return "\n\n".join(map(block, item.rows))
        case Lines():
            marks = [f"{k + 1}." if item.numbered else "-" for k in range(len(item.items))]
            return "\n".join(f"{mark} {line(words)}" for mark, words in zip(marks, item.items, strict=True))
        case Table():
            rule = "|".join("---" if i in item.left else "---:" for i in range(len(item.head)))
            rows = [_row(item.head), f"|{rule}|", *map(_row, item.rows)]
            return "\n".join([*([f"{_piece(item.caption)}\n"] if item.caption else []), *rows])
        case Picture():
            return f"![{_piece(item.caption)}]({folder}/{item.name}.svg)"
        case Listing():
            return f"```text\n{item.lines.rstrip()}\n```"


def line(*pieces: Piece) -> str:
    """Return pieces of a sentence as Markdown."""
    return "".join(map(_piece, pieces))


def _row(cells: tuple[Piece, ...]) -> str:
    return "| " + " | ".join(map(_piece, cells)) + " |"


def _piece(piece: Piece) -> str:
    match piece:
        case str():
            return piece.translate(_MARKS)
        case Code():
            return f"`{piece.words}`"
        case Emphasis():
            return f"*{piece.words.translate(_MARKS)}*"
        case _:
            return f"${piece.latex()}$"
