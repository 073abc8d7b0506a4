"""What running text says of how many solutions a pose has: "there are four solutions", "up to eight", "none if D > 1".

A number counts when it belongs to the arm: what a sentence says of one joint, one equation or one part of the arm is
judged with its formula and stands here as a remark only where somebody might take it for the whole.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from pieper.algebra.spelling import plain

_NUMBERS = "no one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen".split()
_WORDS = {word: value for value, word in enumerate(_NUMBERS)} | {"zero": 0, "a single": 1, "a unique": 1, "unique": 1}
_WORDS |= {"thirty-two": 32, "thirty two": 32, "twice two": 4}
_KIND = (
    r"possible|different|distinct|inverse|kinematics?|ik|closed[- ]form|analytic(?:al)?|real|valid|feasible|admissible|"
    r"mathematical(?:ly)?|theoretical|such|joint|angle|arm|robot|independent|separate|unique|exact|correct|discrete|"
    r"alternative|following|equivalent|general|potential|available"
)
_THINGS = (
    r"solutions?(?:\s+sets?)?|(?:arm\s+)?configurations?|postures?|branches|sets?\s+of\s+(?:joint\s+|inverse\s+)?"
    r"(?:angles?|solutions?|values?|variables?)|joint\s+vectors?|ways\s+(?:to|of)\s+reach(?:ing)?"
)
_NUMBER = "|".join(sorted(map(re.escape, _WORDS), key=len, reverse=True)) + r"|\d+"
_COUNT = re.compile(
    rf"(?<![\w.])(?P<number>{_NUMBER})(?:\s+\((?P<again>\d+)\))?(?:\s+(?:{_KIND}),?)*\s+(?P<thing>{_THINGS})\b",
    re.IGNORECASE,
)
_AFTER = re.compile(
    rf"\bnumber\s+of\s+(?:(?:{_KIND})\s+)*(?P<thing>{_THINGS})(?:\s+(?:for|of)\s+[\w\s-]{{1,40}}?)?\s*(?:is|are|equals|:|=)\s*"
    rf"(?P<most>at most|up to)?\s*(?P<number>{_NUMBER})\b",
    re.IGNORECASE,
)
#: What says that there are so many, and not that some of them are spoken of.
_SAYS = re.compile(
    r"\b(?:there\s+(?:is|are|exists?|will\s+be|can\s+be|may\s+be)|has|have|having|admits?|possess(?:es)?|exists?|yields?|"
    r"gives?|giving|results?\s+in|leads?\s+to|leading\s+to|obtain(?:s|ed)?|find|found|get|up\s+to|at\s+most|maximum\s+of|"
    r"max(?:imum)?|exactly|total\s+of|reach(?:ed)?(?:\s+\w+){0,3}\s+(?:in|with|by)|produces?|provides?|only|allows?)\b",
    re.IGNORECASE,
)
_MOST = re.compile(
    r"\b(?:up\s+to|at\s+most|(?:a\s+)?max(?:imum)?(?:\s+of)?|no\s+more\s+than|not\s+more\s+than)\s*$", re.I
)
_LEAST = re.compile(r"\b(?:at\s+least|more\s+than|over|fewer\s+than|less\s+than|about|around)\s*$", re.IGNORECASE)
_DEFINITE = re.compile(r"\b(?:the|these|those|both|our|its|of|other|last|first|remaining)\s*$", re.IGNORECASE)
#: A step, an equation or one joint; a part of the arm.
_STEP = re.compile(
    r"\b(?:equations?|quadratic|polynomial|quartic|signs?|roots?|sines?|cosines?|step|cos|sin|atan2?|acos|asin|arc\w+|"
    r"branch(?:es)?\s+of|values?\s+of|each)\b|\b(?:for|of|in)\s+(?:the\s+)?(?:joints?\s+(?:angle\s+)?|angles?\s+)?"
    r"\(?(?:theta|q|θ|phi|beta|alpha|d)_?\{?\d|\b(?:for|of)\s+(?:the\s+)?(?:first|second|third|fourth|fifth|sixth|last)\s+"
    r"(?:joint|angle)\b|\bjoint\s+\d",
    re.IGNORECASE,
)
_PART = re.compile(
    r"\b(?:first\s+(?:two|three|3)\s+joints|last\s+(?:two|three|3)\s+joints|wrist|shoulder|spherical|arm\s+part|subproblem|joints\s+\d)\b",
    re.I,
)
_IF = re.compile(r"\b(?:if|when|whenever|provided(?:\s+that)?|for|where)\b(.*)$", re.IGNORECASE | re.DOTALL)
_FIRST = re.compile(
    r"\s*(?:if|when|whenever|provided(?:\s+that)?|for)\b(.*?)(?:,|\bthere\b|\bthen\b|\bthe\s+arm\b)", re.IGNORECASE
)
_COMPARES = re.compile(r"[<>]|\\[lg](?:eq?|t)\b|[≤≥]")
_NOT_ONE = re.compile(r"\b(?:singular|choose|select|pick|take|one\s+of|for\s+example|e\.g\.)\b", re.IGNORECASE)
_ENDLESS = re.compile(
    r"\b(?:infinitely\s+many|infinite(?:\s+number\s+of)?|endlessly\s+many)\s+(?:\w+\s+){0,2}solutions?\b", re.I
)
_POSITION = re.compile(r"\bpositions?\b|\bpoints?\b", re.IGNORECASE)
_POSE = re.compile(r"\bposes?\b|\borientations?\b", re.IGNORECASE)


@dataclass
class Counted:
    """A sentence that says how many solutions there are.

    Attributes:
        line: Where it begins.
        text: The sentence.
        keys: Those of a claim of kind `count`; empty where it was not read.
        why: Why it was not.
    """

    line: int
    text: str
    keys: dict[str, object] = field(default_factory=dict)
    why: str = ""


def counted(text: str) -> list[Counted]:
    """Return what the sentences of a text or LaTeX excerpt say of the number of solutions."""
    return [said for line, sentence in _sentences(text) for said in [_read(line, sentence)] if said is not None]


def _sentences(text: str) -> list[tuple[int, str]]:
    """The sentences of running text with the lines on which they begin; lines of a paragraph are one text."""
    out: list[tuple[int, str]] = []
    line = 1
    for paragraph in re.split(r"(\n\s*\n|\n(?=\s*(?:[-*+]\s|\d+[.)]\s|#|\\item\b|\\section|\\subsection)))", text):
        at = 0
        for end in [*(m.end() for m in re.finditer(r"[.;!?](?=\s|$)|:\s*\n", paragraph)), len(paragraph)]:
            piece = paragraph[at:end]
            start = line + paragraph[: at + len(piece) - len(piece.lstrip())].count("\n")
            if piece.strip():
                out.append((start, " ".join(piece.split())))
            at = end
        line += paragraph.count("\n")
    return out


def _bare(sentence: str) -> str:
    """The sentence without marks of LaTeX and Markdown around its words and numbers."""
    bare = re.sub(r"\\(?:emph|textbf|textit|text|mathbf|mathrm|underline|textsc)\s*\{([^{}]*)\}", r"\1", sentence)
    bare = re.sub(r"\*\*|__|`|~|\\,|\\;|\\ ", " ", bare)
    bare = re.sub(r"(?<!\w)[*_](\w[^*_]*)[*_](?!\w)", r"\1", bare)
    # 2^3 = 8 and 2 x 2 x 2 = 8: what comes out counts
    bare = re.sub(r"\$?\s*\d+(?:\s*(?:\^|\\times|\\cdot|×|x|\*|·)\s*\{?\d+\}?)+\s*=\s*(\d+)\s*\$?", r" \1 ", bare)
    bare = re.sub(r"\$\s*(\d+)\s*\$", r"\1", bare)
    return " ".join(bare.split())


def _read(line: int, sentence: str) -> Counted | None:
    bare = _bare(sentence)
    if _ENDLESS.search(bare):
        return Counted(
            line, sentence, why="endlessly many solutions: a claim of kind freedom says which joint is free there"
        )
    found = _AFTER.search(bare) or _COUNT.search(bare)
    if found is None:
        return None
    before = bare[: found.start("number")].rstrip()
    after_form = found.re is _AFTER
    most = bool(found.group("most")) if after_form else bool(_MOST.search(before))
    if not after_form:
        if _DEFINITE.search(before) and not re.search(r"\b(?:maximum|total)\s+of$", before, re.I):
            return None
        if (
            not most
            and not _SAYS.search(before)
            and not re.match(r"\s*(?:is|are)?\s*(?:possible|exist)", bare[found.end() :])
        ):
            return None
    if _LEAST.search(before):
        return Counted(line, sentence, why="a bound from below, or a rough number, is not judged")
    number = found.group("number").lower()
    count = int(number) if number.isdigit() else _WORDS[number]
    condition, about = "", bare
    told = _IF.search(bare, found.end())
    first = _FIRST.match(bare)
    if first and found.start() >= first.end() and _COMPARES.search(first.group(1)):
        condition, about = plain(_compared(first.group(1))).strip(" .,;:"), bare[first.end() :]
    elif told and _COMPARES.search(told.group(1)):
        condition, about = plain(_compared(told.group(1))).strip(" .,;:"), bare[: told.start()]
    if _STEP.search(re.sub(r"[\\\\${}]", "", about)) or sentence.rstrip().endswith(":") and count == 1:
        return None
    if _NOT_ONE.search(about) and count:
        return None
    if _PART.search(about.partition(":")[0]):  # behind a colon the postures are named
        return Counted(line, sentence, why="it counts the solutions of a part of the arm, not of a pose")
    if count == 0 and not condition:
        why = 'when there is no solution is said in words; write it as when = ".." with count = 0'
        return Counted(line, sentence, why=why) if told else None
    keys: dict[str, object] = {"kind": "count", "count": count}
    if most:
        keys["at_most"] = True
    if condition:
        keys["when"] = condition
    if _POSITION.search(about) and not _POSE.search(about):
        keys["task"] = "position"
    return Counted(line, sentence, keys)


def _compared(text: str) -> str:
    """A condition with the signs of comparison that a claims file has."""
    for signs, sign in ((r"\\leq?\b|≤", "<="), (r"\\geq?\b|≥", ">="), (r"\\lt\b", "<"), (r"\\gt\b", ">"), (r"\$", " ")):
        text = re.sub(signs, sign, text)
    return " ".join(text.split())
