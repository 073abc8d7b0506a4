"""Making displayed MathML fit the width of a page: set a little smaller, or broken before a plus or minus.

Browsers do not break lines inside <math>, so a long sum would run out of the page, or off the paper.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET

#: Visible characters of a formula that fit on one line at full size, measured on formulas of the field in Chromium.
LINE = 56
#: A formula is set at most this much smaller before it is broken, and at most `SMALLEST` where it cannot be.
SMALLER, SMALLEST = 0.80, 0.45
NAMESPACE = "http://www.w3.org/1998/Math/MathML"

#: Elements whose children stand in a row.
_ROWS = {"math", "mrow", "mstyle"}
_SIGNS = {"+", "-", "−"}
_BRACKETS = {"(", ")", "[", "]"}
_TALL = {"mfrac", "mtable", "msqrt", "mover", "munder"}


def inline(content: str) -> str:
    """Return MathML content as a <math> element inside a line."""
    return f'<math xmlns="{NAMESPACE}">{content}</math>'


def displayed(content: str, style: str = "") -> str:
    """Return MathML content as a <math> element on a line of its own."""
    look = f' style="{style}"' if style else ""
    return f'<math xmlns="{NAMESPACE}" display="block"{look}>{content}</math>'


def fitted(content: str) -> str:
    """Return MathML content displayed and fitted to the line: one or more <math> elements; odd content as it is."""
    try:
        root = ET.fromstring(f"<math>{content}</math>")
    except ET.ParseError:
        return displayed(content)
    if not any(element.tag in _TALL for element in root.iter()):
        # brackets around what is one line high need not stretch, and stand closer when they do not
        _unstretched(list(root.iter()))
        content = _source(list(root))
    wide = width(root)
    if wide <= LINE:
        return displayed(content)
    if wide * SMALLER <= LINE:
        return _smaller(displayed(content), LINE / wide)
    lines = _lines(_flat(root))
    if len(lines) == 1:
        return _smaller(displayed(content), max(SMALLEST, LINE / wide))
    return "".join(_as_math(line, k > 0) for k, line in enumerate(lines))


def fits(content: str) -> bool:
    """Whether content that cannot be broken, such as a matrix, fits on a line, set no smaller than can be read."""
    return width(ET.fromstring(f"<math>{content}</math>")) * SMALLEST <= LINE


def width(element: ET.Element) -> float:
    """Return about how many characters wide an element is set; sub- and superscripts count less, fractions once."""
    tag, children = element.tag, list(element)
    if not children:
        text = _sign(element)
        size = sum(1.0 if c not in "()[]{},.;ijlt1" else 0.7 for c in text)
        return size + (1.0 if tag == "mo" and text in (_SIGNS | {"="}) else 0.0)
    if tag in ("msub", "msup", "msubsup", "munder", "mover"):
        return width(children[0]) + 0.62 * max(width(c) for c in children[1:])
    if tag == "mfrac":
        return max(width(c) for c in children) + 0.4
    if tag == "mtable":
        rows = [[width(cell) for cell in row] for row in children]
        return sum(max(column) + 1.2 for column in zip(*rows, strict=False))
    return sum(width(c) for c in children) + (0.9 if tag == "msqrt" else 0.0)


def _sign(element: ET.Element) -> str:
    return (element.text or "").strip()


def _source(elements: list[ET.Element]) -> str:
    return "".join(ET.tostring(element, encoding="unicode") for element in elements)


def _unstretched(elements: list[ET.Element]) -> None:
    for element in elements:
        if element.tag == "mo" and _sign(element) in _BRACKETS:
            element.set("stretchy", "false")


def _smaller(math: str, share: float) -> str:
    return f'<div style="font-size:{share:z.2f}em">{math}</div>'


def _flat(element: ET.Element) -> list[ET.Element]:
    """Return the row of a formula with the rows inside it dissolved, so that it may be broken inside brackets too."""
    out: list[ET.Element] = []
    for child in element:
        out += _flat(child) if child.tag in _ROWS else [child]
    return out


def _lines(row: list[ET.Element]) -> list[list[ET.Element]]:
    """Break a row before signs, as late as the line allows, but not before a sign that opens a bracket."""
    pieces: list[list[ET.Element]] = [[]]
    for k, element in enumerate(row):
        before = "(" if k == 0 else _sign(row[k - 1]) if len(row[k - 1]) == 0 else "term"
        if _sign(element) in _SIGNS and before not in ("(", "[", ",", "=", "{", ""):
            pieces.append([])
        pieces[-1].append(element)
    lines: list[list[ET.Element]] = [[]]
    for piece in pieces:
        if lines[-1] and sum(map(width, lines[-1])) + sum(map(width, piece)) > LINE:
            lines.append([])
        lines[-1] += piece
    return [line for line in lines if line]


def _as_math(line: list[ET.Element], continued: bool) -> str:
    _unstretched(line)  # a bracket whose partner is on another line must not stretch alone
    for k, element in enumerate(line):
        if element.tag == "mo" and _sign(element) in _SIGNS and k and _sign(line[k - 1]) in ("(", "[", ",", "="):
            element.set("form", "prefix")
    body = ('<mspace width="2.5em"/>' if continued else "") + _source(line)
    share = min(1.0, LINE / max(sum(map(width, line)), 1.0))
    math = displayed(f"<mrow>{body}</mrow>", "text-align:left")
    return math if share == 1.0 else _smaller(math, max(SMALLEST, share))
