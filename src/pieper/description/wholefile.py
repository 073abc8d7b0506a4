"""A text file of ours written whole or not at all, and on the disk when that is said; files that are not there."""

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
