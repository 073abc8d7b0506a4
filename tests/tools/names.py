"""Names that a file imports from the tree and that are not there: read as text, files outside the package too.

Pyright looks at the package, the oracle and the benchmarks; tests, the page without a server and examples are only run,
some of them after half an hour of others. A name that was renamed is found here in a second.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
#: Where the packages of the tree stand.
PACKAGES = {"pieper": ROOT / "src" / "pieper"} | {
    name: ROOT / name for name in ("tests", "oracle", "benchmarks", "static_page", "build_backend")
}
FOLDERS = ("src", "tests", "oracle", "benchmarks", "static_page", "build_backend", "examples", "docs")


def missing() -> Iterator[tuple[str, str]]:
    """Yield (file and line, what it imports) of names of the tree that do not exist."""
    for folder in FOLDERS:
        for path in sorted((ROOT / folder).rglob("*.py")):
            if not {"node_modules", "__pycache__"} & set(path.parts):
                yield from missing_in(path)


def missing_in(path: Path) -> Iterator[tuple[str, str]]:
    """Yield those of one file."""
    for node in ast.walk(ast.parse(path.read_text())):
        wanted: list[tuple[str, str | None]] = []
        if isinstance(node, ast.ImportFrom):
            wanted = [(source(node, path), alias.name) for alias in node.names if alias.name != "*"]
        elif isinstance(node, ast.Import):
            wanted = [(alias.name, None) for alias in node.names]
        for module, name in wanted:
            if module.split(".")[0] in PACKAGES and not there(module, name):
                said = f"import {module}" if name is None else f"from {module} import {name}"
                yield f"{path.relative_to(ROOT)}:{node.lineno}", said


def source(node: ast.ImportFrom, path: Path) -> str:
    """Return the full name of the module that an import takes from; nothing where it lies outside the packages."""
    if not node.level:
        return node.module or ""
    folder = path.parents[node.level - 1]
    for name, root in PACKAGES.items():
        if folder.is_relative_to(root):
            return ".".join([name, *folder.relative_to(root).parts, *([node.module] if node.module else [])])
    return ""


def there(module: str, name: str | None) -> bool:
    """Return whether a module of the tree exists and, where a name is given, has it."""
    file = file_of(module)
    if file is None or name is None:
        return file is not None
    if file_of(f"{module}.{name}") is not None:
        return True
    return not file.is_dir() and bool({name, "__getattr__"} & defined(file))


@cache
def file_of(module: str) -> Path | None:
    """Return the file of a module, its stub where it is not Python; a folder of a package without a file of its own."""
    first, *rest = module.split(".")
    stem = PACKAGES[first].joinpath(*rest)
    for file in (stem / "__init__.py", stem.with_name(stem.name + ".py"), stem.with_name(stem.name + ".pyi")):
        if file.exists():
            return file
    return stem if stem.is_dir() else None


@cache
def defined(file: Path) -> frozenset[str]:
    """Return the names that a file binds at its top, under conditions and `try` and by a star too."""
    names = {"__doc__", "__file__", "__name__"}
    todo: list[ast.AST] = [ast.parse(file.read_text())]
    while todo:
        for node in ast.iter_child_nodes(todo.pop()):
            if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
                names.add(node.name)
            elif isinstance(node, ast.ImportFrom) and node.names[0].name == "*":
                module = source(node, file)
                other = file_of(module) if module.split(".")[0] in PACKAGES else None
                names |= defined(other) if other is not None else set()
            elif isinstance(node, ast.Import | ast.ImportFrom):
                names |= {(alias.asname or alias.name).split(".")[0] for alias in node.names}
            else:
                if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
                    names.add(node.id)
                todo.append(node)
    return frozenset(names)
