"""A page as LaTeX: a source that compiles with pdflatex, its figures as PDF files beside it, or the inside of one."""

from __future__ import annotations

import re

from pieper.document import blocks as b
from pieper.document.formulas import equals
from pieper.document.text import plain
from pieper.document.writer import Typesetter

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
% a figure stands above text, and alone on a page only when it fills it
\renewcommand{\topfraction}{0.92}\renewcommand{\bottomfraction}{0.8}
\renewcommand{\textfraction}{0.05}\renewcommand{\floatpagefraction}{0.85}
\setlength{\parindent}{0pt}
\setlength{\emergencystretch}{3em}
\setlength{\parskip}{0.6ex plus 0.2ex}
\setlength{\tabcolsep}{4pt}
\setcounter{MaxMatrixCols}{20}
% a display is set once in a box; wider than the line, it is scaled down to it; much wider, it is broken at its signs
\newsavebox{\formulabox}
\newcommand{\broken}[1]{\parbox{\linewidth}{\raggedright\hangindent=3em\hangafter=1\relpenalty=0\binoppenalty=0
  \let\left\relax\let\right\relax$\displaystyle #1$}}
\newcommand{\fitted}[1]{\sbox{\formulabox}{$\displaystyle #1$}%
  \ifdim\wd\formulabox>1.35\linewidth\broken{#1}\else
  \ifdim\wd\formulabox>\linewidth\resizebox{\linewidth}{!}{\usebox{\formulabox}}\else\usebox{\formulabox}\fi\fi}
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


#: Letters of a word that has no hyphen TeX knows of, such as a path or an address; it may end a line at these.
LONG_WORD, ENDS = 20, "/_"


def latex_text(words: str) -> str:
    """Return plain text as LaTeX; characters that pdflatex cannot set become a question mark."""
    return "".join(_latex_word(part) for part in re.split(r"(\s+)", words))


def _latex_word(word: str) -> str:
    long = len(word) > LONG_WORD
    return "".join(
        _SPECIAL.get(c, c if ord(c) < 0x250 else "?") + (r"\allowbreak{}" if long and c in ENDS else "") for c in word
    )


def source(document: b.Document, folder: str = "figures") -> tuple[str, dict[str, bytes]]:
    """Return a document as LaTeX source and the files it needs.

    Args:
        document: The page.
        folder: Name of the folder of figures beside the source.

    Returns:
        The source, and the figures: relative file name to content.
    """
    writer = _Writer(folder, fit=True)
    title = rf"\title{{{writer.line(document.title)}}}" + "\n"
    title += rf"\author{{{writer.line(document.subtitle)}}}" + "\n" + r"\date{}" + "\n"
    parts = [HEAD, title, r"\begin{document}", r"\maketitle"]
    if document.summary:
        parts.append(rf"\begin{{quote}}{writer.line(document.summary)}\end{{quote}}")
    parts += [*map(writer.block, document.blocks), r"\end{document}"]
    return "\n\n".join(parts) + "\n", writer.files


def fragment(document: b.Document) -> str:
    """Return the inside of a LaTeX document (needs amsmath), formulas at their full width."""
    writer = _Writer("figures", fit=False)
    title = [rf"\subsection*{{{writer.line(document.title)}}}"] if document.title else []
    return "\n\n".join([*title, *map(writer.block, document.blocks)]) + "\n"


class _Writer(Typesetter):
    """Writes blocks one after the other and keeps the figures for their folder."""

    def __init__(self, folder: str, *, fit: bool) -> None:
        self.folder, self.fit = folder, fit
        self.files: dict[str, bytes] = {}

    def _words(self, words: str) -> str:
        return latex_text(words)

    def _code(self, words: str) -> str:
        return rf"\texttt{{{latex_text(words)}}}"

    def _emphasis(self, words: str) -> str:
        return rf"\emph{{{latex_text(words)}}}"

    def _formula(self, formula: b.Formula) -> str:
        return f"${formula.latex()}$"

    def _heading(self, item: b.Heading) -> str:
        command = {True: ("section", "subsection"), False: ("section*", "paragraph")}[item.numbered]
        return rf"\{command[item.level - 1]}{{{self.line(*item.pieces)}}}"

    def _equation(self, item: b.Equation) -> str:
        number = rf" \tag{{{item.number}}}" if item.number is not None else ""
        return rf"\[ {self._body(item)}{number} \]"

    def _lines(self, item: b.Lines) -> str:
        kind = "enumerate" if item.numbered else "itemize"
        items = "\n".join(rf"\item {self.piece(words)}" for words in item.items)
        return rf"\begin{{{kind}}}" + "\n" + items + "\n" + rf"\end{{{kind}}}"

    def _listing(self, item: b.Listing) -> str:
        rows = ("".join(map(_typed, row)) for row in item.lines.splitlines())
        return "{\\small\n\\begin{verbatim}\n" + "\n".join(rows) + "\n\\end{verbatim}\n}"

    def _body(self, item: b.Equation) -> str:
        body = equals(*item.sides).latex()
        return rf"\fitted{{{body}}}" if self.fit else body

    def _equations(self, item: b.Equations) -> str:
        if item.beside:
            bodies = [equals(*row.sides).latex() for row in item.rows]
            rows = [r" \qquad ".join(bodies[k : k + 3]) for k in range(0, len(bodies), 3)]
            return "\n".join(rf"\[ \fitted{{{row}}} \]" if self.fit else rf"\[ {row} \]" for row in rows)
        if self.fit:
            rows, kind = [self._body(row) for row in item.rows], "gather*"
        else:
            rows, kind = [" &= ".join(side.latex() for side in row.sides) for row in item.rows], "align*"
        return rf"\begin{{{kind}}}" + "\n" + " \\\\\n".join(rows) + "\n" + rf"\end{{{kind}}}"

    def _picture(self, item: b.Picture) -> str:
        name = f"{self.folder}/{item.name}.pdf"
        self.files[name] = item.drawing.pdf()
        return (
            "\\begin{figure}[!htbp]\n\\centering\n"
            rf"\includegraphics[width={min(item.width, 1.0):z.2f}\linewidth]{{{name}}}"
            "\n" + rf"\caption{{{self.line(item.caption)}}}" + "\n\\end{figure}"
        )

    def _table(self, item: b.Table) -> str:
        columns = "".join("l" if i in item.left else "r" for i in range(len(item.head)))
        head = " & ".join(rf"\textbf{{{self.line(c)}}}" for c in item.head)
        rows = [" & ".join(self.line(c) for c in row) + r" \\" for row in item.rows]
        body = "\n".join([r"\toprule", head + r" \\", r"\midrule", *rows, r"\bottomrule"])
        caption = rf"\caption{{{self.line(item.caption)}}}" if item.caption else ""
        inside = rf"\begin{{tabular}}{{{columns}}}" + "\n" + body + "\n" + r"\end{tabular}"
        width = sum(max(len(plain(row[i])) for row in (item.head, *item.rows)) + 2 for i in range(len(item.head)))
        if width > 88:
            inside = r"\resizebox{\linewidth}{!}{%" + "\n" + inside + "}"
        return "\\begin{table}[!htbp]\n\\centering\\small\n" + caption + "\n" + inside + "\n\\end{table}"


def _typed(character: str) -> str:
    if ord(character) < 128:
        return character
    return {"°": " deg", "θ": "theta", "±": "+-", "−": "-", "²": "^2", "→": "->", "∞": "inf", "·": "*"}.get(
        character, "?"
    )
