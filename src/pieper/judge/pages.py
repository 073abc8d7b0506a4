"""Write the pages of verdicts, one Markdown page a claims file: what is published is what the judge says today.

Run as ``python -m pieper.judge.pages examples/claims docs/papers``, or ``.. examples/pages docs/pages``.
"""

from __future__ import annotations

import sys
import tomllib
from pathlib import Path

from pieper.judge.claims import check
from pieper.judge.verdict import Judgement

COMMAND = "python -m pieper.judge.pages {claims} {folder}"
NOTE = "This page is written by `" + COMMAND + "` from `{claims}/{name}`."
#: Heading, first sentence and first column of the index, by the folder's name.
INDEX = {
    "papers": ("Five papers, judged", "Every numbered equation, table and figure value of five papers", "paper"),
    "pages": (
        "Public pages, judged",
        "Tables and formulas of courses, programs, forum threads and read-me files, typed as they stand there",
        "page",
    ),
}


def page(path: Path, judgement: Judgement | None = None, *, folder: str = "papers") -> str:
    """Return the page of one claims file.

    Args:
        path: The claims file.
        judgement: Its judgement when it is at hand.
        folder: The folder of docs/ in which the page stands.
    """
    text = (judgement or check(path)).markdown()
    head, rest = text.split("\n", 1)
    note = NOTE.format(name=path.name, claims=f"examples/{path.parent.name}", folder=f"docs/{folder}")
    found = _found(path)
    return f"{head}\n\n{note}\n" + (f"\n**What was found.** {found}\n" if found else "") + rest


def _found(path: Path) -> str:
    """What a claims file says was found on its page."""
    return str(tomllib.loads(path.read_text(encoding="utf-8")).get("found", ""))


def write(claims: Path, folder: Path) -> list[Path]:
    """Write a page for every claims file of a folder and an index of them; return what was written."""
    folder.mkdir(parents=True, exist_ok=True)
    heading, sentence, what = INDEX[folder.name]
    written, rows = [], []
    for path in sorted(claims.glob("*.toml")):
        text = page(path, folder=folder.name)
        target = folder / f"{path.stem}.md"
        target.write_text(text, encoding="utf-8")
        written.append(target)
        title = text.split("\n", 1)[0].removeprefix("# ")
        summary = next(line for line in text.splitlines() if line.startswith("**") and "claims:" in line).strip("*")
        found = _found(path)
        rows.append(f"| [{title}]({path.stem}.md) | {summary} |" + (f" {found} |" if found else ""))
    index = folder / "index.md"
    more = (" what was found |", "---|") if any(_found(path) for path in claims.glob("*.toml")) else ("", "")
    lines = [
        f"# {heading}",
        "",
        f"{sentence} judged by `pieper check`." if what == "page" else f"{sentence}, judged by `pieper check`.",
    ]
    lines += ["", f"| {what} | verdicts |{more[0]}", f"|---|---|{more[1]}", *rows, ""]
    index.write_text("\n".join(lines), encoding="utf-8")
    return [*written, index]


if __name__ == "__main__":
    for made in write(Path(sys.argv[1]), Path(sys.argv[2])):
        print(made)
