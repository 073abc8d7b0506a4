"""Which tests are slow, and which must share a process when there are several."""

from __future__ import annotations

from pathlib import Path

import pytest

HERE = Path(__file__).parent
#: Folders whose tests search, follow paths, draw many arms or drive a browser: minutes instead of seconds.
SLOW = {"browser", "laws", "oracle", "papers"}


# First of all hooks: pytest-xdist reads the groups in its own hook of this name.
@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark what stands in a slow folder, and keep a file in one process: it shares a server, an arm."""
    for item in items:
        folder = item.path.relative_to(HERE).parts[0]
        if folder in SLOW:
            item.add_marker(pytest.mark.slow)
        item.add_marker(pytest.mark.xdist_group(str(item.path.relative_to(HERE))))
