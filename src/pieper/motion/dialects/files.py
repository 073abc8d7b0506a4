"""Which dialect a program is written in or read from, and what is refused before a line is written."""

from __future__ import annotations

import os
from collections.abc import Sequence

from pieper import arguments
from pieper.errors import InputError
from pieper.motion.dialects import fanuc_ls, inform, krl, pacscript, rapid, trajectory, urscript
from pieper.motion.dialects.configuration import is_of
from pieper.motion.dialects.dialect import Dialect, Script, Target, checked_name
from pieper.motion.instructions import Move

DIALECTS: dict[str, Dialect] = {
    d.name: d
    for d in (
        rapid.DIALECT,
        urscript.DIALECT,
        krl.DIALECT,
        fanuc_ls.DIALECT,
        inform.DIALECT,
        pacscript.DIALECT,
        trajectory.ROS,
        trajectory.CSV,
    )
}


def check_splines(moves: Sequence[Move], dialect: str) -> None:
    """Refuse a maker's dialect for moves, as the program numbers them, of which one is a spline.

    Raises:
        InputError: One is, or no such dialect.
    """
    arguments.word(dialect, "dialect", DIALECTS)
    splines = [number for number, move in enumerate(moves, 1) if move.kind == "move_s"]
    if splines and DIALECTS[dialect].maker is not None:
        why = f"is a spline, which {dialect} is not written with here; write ros or csv, or lines and circles."
        raise InputError(f"move {splines[0]} {why}", move=splines[0], why=why)


def text_of(script: Script, dialect: str) -> str:
    """Return a script in a dialect.

    Raises:
        InputError: No such dialect, an arm of another maker or with other axes, or a name the maker does not take.
    """
    arguments.word(dialect, "dialect", DIALECTS)
    found = DIALECTS[dialect]
    said = script.description.manufacturer
    if found.maker is not None:
        if not is_of(said, found.maker):
            raise InputError(
                f"{script.plan.name} is made by {said}; {dialect} is for another maker's controllers. Choose its own "
                "dialect, or ros or csv.",
                given=dialect,
                maker=said,
            )
        if script.plan.n != 6:
            raise InputError(
                f"{dialect} is written for six axes; {script.plan.name} has {script.plan.n}.", given=dialect
            )
        checked_name(script.name, found)
    return found.write(script)


def dialect_of(path: str | os.PathLike[str]) -> str:
    """Return the dialect that a file's ending names.

    Raises:
        InputError: The ending is no dialect's.
    """
    file = arguments.file(path)
    for name, dialect in DIALECTS.items():
        if file.suffix.lower() in dialect.suffixes:
            return name
    endings = ", ".join(s for d in DIALECTS.values() for s in d.suffixes)
    raise InputError(f"{file.name} has no ending of a known dialect: {endings}.", given=str(path))


def read_program(path: str | os.PathLike[str]) -> list[Target]:
    """Return the targets of a program file in order; its dialect follows from the file's ending.

    Args:
        path: A file of `Program.write`, or one of the same form.

    Returns:
        Targets with .kind and .q (n,) in rad or m, or .T (4, 4) in m, whichever the file has.

    Raises:
        InputError: No such file, an unknown ending, or text that is not of the dialect.
    """
    file, kind = arguments.file(path), DIALECTS[dialect_of(path)]
    try:
        text = file.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"cannot read {path}: {arguments.cause(error)}.", path=path) from None
    if not text.strip():
        raise InputError(f"{file.name} is empty: there is no program in it.", path=path)
    try:
        return kind.targets(text)
    except InputError:
        raise
    except (KeyError, IndexError, ValueError, TypeError) as error:
        raise InputError(
            f"{file.name} is not {kind.name} as it is written here: a move names a target that is not there, or a "
            f"number is missing ({type(error).__name__}: {error}). Compare it with a file of Program.write.",
            path=path,
        ) from None
