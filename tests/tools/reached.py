"""Which tests come to which place that is changed, and what processor time each takes: read by tests.tools.mutants.

In a copy of the package each place that a change would alter says that it is evaluated, beside doing what it does:
that costs a call where coverage costs one a line, so a run of the tests is hardly longer for it. As a plugin of pytest
(-p tests.tools.reached) this file knows which test is running, and writes down what it came to and how long it took.
What a test's preparation comes to counts for every test of its file, which may share it; so its time is the file's.
"""

from __future__ import annotations

import ast
import importlib
import json
import os
import time
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import pytest

#: Where the plugin writes what it saw; not named: it does nothing. After how many processor seconds it ends.
INTO, LONGEST = "PIEPER_REACHED_BY_TESTS", "PIEPER_REACHED_IN_SECONDS"
#: The module of the copy that is told what is evaluated, its text, and what its function is called where it is used.
PROBES, CALLED = "probes", "_evaluated"
TEXT = """RUNNING, SEEN = [""], {}


def evaluated(number):
    SEEN.setdefault(RUNNING[0], set()).add(number)
"""
Span = tuple[int, int, int, int]
spent: dict[str, float] = {}
prepared: dict[str, float] = {}
passed: set[str] = set()


class Recorded(NamedTuple):
    """What one file of tests does: the processor seconds of each test and of what is prepared, and who comes where."""

    seconds: dict[str, float]
    places: dict[str, list[int]]
    prepares: float = 0.0


class _Probing(ast.NodeTransformer):
    """Puts a call before each expression that is changed; what stands outside of functions is asked of all of them."""

    def __init__(self, at: dict[Span, list[int]], outside: Iterable[int]):
        self.at, self.outside, self.depth = at, list(outside), 0

    def visit(self, node: ast.AST) -> Any:
        if isinstance(node, ast.pattern):
            return node
        function = isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
        self.depth += function
        self.generic_visit(node)
        self.depth -= function
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            first = isinstance(node.body[0], ast.Expr) and isinstance(node.body[0].value, ast.Constant)
            node.body[first:first] = [ast.Expr(_call(k)) for k in self.outside]
        elif isinstance(node, ast.expr) and self.depth:
            span = (node.lineno, node.col_offset, node.end_lineno or 0, node.end_col_offset or 0)
            if numbers := self.at.get(span):
                return ast.BoolOp(ast.Or(), [*map(_call, numbers), node])
        return node


def _call(number: int) -> ast.Call:
    return ast.Call(ast.Name(CALLED, ast.Load()), [ast.Constant(number)], [])


def within_functions(tree: ast.Module) -> set[Span]:
    """Return where the expressions stand that are evaluated when a function runs, not when its file is loaded."""
    bodies = (n.body for n in ast.walk(tree) if isinstance(n, ast.FunctionDef | ast.AsyncFunctionDef))
    inner = (e for body in bodies for line in body for e in ast.walk(line) if isinstance(e, ast.expr))
    return {(e.lineno, e.col_offset, e.end_lineno or 0, e.end_col_offset or 0) for e in inner}


def probed(text: str, numbered: dict[int, Span]) -> str:
    """Return a file's text in which each of these numbered places says that it is evaluated."""
    tree = ast.parse(text)
    inside = within_functions(tree)
    at: dict[Span, list[int]] = {}
    for number, span in numbered.items():
        if span in inside:
            at.setdefault(span, []).append(number)
    tree = _Probing(at, [k for k, span in numbered.items() if span not in inside]).visit(tree)
    first = next(
        (i for i, n in enumerate(tree.body) if not (_is_text(n) or getattr(n, "module", "") == "__future__")),
        len(tree.body),
    )
    loaded = ast.ImportFrom(f"pieper.{PROBES}", [ast.alias("evaluated", CALLED)], 0)
    tree.body.insert(first, loaded)
    return ast.unparse(ast.fix_missing_locations(tree))


def _is_text(node: ast.stmt) -> bool:
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)


def _probes() -> Any:
    return importlib.import_module(f"pieper.{PROBES}")


def _named(running: str) -> None:
    if INTO in os.environ:
        _probes().RUNNING[0] = running


@pytest.hookimpl(wrapper=True)
def pytest_runtest_setup(item: pytest.Item) -> Iterator[None]:
    """Count what a preparation comes to, and its time, for the whole file."""
    file, begin = file_of(item.nodeid), time.process_time()
    _named(file)
    try:
        return (yield)
    finally:
        prepared[file] = prepared.get(file, 0.0) + time.process_time() - begin


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Iterator[None]:
    """Take the time of a test with what it clears away."""
    file, begin = file_of(item.nodeid), time.process_time()
    before = prepared.get(file, 0.0)
    try:
        return (yield)
    finally:
        spent[item.nodeid] = time.process_time() - begin - (prepared.get(file, 0.0) - before)
        if time.process_time() > float(os.environ.get(LONGEST, "inf")):
            item.session.shouldstop = "long enough"


@pytest.hookimpl(wrapper=True)
def pytest_pyfunc_call(pyfuncitem: pytest.Function) -> Iterator[None]:
    """Count what a test itself comes to for it alone."""
    _named(pyfuncitem.nodeid)
    try:
        return (yield)
    finally:
        _named(file_of(pyfuncitem.nodeid))


def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    """Keep which tests pass: one that fails on the untouched code, or is left out there, notices nothing."""
    if report.when == "call" and report.passed:
        passed.add(report.nodeid)


def pytest_sessionfinish() -> None:
    """Write the times, and who came where."""
    if path := os.environ.get(INTO):
        seconds = {name: s for name, s in spent.items() if name in passed}
        places = {name: sorted(numbers) for name, numbers in _probes().SEEN.items()}
        said = {"seconds": seconds, "places": places, "prepares": sum(prepared.values())}
        Path(path).write_text(json.dumps(said))


def reaching(recorded: list[Recorded], place: int, *, loaded: bool) -> dict[str, float]:
    """Return the tests that come to a place, with their times.

    What is evaluated when a file is loaded may matter to any test, so all are asked where a place is such a one.
    """
    out: dict[str, float] = {}
    for seconds, places, _ in recorded:
        for name, numbers in places.items():
            if place in numbers:
                out |= seconds if "::" not in name else {name: seconds[name]} if name in seconds else {}
    return out | ({name: s for seconds, *_ in recorded for name, s in seconds.items()} if loaded else {})


def cost(asked: Iterable[str], tests: dict[str, float], prepares: dict[str, float]) -> float:
    """Return the processor seconds that tests take, with what their files prepare, each once."""
    asked = list(asked)
    return sum(tests[name] for name in asked) + sum(
        prepares.get(file, 0.0) for file in {file_of(name) for name in asked}
    )


def file_of(name: str) -> str:
    """Return the file of a test."""
    return name.split("::")[0]


def ordered(tests: dict[str, float], module: str, budget: float | None, prepares: dict[str, float]) -> list[str]:
    """Return tests in the order to ask them: of the file named after the module first, then the quickest.

    What a file prepares counts for each of its tests in that order, and once in the budget. With a budget those are
    left out with which the processor seconds would go beyond it, but never the first.
    """
    asked = sorted(
        tests, key=lambda name: (f"test_{module}.py" not in name, tests[name] + prepares.get(file_of(name), 0.0))
    )
    if budget is None:
        return asked
    out: list[str] = []
    for name in asked:
        if out and cost([*out, name], tests, prepares) > budget:
            break
        out.append(name)
    return out
