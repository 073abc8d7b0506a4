"""Robot files: an arm in TOML, the unit in every key; read, written, and rewritten in place."""

from __future__ import annotations

import os
from pathlib import Path

from pieper.description.dh import Description
from pieper.description.rewrite import rewritten
from pieper.description.robotparse import LARGEST_FILE, parse
from pieper.description.robottext import dumps
from pieper.description.wholefile import bytes_of, replace_file
from pieper.errors import InputError

__all__ = ["dumps", "loads", "read", "write"]


def read(path: str | Path) -> Description:
    """Read a robot file.

    Args:
        path: A .toml file.

    Returns:
        The arm it describes.

    Raises:
        InputError: The file cannot be read or says something impossible; the message names file, line, joint and key.
    """
    return parse(bytes_of(Path(path), LARGEST_FILE, "robot file"), str(path))


def loads(text: str | bytes, file: str = "<text>") -> Description:
    """Read an arm from the text of a robot file; `file` is what messages call it."""
    return parse(text.encode() if isinstance(text, str) else text, file)


def write(description: Description, path: str | Path) -> Path:
    """Write a robot file whole or not at all.

    Where the file exists, it keeps its comments, layout and way of saying every number whose meaning is unchanged.

    Args:
        description: The arm.
        path: The .toml file to write.

    Returns:
        The path.

    Raises:
        InputError: The folder cannot be written to, or an existing file there is not a robot file.
    """
    target = Path(os.path.realpath(path))
    existing = _existing_text(target)
    if existing is None:
        text = dumps(description)
    else:
        text = rewritten(existing, description, str(path))
    replace_file(target, text)
    return Path(path)


def _existing_text(target: Path) -> str | None:
    """Return the text of the file to be rewritten, None where there is nothing to keep."""
    try:
        if not target.exists() or target.stat().st_size == 0:
            return None
        if target.is_dir():
            raise InputError(f"{str(target)!r} is a folder; give a file name ending in .toml.", file=str(target))
        read(target)
        return target.read_text("utf-8-sig")
    except InputError as error:
        raise InputError(
            f"{str(target)!r} exists and is not a robot file that could be updated; it is left alone. ({error})",
            file=str(target),
        ) from None
    except OSError as error:
        raise InputError(f"{str(target)!r} cannot be written: {error.strerror}.", file=str(target)) from None
