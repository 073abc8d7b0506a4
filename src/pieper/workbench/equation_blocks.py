"""The arm's equations as blocks for the page: headings, sentences, formulas, entries of the pose."""

from __future__ import annotations

import re
from typing import Any

import pieper

#: Formulas longer than this are not typeset: the browser would stand still for seconds.
LONGEST_FORMULA = 30_000
_DISPLAY = re.compile(r"\\\[(.*?)\\\]|\\begin\{(align\*?|equation\*?|gather\*?)\}(.*?)\\end\{\2\}", re.DOTALL)
_HEADING = re.compile(r"\\(?:section|subsection|subsubsection|paragraph)\*?\{((?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*)\}")


def forward_blocks(arm: pieper.Arm, lengths: str) -> list[dict[str, Any]]:
    """Return A_i, the partial products and the twelve entries of the pose."""
    fk = arm.symbolic.fk(lengths=lengths)
    blocks: list[dict[str, Any]] = []
    if fk.relations():
        blocks += [{"heading": "Joint angles of the table"}, *({"latex": line} for line in fk.relations("latex"))]
    if fk.meanings():
        blocks += [{"heading": "Constants, in metres"}, {"latex": r",\quad ".join(fk.meanings("latex"))}]
    blocks.append({"heading": "The pose, entry by entry"})
    for k, line in enumerate(fk.pose.equations("latex")):
        blocks.append(_formula(line, entry=4 * (k % 3) + k // 3))
    blocks.append({"heading": "Link matrices and products"})
    blocks += [_formula(m.latex()) for m in fk.matrices()[: fk.n + 2 if fk.n > 2 else fk.n]]
    return blocks


def inverse_blocks(arm: pieper.Arm) -> list[dict[str, Any]]:
    """Return the derivation of the inverse, step by step."""
    return blocks_of_latex(arm.symbolic.ik().latex())


def singular_blocks(arm: pieper.Arm) -> list[dict[str, Any]]:
    """Return the determinant's factors and what each means."""
    return blocks_of_latex(arm.symbolic.singularities().latex())


def _formula(latex: str, **more: Any) -> dict[str, Any]:
    if len(latex) > LONGEST_FORMULA:
        return {"text": f"(A formula of {len(latex):,} characters is left out here; the library has it.)"}
    return {"latex": latex, **more}


def blocks_of_latex(text: str) -> list[dict[str, Any]]:
    """Cut a LaTeX fragment into displayed formulas, headings and sentences with inline formulas between dollars.

    Args:
        text: Paragraphs with displayed formulas among them, without a preamble.
    """
    blocks: list[dict[str, Any]] = []
    at = 0
    for found in _DISPLAY.finditer(text):
        blocks += _sentences(text[at : found.start()])
        plain, kind, body = found.groups()
        inner = plain or body or ""
        if kind and kind.startswith("align"):
            inner = rf"\begin{{aligned}}{inner}\end{{aligned}}"
        elif kind and kind.startswith("gather"):
            inner = rf"\begin{{gathered}}{inner}\end{{gathered}}"
        blocks.append(_formula(inner.strip()))
        at = found.end()
    return blocks + _sentences(text[at:])


def _sentences(text: str) -> list[dict[str, Any]]:
    out: list[dict[str, Any]] = []
    for paragraph in re.split(r"\n\s*\n", text):
        at = 0
        for heading in _HEADING.finditer(paragraph):
            out += _prose(paragraph[at : heading.start()])
            out.append({"heading": _plain(heading.group(1))})
            at = heading.end()
        out += _prose(paragraph[at:])
    return out


def _prose(text: str) -> list[dict[str, Any]]:
    text = _plain(text)
    return [{"text": text}] if text else []


def _plain(text: str) -> str:
    """Return a LaTeX sentence as words; formulas between dollars are kept for the page to typeset."""
    parts = re.split(r"(\$[^$]*\$)", text.replace(r"\(", "$").replace(r"\)", "$").replace("$$", ""))
    for i in range(0, len(parts), 2):
        words = re.sub(r"\\(?:begin|end)\{[a-z*]+\}(?:\[[^\]]*\])?", " ", parts[i])
        words = re.sub(r"\\item\b\s*", "\n• ", words)
        words = re.sub(r"\\(?:emph|textbf|textit|texttt|text|mbox|label)\{([^{}]*)\}", r"\1", words)
        words = words.replace(r"\\", " ").replace("~", " ").replace("---", "–").replace("--", "–")
        words = re.sub(r"\\([%&_#{}$])", r"\1", words)
        parts[i] = re.sub(r"\\[a-zA-Z]+\*?\s?", "", words)
    return re.sub(r"[ \t]*\n[ \t]*(?!•)", " ", "".join(parts)).strip()
