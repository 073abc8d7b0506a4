"""Matrices in an excerpt, as LaTeX, Python, MATLAB and plain text print them: taken out, their places marked."""

from __future__ import annotations

import re

Cells = list[list[str]]
PLACED = re.compile(r"§(\d+)§")
_LATEX = re.compile(r"\\begin\{([bpv]?matrix|array)\}(?:\{[^}]*\})?(.*?)\\end\{\1\}", re.DOTALL)
_NESTED = re.compile(
    r"(?:[\w.]*(?:array|Matrix|matrix)\s*\(\s*)?\[\s*(\[[^\[\]]*\]\s*(?:,\s*\[[^\[\]]*\]\s*)+),?\s*\]\s*\)?"
)
_ROWS = re.compile(r"(?<=[=:])[ \t]*\n?((?:[ \t]*\[[^\[\]=]*\][ \t]*[,;]?[ \t]*(?:\n|$)){2,4})")
_SEMICOLONS = re.compile(r"(?<=[=])[ \t]*\[([^\[\]=]*;[^\[\]=]*)\]")


def taken_out(text: str) -> tuple[str, list[Cells]]:
    """The text with every matrix replaced by a mark §0§, §1§, and the matrices' cells.

    Args:
        text: The excerpt; line breaks keep their number.
    """
    found: list[Cells] = []

    def keep(cells: Cells, match: re.Match[str]) -> str:
        if len({len(row) for row in cells}) != 1 or len(cells) < 2:
            return match.group()
        found.append(cells)
        breaks = match.group().count("\n")
        return f" §{len(found) - 1}§" + "\n" * breaks

    def latex(match: re.Match[str]) -> str:
        rows = [row for row in re.split(r"\\\\", match.group(2)) if row.strip()]
        return keep([[cell.strip() for cell in row.split("&")] for row in rows], match)

    def rows(match: re.Match[str]) -> str:
        return keep([_cells(row) for row in re.findall(r"\[([^\[\]]*)\]", match.group(1))], match)

    def semicolons(match: re.Match[str]) -> str:
        return keep([_cells(row) for row in match.group(1).split(";") if row.strip()], match)

    text = _LATEX.sub(latex, text)
    text = _ROWS.sub(rows, _NESTED.sub(rows, text))
    return _SEMICOLONS.sub(semicolons, text), found


def _cells(row: str) -> list[str]:
    """The cells of a row: between commas outside of brackets, or between spaces where there is no comma."""
    depth, cells, separator = 0, [""], "," if "," in re.sub(r"\([^()]*\)", "", row) else " "
    for letter in row.strip():
        depth += (letter in "([{") - (letter in ")]}")
        if letter == separator and not depth:
            cells.append("")
        else:
            cells[-1] += letter
    return [cell.strip() for cell in cells if cell.strip()]
