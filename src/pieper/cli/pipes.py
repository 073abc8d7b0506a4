"""Named pipes and the shell's <(command): what can be read once, looked at first and read whole afterwards."""

from __future__ import annotations

import io
import os
import stat
import sys
from itertools import islice
from pathlib import Path
from typing import BinaryIO

#: Pipes that were looked at, by name, until somebody reads them.
_LOOKED_AT: dict[str, BinaryIO] = {}


class _Again(io.RawIOBase):
    """What was read of a pipe already, and the rest of it."""

    def __init__(self, head: bytes, rest: BinaryIO) -> None:
        self._head, self._rest = head, rest

    def readable(self) -> bool:
        return True

    def readinto(self, buffer: memoryview) -> int:  # type: ignore[override]
        if not self._head:
            data = self._rest.read(len(buffer))
        else:
            data, self._head = self._head[: len(buffer)], self._head[len(buffer) :]
        buffer[: len(data)] = data
        return len(data)

    def close(self) -> None:
        self._rest.close()
        super().close()


def is_pipe(name: str) -> bool:
    """Return whether a file can be read only once: a pipe, a socket or a terminal."""
    try:
        mode = os.stat(name).st_mode
    except OSError:
        return False
    return not (stat.S_ISREG(mode) or stat.S_ISDIR(mode))


def opened(name: str) -> BinaryIO:
    """Return a file to read from, from its beginning even where it is a pipe that was looked at."""
    return _LOOKED_AT.pop(name, None) or (sys.stdin.buffer if name == "-" else Path(name).open("rb"))


def keep(name: str, data: bytes) -> None:
    """Have what was read of a pipe, or of the standard input, read once more."""
    if name == "-" or is_pipe(name):
        _LOOKED_AT[name] = io.BytesIO(data)


def looked_at(name: str, lines: int) -> list[bytes]:
    """Return the first lines of a file, which stays to be read."""
    file = opened(name)
    if not is_pipe(name):
        with file:
            return list(islice(file, lines))
    head = list(islice(file, lines))
    _LOOKED_AT[name] = io.BufferedReader(_Again(b"".join(head), file))
    return head
