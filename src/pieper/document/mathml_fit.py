"""Making displayed MathML fit the width of a page: set a little smaller, or broken before a plus or minus.

Browsers do not break lines inside <math>, so a long sum would run out of the page, or off the paper.
"""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET

#: Visible characters of a formula that fit on one line at full size, measured on formulas of the field in Chromium.
LINE = 56
#: A formula is set at most this much smaller before it is broken, and at most `SMALLEST` where it cannot be.
SMALLER, SMALLEST = 0.80, 0.45
NAMESPACE = "http://www.w3.org/1998/Math/MathML"

_DISPLAY = re.compile(r"<math\b[^>]*display=\"block\"[^>]*>.*?</math>", re.S)
#: Elements whose children stand in a row.
_ROWS = {"math", "mrow", "mstyle"}
_SIGNS = {"+", "-", "−"}
_TALL = {"mfrac", "mtable", "msqrt", "mover", "munder"}


def fitted(mathml: str) -> str:
    """Return MathML (and the HTML around it) with every displayed formula fitted to the line."""
    return _DISPLAY.sub(lambda match: _fit(match[0]), mathml)


def width(element: ET.Element) -> float:
    """Return about how many characters wide an element is set; sub- and superscripts count less, fractions once."""
    tag = element.tag.split("}")[-1]
    children = list(element)
    if not children:
        text = (element.text or "").strip()
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


def _fit(source: str) -> str:
    try:
        root = ET.fromstring(source)
    except ET.ParseError:
        return source
    if not any(element.tag.split("}")[-1] in _TALL for element in root.iter()):
        # brackets around what is one line high need not stretch, and stand closer when they do not
        source = re.sub(r"<mo>([()\[\]])</mo>", r'<mo stretchy="false">\1</mo>', source)
    wide = width(root)
    if wide <= LINE:
        return source
    if wide * SMALLER <= LINE:
        return _smaller(source, LINE / wide)
    lines = _lines(_flat(root))
    if len(lines) == 1:
        return _smaller(source, max(SMALLEST, LINE / wide))
    return "".join(_as_math(line, k > 0) for k, line in enumerate(lines))


def _smaller(source: str, share: float) -> str:
    return f'<div style="font-size:{share:.2f}em">{source}</div>'


def _flat(element: ET.Element) -> list[ET.Element]:
    """Return the row of a formula with the rows inside it dissolved, so that it may be broken inside brackets too."""
    out: list[ET.Element] = []
    for child in element:
        if child.tag.split("}")[-1] in _ROWS:
            out += _flat(child)
        else:
            out.append(child)
    return out


def _lines(row: list[ET.Element]) -> list[list[ET.Element]]:
    """Break a row before signs, as late as the line allows, but not before a sign that opens a bracket."""
    pieces: list[list[ET.Element]] = [[]]
    for k, element in enumerate(row):
        text = (element.text or "").strip()
        before = "(" if k == 0 else (row[k - 1].text or "").strip() if len(row[k - 1]) == 0 else "term"
        if text in _SIGNS and before not in ("(", "[", ",", "=", "{", ""):
            pieces.append([])
        pieces[-1].append(element)
    lines: list[list[ET.Element]] = [[]]
    for piece in pieces:
        if lines[-1] and sum(map(width, lines[-1])) + sum(map(width, piece)) > LINE:
            lines.append([])
        lines[-1] += piece
    return [line for line in lines if line]


def _as_math(line: list[ET.Element], continued: bool) -> str:
    ET.register_namespace("", NAMESPACE)
    for k, element in enumerate(line):
        text = (element.text or "").strip() if element.tag.split("}")[-1] == "mo" else ""
        if text in ("(", ")", "[", "]"):
            # a bracket whose partner is on another line must not stretch alone
            element.set("stretchy", "false")
        if text in _SIGNS and k and (line[k - 1].text or "").strip() in ("(", "[", ",", "="):
            element.set("form", "prefix")
    body = "".join(ET.tostring(element, encoding="unicode") for element in line)
    body = body.replace(f' xmlns="{NAMESPACE}"', "")
    inside = f'<mrow><mspace width="2.5em"/>{body}</mrow>' if continued else f"<mrow>{body}</mrow>"
    share = min(1.0, LINE / max(sum(map(width, line)), 1.0))
    math = f'<math xmlns="{NAMESPACE}" display="block" style="text-align:left">{inside}</math>'
    return math if share == 1.0 else _smaller(math, max(SMALLEST, share))
