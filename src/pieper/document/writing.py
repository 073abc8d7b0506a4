"""Writing files whole or not at all, so that an interruption leaves nothing half written."""

from __future__ import annotations

import errno
import os
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO

from pieper import arguments
from pieper.errors import InputError

#: What says that there is no room: a full disk, a used-up quota, a file larger than is allowed.
NO_ROOM = {errno.ENOSPC, errno.EFBIG, errno.EDQUOT}


@contextmanager
def whole_file(path: str | os.PathLike[str]) -> Generator[BinaryIO, None, None]:
    """Open a file that appears whole at the end of the block, or not at all when the block fails.

    Args:
        path: Where to; what is written goes into a neighbour first, which is then renamed over it. A link stays one,
            and a device or a pipe is written as it comes.

    Yields:
        The file, open for writing bytes.

    Raises:
        InputError: This is no path, or is a folder, or its folder does not exist or cannot be written, or there is no
            room; the message names it.
    """
    import tempfile

    given = arguments.file(path)
    # the shell's links to pipes lead to no name
    apart = given.exists() and not given.is_file()
    path = Path(os.path.realpath(given)) if given.is_symlink() and not apart else given
    if path.is_dir():
        raise InputError(f"{given} is a folder: give the name of a file in it.", path=given)
    name = None
    try:
        if apart:
            with path.open("wb") as file:
                yield file
            return
        handle, name = tempfile.mkstemp(prefix=f".{path.name}.", dir=path.parent or Path("."))
        with os.fdopen(handle, "wb") as file:
            yield file
        os.chmod(name, path.stat().st_mode & 0o777 if path.exists() else 0o666 & ~_umask())
        os.replace(name, path)
        name = None
    except OSError as error:
        reason = error.strerror or str(error)
        cure = (
            "Free room there, or choose another"
            if error.errno in NO_ROOM
            else "Choose a folder that exists and is yours"
        )
        raise InputError(f"cannot write {given}: {reason}. {cure}.", path=given) from None
    finally:
        if name is not None:
            Path(name).unlink(missing_ok=True)


def write_whole(path: str | os.PathLike[str], content: bytes | str) -> Path:
    """Write a file whole or not at all.

    Raises:
        InputError: This is no path, or is a folder, or its folder does not exist or cannot be written.
    """
    with whole_file(path) as file:
        file.write(content.encode() if isinstance(content, str) else content)
    return Path(path)


def write_beside(path: Path, files: dict[str, bytes]) -> list[Path]:
    """Write the figures of a source beside it, each whole or not at all; return them."""
    out: list[Path] = []
    for name, content in files.items():
        target = path.parent / name
        try:
            target.parent.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise InputError(f"cannot make the folder {target.parent}: {error.strerror}.", path=target) from None
        out.append(write_whole(target, content))
    return out


def _umask() -> int:
    now = os.umask(0)
    os.umask(now)
    return now
