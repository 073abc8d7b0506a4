"""An arm's solver, written in a language into a file."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

from pieper.code import c, javascript, python
from pieper.code.export import Export, ExportedArm, export
from pieper.document.writing import whole_file
from pieper.errors import InputError

Printer = Callable[[Export], str]


def write(arm: ExportedArm, language: str, path: str | os.PathLike[str], name: str = "arm") -> Path:
    """Write an arm's solver in a language; see `pieper.Arm.code`.

    Raises:
        InputError: An unknown language, a name that is no word, a place that cannot be written.
        PlanError: The arm cannot be exported; the message says why.
    """
    printers: dict[str, Printer] = {
        "c": c.text,
        "c++": c.text,
        "python": python.text,
        "javascript": javascript.text_for(Path(path).suffix),
    }
    if language not in printers:
        raise InputError(
            f"language is {language!r}; it may be {', '.join(printers)}.", given=language, allowed=tuple(printers)
        )
    text = printers[language](export(arm, name))
    with whole_file(path) as file:
        file.write(text.encode())
    return Path(path)
