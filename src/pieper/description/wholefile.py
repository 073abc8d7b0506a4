"""A text file written whole or not at all."""

from __future__ import annotations

import os
from contextlib import suppress
from pathlib import Path

from pieper.errors import InputError


def replace_file(target: Path, text: str) -> None:
    """Put text into a file in one step: readers see the old file or the new one, never half of it."""
    import tempfile

    temporary = None
    try:
        handle, temporary = tempfile.mkstemp(dir=target.parent, prefix=f".{target.name}.", suffix=".part")
        with os.fdopen(handle, "w", encoding="utf-8", newline="\n") as stream:
            stream.write(text)
            stream.flush()
            os.fsync(stream.fileno())
        os.chmod(temporary, target.stat().st_mode & 0o777 if target.exists() else 0o666 & ~_umask())
        os.replace(temporary, target)
    except OSError as error:
        _discard(temporary)
        raise InputError(
            f"{str(target)!r} cannot be written: {error.strerror}. Choose a folder that exists and is writable.",
            file=str(target),
        ) from None
    except BaseException:  # Ctrl-C included: nothing half written stays behind
        _discard(temporary)
        raise


def _discard(temporary: str | None) -> None:
    if temporary is not None:
        with suppress(OSError):
            os.unlink(temporary)


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
