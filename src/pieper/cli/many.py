"""What commands that work through a file have in common with a terminal: a progress bar, and where rows go."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Callable, Iterator
from typing import BinaryIO

import click


@contextlib.contextmanager
def progress(size: int, what: str) -> Iterator[Callable[[int], None]]:
    """Yield what is told of the bytes read: a progress bar on the error stream where that is a terminal."""
    if not sys.stderr.isatty():
        yield lambda _: None
        return
    with click.progressbar(length=size, label=what, file=sys.stderr, update_min_steps=1 << 18) as bar:
        yield bar.update


def put(out: BinaryIO | None, text: str) -> None:
    """Write text into a file, or where there is none to standard output."""
    if out is None:
        sys.stdout.write(text)
    else:
        out.write(text.encode())
