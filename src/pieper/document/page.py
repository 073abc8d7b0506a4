"""A page of sentences and formulas that prints itself as plain text, LaTeX, or HTML with MathML.

Sentences may hold formulas: a paragraph is a list of strings and expressions.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from html import escape

from pieper.algebra.notation import formula, latex, mathml, text


@dataclass(frozen=True)
class Raw:
    """A formula that is no expression (a product of matrices, say), written out for each style."""

    text: str
    latex: str
    mathml: str

    def __add__(self, other: Raw) -> Raw:
        return Raw(self.text + other.text, self.latex + other.latex, self.mathml + other.mathml)


@dataclass(frozen=True)
class Item:
    """One block: kind "title", "heading", "paragraph" or "display", and its parts."""

    kind: str
    parts: tuple


@dataclass
class Page:
    """Blocks in reading order."""

    items: list[Item] = field(default_factory=list)

    def title(self, words: str):
        """The page's title."""
        self.items.append(Item("title", (words,)))

    def heading(self, *parts):
        """A numbered step's or section's heading."""
        self.items.append(Item("heading", parts))

    def paragraph(self, *parts):
        """Sentences with formulas in them."""
        self.items.append(Item("paragraph", parts))

    def display(self, *parts):
        """A formula on a line of its own; parts are joined by equals signs."""
        self.items.append(Item("display", parts))

    def text(self) -> str:
        """Plain text, formulas indented."""
        lines = []
        for item in self.items:
            if item.kind == "display":
                lines.append("    " + " = ".join(_piece(p, "text") for p in item.parts))
            elif item.kind == "title":
                words = "".join(_piece(p, "text") for p in item.parts)
                lines += [words, "=" * len(words)]
            else:
                lines.append(("\n" if item.kind == "heading" else "") + "".join(_piece(p, "text") for p in item.parts))
        return "\n".join(lines) + "\n"

    def latex(self) -> str:
        r"""LaTeX for the inside of a document (amsmath)."""
        lines = []
        for item in self.items:
            body = (" = " if item.kind == "display" else "").join(_piece(p, "latex", item.kind) for p in item.parts)
            frame = {
                "title": rf"\subsection*{{{body}}}",
                "heading": rf"\paragraph{{{body}}}",
                "display": rf"\[ {body} \]",
            }
            lines.append(frame.get(item.kind, body + "\n"))
        return "\n".join(lines) + "\n"

    def mathml(self) -> str:
        """HTML elements with MathML inside, nothing fetched and no script."""
        lines = []
        for item in self.items:
            if item.kind == "display":
                body = "<mo>=</mo>".join(_piece(p, "mathml", "display") for p in item.parts)
                lines.append(f'<div class="formula" style="margin:0.4em 0">{formula(body, block=True)}</div>')
            else:
                tag = {"title": "h2", "heading": "h3"}.get(item.kind, "p")
                lines.append(f"<{tag}>{''.join(_piece(p, 'mathml', item.kind) for p in item.parts)}</{tag}>")
        return "\n".join(lines) + "\n"


def _piece(part, style: str, kind: str = "") -> str:
    inside = kind == "display"
    if isinstance(part, str):
        if style == "mathml":
            return f"<mtext>{escape(part)}</mtext>" if inside else escape(part)
        if style == "latex":
            return rf"\text{{{_tex(part)}}}" if inside else _tex(part)
        return part
    if isinstance(part, Raw):
        body = getattr(part, style)
    else:
        body = {"text": text, "latex": latex, "mathml": mathml}[style](part)
    if style == "text" or inside:
        return body
    return f"${body}$" if style == "latex" else formula(body)


_SIGNS = (("·", r"$\cdot$"), ("×", r"$\times$"), ("−", "$-$"))


def _tex(words: str) -> str:
    for sign, code in (("&", r"\&"), ("%", r"\%"), ("_", r"\_"), ("#", r"\#"), *_SIGNS):
        words = words.replace(sign, code)
    return words


def comma_list(parts: list, word: str = "and") -> list:
    """[a, ", ", b, " and ", c] for a paragraph."""
    out: list = []
    for place, part in enumerate(parts):
        if place:
            out.append(f" {word} " if place == len(parts) - 1 else ", ")
        out.append(part)
    return out


def matrix_equation(i: int, j: int, n: int, *, inverse: bool = False) -> Raw:
    """(A1 .. Ai)^-1 T (A_{j+1} .. An)^-1 = A_{i+1} .. A_j, or the inverse of both sides."""
    if inverse:
        left = _links(j + 1, n) + Raw("T^-1", "T^{-1}", "<msup><mi>T</mi><mrow><mo>−</mo><mn>1</mn></mrow></msup>")
        left = (
            left
            if j == n
            else _links(j + 1, n) + Raw(" T^-1", r"\,T^{-1}", left.mathml[len(_links(j + 1, n).mathml) :])
        )
        if i:
            left = left + Raw(" ", r"\,", "") + _links(1, i)
        return left + _equals() + _back(i + 1, j)
    middle = Raw("T", "T", "<mi>T</mi>")
    left = _back(1, i) + Raw(" ", r"\,", "") + middle if i else middle
    if j < n:
        left = left + Raw(" ", r"\,", "") + _back(j + 1, n)
    return left + _equals() + _links(i + 1, j)


def _equals() -> Raw:
    return Raw(" = ", " = ", "<mo>=</mo>")


def _links(first: int, last: int) -> Raw:
    found = Raw("", "", "")
    for k in range(first, last + 1):
        gap = "" if k == first else " "
        found = found + Raw(f"{gap}A{k}", f"{gap}A_{{{k}}}", f"<msub><mi>A</mi><mn>{k}</mn></msub>")
    return found


def _back(first: int, last: int) -> Raw:
    inner = _links(first, last)
    power = "<mrow><mo>−</mo><mn>1</mn></mrow>"
    if first == last:
        return Raw(f"{inner.text}^-1", f"A_{{{first}}}^{{-1}}", f"<msubsup><mi>A</mi><mn>{first}</mn>{power}</msubsup>")
    return Raw(
        f"({inner.text})^-1",
        rf"({inner.latex})^{{-1}}",
        f"<msup><mrow><mo>(</mo>{inner.mathml}<mo>)</mo></mrow>{power}</msup>",
    )
