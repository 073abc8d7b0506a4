"""Change the code in small ways, one at a time, and say which changes no test of their wing notices.

Usage: python -m tests.tools.mutants [--count 200] [--seed 1] [--of solver motion judge] [--wings solver motion judge]
           [--again] [--quick] [--budget 60] [--seconds 300]

The sample is drawn once from the seed; what was tried is kept in out/mutants.json and not tried again, so a run that
was stopped goes on. A change is made in a copy of the package (build/mutants), never in the tree. Each file of the
wing's tests is run once on a copy in which the places that are changed say that they are evaluated: a change is tried
on the tests that come to it, those of its own file first, then the quickest, until one fails. A file of tests that was
written since is run for that again. What takes far more processor time than on the untouched code counts as noticed.
"""

from __future__ import annotations

import argparse
import ast
import copy
import hashlib
import importlib.util
import json
import math
import os
import random
import resource
import shutil
import signal
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from tests.tools.reached import (
    INTO,
    LONGEST,
    PROBES,
    TEXT,
    Recorded,
    cost,
    file_of,
    ordered,
    probed,
    reaching,
    within_functions,
)

ROOT = Path(__file__).resolve().parents[2]
SOURCE = ROOT / "src" / "pieper"
COPY = ROOT / "build" / "mutants" / "pieper"
KEPT = ROOT / "out" / "mutants.json"
#: The quick tests of each wing, and its slow ones.
TESTS = {"solver": ["tests/solver", "tests/kernels"], "motion": ["tests/motion"], "judge": ["tests/judge"]}
SLOW = {"solver": ["tests/laws", "tests/oracle"], "motion": [], "judge": ["tests/papers"]}
#: The wings a sample is drawn of where none are named; of the others' tests all are quick.
DRAWN = list(TESTS)
TESTS |= {wing: [f"tests/{wing}"] for wing in ("document", "equations", "calibration", "maps", "code")}
#: Processor seconds that an interpreter with pytest may take before its first test, how many times as long as on the
#: untouched code the tests may take, and as what part of the time that passes work counts at the least.
STARTS, TIMES_AS_LONG, WAITS = 8.0, 4.0, 30.0
#: Seconds between two looks whether a run has ended, and what is loaded before it is forked.
POLL, LOADED = 0.02, ("numpy", "hypothesis", "xdist", "scipy.optimize", "sympy", "mpmath", "click")
COMPARED = {ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt, ast.Eq: ast.NotEq, ast.NotEq: ast.Eq}
COMPARED |= {ast.Is: ast.IsNot, ast.IsNot: ast.Is, ast.In: ast.NotIn, ast.NotIn: ast.In}
TURNED = {ast.Lt: ast.GtE, ast.LtE: ast.Gt, ast.Gt: ast.LtE, ast.GtE: ast.Lt}
SWAPPED = {ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult}


class Change(NamedTuple):
    """One small change: where, the source before and after, and the lines and columns that it replaces."""

    path: str
    before: str
    after: str
    span: tuple[int, int, int, int]

    @property
    def name(self) -> str:
        """What the change is called in the results."""
        return f"{self.path}:{self.span[0]}:{self.span[1]} {self.before} -> {self.after}"


def altered(node: ast.AST) -> Iterator[ast.AST]:
    """Yield a node with one thing about it changed."""
    if isinstance(node, ast.Compare):
        for i, op in enumerate(node.ops):
            for table in (COMPARED, TURNED):
                if type(op) in table:
                    other = copy.deepcopy(node)
                    other.ops[i] = table[type(op)]()
                    yield other
    elif isinstance(node, ast.BinOp) and type(node.op) in SWAPPED:
        other = copy.deepcopy(node)
        other.op = SWAPPED[type(node.op)]()
        yield other
    elif isinstance(node, ast.BoolOp):
        other = copy.deepcopy(node)
        other.op = ast.Or() if isinstance(node.op, ast.And) else ast.And()
        yield other
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, (ast.USub, ast.Not)):
        yield node.operand
    elif isinstance(node, ast.Constant) and isinstance(node.value, (bool, int, float)):
        value = node.value
        changed = (
            not value if isinstance(value, bool) else value + 1 if isinstance(value, int) else 2 * value + (not value)
        )
        yield ast.Constant(changed)


def spoken(tree: ast.Module) -> set[int]:
    """Return the ids of nodes that are words or types, not doings."""
    out: set[int] = set()
    for node in ast.walk(tree):
        for part in ("annotation", "returns"):
            if getattr(node, part, None) is not None:
                out |= {id(n) for n in ast.walk(getattr(node, part))}
        if isinstance(node, ast.JoinedStr):
            out |= {id(n) for n in ast.walk(node)}
    return out


def changes(path: Path) -> Iterator[Change]:
    """Yield every small change of a file."""
    text = path.read_text()
    tree = ast.parse(text)
    skipped, lines = spoken(tree), text.encode().splitlines(keepends=True)
    for node in ast.walk(tree):
        if id(node) in skipped or not isinstance(node, ast.expr):
            continue
        for other in altered(node):
            span = (node.lineno, node.col_offset, node.end_lineno or 0, node.end_col_offset or 0)
            yield Change(str(path.relative_to(SOURCE)), _between(lines, span), ast.unparse(other), span)


def _between(lines: list[bytes], span: tuple[int, int, int, int]) -> str:
    """Return what stands in a place, on one line."""
    first, start, last, end = span
    taken = lines[first - 1 : last]
    taken[-1] = taken[-1][:end]
    taken[0] = taken[0][start:]
    return " ".join(b"".join(taken).decode().split())


def with_change(text: str, change: Change) -> str:
    """Return a file's text with the change made; columns count bytes."""
    lines = text.encode().splitlines(keepends=True)
    first, start, last, end = change.span
    whole = lines[first - 1][:start] + f"({change.after})".encode() + lines[last - 1][end:]
    return b"".join([*lines[: first - 1], whole, *lines[last:]]).decode()


def sample(wings: list[str], count: int, seed: int) -> list[Change]:
    """Return the changes to try: as many of each wing as its part of all possible ones."""
    every = [c for wing in wings for path in sorted((SOURCE / wing).rglob("*.py")) for c in changes(path)]
    return random.Random(seed).sample(every, min(count, len(every)))


def tested(
    tests: list[str], limit: float | None, *, into: Path | None = None, longest: float = math.inf
) -> tuple[str, float]:
    """Run tests on the copy; return "noticed by ..." or "survived", and the processor seconds it took.

    Into a file goes which places they come to, if one is named; then all are run that begin before the longest time is
    over, else only until one fails.
    """

    def work() -> int:
        sys.path.insert(0, str(COPY.parent))
        os.environ |= {"PYTHONPATH": str(COPY.parent), "PYTHONDONTWRITEBYTECODE": "1"}
        words = "-q -p no:cacheprovider --no-header --tb=no -n 0".split()
        if into is None:
            return int(pytest.main([*words, "-x", *tests]))
        os.environ |= {INTO: str(into), LONGEST: str(longest)}
        return int(pytest.main([*words, "-p", "tests.tools.reached", *tests]))

    return limited(work, limit)


def limited(work: Callable[[], int], limit: float | None) -> tuple[str, float]:
    """Do work in a process of its own; return what is said of it, and the processor seconds it took.

    The limit is one of processor time, so that it means the same on a busy machine; what waits for good is stopped too.
    The process is a fork of this one, which has loaded what tests need but nothing of the package.
    """
    with tempfile.TemporaryFile() as out:
        if not (child := os.fork()):
            code = 1
            try:
                if limit is not None:
                    resource.setrlimit(resource.RLIMIT_CPU, (math.ceil(limit), math.ceil(limit) + 2))
                os.chdir(ROOT)
                os.dup2(out.fileno(), 1)
                os.dup2(out.fileno(), 2)
                code = work()
                sys.stdout.flush()
            finally:
                os._exit(code)
        begin, waits = time.monotonic(), math.inf if limit is None else WAITS * (limit + 1)
        while True:
            ended, status, used = os.wait4(child, os.WNOHANG)
            if not ended and time.monotonic() - begin > waits:
                os.kill(child, signal.SIGKILL)
                _, _, used = os.wait4(child, 0)
                return "noticed: it waits for good", used.ru_utime + used.ru_stime
            if ended:
                break
            time.sleep(POLL)
        out.seek(0)
        text = out.read().decode(errors="replace")
    spent = used.ru_utime + used.ru_stime
    if os.WIFSIGNALED(status) and os.WTERMSIG(status) in (signal.SIGXCPU, signal.SIGKILL):
        return "noticed: it takes too long", spent
    failed = [line for line in text.splitlines() if line.startswith(("FAILED", "ERROR"))]
    return (f"noticed: {failed[0] if failed else text[-200:]}" if status else "survived"), spent


def recorded(state: dict[str, Any], folders: list[str], longest: float) -> list[Recorded]:
    """Return what each file of tests comes to; those not seen as they are now are run on the copy that says so.

    Of a file that takes longer than the longest time its first tests are known; one test alone may take twice that.
    """
    out = []
    for path in (p for folder in folders for p in sorted((ROOT / folder).rglob("test_*.py"))):
        file, text = str(path.relative_to(ROOT)), hashlib.sha1(path.read_bytes()).hexdigest()
        seen = state["reached"].get(file, {})
        if seen.get("text") != text or "prepares" not in seen:
            into = COPY.parent / "reached.json"
            into.unlink(missing_ok=True)
            limit = None if math.isinf(longest) else STARTS + 2 * longest
            said, spent = tested([file], limit, into=into, longest=longest)
            seen = json.loads(into.read_text()) if into.exists() else {"seconds": {}, "places": {}, "prepares": 0.0}
            state["reached"][file] = {"text": text, **seen}
            keep(state)
            left = " is left out: it takes too long" if said == "noticed: it takes too long" else ""
            print(f"[{spent:.0f} s] what {file} comes to{left}", flush=True)
        out.append(Recorded(*(state["reached"][file][key] for key in Recorded._fields)))
    return out


def with_probes(chosen: list[Change]) -> None:
    """Make the copy say which of the places to change are evaluated."""
    (COPY / f"{PROBES}.py").write_text(TEXT)
    for path in {c.path for c in chosen}:
        places = {k: c.span for k, c in enumerate(chosen) if c.path == path}
        (COPY / path).write_text(probed((SOURCE / path).read_text(), places))


def tried(change: Change, place: int, known: list[Recorded], budget: float | None) -> tuple[str, float, int]:
    """Try a change on the tests that come to it; return what is said, the processor seconds and how many were asked."""
    loaded = change.span not in within_functions(ast.parse((SOURCE / change.path).read_text()))
    tests = reaching(known, place, loaded=loaded)
    prepares = {file_of(name): one.prepares for one in known for name in one.seconds}
    asked = ordered(tests, Path(change.path).stem, budget, prepares)
    if not asked:
        return "survived", 0.0, 0
    said, spent = tested(asked, STARTS + TIMES_AS_LONG * cost(asked, tests, prepares))
    return said, spent, len(asked)


def copied() -> None:
    """Put the package as it stands, its native modules included, where changes are made."""
    found = importlib.util.find_spec("pieper")
    if found is None or not found.submodule_search_locations:
        sys.exit("pieper is not here: say PYTHONPATH=src, with its native module built")
    shutil.rmtree(COPY.parent, ignore_errors=True)
    shutil.copytree(SOURCE, COPY, ignore=shutil.ignore_patterns("node_modules", "__pycache__", "*.so"))
    for native in Path(found.submodule_search_locations[0]).glob("_*.so"):
        shutil.copy(native, COPY)


def kept(chosen: list[Change]) -> dict[str, Any]:
    """Return what was tried before, and who comes where: of this sample, for any other is numbered otherwise."""
    state = json.loads(KEPT.read_text()) if KEPT.exists() else {}
    names = [c.name for c in chosen]
    reached = state.get("reached", {}) if state.get("sample") == names else {}
    return {"sample": names, "tried": state.get("tried", {}), "reached": reached}


def keep(state: dict[str, Any]) -> None:
    """Write what was tried."""
    KEPT.parent.mkdir(exist_ok=True)
    part = KEPT.with_suffix(".part")
    part.write_text(json.dumps(state, indent=1) + "\n")
    part.replace(KEPT)


def main() -> None:
    """Try what has not been tried, say how far it is, and print the survivors."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--of", nargs="*", default=DRAWN, choices=list(TESTS), help="the wings that the sample is of")
    parser.add_argument("--wings", nargs="*", choices=list(TESTS), help="try those of these wings; none: of all")
    parser.add_argument("--quick", action="store_true", help="leave the folders of slow tests out")
    parser.add_argument(
        "--budget", type=float, help="processor seconds of tests a change at the most; none: all that reach it"
    )
    parser.add_argument(
        "--longest", type=float, default=math.inf, help="ask no test of a file that begins after so many seconds of it"
    )
    parser.add_argument("--again", action="store_true", help="try the survivors again, after new tests")
    parser.add_argument("--seconds", type=float, default=math.inf, help="stop after so many, and go on another time")
    args = parser.parse_args()
    args.wings = args.wings or args.of
    begin, every = time.monotonic(), sample(args.of, args.count, args.seed)
    state = kept(every)
    chosen = [(k, c) for k, c in enumerate(every) if c.path.split("/")[0] in args.wings]
    if args.again:
        state["tried"] = {name: said for name, said in state["tried"].items() if said != "survived"}
    for name in LOADED:
        if importlib.util.find_spec(name):
            importlib.import_module(name)
    copied()
    with_probes(every)
    known = {
        wing: recorded(state, TESTS[wing] + ([] if args.quick else SLOW.get(wing, [])), args.longest)
        for wing in args.wings
    }
    copied()
    for i, (place, change) in enumerate(chosen):
        if change.name in state["tried"]:
            continue
        target, original = COPY / change.path, (SOURCE / change.path).read_text()
        target.write_text(with_change(original, change))
        said, spent, asked = tried(change, place, known[change.path.split("/")[0]], args.budget)
        target.write_text(original)
        state["tried"][change.name] = said
        keep(state)
        print(f"[{i + 1} of {len(chosen)}, {asked} tests, {spent:.0f} s] {change.name}: {said[:120]}", flush=True)
        if time.monotonic() - begin > args.seconds:
            break
    told = [c for _, c in chosen if c.name in state["tried"]]
    survivors = [c.name for c in told if state["tried"][c.name] == "survived"]
    print(f"{len(told)} of {len(chosen)} changes tried, {len(survivors)} of them not noticed:", *survivors, sep="\n")


if __name__ == "__main__":
    main()
