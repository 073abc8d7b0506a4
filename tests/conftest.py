"""Which tests are slow, which share a process when there are several, and the one browser of a process."""

from __future__ import annotations

from pathlib import Path

import pytest

from oracle.browser import FLAGS, chromium

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


@pytest.fixture(scope="session")
def browser():
    """The one Chromium of this process: Playwright runs once in a process."""
    playwright = pytest.importorskip(
        "playwright.sync_api", reason="the browser stories need Playwright: pip install playwright"
    )
    with playwright.sync_playwright() as p:
        path = chromium() or (p.chromium.executable_path if Path(p.chromium.executable_path).exists() else None)
        if path is None:
            pytest.skip("no Chromium was found: apt-get install chromium, or playwright install chromium")
        opened = p.chromium.launch(executable_path=path, args=FLAGS)
        yield opened
        opened.close()
