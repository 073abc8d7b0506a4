"""A text file of ours written whole or not at all, and on the disk when that is said."""

from __future__ import annotations

import os
from pathlib import Path

from pieper.document.writing import whole_file


def replace_file(target: Path, text: str) -> None:
    """Put text into a file in one step: readers see the old file or the new one, never half of it."""
    with whole_file(target) as stream:
        stream.write(text.encode())
        stream.flush()
        os.fsync(stream.fileno())
