"""Which tests reach which line, and what processor time each takes: read by tests.tools.mutants.

As a plugin of pytest (-p tests.tools.reached, under coverage) it names what is running to coverage and writes the times
beside coverage's file. What a test's preparation reaches counts for every test of its file, which may share it.
"""

from __future__ import annotations

import json
import os
import time
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import NamedTuple

import pytest
from coverage import Coverage, CoverageData

#: Where the plugin writes the processor seconds of each test; not named: it does nothing.
TIMES = "PIEPER_TIMES_OF_TESTS"
spent: dict[str, float] = {}
passed: set[str] = set()


class Recorded(NamedTuple):
    """What one file of tests does: the processor seconds of each test, and coverage's file of what it reaches."""

    seconds: dict[str, float]
    lines: Path


def _named(context: str) -> None:
    if (running := Coverage.current()) is not None:
        running.switch_context(context)


def pytest_runtest_setup(item: pytest.Item) -> None:
    """Count what a preparation reaches for the whole file."""
    _named(item.nodeid.split("::")[0])


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Iterator[None]:
    """Take the time of a test with what it prepares and clears away."""
    begin = time.process_time()
    try:
        return (yield)
    finally:
        spent[item.nodeid] = time.process_time() - begin


@pytest.hookimpl(wrapper=True)
def pytest_pyfunc_call(pyfuncitem: pytest.Function) -> Iterator[None]:
    """Count what a test itself reaches for it alone."""
    _named(pyfuncitem.nodeid)
    try:
        return (yield)
    finally:
        _named(pyfuncitem.nodeid.split("::")[0])


def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    """Keep which tests pass: one that fails on the untouched code, or is left out there, notices nothing."""
    if report.when == "call" and report.passed:
        passed.add(report.nodeid)


def pytest_sessionfinish() -> None:
    """Write the times."""
    if path := os.environ.get(TIMES):
        Path(path).write_text(json.dumps({name: s for name, s in spent.items() if name in passed}))


@cache
def _contexts(data: Path, source: str) -> dict[int, list[str]]:
    read = CoverageData(basename=str(data))
    read.read()
    return read.contexts_by_lineno(source)


def reaching(recorded: list[Recorded], source: Path, lines: range) -> dict[str, float]:
    """Return the tests that reach any of these lines of a file, with their times; on none of them, any of the file.

    A line that no test reaches while it runs is one that stands outside of functions, or one that nothing reaches:
    for the first every test that reaches anything of the file is asked.
    """
    out: dict[str, float] = {}
    anywhere: dict[str, float] = {}
    for seconds, data in recorded:
        for line, contexts in _contexts(data, str(source)).items():
            whole = any(context and "::" not in context for context in contexts)
            tests = seconds if whole else {name: seconds[name] for name in contexts if name in seconds}
            anywhere |= tests
            if line in lines:
                out |= tests
    return out or anywhere


def ordered(tests: dict[str, float], module: str, budget: float | None) -> list[str]:
    """Return tests in the order to ask them: of the file named after the module first, then the quickest.

    With a budget those are left out with which the processor seconds would go beyond it, but never the first.
    """
    asked = sorted(tests, key=lambda name: (f"test_{module}.py" not in name, tests[name]))
    if budget is None:
        return asked
    out, total = [], 0.0
    for name in asked:
        total += tests[name]
        if out and total > budget:
            break
        out.append(name)
    return out
