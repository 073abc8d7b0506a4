"""What was guessed of an excerpt, written as a claims file."""

from __future__ import annotations

import json
import re

from pieper.judge.excerpt import Guess

_TAKEN_OFF = re.compile(r"with the constant (base|tool)(?: and (tool))? taken off")


def of_the_page(text: str, found: list[Guess]) -> list[str]:
    """The lines of [arm] that say how a page means its letters: the table's angles, base or tool taken off."""
    lines: list[str] = []
    if any(guess.relation for guess in found):
        lines.append('angles = "table"')
    off = _TAKEN_OFF.search(text)
    if off:
        lines.append("taken_off = " + json.dumps([part for part in off.groups() if part]))
    return lines


def claims_file(found: list[Guess], arm: str, source: str) -> str:
    """The guesses as a claims file.

    Args:
        found: What was read.
        arm: The lines of its [arm] table.
        source: The excerpt's name.
    """
    lines = [
        f"# Guessed from {source}. Look at every claim: its kind, its joint or entry, and the formula beside its line.",
        "# Mend or delete what was misread, then judge it with: pieper check <this file>",
        f"title = {_quoted(f'Claims of {source}')}",
        "",
        "[arm]",
        arm,
        "",
    ]
    symbols = [guess for guess in found if guess.symbol]
    if symbols:
        lines.append("[symbols]")
        for guess in symbols:
            assert guess.symbol is not None
            head = f"line {guess.line}: " if guess.line else ""
            lines += [f"# {head}{guess.text}", f"{guess.symbol[0]} = {_quoted(guess.symbol[1])}"]
        lines.append("")
    used: set[str] = set()
    for guess in found:
        if guess.why:
            lines += [f"# line {guess.line}, not read: {guess.text}", f"#   {guess.why}", ""]
        if not guess.keys:
            continue
        name = str(guess.keys["id"])
        while name in used:
            name += "'"
        used.add(name)
        lines += [f"# line {guess.line}: {guess.text}", "[[claim]]"]
        lines += [f"{key} = {_quoted(value)}" for key, value in {**guess.keys, "id": name}.items()]
        lines.append("")
    return "\n".join(lines)


def _quoted(value: object) -> str:
    return json.dumps(value, ensure_ascii=False)
