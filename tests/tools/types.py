"""Types of the whole tree by pyright, which looks only at files that it has not yet found right as they are now.

What a file is found right with is kept (out/types.json): its own text, and of everything that it imports, directly or
not, the part that types come from. A body of a function whose types are all written down is no such part, so that a
change in one makes one file be looked at again.
"""

from __future__ import annotations

import ast
import hashlib
import json
import re
import subprocess
import sys
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
KEPT = ROOT / "out" / "types.json"
FOLDERS = ("src/pieper", "oracle", "benchmarks")
#: More files than this are worth a second process of pyright's own.
FEW = 40
#: A number with a name: to other files it is a float, whatever its value.
_NUMBER = re.compile(r"^([A-Z][A-Z0-9_]*) = [\d.]+(?:e-?\d+)?$", re.MULTILINE)


def complaints(run: Callable[..., tuple[int, str]]) -> list[str]:
    """Return what pyright says against the tree; `run` runs a tool of the environment."""
    known = set(json.loads(KEPT.read_text())) if KEPT.exists() else set()
    keys = {path: key(path, run) for path in sources()}
    new = [str(path.relative_to(ROOT)) for path, found in keys.items() if found not in known]
    said: list[str] = []
    if new:
        threads = ["--threads"] if len(new) > FEW else []
        _, text = run("pyright", *threads, "--pythonpath", sys.executable, *new)
        if not re.search(r"\d+ errors?,", text):
            return ["pyright did not run", text]
        said = [line.strip() for line in text.splitlines() if " - error: " in line]
    wrong = {path for path in keys if any(str(path) in line for line in said)}
    KEPT.parent.mkdir(exist_ok=True)
    KEPT.write_text(json.dumps(sorted(found for path, found in keys.items() if path not in wrong), indent=0))
    return said


def sources() -> list[Path]:
    """Return the files whose types are checked."""
    found = (path for folder in FOLDERS for end in ("*.py", "*.pyi") for path in (ROOT / folder).rglob(end))
    return sorted(path for path in found if not {"node_modules", "__pycache__"} & set(path.parts))


def key(path: Path, run: Callable[..., tuple[int, str]]) -> str:
    """Return what stands for a file as it is now and for all that its types depend on."""
    parts = [settings(run), str(path.relative_to(ROOT)), path.read_text()]
    parts += [f"{other.relative_to(ROOT)} {outside(other)}" for other in sorted(reached(path))]
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()


@cache
def settings(run: Callable[..., tuple[int, str]]) -> str:
    """Return what else types depend on: pyright's settings and version, Python's, and the packages installed."""
    rules = (ROOT / "pyproject.toml").read_text().partition("[tool.pyright]")[2]
    listed = "import importlib.metadata as m; print(sorted((d.name or '', d.version) for d in m.distributions()))"
    packages = subprocess.run([sys.executable, "-c", listed], capture_output=True, text=True, check=True).stdout
    return "\n".join([rules, run("pyright", "--version")[1], sys.version, packages])


@cache
def reached(path: Path) -> frozenset[Path]:
    """Return all files of the tree that a file imports, directly or not."""
    seen: set[Path] = set()
    todo = [path]
    while todo:
        new = imported(todo.pop()) - seen
        seen |= new
        todo += new
    return frozenset(seen)


@cache
def imported(path: Path) -> frozenset[Path]:
    """Return the files of the tree that a file names in its imports, those in functions too."""
    out: set[Path] = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            whole = [alias.name.split(".") for alias in node.names]
            names = [".".join(parts[: k + 1]) for parts in whole for k in range(len(parts))]
        elif isinstance(node, ast.ImportFrom):
            base = node.module or ""
            if node.level:
                here = path.relative_to(ROOT / "src" if ROOT / "src" in path.parents else ROOT).parts[: -node.level]
                base = ".".join([*here, *base.split(".")] if base else here)
            inner = [f"{base}.{alias.name}" for alias in node.names]
            names = inner if all(files_of(name) for name in inner) else [base, *inner]
        else:
            continue
        out |= {file for name in names for file in files_of(name)}
    return frozenset(out)


@cache
def files_of(name: str) -> frozenset[Path]:
    """Return the files of a dotted name; types that are taken from it do not come from the packages above."""
    parts = name.split(".")
    place = (ROOT / "src" if parts[0] == "pieper" else ROOT).joinpath(*parts)
    ends = (place.with_suffix(".pyi"), place.with_suffix(".py"), place / "__init__.py")
    return frozenset(end for end in ends if end.exists() and any(ROOT / f in end.parents for f in FOLDERS))


@cache
def outside(path: Path) -> str:
    """Return what stands for a file's text without the bodies that say nothing to other files."""
    lines: list[str | None] = list(path.read_text().splitlines())
    for first, last in hidden(ast.parse(path.read_text())):
        lines[first - 1 : last] = [None] * (last - first + 1)
    text = "\n".join(line for line in lines if line is not None and not line.startswith("#"))
    return hashlib.sha256(re.sub(_NUMBER, r"\1 = float", text).encode()).hexdigest()


def hidden(tree: ast.AST) -> Iterator[tuple[int, int]]:
    """Yield the first and last line of each body whose types are all written down around it.

    A body that sets attributes stays, and one of a single statement: it may say that a method is abstract.
    """
    for node in ast.iter_child_nodes(tree):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            sets = any(isinstance(n, ast.Attribute) and isinstance(n.ctx, ast.Store) for n in ast.walk(node))
            own_lines = node.body[0].lineno > node.lineno
            if node.returns is not None and len(node.body) > 1 and not sets and own_lines:
                yield node.body[0].lineno, node.body[-1].end_lineno or node.lineno
        else:
            yield from hidden(node)
