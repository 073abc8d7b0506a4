"""The letters in which a page names the entries of a pose: n, o, a, p (Paul), or r11 .. r33 (Craig, Spong)."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from pieper.algebra.expression import Expr, Sym
from pieper.document.blocks import Block, Document, Equation, Equations, Heading, Lines, Note, Paragraph, Piece, Step
from pieper.errors import InputError

LETTERS = ("noap", "r")
_TABLE: dict[Any, Any] = {
    Sym(letter, axis, 4): Sym("r", f"{row}{column}", 4)
    for column, letter in enumerate("noa", 1)
    for row, axis in enumerate("xyz", 1)
}
_WORDS = {
    "with the columns n, o, a and p": "with the entries r11 to r33 of its rotation and the position p",
    "of which the task gives the approach a and the position p": "of which the task gives the third column of the "
    "rotation, r13, r23 and r33, and the position p",
    "n, o, a are the columns of the rotation and p is the position": "r11 to r33 is the rotation and p the position",
}


def checked_letters(letters: str) -> str:
    """Return the letters, or refuse them.

    Raises:
        InputError: They are none of `LETTERS`.
    """
    if letters not in LETTERS:
        raise InputError(f"letters must be one of {', '.join(LETTERS)}, got {letters!r}.", given=letters)
    return letters


def in_letters(page: Document, letters: str) -> Document:
    """The page in other letters for the entries of the pose.

    Args:
        page: A page in n, o, a and p.
        letters: "noap", or "r": r11 to r33, and p_x, p_y, p_z as before.
    """
    if checked_letters(letters) == "noap":
        return page
    return replace(page, blocks=[_block(block) for block in page.blocks], summary=_piece(page.summary))


def _piece(piece: Piece) -> Any:
    if isinstance(piece, Expr):
        return piece.substitute(_TABLE)
    if isinstance(piece, str):
        for words, other in _WORDS.items():
            piece = piece.replace(words, other)
    return piece


def _pieces(pieces: tuple[Piece, ...]) -> tuple[Piece, ...]:
    return tuple(_piece(piece) for piece in pieces)


def _block(block: Block) -> Block:
    match block:
        case Equation():
            return replace(block, sides=_pieces(block.sides), name=_name(block.name))
        case Equations():
            return replace(block, rows=tuple(_block(row) for row in block.rows))
        case Paragraph() | Note() | Heading():
            return replace(block, pieces=_pieces(block.pieces))
        case Lines():
            return replace(block, items=_pieces(block.items))
        case Step():
            return replace(block, solves=_piece(block.solves))
        case _:
            return block


def _name(name: str) -> str:
    letter, _, axis = name.partition("_")
    return str(_TABLE.get(Sym(letter, axis, 4), name)) if letter in "noa" and axis else name
