"""An arm's solver, written in a language into a file."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

from pieper import arguments
from pieper.code import c, cpp, javascript, jax, matlab, python, wasm
from pieper.code.export import Export, export
from pieper.document.writing import whole_file
from pieper.errors import InputError
from pieper.solver.plan.planned_arm import PlannedArm

#: A printer takes an export and a path, and returns what goes into which file.
Printer = Callable[[Export, Path], dict[Path, bytes]]


def _one(text: Callable[[Export], str]) -> Printer:
    return lambda export, path: {path: text(export).encode()}


def _matlab(export: Export, path: Path) -> dict[Path, bytes]:
    return {file: text.encode() for file, text in matlab.texts(export, path).items()}


PRINTERS: dict[str, Printer] = {
    "c": _one(c.text),
    "c++": _one(cpp.text),
    "python": _one(python.text),
    "matlab": _matlab,
    "javascript": lambda export, path: {path: javascript.text(export, path.suffix).encode()},
    "jax": _one(jax.text),
    "wasm": lambda export, path: {path: wasm.content(export, path.suffix)},
}
#: Endings that say in which languages a file is.
ENDINGS = {
    ".c": ("c",),
    ".h": ("c", "c++"),
    **dict.fromkeys((".cpp", ".cc", ".cxx", ".hpp", ".hh", ".hxx"), ("c++",)),
    ".py": ("python", "jax"),
    ".m": ("matlab",),
    ".js": ("javascript",),
    ".mjs": ("javascript", "wasm"),
    ".wasm": ("wasm",),
}


def write(arm: PlannedArm, language: str, path: str | os.PathLike[str], name: str = "arm") -> Path:
    """Write an arm's solver in a language; see `pieper.Arm.code`.

    Raises:
        InputError: An unknown language, a name that is no word, a path that ends as another language's, a place that
            cannot be written, no compiler for wasm.
        PlanError: The arm cannot be exported; the message says why.
    """
    arguments.word(language, "language", PRINTERS)
    target = arguments.file(path)
    said = ENDINGS.get(target.suffix.lower(), (language,))
    if language not in said:
        raise InputError(
            f"{target.name} ends as a file of {' or '.join(said)} does, and {language} was asked for. Name another "
            f"file, or ask for {' or '.join(map(repr, said))}.",
            path=target,
            language=language,
        )
    files = PRINTERS[language](export(arm, name), target)
    if language == "matlab" and target.suffix != ".m":
        try:
            target.mkdir(exist_ok=True)
        except OSError as error:
            raise InputError(f"cannot write into {target}: {error.strerror}. Name a folder, or a .m file.") from None
    for file, data in files.items():
        with whole_file(file) as out:
            out.write(data)
    return target
