"""Which pieper this is, for what it writes: files, reports, stores."""

from __future__ import annotations

from functools import cache


@cache
def installed_version() -> str:
    """Return the version that is installed, "" for a source tree that was not installed."""
    from importlib.metadata import PackageNotFoundError, version

    try:
        return version("pieper")
    except PackageNotFoundError:
        return ""
