"""What a language says in its own way of an arm's program, and the parts of a file that follow from it."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from pieper.code.export import Export
from pieper.code.labels import Manner
from pieper.code.program import LoopWords, Words, statements
from pieper.tolerances import ROTATION_ACCEPTED

#: How most languages say an operation, with {0} {1} {2} for its arguments.
USUAL = {
    "add": "{0} + {1}",
    "sub": "{0} - {1}",
    "mul": "{0} * {1}",
    "div": "{0} / {1}",
    "neg": "-{0}",
    "select": "{0} ? {1} : {2}",
    "lt": "{0} < {1}",
    "le": "{0} <= {1}",
    "gt": "{0} > {1}",
    "ge": "{0} >= {1}",
    "eq": "{0} == {1}",
    "ne": "{0} != {1}",
    "and": "{0} && {1}",
    "or": "{0} || {1}",
    "not": "!{0}",
    "true": "true",
    "false": "false",
}
#: The same where arrays are compared entry by entry.
ENTRYWISE = {"and": "{0} & {1}", "or": "{0} | {1}", "not": "~{0}"}


def functions(prefix: str) -> dict[str, str]:
    """Return the elementary functions, as they are called after a prefix."""
    return {name: f"{prefix}{name}({{0}})" for name in ("abs", "sqrt", "sin", "cos")} | {
        "atan2": f"{prefix}atan2({{0}}, {{1}})"
    }


def starred(header: Sequence[str]) -> str:
    """Return a header for a comment between stars, which it must not end."""
    return "\n".join(header).replace("*/", "* /")


def quoted(header: Sequence[str]) -> str:
    """Return a header for a text between three quotes, which it must not end."""
    return "\n".join(header).replace("\\", "/").replace('"""', "'''")


@dataclass(frozen=True, kw_only=True)
class Notation:
    """How a language says an arm's numbers.

    Attributes:
        infinity: Its word for what is larger than any number.
        truths: Its words for false and true.
        header: Takes the lines that say what the file is, and makes a comment's text of them.
        manner: How it says what names a posture.
        brackets: What lists stand between.
        texts: What lists of texts stand between, and the mark on both sides of a text.
    """

    infinity: str
    truths: tuple[str, str]
    manner: Manner
    header: Callable[[Sequence[str]], str] = starred
    brackets: str = "[]"
    texts: str = '[]"'

    def numbers(self, value: Any) -> str:
        """Return numbers as nested literals."""
        return nested(value, self.brackets, finite_or(self.infinity))

    def listed(self, said: Iterable[str]) -> str:
        """Return what is said already as a list."""
        return self.brackets[0] + ", ".join(said) + self.brackets[1]

    def parts(self, export: Export) -> dict[str, str]:
        """Return what stands for the @WORDS@ of a file that say the arm and its test poses."""
        first, last, mark = self.texts
        names = ", ".join(mark + name + mark for name in export.labels.names)
        return {
            "HEADER": self.header(export.header),
            "LOWER": self.numbers(export.lower),
            "UPPER": self.numbers(export.upper),
            "SLIDES": self.listed(self.truths[int(s)] for s in export.slides),
            "LINKS": self.numbers(export.links.reshape(-1, 12)),
            "VERIFIED": repr(export.verified),
            "ACCEPTED": repr(ROTATION_ACCEPTED),
            "DEFAULT": repr(export.between.default),
            "TEST_Q": self.numbers(export.q),
            "TEST_T": self.numbers(np.round(export.T.reshape(-1, 16), 12)),
            "COUNTS": self.listed(str(k) for k in export.counts),
            **self.manner.parts(export.labels, first + names + last),
        }


@dataclass(frozen=True, kw_only=True)
class Language(Notation):
    """How a language says a program's operations as well.

    Attributes:
        words: An operation -> how it is said, with {0} {1} {2} for its arguments.
        entry: Says an entry (0 to 15, row by row) of the pose.
        assign: Takes a name, whether it is a truth, and an expression.
        loop: Makes lines of a loop.
        per_row: How the joints of a row are put together, and the rows; all joints of all rows in one list if None.
    """

    words: Mapping[str, str]
    assign: Callable[[str, bool, str], str]
    loop: Callable[[LoopWords], list[str]]
    entry: Callable[[int], str] = "T[{}]".format
    per_row: tuple[str, str] | None = None

    def parts(self, export: Export) -> dict[str, str]:
        """Return what stands for the @WORDS@ of a file."""
        program, n, between = export.program, 6, ", "
        words = Words(program, self.words, self.entry)
        lines, said = statements(words, self.assign, self.loop), words.text
        rows = [said(i) for i in program.q]
        if self.per_row is not None:
            around, between = self.per_row
            rows = [around.format(", ".join(rows[n * m : n * m + n])) for m in range(8)]
        own = {
            "PROGRAM": "\n".join(lines),
            "ROWS": between.join(rows),
            "VALID": ", ".join(said(i) for i in program.valid),
            "UNCLEAR": said(program.unclear),
        }
        return super().parts(export) | own


def nested(value: Any, brackets: str, number: Callable[[float], str]) -> str:
    """Return numbers as nested literals between a language's brackets."""
    if isinstance(value, (list, tuple, np.ndarray)):
        items: Sequence[Any] = list(value)
        return brackets[0] + ", ".join(nested(v, brackets, number) for v in items) + brackets[1]
    return number(float(value))


def finite_or(infinity: str) -> Callable[[float], str]:
    """Return how a number is said where infinity has a name of its own."""
    return lambda x: repr(x) if np.isfinite(x) else infinity if x > 0 else f"-{infinity}"


def counted(text: str, export: Export) -> str:
    """Return a text with the counts of joints (N, and N1, which is one more) and of axes (AXES, AXES1) in place."""
    counts = {"N": export.n, "N1": export.n + 1, "AXES": export.axis_count, "AXES1": export.axis_count + 1}
    return re.sub(r"(?<![@\w])(N1?|AXES1?)(?![@\w])", lambda found: str(counts[found[1]]), text)


def filled(frame: str, parts: dict[str, str], export: Export) -> str:
    """Return a frame with its @WORDS@, its counts of joints and axes and its NAME_ in place; no part is looked into."""
    parts = parts | {"TESTS": str(len(export.q))}
    own = counted(frame, export)
    own = own.replace("NAME_", f"{export.name}_")
    return re.sub(r"@([A-Z_]+)@", lambda found: parts[found[1]].replace("NAME_", f"{export.name}_"), own)
