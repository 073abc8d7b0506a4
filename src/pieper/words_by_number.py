"""Words that follow a number: one solution, two solutions."""

from __future__ import annotations


def plural(count: int, one: str, many: str | None = None) -> str:
    """Return a count with its noun: "1 solution", "2 solutions"; `many` where an s is not enough."""
    return f"{count} {one if count == 1 else many or one + 's'}"
