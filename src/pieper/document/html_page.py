"""A document as one HTML file that needs nothing else: no scripts, no fetches, figures inline, formulas as MathML."""

from __future__ import annotations

import re
from pathlib import Path

from pieper.document.blocks import (
    Code,
    Document,
    Formula,
    Formulas,
    Heading,
    Lines,
    Picture,
    Table,
    Text,
    escaped,
    marked,
)
from pieper.document.mathml_fit import fitted

FOOTER = "Made by pieper. Lengths are in millimetres and angles in degrees unless another unit is printed."

#: The look of a page, on screen and on paper.
STYLE = Path(__file__).with_name("page.css")


def page(document: Document) -> str:
    """Return a document as one self-contained HTML file."""
    body, contents = _Body(document).written()
    summary = f'<div class="summary"><p>{inline(document.summary)}</p></div>' if document.summary else ""
    subtitle = f'<p class="subtitle">{inline(document.subtitle)}</p>' if document.subtitle else ""
    policy = "default-src 'none'; style-src 'unsafe-inline'; img-src data:"
    return (
        '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">\n'
        f"<title>{escaped(document.title)}</title>\n<style>\n{STYLE.read_text()}</style>\n</head>\n<body>\n<main>\n"
        f"<header><h1>{inline(document.title)}</h1>{subtitle}</header>\n{summary}\n{contents}\n{body}\n"
        f"<footer>{FOOTER}</footer>\n</main>\n</body>\n</html>\n"
    )


def inline(text: str) -> str:
    """Return a paragraph's text as HTML, `code` and *emphasis* marked."""
    tags = {"code": ("<code>", "</code>"), "emphasis": ("<em>", "</em>"), "plain": ("", "")}
    return "".join(tags[kind][0] + escaped(piece) + tags[kind][1] for kind, piece in marked(text))


class _Body:
    """Writes blocks one after the other and keeps the numbers of sections, figures and tables."""

    def __init__(self, document: Document) -> None:
        self.document = document
        self.section = self.subsection = self.figures = self.tables = 0
        self.contents: list[str] = []

    def written(self) -> tuple[str, str]:
        body = "\n".join(self._block(block) for block in self.document.blocks)
        nav = f"<nav>{''.join(self.contents)}</nav>" if len(self.contents) > 3 else ""
        return body, nav

    def _block(self, block: object) -> str:
        if isinstance(block, Heading):
            return self._heading(block)
        if isinstance(block, Text):
            return f"<p>{inline(block.text)}</p>"
        if isinstance(block, Lines):
            tag = "ol" if block.numbered else "ul"
            return f"<{tag}>{''.join(f'<li>{inline(item)}</li>' for item in block.items)}</{tag}>"
        if isinstance(block, Table):
            return self._table(block)
        if isinstance(block, Picture):
            return self._picture(block)
        if isinstance(block, Formula):
            return f'<div class="formula">{fitted(block.mathml)}</div>'
        if isinstance(block, Formulas):
            return f'<div class="beside">{"".join(self._block(f) for f in block.formulas)}</div>'
        if isinstance(block, Code):
            return f"<pre>{escaped(block.text)}</pre>"
        raise TypeError(f"a page cannot hold a {type(block).__name__}")

    def _heading(self, block: Heading) -> str:
        if block.level == 1:
            self.section, self.subsection = self.section + 1, 0
            number = str(self.section)
            self.contents.append(f'<a href="#s{number}"><span class="number">{number}</span>{inline(block.text)}</a>')
        else:
            self.subsection += 1
            number = f"{self.section}.{self.subsection}"
        tag = f"h{block.level + 1}"
        return f'<{tag} id="s{number}"><span class="number">{number}</span>{inline(block.text)}</{tag}>'

    def _table(self, block: Table) -> str:
        self.tables += 1
        side = ["left" if i in block.left else "right" for i in range(len(block.head))]
        head = "".join(f'<th class="{s}">{inline(c)}</th>' for s, c in zip(side, block.head, strict=True))
        rows = []
        for i, row in enumerate(block.rows):
            cells = "".join(f'<td class="{s}">{inline(c)}</td>' for s, c in zip(side, row, strict=True))
            rows.append(f"<tr{' class=strong' if i in block.strong else ''}>{cells}</tr>")
        caption = f"<caption><b>Table {self.tables}.</b> {inline(block.caption)}</caption>" if block.caption else ""
        long = (" long" if len(block.rows) > 22 else "") + (" dense" if len(block.head) > 8 else "")
        return (
            f'<div class="wide{long}"><table>{caption}<thead><tr>{head}</tr></thead>'
            f"<tbody>{''.join(rows)}</tbody></table></div>"
        )

    def _picture(self, block: Picture) -> str:
        self.figures += 1
        drawing = inline_svg(block.svg, f"f{self.figures}-")
        return (
            f'<figure style="width:{100 * block.width:.0f}%">{drawing}'
            f"<figcaption><b>Figure {self.figures}.</b> {inline(block.caption)}</figcaption></figure>"
        )


def inline_svg(text: str, prefix: str) -> str:
    """Return SVG text fit to stand inside HTML: no prologue, no fixed size, identifiers made unique by a prefix."""
    text = text[text.index("<svg") :]
    text = re.sub(r"<metadata>.*?</metadata>", "", text, flags=re.S)
    text = re.sub(r'\bid="([^"]+)"', lambda m: f'id="{prefix}{m[1]}"', text)
    text = re.sub(r'href="#([^"]+)"', lambda m: f'href="#{prefix}{m[1]}"', text)
    text = re.sub(r"url\(#([^)]+)\)", lambda m: f"url(#{prefix}{m[1]})", text)
    head, rest = text.split(">", 1)
    head = re.sub(r'\s(width|height|xmlns:[a-z]+|version)="[^"]*"', "", head).replace("<svg", '<svg role="img"', 1)
    # coordinates finer than a hundredth of a point are of no use to anyone; scales of glyphs are
    rest = re.sub(r'\bd="[^"]*"', lambda m: re.sub(r"-?\d+\.\d{3,}", _shorter, m[0]), rest)
    return f"{head}>{rest}".replace("xlink:href", "href").strip()


def _shorter(number: re.Match) -> str:
    return f"{float(number[0]):.2f}".rstrip("0").rstrip(".")
