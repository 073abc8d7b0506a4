"""The one walk over a page's blocks and a sentence's pieces, of which every renderer is made."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Generic, TypeVar

from pieper.document.blocks import (
    Block,
    Code,
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

#: What a piece of a sentence, and what a block becomes.
P = TypeVar("P")
B = TypeVar("B")


class Writer(ABC, Generic[P, B]):
    """Says for each kind of piece and of block what it becomes; a renderer fills these in."""

    def piece(self, piece: Piece) -> P:
        """Return one piece of a sentence."""
        match piece:
            case str():
                return self._words(piece)
            case Code():
                return self._code(piece.words)
            case Emphasis():
                return self._emphasis(piece.words)
            case _:
                return self._formula(piece)

    def block(self, item: Block) -> B:
        """Return one block."""
        match item:
            case Heading():
                return self._heading(item)
            case Step():
                return self._step(item)
            case Paragraph():
                return self._paragraph(item)
            case Note():
                return self._note(item)
            case Equation():
                return self._equation(item)
            case Equations():
                return self._equations(item)
            case Lines():
                return self._lines(item)
            case Table():
                return self._table(item)
            case Picture():
                return self._picture(item)
            case Listing():
                return self._listing(item)

    def _step(self, item: Step) -> B:
        return self._heading(item.heading)

    @abstractmethod
    def _words(self, words: str) -> P: ...
    @abstractmethod
    def _code(self, words: str) -> P: ...
    @abstractmethod
    def _emphasis(self, words: str) -> P: ...
    @abstractmethod
    def _formula(self, formula: Formula) -> P: ...
    @abstractmethod
    def _heading(self, item: Heading) -> B: ...
    @abstractmethod
    def _paragraph(self, item: Paragraph) -> B: ...
    @abstractmethod
    def _note(self, item: Note) -> B: ...
    @abstractmethod
    def _equation(self, item: Equation) -> B: ...
    @abstractmethod
    def _equations(self, item: Equations) -> B: ...
    @abstractmethod
    def _lines(self, item: Lines) -> B: ...
    @abstractmethod
    def _table(self, item: Table) -> B: ...
    @abstractmethod
    def _picture(self, item: Picture) -> B: ...
    @abstractmethod
    def _listing(self, item: Listing) -> B: ...


class Typesetter(Writer[str, str]):
    """A writer of text with marks in it: pieces of a sentence stand one behind the other."""

    def line(self, *pieces: Piece) -> str:
        """Return pieces of a sentence."""
        return "".join(map(self.piece, pieces))

    def _note(self, item: Note) -> str:
        return self._paragraph(Paragraph(item.pieces))

    def _paragraph(self, item: Paragraph) -> str:
        return self.line(*item.pieces)

    def marked(self, item: Lines) -> str:
        """Return a list with a dash or a number before each item, a line each."""
        marks = [f"{k + 1}." if item.numbered else "-" for k in range(len(item.items))]
        return "\n".join(f"{mark} {self.piece(words)}" for mark, words in zip(marks, item.items, strict=True))
