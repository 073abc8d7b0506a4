"""A run that somebody stops: a signal becomes an interruption like Ctrl-C, which leaves no half file behind."""

from __future__ import annotations

import contextlib
import signal
import threading
from collections.abc import Iterator
from types import FrameType

#: What ends a program, and its terminal: SIGTERM, and SIGHUP where there is one.
ENDING = tuple(number for number in signal.Signals if number.name in ("SIGTERM", "SIGHUP"))
#: Added to a signal's number, as shells do, for the exit status.
BY_SIGNAL = 128


class Stopped(KeyboardInterrupt):
    """A run was stopped.

    Args:
        sentence: What is said of it; "" where nothing is.
        number: The signal.
    """

    def __init__(self, sentence: str = "", number: int = signal.SIGINT) -> None:
        super().__init__(sentence)
        self.status = BY_SIGNAL + number


def told(stop: BaseException, sentence: str) -> Stopped:
    """Return an interruption that says a sentence and keeps its signal."""
    number = stop.status - BY_SIGNAL if isinstance(stop, Stopped) else signal.SIGINT
    return Stopped(sentence, number)


@contextlib.contextmanager
def signals_interrupt() -> Iterator[None]:
    """Make the signals that end a program, or its terminal, interrupt it like Ctrl-C inside the block.

    One that is ignored (nohup) or already handled stays as it is.
    """
    here = signal.valid_signals() if threading.current_thread() is threading.main_thread() else set[int]()
    mine = [number for number in ENDING if number in here and signal.getsignal(number) == signal.SIG_DFL]
    for number in mine:
        signal.signal(number, _stop)
    try:
        yield
    finally:
        for number in mine:
            signal.signal(number, signal.SIG_DFL)


def _stop(number: int, _frame: FrameType | None) -> None:
    raise Stopped("", number)
