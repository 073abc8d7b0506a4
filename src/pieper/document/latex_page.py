"""A document as LaTeX source that compiles with pdflatex, with its figures as PDF files beside it."""

from __future__ import annotations

import io
import re
from pathlib import Path

from pieper.document.blocks import Code, Document, Formula, Formulas, Heading, Lines, Picture, Table, Text, marked

HEAD = r"""\documentclass[11pt,a4paper]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{lmodern}
\usepackage{textcomp}
\usepackage{amsmath,amssymb}
\usepackage{graphicx}
\usepackage{booktabs}
\usepackage{longtable}
\usepackage[margin=22mm]{geometry}
\usepackage[hidelinks]{hyperref}
\allowdisplaybreaks
\setlength{\parindent}{0pt}
\setlength{\parskip}{0.6ex plus 0.2ex}
\setlength{\tabcolsep}{4pt}
\setcounter{MaxMatrixCols}{20}
"""

_SPECIAL = {
    "\\": r"\textbackslash{}", "{": r"\{", "}": r"\}", "$": r"\$", "&": r"\&", "#": r"\#", "%": r"\%", "_": r"\_",
    "^": r"\textasciicircum{}", "~": r"\textasciitilde{}", "<": r"\textless{}", ">": r"\textgreater{}",
    "|": r"\textbar{}",
    "°": r"\textdegree{}", "\u00a0": "~", "±": r"\ensuremath{\pm}", "−": r"\ensuremath{-}", "·": r"\ensuremath{\cdot}",
    "×": r"\ensuremath{\times}", "²": r"\ensuremath{^2}", "³": r"\ensuremath{^3}", "∞": r"\ensuremath{\infty}",
    "→": r"\ensuremath{\to}", "≤": r"\ensuremath{\le}", "≥": r"\ensuremath{\ge}", "≈": r"\ensuremath{\approx}",
    "θ": r"\ensuremath{\theta}", "α": r"\ensuremath{\alpha}", "π": r"\ensuremath{\pi}", "σ": r"\ensuremath{\sigma}",
    "γ": r"\ensuremath{\gamma}", "β": r"\ensuremath{\beta}", "φ": r"\ensuremath{\varphi}", "√": r"\ensuremath{\surd}",
    "…": r"\ldots{}", "–": "--", "—": "---", "‘": "`", "’": "'", "“": "``", "”": "''", "½": r"\ensuremath{\frac12}",
    "⁻": r"\ensuremath{^-}", "¹": r"\ensuremath{^1}", "⁰": r"\ensuremath{^0}",
} | {chr(0x2080 + k): rf"\ensuremath{{_{k}}}" for k in range(10)}  # fmt: skip


def latex_text(text: str) -> str:
    """Return plain text as LaTeX; characters that pdflatex cannot set become a question mark."""
    return "".join(_SPECIAL.get(c, c if ord(c) < 0x250 else "?") for c in text)


def inline(text: str) -> str:
    """Return a paragraph as LaTeX, `code` and *emphasis* marked."""
    forms = {"plain": "{}", "code": r"\texttt{{{}}}", "emphasis": r"\emph{{{}}}"}
    return "".join(forms[kind].format(latex_text(piece)) for kind, piece in marked(text))


def source(document: Document, folder: str = "figures") -> tuple[str, dict[str, bytes]]:
    """Return a document as LaTeX source and the files it needs.

    Args:
        document: The page.
        folder: Name of the folder of figures beside the source.

    Returns:
        The source, and the figures: relative file name to content.
    """
    files: dict[str, bytes] = {}
    title = rf"\title{{{inline(document.title)}}}" + "\n"
    title += rf"\author{{{inline(document.subtitle)}}}" + "\n" + r"\date{}" + "\n"
    parts = [HEAD, title, r"\begin{document}", r"\maketitle"]
    if document.summary:
        parts.append(rf"\begin{{quote}}{inline(document.summary)}\end{{quote}}")
    parts += [_block(block, folder, files) for block in document.blocks]
    parts.append(r"\end{document}")
    return "\n\n".join(parts) + "\n", files


def _block(block: object, folder: str, files: dict[str, bytes]) -> str:
    if isinstance(block, Heading):
        return rf"\{'section' if block.level == 1 else 'subsection'}{{{inline(block.text)}}}"
    if isinstance(block, Text):
        return inline(block.text)
    if isinstance(block, Lines):
        kind = "enumerate" if block.numbered else "itemize"
        items = "\n".join(rf"\item {inline(item)}" for item in block.items)
        return rf"\begin{{{kind}}}" + "\n" + items + "\n" + rf"\end{{{kind}}}"
    if isinstance(block, Table):
        return _table(block)
    if isinstance(block, Picture):
        name = f"{folder}/{block.name}.pdf"
        out = io.BytesIO()
        block.figure.savefig(out, format="pdf", metadata={"CreationDate": None})
        files[name] = out.getvalue()
        return (
            "\\begin{figure}[!htbp]\n\\centering\n"
            rf"\includegraphics[width={min(block.width, 1.0):.2f}\linewidth]{{{name}}}"
            "\n" + rf"\caption{{{inline(block.caption)}}}" + "\n\\end{figure}"
        )
    if isinstance(block, Formula):
        return fitted(block.latex)
    if isinstance(block, Formulas):
        bodies = [f.latex.strip().removeprefix(r"\[").removesuffix(r"\]").strip() for f in block.formulas]
        rows = [r" \qquad ".join(bodies[k : k + 3]) for k in range(0, len(bodies), 3)]
        return "\n".join(rf"\[ \fitted{{{row}}} \]" for row in rows)
    if isinstance(block, Code):
        body = "\n".join("".join(c if ord(c) < 128 else _plain(c) for c in line) for line in block.text.splitlines())
        return "{\\small\n\\begin{verbatim}\n" + body + "\n\\end{verbatim}\n}"
    raise TypeError(f"a page cannot hold a {type(block).__name__}")


def _plain(character: str) -> str:
    return {"°": " deg", "θ": "theta", "±": "+-", "−": "-", "²": "^2", "→": "->", "∞": "inf", "·": "*"}.get(
        character, "?"
    )


def _table(block: Table) -> str:
    columns = "".join("l" if i in block.left else "r" for i in range(len(block.head)))
    head = " & ".join(rf"\textbf{{{inline(c)}}}" for c in block.head)
    rows = [" & ".join(inline(c) for c in row) + r" \\" for row in block.rows]
    body = "\n".join([r"\toprule", head + r" \\", r"\midrule", *rows, r"\bottomrule"])
    caption = rf"\caption{{{inline(block.caption)}}}" if block.caption else ""
    inside = rf"\begin{{tabular}}{{{columns}}}" + "\n" + body + "\n" + r"\end{tabular}"
    width = sum(max(len(str(row[i])) for row in (block.head, *block.rows)) + 2 for i in range(len(block.head)))
    if width > 88:
        inside = r"\resizebox{\linewidth}{!}{%" + "\n" + inside + "}"
    return "\\begin{table}[!htbp]\n\\centering\\small\n" + caption + "\n" + inside + "\n\\end{table}"


_DISPLAY = re.compile(r"\\\[(.*?)\\\]", re.S)


def fitted(latex: str) -> str:
    """Return LaTeX whose displays are shrunk to the width of the line where they are longer."""

    def shrunk(match: re.Match) -> str:
        body = match[1].strip()
        return rf"\[ \fitted{{{body}}} \]"

    return _DISPLAY.sub(shrunk, latex)


# a display is set once in a box; wider than the line, it is scaled down to it
HEAD += r"""\newsavebox{\formulabox}
\newcommand{\fitted}[1]{\sbox{\formulabox}{$\displaystyle #1$}%
  \ifdim\wd\formulabox>\linewidth\resizebox{\linewidth}{!}{\usebox{\formulabox}}\else\usebox{\formulabox}\fi}
"""


def write_beside(path: Path, files: dict[str, bytes]) -> list[Path]:
    """Write the figures of a LaTeX source beside it, each whole or not at all; return them."""
    from pieper.document.writing import write_whole
    from pieper.errors import InputError

    out = []
    for name, content in files.items():
        target = path.parent / name
        try:
            target.parent.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise InputError(f"cannot make the folder {target.parent}: {error.strerror}.", path=target) from None
        out.append(write_whole(target, content))
    return out
