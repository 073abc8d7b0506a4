"""The equations of an excerpt, one a piece: numbers of equations, matrices and branches taken out of the text.

`a = b, c = d` are two equations; "(7.1)", "[12]", "Eq. (5)" behind one and "(6)" or "7." before one are its number and
no factor; `{}^0_1T` is T01; the rows of a `cases` are the branches of one formula.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from pieper.judge.excerpt_matrices import Cells, taken_out

#: Between what a sentence says of singular places and what it says beside that.
_CLAUSE = re.compile(r"[,;]\s+(?=(?:and|so|thus|hence|while)\b)")
SINGULAR = "§singular§"  # before an equation that says where an arm is singular
BRANCH = "§or§"  # between the branches of a formula
#: `... = D` behind an equation, which gives its right side a name: \\equiv D, := D, \\triangleq D.
_NAMED = re.compile(
    r"=\s*(?P<what>[^=]+?)\s*(?:\\equiv|\\triangleq|\\coloneqq|:=|≡|≜)\s*(?P<name>\\?[A-Za-z]+(?:_\{?\w+\}?)?)\s*[.,;&]*\s*$"
)
_ASSIGNED = re.compile(r":=|\\coloneqq|\\triangleq|\\equiv|≡|≜")
EQUALS = re.compile(r"(?<![<>!=:])=(?!=)")
#: A sentence that says where something happens, which is no claim.
CONDITION = re.compile(r"^[A-Z][a-z]+(?:\s+[a-z]+){1,8}\s+where\s.*=")

_DIGITS = r"\d+(?:[.\-]\d+)*[a-z]?"
_BEHIND = re.compile(
    rf"\\(?:tag|label)\*?\{{([^}}]*)\}}|(?<![A-Za-z\d_^]),?\s*(?:\b(?:[Ee]qs?|[Ee]quations?|[Ff]ormula)\.?\s*)?"
    rf"(?:\(({_DIGITS})\)|(?<=\s)\[({_DIGITS})\])\s*[.,;]?\s*$|,?\s+\b(?:[Ee]qs?|[Ee]quations?)\.?\s*({_DIGITS})\s*[.,;]?\s*$"
)
_BEFORE = re.compile(
    rf"^\s*(?:(?:[Ee]qs?\b\.?|[Ee]quations?\b|[Ff]ormula\b)\s*[\(\[]?({_DIGITS})[\)\]]?\s*[:.]?|[\(\[]({_DIGITS})[\)\]]\s*:?|"
    rf"({_DIGITS})[.):])\s+(?=[A-Za-z\\{{^])"
)
_BLOCK = re.compile(
    r"\\(?:begin|end)\{(?:equation|align|aligned|alignat|gather|gathered|split|eqnarray|multline|math|displaymath)\*?\}"
)
_CASES = re.compile(
    r"(?:\\left\s*\\\{)?\s*\\begin\{(d?cases|array)\}(?:\{[lcr ]*\})?(.*?)\\end\{\1\}(?:\s*\\right\s*\.)?", re.DOTALL
)
_BESIDE = re.compile(
    r"(?<![\w})\]])(?:\{\s*\})?\s*(?:\^\s*\{?\s*(\d)\s*\}?\s*_\s*\{?\s*(\d)\s*\}?|_\s*\{?\s*(\d)\s*\}?\s*\^\s*\{?\s*(\d)\s*\}?)\s*"
    r"(?:\\(?:mathbf|mathrm|boldsymbol|bm|text)\s*\{\s*)?(?<![A-Za-z])([ATRP])(?:\s*\})?(?![A-Za-z\d_])"
)
_AROUND = re.compile(
    r"(?<![\w})\]])(?:\{\s*\})?\s*\^\s*\{?\s*(\d)\s*\}?\s*(?:\\(?:mathbf|mathrm|boldsymbol|bm|text)\s*\{\s*)?(?<![A-Za-z])([ATRP])"
    r"(?:\s*\})?\s*_\s*\{?\s*(\d)\s*\}?(?![A-Za-z\d_])"
)
_SPONG = re.compile(
    r"(?<![A-Za-z\\\\])([ATR])\s*(?:_\s*\{?\s*([1-9])\s*\}?\s*\^\s*\{?\s*(\d)\s*\}?|\^\s*\{?\s*(\d)\s*\}?\s*_\s*\{?\s*([1-9])\s*\}?)(?!\w)"
)
_JOINER = re.compile(r"\\q?quad\b|;|\\(?:text|mbox|mathrm)\s*\{\s*,?\s*(?:and|with|where)\s*\}|\b(?:and|with|where)\b")
_LEADS = re.compile(r"^(?:\s|,|&|\\q?quad\b|\b(?:and|with|where|so|then|thus|hence|therefore|giving|gives)\b:?)+")
_BETWEEN = re.compile(r"\$|\\\(|\\\)|\b(?:when|if|where|for|at|or|and)\b|,")
#: Before an equation inside a sentence: it says where, and claims nothing.
_ON_CONDITION = re.compile(
    r"\b(?:unless|except\s+(?:when|where|if|at|for)|if|when|whenever|provided(?:\s+that)?|assuming(?:\s+that)?)\s*$",
    re.I,
)
#: How a sentence says that an arm is singular somewhere.
_SINGULAR = re.compile(
    r"\bsingular|\bdeterminant\b.*\b(?:vanish\w*|zero)\b|\brank\b.*\b(?:less|fewer|below|lower|drops?|falls?|deficient)\b|"
    r"\b(?:los\w+|drops?\s+in)\s+rank\b|\brank[- ]deficient\b",
    re.I,
)
_CODE = re.compile(
    r"^[ \t]*(?:function\b.*|end;?|def\s.*:|return\b.*|(?:import|from)\s.*|clc;?|clear\b.*)[ \t]*$", re.M
)
_PROSE = re.compile(r"[A-Za-z]{3,}\s+[A-Za-z]{3,}")


@dataclass(frozen=True)
class Line:
    """One equation of an excerpt.

    Attributes:
        number: The line it stands on.
        text: The equation, or a sentence about singular places with `SINGULAR` before it.
        tag: The equation's own number, "" where it has none.
        matrices: The matrices of the excerpt; §0§ stands for the first.
    """

    number: int
    text: str
    tag: str
    matrices: list[Cells]


def bare(text: str) -> str:
    """A text without the lines of a program that are no statements, and `code` in a sentence as $a formula$."""
    return re.sub(r"(?<!`)`([^`\n]+)`(?!`)", r"$\1$", _CODE.sub("", text))


def equations(text: str) -> list[Line]:
    """Return every equation of a text; a line with a sentence about singular places gives that first."""
    text, matrices = taken_out(re.sub(r"(?<!\\)%.*", "", text))
    text = _BLOCK.sub(" ", _CASES.sub(_branches, _placed(text)))
    out: list[Line] = []
    for number, line in enumerate(text.split("\n"), 1):
        for sentence in re.split(r"(?<=[.;])\s", line):
            if _says_singular(sentence):
                begins = [0, *(cut.end() for cut in _CLAUSE.finditer(sentence))]
                clauses = zip(begins, [*begins[1:], len(sentence)], strict=True)
                # what is said of other things before it is no part of it
                said = sentence[next((a for a, b in clauses if _says_singular(sentence[a:b])), 0) :]
                out += [Line(number, f"{SINGULAR}{piece}", "", matrices) for piece in _singular(said)]
                line = line.replace(said, "")
        if "$" in line and CONDITION.search(line):
            out.append(Line(number, line.strip(), "", matrices))
            continue
        before = ""
        for piece in re.split(r"\\\\(?:\[[^\]]*\])?|\$\$|(?<!\\)\$|\\\[|\\\]|\\\(|\\\)", line):
            untagged, tag = numbered(piece)
            for one in () if _ON_CONDITION.search(before) else apart(untagged):
                out += [Line(number, text.strip(" \t.,;&"), tag, matrices) for text in _with_names(one)]
            before = piece
    return out


def _with_names(piece: str) -> list[str]:
    """The equation of a piece, before it the definition of a name that it gives its right side; nothing without one."""
    named = _NAMED.search(piece)
    if named:
        return [f"{named.group('name')} = {named.group('what')}", piece[: named.start()] + f"= {named.group('what')}"]
    piece = _ASSIGNED.sub("=", piece, count=1) if not EQUALS.search(piece) else piece
    return [piece] if EQUALS.search(piece) else []


def numbered(piece: str) -> tuple[str, str]:
    """Return a piece without the number of its equation, and that number."""
    tag = ""
    for pattern in (_BEFORE, _BEHIND):
        found = pattern.search(piece)
        if found:
            rest = piece[: found.start()] + piece[found.end() :]
            if EQUALS.search(rest):
                piece, tag = rest, next((group for group in found.groups() if group), tag)
    return piece, tag


def apart(piece: str) -> list[str]:
    """Return the equations of a piece that has several, separated by commas, `and`, `with`, `where` or wide spaces."""
    cuts, depth = [0], 0
    for k, letter in enumerate(piece):
        depth += (letter in "([{") - (letter in ")]}")
        joined = _JOINER.match(piece, k) if depth == 0 and (k == 0 or not piece[k - 1].isalpha()) else None
        if depth == 0 and (letter == "," or joined):
            cuts.append(k)
    parts = [piece[a:b] for a, b in zip(cuts, [*cuts[1:], len(piece)], strict=True)]
    out: list[str] = []
    for part in parts:
        body = _LEADS.sub("", part.lstrip(";"))
        left = EQUALS.split(body, maxsplit=1)[0]
        whole = EQUALS.search(body) and not re.match(r"\s*(?:\\text\s*\{\s*)?(?:for|if|when|provided)\b", body)
        if out and not (whole and EQUALS.search(out[-1]) and left.strip() and not re.search(r"[<>]", left)):
            out[-1] += part
        else:
            out.append(body if out else part)
    return out


def _branches(match: re.Match[str]) -> str:
    """The rows of a `cases` as branches; a column of conditions behind them is left out."""
    rows = [row.partition("&")[0].strip(" \t\n,") for row in re.split(r"\\\\(?:\[[^\]]*\])?", match.group(2))]
    rows = [row for row in rows if row]
    if any(EQUALS.search(row) for row in rows):
        return match.group(2)  # equations below each other
    return " " + f" {BRANCH} ".join(" ".join(row.split()) for row in rows) + "\n" * match.group().count("\n")


def _placed(text: str) -> str:
    """Names of matrices with their indices before the letter, or around it, as T01."""

    def name(letter: str, first: str, last: str) -> str:
        return f" {'T' if letter == 'A' else letter}{first}{last} "

    text = _BESIDE.sub(lambda m: name(m.group(5), m.group(1) or m.group(4), m.group(2) or m.group(3)), text)
    text = _AROUND.sub(lambda m: name(m.group(2), m.group(1), m.group(3)), text)

    def behind(m: re.Match[str]) -> str:
        """T_3^0, and T^0_3: the frame above is the one that it is seen from."""
        above, below = (m.group(3) or m.group(4)), (m.group(2) or m.group(5))
        return name(m.group(1), above, below) if int(above) < int(below) else m.group(0)

    return _SPONG.sub(behind, text)


def _says_singular(sentence: str) -> bool:
    return bool(_SINGULAR.search(sentence) and EQUALS.search(sentence))


def _singular(sentence: str) -> list[str]:
    """The equations of a sentence about singular configurations, joined by or."""
    pieces = [piece.strip(" .,;") for piece in _BETWEEN.split(sentence)]
    found = [piece for piece in pieces if EQUALS.search(piece) and not _PROSE.search(piece)]
    return [" or ".join(found)] if found else []
