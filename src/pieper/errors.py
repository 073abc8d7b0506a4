"""The two ways a call can fail; mathematics is never one of them."""

from __future__ import annotations


class PieperError(Exception):
    """Base of everything pieper raises on purpose.

    Args:
        message: One or two sentences: what was given, what is allowed, how to cure it.
        **data: The facts behind the sentence, readable as attributes (`error.joint`, `error.index`, ...).
    """

    def __init__(self, message: str, **data: object) -> None:
        super().__init__(message)
        self.data = data
        for key, value in data.items():
            setattr(self, key, value)


class InputError(PieperError, ValueError):
    """The caller said something impossible: a wrong shape, NaN, not a rotation, an unknown joint, a bad file."""


class PlanError(PieperError, ValueError):
    """This arm, or this task for it, is beyond the solver; said when the arm is planned, never while solving."""


class PieperWarning(UserWarning):
    """Something was accepted that probably was not meant (degrees where radians are, for one)."""


class NoSolutionError(PieperError, LookupError):
    """Somebody asked for *the* solution of a pose that has none; carries the reason."""
