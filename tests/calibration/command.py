"""The command line, called from a test."""

from __future__ import annotations

from pieper import cli


def main(arguments: list[str]) -> int:
    """Run it and return its exit status."""
    try:
        cli.main(arguments)
    except SystemExit as left:
        return int(left.code or 0)
    return 0
