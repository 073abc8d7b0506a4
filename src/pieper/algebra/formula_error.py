"""A formula that cannot be read, with the place at which reading stopped."""

from __future__ import annotations

from pieper.errors import InputError


class FormulaError(InputError):
    """A formula that cannot be read; the message shows the line with a caret under the place."""


def fail(text: str, at: int, message: str, **data: object) -> FormulaError:
    """The error with the place shown: the line around a character of the text, and a caret under it."""
    start = max(0, at - 60)
    shown = text[start : at + 60].replace("\n", " ")
    if start:
        shown = "..." + shown
        start -= 3
    return FormulaError(f"{message}\n  {shown}\n  {' ' * (at - start)}^", text=text, position=at, **data)
