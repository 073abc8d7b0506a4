"""A page as one HTML file that needs nothing else: no scripts, no fetches, figures inline, formulas as MathML."""

from __future__ import annotations

import base64
import html
import re
from pathlib import Path

from pieper.document import blocks as b
from pieper.document.formulas import equals
from pieper.document.identity import custom_properties, icon_address, identity
from pieper.document.mathml_fit import displayed, fitted, inline
from pieper.document.writer import Typesetter

UNITS = "Lengths are in millimetres and angles in degrees unless another unit is printed."
FOOTER = f"Made by pieper. {UNITS}"

NARROW = 0.9  # of the text's width; a figure of one picture is printed smaller than a row of them

#: The look of a page, on screen and on paper.
STYLE = Path(__file__).with_name("page.css")

#: Letters and signs of formulas, with the sizes of their parts (docs/decisions/math_font.md).
MATH_FONT = Path(__file__).with_name("math.woff2")


def page(document: b.Document) -> str:
    """Return a document as one self-contained HTML file."""
    writer = _Writer(fit=True)
    body = "\n".join(map(writer.block, document.blocks))
    contents = f"<nav>{''.join(writer.contents)}</nav>" if len(writer.contents) > 3 else ""
    title = escaped(document.title)
    summary = f'<div class="summary"><p>{escaped(document.summary)}</p></div>' if document.summary else ""
    subtitle = f'<p class="subtitle">{escaped(document.subtitle)}</p>' if document.subtitle else ""
    units = f'<p class="units">{UNITS}</p>'  # on paper, where a foot after the last line may take a page of its own
    icon, name = icon_address(), identity()["wordmark"]
    mark = f'<div class="wordmark"><img src="{icon}" alt=""/>{name}</div>'
    policy = "default-src 'none'; style-src 'unsafe-inline'; img-src data:; font-src data:"
    own = f":root {{ {custom_properties()} }}\n"
    style = own + _font() + STYLE.read_text(encoding="utf-8") + _running_foot(document)
    return (
        '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">\n'
        f'<title>{title}</title>\n<link rel="icon" href="{icon}"/>\n<style>\n{style}</style>\n</head>\n<body>\n<main>\n'
        f"<header>{mark}<h1>{title}</h1>{subtitle}{units}</header>\n{summary}\n{contents}\n{body}\n"
        f"<footer>{FOOTER}</footer>\n</main>\n</body>\n</html>\n"
    )


def _font() -> str:
    """The font of formulas, in the page: a machine without one sets fractions and powers like anybody's."""
    data = base64.b64encode(MATH_FONT.read_bytes()).decode("ascii")
    return f'@font-face {{ font-family: "Pieper Math"; src: url(data:font/woff2;base64,{data}) format("woff2"); }}\n'


def _running_foot(document: b.Document) -> str:
    """What stands at the foot of every printed page: the title, who made it and when, the page's number."""
    title, edition = (
        words.replace("\\", "").replace('"', "").replace("<", "") for words in (document.title, document.edition)
    )
    number = 'counter(page) " of " counter(pages)'
    return (
        f'@page {{ @bottom-left {{ content: "{title}"; }} @bottom-center {{ content: "{edition}"; }} '
        f"@bottom-right {{ content: {number}; }} }}\n"
    )


def fragment(document: b.Document) -> str:
    """Return a document as HTML elements to stand in a page of somebody else's, formulas at their full width."""
    title = [f"<h2>{escaped(document.title)}</h2>"] if document.title else []
    return "\n".join([*title, *map(_Writer(fit=False).block, document.blocks)]) + "\n"


def escaped(words: str) -> str:
    """Return words safe inside HTML elements and attributes."""
    return html.escape(words, quote=True)


class _Writer(Typesetter):
    """Writes blocks one after the other and keeps the numbers of sections, figures and tables."""

    def __init__(self, *, fit: bool) -> None:
        self.fit = fit
        self.section = self.subsection = self.figures = self.tables = 0
        self.contents: list[str] = []

    def _words(self, words: str) -> str:
        return escaped(words)

    def _code(self, words: str) -> str:
        return f"<code>{escaped(words)}</code>"

    def _emphasis(self, words: str) -> str:
        return f"<em>{escaped(words)}</em>"

    def _formula(self, formula: b.Formula) -> str:
        return inline(formula.mathml())

    def _paragraph(self, item: b.Paragraph) -> str:
        return f"<p>{self.line(*item.pieces)}</p>"

    def _note(self, item: b.Note) -> str:
        return f'<p class="note">{self.line(*item.pieces)}</p>'

    def _equations(self, item: b.Equations) -> str:
        rows = "".join(map(self._equation, item.rows))
        return f'<div class="{"beside" if item.beside else "group"}">{rows}</div>'

    def _lines(self, item: b.Lines) -> str:
        tag = "ol" if item.numbered else "ul"
        return f"<{tag}>{''.join(f'<li>{self.piece(words)}</li>' for words in item.items)}</{tag}>"

    def _listing(self, item: b.Listing) -> str:
        return f"<pre>{escaped(item.lines)}</pre>"

    def _heading(self, item: b.Heading) -> str:
        tag, words = f"h{item.level + 1}", self.line(*item.pieces)
        if not item.numbered:
            return f"<{tag}>{words}</{tag}>"
        if item.level == 1:
            self.section, self.subsection = self.section + 1, 0
            number = str(self.section)
            self.contents.append(f'<a href="#s{number}"><span class="number">{number}</span>{words}</a>')
        else:
            self.subsection += 1
            number = f"{self.section}.{self.subsection}"
        return f'<{tag} id="s{number}"><span class="number">{number}</span>{words}</{tag}>'

    def _equation(self, item: b.Equation) -> str:
        content = equals(*item.sides).mathml()
        math = fitted(content) if self.fit else displayed(content)
        if item.number is None:
            return f'<div class="formula">{math}</div>'
        return f'<div class="formula numbered"><div>{math}</div><span>({item.number})</span></div>'

    def _table(self, item: b.Table) -> str:
        self.tables += 1
        side = ["left" if i in item.left else "right" for i in range(len(item.head))]
        head = "".join(f'<th class="{s}">{self.line(c)}</th>' for s, c in zip(side, item.head, strict=True))
        rows: list[str] = []
        for i, row in enumerate(item.rows):
            cells = "".join(f'<td class="{s}">{self.line(c)}</td>' for s, c in zip(side, row, strict=True))
            rows.append(f"<tr{' class=strong' if i in item.strong else ''}>{cells}</tr>")
        caption = f"<caption><b>Table {self.tables}.</b> {escaped(item.caption)}</caption>" if item.caption else ""
        long = (" long" if len(item.rows) > 22 else "") + (" dense" if len(item.head) > 8 else "")
        return (
            f'<div class="wide{long}"><table>{caption}<thead><tr>{head}</tr></thead>'
            f"<tbody>{''.join(rows)}</tbody></table></div>"
        )

    def _picture(self, item: b.Picture) -> str:
        self.figures += 1
        narrow = ' class="narrow"' if item.width < NARROW else ""
        drawing = inline_svg(item.drawing.svg(), f"f{self.figures}-")
        return (
            f'<figure{narrow} style="width:{100 * item.width:z.0f}%">{drawing}'
            f"<figcaption><b>Figure {self.figures}.</b> {escaped(item.caption)}</figcaption></figure>"
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


def _shorter(number: re.Match[str]) -> str:
    return f"{float(number[0]):z.2f}".rstrip("0").rstrip(".")
