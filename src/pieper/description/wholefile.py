"""A text file of ours written whole or not at all, and on the disk when that is said; files read, or not there."""

from __future__ import annotations

import os
import re
from pathlib import Path

from pieper.document.writing import whole_file
from pieper.errors import InputError


def replace_file(target: Path, text: str) -> None:
    """Put text into a file in one step: readers see the old file or the new one, never half of it."""
    with whole_file(target) as stream:
        stream.write(text.encode())
        stream.flush()
        os.fsync(stream.fileno())


def bytes_of(path: Path, most: int, kind: str) -> bytes:
    """Return what stands in a file of at most `most` bytes.

    Raises:
        InputError: It is missing, cannot be read, or is larger.
    """
    try:
        with path.open("rb") as stream:
            data = stream.read(most + 1)
    except FileNotFoundError:
        raise no_file(path) from None
    except OSError as error:
        raise InputError(f"{str(path)!r} cannot be read: {error.strerror}.", file=str(path)) from None
    if len(data) > most:
        raise InputError(f"{path}: larger than {most:,} bytes; this is not a {kind}.", file=str(path))
    return data


def no_file(path: Path) -> InputError:
    """Return the refusal of a file that is not there, with the one that may be meant or what to do."""
    said = str(path)
    if said.lstrip().startswith("<"):
        return InputError(
            "the source is the text of a file: write it into one, such as arm.urdf, and load that.", file=said[:40]
        )
    if re.match(r"(https?|ftp):/", said):
        cure = " Fetch it, and load the file."
    elif re.match(r"(package|model):/", said):
        cure = " Give the path of the file itself."
    else:
        import difflib

        near = difflib.get_close_matches(path.name, _names_in(path.parent), n=1)
        cure = f" Did you mean {str(path.parent / near[0])!r}?" if near else ""
    return InputError(f"there is no file {said!r}.{cure}", file=said)


def _names_in(folder: Path) -> list[str]:
    try:
        return [entry.name for entry in folder.iterdir()][:1000]
    except OSError:
        return []
