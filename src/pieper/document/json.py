"""A page as plain data for programs and for the workbench: one dict a block, its kind and its fields."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from pieper.document import blocks as b
from pieper.document.formulas import equals
from pieper.document.writer import Writer

Data = dict[str, Any]


def fragment(document: b.Document) -> Data:
    """Return a document as data that `json.dumps` takes."""
    return {
        "title": document.title,
        "subtitle": document.subtitle,
        "summary": document.summary,
        "blocks": blocks(document.blocks),
    }


def blocks(items: Iterable[b.Block]) -> list[Data]:
    """Return blocks as data; pieces are strings, {"code"}, {"emphasis"} or formulas {"latex", "text"}."""
    return [_WRITER.block(item) for item in items]


class _Writer(Writer[str | Data, Data]):
    def _pieces(self, pieces: Iterable[b.Piece]) -> list[str | Data]:
        return [self.piece(piece) for piece in pieces]

    def _words(self, words: str) -> str:
        return words

    def _code(self, words: str) -> Data:
        return {"code": words}

    def _emphasis(self, words: str) -> Data:
        return {"emphasis": words}

    def _formula(self, formula: b.Formula) -> Data:
        return {"latex": formula.latex(), "text": formula.text()}

    def _heading(self, item: b.Heading) -> Data:
        return {"kind": "heading", "level": item.level, "pieces": self._pieces(item.pieces)}

    def _step(self, item: b.Step) -> Data:
        said = {"number": item.number, "solves": self._formula(item.solves), "branches": item.branches}
        return {"kind": "step", **said, "pieces": self._pieces(item.heading.pieces)}

    def _paragraph(self, item: b.Paragraph) -> Data:
        return {"kind": "paragraph", "pieces": self._pieces(item.pieces)}

    def _note(self, item: b.Note) -> Data:
        return {"kind": "note", "pieces": self._pieces(item.pieces)}

    def _equation(self, item: b.Equation) -> Data:
        more = {"number": item.number} if item.number is not None else {}
        return {"kind": "equation", **self._formula(equals(*item.sides)), **more, "name": item.name}

    def _equations(self, item: b.Equations) -> Data:
        return {"kind": "equations", "rows": blocks(item.rows), "beside": item.beside}

    def _lines(self, item: b.Lines) -> Data:
        return {"kind": "lines", "items": self._pieces(item.items), "numbered": item.numbered}

    def _table(self, item: b.Table) -> Data:
        rows = [self._pieces(row) for row in item.rows]
        return {"kind": "table", "head": self._pieces(item.head), "rows": rows, "caption": item.caption}

    def _picture(self, item: b.Picture) -> Data:
        return {"kind": "figure", "name": item.name, "caption": item.caption, "svg": item.drawing.svg()}

    def _listing(self, item: b.Listing) -> Data:
        return {"kind": "listing", "lines": item.lines}


_WRITER = _Writer()
