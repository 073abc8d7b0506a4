"""What commands that work through a file show of it: a progress bar on a terminal."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Callable, Iterator

import click


@contextlib.contextmanager
def progress(size: int, what: str) -> Iterator[Callable[[int], None]]:
    """Yield what is told of the bytes read: a progress bar on the error stream where that is a terminal."""
    if not sys.stderr.isatty():
        yield lambda _: None
        return
    with click.progressbar(length=size, label=what, file=sys.stderr, update_min_steps=1 << 18) as bar:
        yield bar.update
