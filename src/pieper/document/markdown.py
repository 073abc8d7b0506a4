"""A page as Markdown, formulas between dollars, its figures as SVG files beside it."""

from __future__ import annotations

from pieper.document import blocks as b
from pieper.document.formulas import equals
from pieper.document.writer import Typesetter

_MARKS = str.maketrans({c: "\\" + c for c in "\\`*_[]<>$|#"})


def source(document: b.Document, folder: str = "figures") -> tuple[str, dict[str, bytes]]:
    """Return a document as Markdown and the figures it names: relative file name to content."""
    writer = _Writer(folder)
    parts = [f"# {writer.line(document.title)}"] if document.title else []
    parts += [f"*{writer.line(document.subtitle)}*"] if document.subtitle else []
    parts += [f"**{writer.line(document.summary)}**"] if document.summary else []
    parts += [writer.block(item) for item in document.blocks]
    pictures = [item for item in document.blocks if isinstance(item, b.Picture)]
    return "\n\n".join(parts) + "\n", {f"{folder}/{p.name}.svg": p.drawing.svg().encode() for p in pictures}


def fragment(document: b.Document) -> str:
    """Return a document as Markdown."""
    return source(document)[0]


class _Writer(Typesetter):
    def __init__(self, folder: str) -> None:
        self.folder = folder

    def _words(self, words: str) -> str:
        return words.translate(_MARKS)

    def _code(self, words: str) -> str:
        return f"`{words}`"

    def _emphasis(self, words: str) -> str:
        return f"*{words.translate(_MARKS)}*"

    def _formula(self, formula: b.Formula) -> str:
        return f"${formula.latex()}$"

    def _heading(self, item: b.Heading) -> str:
        return f"{'#' * (item.level + 1)} {self.line(*item.pieces)}"

    def _note(self, item: b.Note) -> str:
        return f"> {self.line(*item.pieces)}"

    def _equation(self, item: b.Equation) -> str:
        number = rf" \tag{{{item.number}}}" if item.number is not None else ""
        return f"$$\n{equals(*item.sides).latex()}{number}\n$$"

    def _equations(self, item: b.Equations) -> str:
        return "\n\n".join(map(self._equation, item.rows))

    def _lines(self, item: b.Lines) -> str:
        return self.marked(item)

    def _table(self, item: b.Table) -> str:
        rule = "|".join("---" if i in item.left else "---:" for i in range(len(item.head)))
        rows = [self._row(item.head), f"|{rule}|", *map(self._row, item.rows)]
        return "\n".join([*([f"{self.line(item.caption)}\n"] if item.caption else []), *rows])

    def _row(self, cells: tuple[b.Piece, ...]) -> str:
        return "| " + " | ".join(map(self.piece, cells)) + " |"

    def _picture(self, item: b.Picture) -> str:
        return f"![{self.line(item.caption)}]({self.folder}/{item.name}.svg)"

    def _listing(self, item: b.Listing) -> str:
        return f"```text\n{item.lines.rstrip()}\n```"
