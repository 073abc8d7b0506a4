"""A page as plain data for programs and for the workbench: one dict a block, its kind and its fields."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

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
from pieper.document.formulas import equals

Data = dict[str, Any]


def fragment(document: Document) -> Data:
    """Return a document as data that `json.dumps` takes."""
    return {
        "title": document.title,
        "subtitle": document.subtitle,
        "summary": document.summary,
        "blocks": blocks(document.blocks),
    }


def blocks(items: Iterable[Block]) -> list[Data]:
    """Return blocks as data."""
    return [block(item) for item in items]


def block(item: Block) -> Data:
    """Return one block as data; pieces are strings, {"code"}, {"emphasis"} or formulas {"latex", "text"}."""
    match item:
        case Heading():
            return {"kind": "heading", "level": item.level, "pieces": _pieces(item.pieces)}
        case Step():
            solves, pieces = _formula(item.solves), _pieces(item.heading.pieces)
            return {
                "kind": "step", "number": item.number, "solves": solves, "branches": item.branches, "pieces": pieces
            }  # fmt: skip
        case Paragraph():
            return {"kind": "paragraph", "pieces": _pieces(item.pieces)}
        case Note():
            return {"kind": "note", "pieces": _pieces(item.pieces)}
        case Equation():
            more = {"number": item.number} if item.number is not None else {}
            return {"kind": "equation", **_formula(equals(*item.sides)), **more, "name": item.name}
        case Equations():
            return {"kind": "equations", "rows": blocks(item.rows), "beside": item.beside}
        case Lines():
            return {"kind": "lines", "items": _pieces(item.items), "numbered": item.numbered}
        case Table():
            rows = [_pieces(row) for row in item.rows]
            return {"kind": "table", "head": _pieces(item.head), "rows": rows, "caption": item.caption}
        case Picture():
            return {"kind": "figure", "name": item.name, "caption": item.caption, "svg": item.drawing.svg()}
        case Listing():
            return {"kind": "listing", "lines": item.lines}


def _pieces(pieces: Iterable[Piece]) -> list[str | Data]:
    return [_piece(piece) for piece in pieces]


def _piece(piece: Piece) -> str | Data:
    match piece:
        case str():
            return piece
        case Code():
            return {"code": piece.words}
        case Emphasis():
            return {"emphasis": piece.words}
        case _:
            return _formula(piece)


def _formula(formula: Formula) -> Data:
    return {"latex": formula.latex(), "text": formula.text()}
