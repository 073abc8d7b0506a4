"""Change the code in small ways, one at a time, and say which changes no test of their wing notices.

Usage: python -m tests.tools.mutants [--count 200] [--seed 1] [--wings solver motion judge] [--again] [--quick]

The sample is drawn once from the seed; what was tried is kept in out/mutants.json and not tried again, so a run that
was stopped goes on. A change is made in a copy of the package (build/mutants), never in the tree. The wing's quick
tests are run once under coverage, which says what test reaches which line: a change is tried on those that reach it,
and where they do not notice it on the slow ones too (not with --quick). What takes far longer than the untouched code
counts as noticed.
"""

from __future__ import annotations

import argparse
import ast
import copy
import json
import os
import random
import shutil
import subprocess
import sys
import time
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

ROOT = Path(__file__).resolve().parents[2]
SOURCE = ROOT / "src" / "pieper"
COPY = ROOT / "build" / "mutants" / "pieper"
KEPT = ROOT / "out" / "mutants.json"
REACHED = ROOT / "out" / "reached"
#: The quick tests of each wing, and its slow ones.
TESTS = {"solver": ["tests/solver", "tests/kernels"], "motion": ["tests/motion"], "judge": ["tests/judge"]}
SLOW = {"solver": ["tests/laws", "tests/oracle"], "motion": [], "judge": ["tests/papers"]}
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
    skipped = spoken(tree)
    for node in ast.walk(tree):
        if id(node) in skipped or not isinstance(node, ast.expr):
            continue
        for other in altered(node):
            span = (node.lineno, node.col_offset, node.end_lineno or 0, node.end_col_offset or 0)
            before = " ".join((ast.get_source_segment(text, node) or "").split())
            yield Change(str(path.relative_to(SOURCE)), before, ast.unparse(other), span)


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


def tested(tests: list[str], limit: float | None, *, under: tuple[str, ...] = ()) -> tuple[str, float]:
    """Run tests on the copy; return "noticed by ..." or "survived", and the seconds it took."""
    begin = time.monotonic()
    words = "-x -q -p no:cacheprovider --no-header --tb=no -n 0".split()
    env = {**os.environ, "PYTHONPATH": str(COPY.parent), "PYTHONDONTWRITEBYTECODE": "1"}
    command = [sys.executable, "-m", *under, "pytest", *words, *tests]
    try:
        done = subprocess.run(command, cwd=ROOT, env=env, capture_output=True, text=True, timeout=limit)
    except subprocess.TimeoutExpired:
        return "noticed: it takes too long", time.monotonic() - begin
    failed = [line for line in done.stdout.splitlines() if line.startswith(("FAILED", "ERROR"))]
    said = f"noticed: {failed[0] if failed else done.stdout[-200:]}" if done.returncode else "survived"
    return said, time.monotonic() - begin


def recorded(wing: str) -> float:
    """Run a wing's quick tests under coverage, by test; return the seconds that they took."""
    settings = REACHED / "settings.toml"
    settings.parent.mkdir(parents=True, exist_ok=True)
    settings.write_text('[tool.coverage.run]\ndynamic_context = "test_function"\nsource_pkgs = ["pieper"]\n')
    under = ("coverage", "run", f"--rcfile={settings}", f"--data-file={REACHED / wing}", "-m")
    said, spent = tested([*TESTS[wing], "-m", "not slow"], None, under=under)
    if said != "survived":
        sys.exit(f"the tests of {wing} do not pass on the untouched code: {said}")
    return spent


@cache
def reaching(wing: str, path: str) -> dict[int, set[str]]:
    """Return the tests that reach each line of a file, as pytest names them; under 0, those that reach any."""
    from coverage import CoverageData

    data = CoverageData(basename=str(REACHED / wing))
    data.read()
    out: dict[int, set[str]] = {0: set()}
    for line, contexts in data.contexts_by_lineno(str(COPY / path)).items():
        names = {name for context in contexts if (name := _test_of(context))}
        out[line] = names
        out[0] |= names
    return out


def _test_of(context: str) -> str:
    """Return pytest's name of a test from coverage's; none for what runs outside of tests."""
    parts = context.split(".")
    for k in range(len(parts), 0, -1):
        file = ROOT.joinpath(*parts[:k]).with_suffix(".py")
        if k < len(parts) and file.exists():
            return "::".join([str(file.relative_to(ROOT)), *parts[k:]])
    return ""


def tried(change: Change, slow: bool, untouched: float) -> tuple[str, float]:
    """Try a change on the tests that reach it; on all of its file where it stands outside of functions."""
    wing = change.path.split("/")[0]
    lines = reaching(wing, change.path)
    first, _, last, _ = change.span
    tests = set().union(*(lines.get(line, set()) for line in range(first, last + 1))) or lines[0]
    said, spent = tested(sorted(tests), 60 + 4 * untouched) if tests else ("survived", 0.0)
    if said == "survived" and slow and SLOW[wing]:
        said, more = tested(SLOW[wing], None)
        spent += more
    return said, spent


def copied() -> None:
    """Put the package as it stands, its native modules included, where changes are made."""
    import pieper

    shutil.rmtree(COPY.parent, ignore_errors=True)
    shutil.copytree(SOURCE, COPY, ignore=shutil.ignore_patterns("node_modules", "__pycache__", "*.so"))
    for native in Path(str(pieper.__file__)).parent.glob("_*.so"):
        shutil.copy(native, COPY)


def kept() -> dict[str, Any]:
    """Return what was tried before."""
    return json.loads(KEPT.read_text()) if KEPT.exists() else {"tried": {}, "untouched_s": {}}


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
    parser.add_argument("--wings", nargs="*", default=list(TESTS), choices=list(TESTS))
    parser.add_argument("--quick", action="store_true", help="leave the slow tests out")
    parser.add_argument("--again", action="store_true", help="try the survivors again, after new tests")
    args = parser.parse_args()
    state, chosen = kept(), sample(args.wings, args.count, args.seed)
    if args.again:
        state["tried"] = {name: said for name, said in state["tried"].items() if said != "survived"}
    copied()
    for wing in args.wings:
        if wing not in state["untouched_s"] or args.again or not (REACHED / wing).exists():
            state["untouched_s"][wing] = recorded(wing)
            keep(state)
    for i, change in enumerate(chosen):
        if change.name in state["tried"]:
            continue
        target, original = COPY / change.path, (SOURCE / change.path).read_text()
        target.write_text(with_change(original, change))
        said, spent = tried(change, not args.quick, state["untouched_s"][change.path.split("/")[0]])
        target.write_text(original)
        state["tried"][change.name] = said
        keep(state)
        print(f"[{i + 1} of {len(chosen)}, {spent:.0f} s] {change.name}: {said[:120]}", flush=True)
    survivors = [c.name for c in chosen if state["tried"][c.name] == "survived"]
    print(f"{len(chosen)} changes, {len(survivors)} of them not noticed:", *survivors, sep="\n")


if __name__ == "__main__":
    main()
