"""Write the pages of verdicts, one Markdown page a claims file: what is published is what the judge says today.

Run as ``python -m pieper.judge.pages examples/claims docs/papers``.
"""

from __future__ import annotations

import sys
from pathlib import Path

from pieper.judge.claims import check
from pieper.judge.verdict import Judgement

COMMAND = "python -m pieper.judge.pages examples/claims docs/papers"
NOTE = "This page is written by `" + COMMAND + "` from `examples/claims/{name}`."


def page(path: Path, judgement: Judgement | None = None) -> str:
    """Return the page of one claims file; `judgement` is its judgement when it is at hand."""
    text = (judgement or check(path)).markdown()
    head, rest = text.split("\n", 1)
    return f"{head}\n\n{NOTE.format(name=path.name)}\n{rest}"


def write(claims: Path, folder: Path) -> list[Path]:
    """Write a page for every claims file of a folder and an index of them; return what was written."""
    folder.mkdir(parents=True, exist_ok=True)
    written, rows = [], []
    for path in sorted(claims.glob("*.toml")):
        text = page(path)
        target = folder / f"{path.stem}.md"
        target.write_text(text, encoding="utf-8")
        written.append(target)
        title = text.split("\n", 1)[0].removeprefix("# ")
        summary = next(line for line in text.splitlines() if line.startswith("**") and "claims:" in line).strip("*")
        rows.append(f"| [{title}]({path.stem}.md) | {summary} |")
    index = folder / "index.md"
    lines = [
        "# Five papers, judged",
        "",
        "Every numbered equation, table and figure value of five papers, judged by `pieper check`.",
    ]
    lines += ["", "| paper | verdicts |", "|---|---|", *rows, ""]
    index.write_text("\n".join(lines), encoding="utf-8")
    return [*written, index]


if __name__ == "__main__":
    for made in write(Path(sys.argv[1]), Path(sys.argv[2])):
        print(made)
