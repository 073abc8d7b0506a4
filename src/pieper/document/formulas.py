"""Formulas that are no expressions: sides joined by equals signs, matrices, products of named matrices."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from pieper.document.blocks import Equation, Formula, Piece


@dataclass(frozen=True)
class Written:
    """A formula written out in each notation."""

    as_text: str
    as_latex: str
    as_mathml: str

    def text(self) -> str:
        """Return plain text."""
        return self.as_text

    def latex(self) -> str:
        """Return LaTeX for math mode."""
        return self.as_latex

    def mathml(self) -> str:
        """Return MathML without the outer element."""
        return self.as_mathml

    def __add__(self, other: Formula) -> Written:
        return Written(self.as_text + other.text(), self.as_latex + other.latex(), self.as_mathml + other.mathml())


NOTHING = Written("", "", "")
EQUALS = Written(" = ", " = ", "<mo>=</mo>")
ZERO = Written("0", "0", "<mn>0</mn>")
MINUS_ONE = "<mrow><mo>−</mo><mn>1</mn></mrow>"


def joined(parts: Sequence[Formula], between: Written = NOTHING) -> Written:
    """Return formulas one after the other."""
    out = NOTHING
    for place, part in enumerate(parts):
        out = out + between + part if place else out + part
    return out


def equals(*sides: Formula) -> Written:
    """Return sides joined by equals signs."""
    return joined(sides, EQUALS)


def in_line(equations: Sequence[Equation]) -> tuple[Piece, ...]:
    """Return equations as pieces of a sentence, semicolons between them."""
    pieces: list[Piece] = []
    for row in equations:
        if pieces:
            pieces.append("; ")
        pieces.append(equals(*row.sides))
    return tuple(pieces)


def named(letter: str, index: str = "") -> Written:
    """Return a letter with an index: A1, T03."""
    if not index:
        return Written(letter, letter, f"<mi>{letter}</mi>")
    tag = "mn" if index.isdigit() else "mi"
    return Written(f"{letter}{index}", f"{letter}_{{{index}}}", f"<msub><mi>{letter}</mi><{tag}>{index}</{tag}></msub>")


def product(factors: Sequence[Formula]) -> Written:
    """Return named matrices side by side, a thin space between them."""
    return joined(factors, Written(" ", r"\,", ""))


def matrix(rows: Sequence[Sequence[Formula]]) -> Written:
    """Return a matrix in square brackets; in plain text one line a row, columns aligned."""
    cells = [[entry.text() for entry in row] for row in rows]
    widths = [max(len(row[c]) for row in cells) for c in range(len(cells[0]))]
    lines = ["[ " + "   ".join(cell.ljust(w) for cell, w in zip(row, widths, strict=True)) + " ]" for row in cells]
    latex = r" \\ ".join(" & ".join(entry.latex() for entry in row) for row in rows)
    mathml = "".join(f"<mtr>{''.join(f'<mtd>{entry.mathml()}</mtd>' for entry in row)}</mtr>" for row in rows)
    return Written(
        "\n".join(lines),
        rf"\begin{{bmatrix}} {latex} \end{{bmatrix}}",
        f"<mrow><mo>[</mo><mtable>{mathml}</mtable><mo>]</mo></mrow>",
    )
