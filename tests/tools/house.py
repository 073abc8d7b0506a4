"""Read the whole tree as text: who imports whom, how long the files are, what they are called; print it as a table.

Usage: python -m tests.tools.house [--short]

Every import counts, inside functions, under TYPE_CHECKING and by `import_module` too. The law has no exceptions.
--short prints only what breaks it.
"""

from __future__ import annotations

import ast
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from statistics import median
from typing import NamedTuple

from tests.tools.names import missing
from tests.tools.thresholds import bare

ROOT = Path(__file__).resolve().parents[2]
SOURCE = ROOT / "src" / "pieper"
#: A wing may import from itself and from wings on lower floors; neighbours on a floor do not know each other. What
#: motion asks of the surroundings stands under it. `__init__` is the public surface, `arm` the facade behind it.
FLOORS = (
    ("errors", "words_by_number", "made_by"),
    ("arguments",),
    ("tolerances",),
    ("_kernel", "_code"),
    ("document", "kinematics"),
    ("description",),
    ("drawing",),
    ("solver",),
    ("collision",),
    ("motion",),
    ("algebra",),
    ("equations",),
    ("judge",),
    ("maps", "calibration", "code", "verify"),
    ("presentation",),
    ("at_scale", "jax", "torch"),
    ("along_paths",),
    ("arm",),
    ("arms", "cell"),
    ("__init__",),
    ("cli", "workbench"),
    ("__main__",),
)
FLOOR = {wing: i for i, wings in enumerate(FLOORS) for wing in wings}
#: Wings that may import less than their floor would allow.
ONLY = {
    "document": {"errors", "words_by_number", "arguments"},
    "algebra": {"errors", "words_by_number", "arguments", "tolerances", "_kernel", "document", "kinematics"},
}
PUBLIC_ONLY = ("cli", "workbench")
#: What the command line opens beside it, the workbench itself and not its rooms; and the thresholds of all.
DOORS = ("pieper.workbench", "pieper.tolerances")
LONGEST, MEDIAN = 400, 150
#: Names that begin with an underscore and are not ours to make public.
FOREIGN = {"_kernel", "_code", "_axinfo", "_fields"}
#: Names that say nothing about the room, and participles that say nothing about the thing.
FOSSIL_ROOMS = {"utils", "helpers", "common", "core", "manager", "misc"}
FOSSIL_ROOMS |= {"failing", "given", "judged", "looked", "made", "printed", "shown", "told"}
#: Files in which an object is asked what it is, because it comes from elsewhere: other libraries' poses and models.
ASKS_STRANGERS = {"src/pieper/kinematics/pose.py", "src/pieper/description/mjcf.py"}
GROUPS = {
    "src": ("src/pieper/**/*.py",),
    "kernels": ("kernels/**/*.hpp", "kernels/**/*.cpp"),
    "page": ("src/pieper/workbench/page/src/**/*.mjs",),
    "tests": ("tests/**/*.py", "oracle/**/*.py", "oracle/*.cpp", "benchmarks/**/*.py", "build_backend/**/*.py"),
}


class Violation(NamedTuple):
    """A rule that a file breaks, and with what."""

    rule: str
    where: str
    what: str = ""

    def __str__(self) -> str:
        return f"{self.rule}: {self.where} {self.what}".strip()


@dataclass
class Room:
    """One Python file of the package, as read.

    Attributes:
        imports: (module, name or None): `from module import name`, or `import module`.
        strange: Private names taken from other files, and public modules reached through `pieper.`, as written.
        asks: Attributes asked after by hasattr, or by getattr with a default.
    """

    module: str
    path: Path
    tree: ast.Module
    imports: list[tuple[str, str | None]] = field(default_factory=list)
    strange: list[str] = field(default_factory=list)
    asks: list[str] = field(default_factory=list)

    @property
    def where(self) -> str:
        """The path from the root of the tree."""
        return str(self.path.relative_to(ROOT))

    @property
    def wing(self) -> str:
        """The room's wing: the first part below the package."""
        return self.path.relative_to(SOURCE).parts[0].removesuffix(".py")


def files(*patterns: str) -> list[Path]:
    """Return the files of patterns, tools and what was built left out."""
    skipped = {"node_modules", "dist", "__pycache__"}
    return sorted(p for g in patterns for p in ROOT.glob(g) if not skipped & set(p.relative_to(ROOT).parts))


def module_of(path: Path) -> str:
    """Return the dotted name of a file below src."""
    parts = path.relative_to(ROOT / "src").with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


@cache
def rooms() -> dict[str, Room]:
    """Return every file of the package by its dotted name."""
    out = {}
    for path in files(*GROUPS["src"]):
        room = Room(module_of(path), path, ast.parse(path.read_text(), str(path)))
        read(room)
        out[room.module] = room
    return out


def absolute(room: Room, node: ast.ImportFrom) -> str:
    """Return the module of a `from` import, relative ones resolved."""
    if not node.level:
        return node.module or ""
    package = room.module.split(".")
    if room.path.name != "__init__.py":
        package = package[:-1]
    base = package[: len(package) - node.level + 1]
    return ".".join([*base, *([node.module] if node.module else [])])


def read(room: Room) -> None:
    """Fill in what a file imports, reaches for and asks."""
    nodes = list(ast.walk(room.tree))
    for node in nodes:
        if isinstance(node, ast.Import):
            for name in node.names:
                if name.name.split(".")[0] == "pieper":
                    room.imports.append((name.name, None))
        elif isinstance(node, ast.ImportFrom):
            module = absolute(room, node)
            if module.split(".")[0] == "pieper":
                room.imports += [(module, name.name) for name in node.names]
                room.strange += [f"{module}.{n.name}" for n in node.names if private(n.name) and n.name not in FOREIGN]
        elif isinstance(node, ast.Call):
            called = node.func.id if isinstance(node.func, ast.Name) else getattr(node.func, "attr", "")
            if called in ("import_module", "__import__") and node.args:
                room.imports += [(module, None) for module in named(node.args[0])]
            if called == "hasattr" or (called == "getattr" and len(node.args) == 3):
                room.asks.append(node.args[1].value if isinstance(node.args[1], ast.Constant) else "...")
    own = defined(nodes)
    for node in nodes:
        if isinstance(node, ast.Attribute):
            if private(node.attr) and node.attr not in own | FOREIGN:
                room.strange.append(ast.unparse(node))
            if isinstance(node.value, ast.Name) and node.value.id == "pieper" and is_module(f"pieper.{node.attr}"):
                room.imports.append((f"pieper.{node.attr}", None))


def defined(nodes: list[ast.AST]) -> set[str]:
    """Return the names that a file itself gives to functions, fields and attributes."""
    out: set[str] = set()
    for node in nodes:
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            out.add(node.name)
        elif isinstance(node, (ast.Name, ast.Attribute)) and isinstance(node.ctx, ast.Store):
            out.add(node.id if isinstance(node, ast.Name) else node.attr)
    return out


def private(name: str) -> bool:
    """Return whether a name is meant for its own file alone."""
    return name.startswith("_") and not name.startswith("__")


def named(argument: ast.expr) -> list[str]:
    """Return the modules that an argument of import_module can mean; of an f-string, all that begin alike."""
    if isinstance(argument, ast.Constant):
        return [argument.value] if str(argument.value).split(".")[0] == "pieper" else []
    if isinstance(argument, ast.JoinedStr) and isinstance(argument.values[0], ast.Constant):
        start = str(argument.values[0].value)
        return [m for path in files(*GROUPS["src"]) if (m := module_of(path)).startswith(start) and start]
    return []


@cache
def is_module(name: str) -> bool:
    """Return whether a dotted name is a file or folder of the package."""
    path = ROOT / "src" / Path(*name.split("."))
    native = name in ("pieper._kernel", "pieper._code")
    return native or path.with_suffix(".py").exists() or (path / "__init__.py").exists()


def targets(room: Room) -> Iterator[str]:
    """Yield the modules that a file depends on: what it imports, and the packages that are run on the way there."""
    for module, name in room.imports:
        target = f"{module}.{name}" if name and is_module(f"{module}.{name}") else module
        parts = target.split(".")
        for k in range(2, len(parts)):
            package = ".".join(parts[:k])
            if not room.module.startswith(package + ".") and package != room.module:
                yield package
        yield target


@cache
def graph() -> dict[str, set[str]]:
    """Return the file graph: module -> modules it imports."""
    return {m: {t for t in targets(room) if t in rooms() and t != m} for m, room in rooms().items()}


def circles() -> list[set[str]]:
    """Return the sets of files that can all be reached from each other."""
    reach: dict[str, set[str]] = {}
    for start in graph():
        seen, todo = set(), list(graph()[start])
        while todo:
            if (at := todo.pop()) not in seen:
                seen.add(at)
                todo += graph()[at]
        reach[start] = seen
    found = [frozenset(b for b in reach[a] if a in reach[b]) for a in reach if a in reach[a]]
    return [set(c) for c in dict.fromkeys(found)]


def wing_of(module: str) -> str:
    """Return the wing of a dotted name."""
    return (module.split(".") + ["__init__"])[1]


def upward() -> Iterator[Violation]:
    """Yield the imports that run up, or where they may not."""
    for room in rooms().values():
        if room.wing not in FLOOR:
            yield Violation("no such wing", room.where)
            continue
        for target in sorted(set(targets(room))):
            other = wing_of(target)
            if other == room.wing or other not in FLOOR:
                continue
            if room.wing in PUBLIC_ONLY:
                if other != "__init__" and target not in DOORS:
                    yield Violation("not public", room.where, f"-> {target}")
            elif FLOOR[other] >= FLOOR[room.wing]:
                yield Violation("upward", room.where, f"-> {target}")
            elif other not in ONLY.get(room.wing, FLOOR):
                yield Violation("may import less", room.where, f"-> {target}")


def unexported() -> Iterator[Violation]:
    """Yield what cli and workbench take from the package that it does not offer."""
    # read off the source: the law is held without the package being built
    lists = [node for node in ast.parse((SOURCE / "__init__.py").read_text()).body if isinstance(node, ast.Assign)]
    (offered,) = (ast.literal_eval(node.value) for node in lists if ast.unparse(node.targets[0]) == "__all__")
    for room in rooms().values():
        for module, name in room.imports:
            if room.wing in PUBLIC_ONLY and module == "pieper" and name and name not in offered:
                yield Violation("not public", room.where, f"-> pieper.{name}")


def private_names() -> Iterator[Violation]:
    """Yield the private names that files take from each other."""
    for room in rooms().values():
        yield from (Violation("private", room.where, f"-> {name}") for name in room.strange)


def in_circles() -> Iterator[Violation]:
    """Yield the imports that close a circle."""
    for circle in circles():
        for a in circle:
            yield from (Violation("circle", rooms()[a].where, f"-> {b}") for b in graph()[a] & circle)


def purpose(path: Path) -> bool:
    """Return whether a file says in its first lines what it is for."""
    text = path.read_text()
    if path.suffix == ".py":
        return text.startswith('"""')
    first = next((line for line in text.splitlines() if line.strip() and line.strip() != "#pragma once"), "")
    return first.startswith(("//", "/*"))


def lengths(group: str) -> dict[str, int]:
    """Return the number of lines of each file of a group."""
    return {str(p.relative_to(ROOT)): len(p.read_text().splitlines()) for p in files(*GROUPS[group])}


def sizes() -> Iterator[Violation]:
    """Yield files that are too long or do not say their purpose, and groups whose files are too long by half."""
    for group, patterns in GROUPS.items():
        counted = lengths(group)
        yield from (Violation("too long", where) for where, n in counted.items() if n > LONGEST)
        yield from (Violation("no purpose", str(p.relative_to(ROOT))) for p in files(*patterns) if not purpose(p))
        if counted and median(counted.values()) >= MEDIAN:
            yield Violation("median", group)


def fossils() -> Iterator[Violation]:
    """Yield names that say nothing, and objects of our own that are asked what they are."""
    for group in GROUPS.values():
        for path in files(*group):
            parts = path.relative_to(ROOT).with_suffix("").parts
            if FOSSIL_ROOMS & set(parts):
                yield Violation("fossil name", str(path.relative_to(ROOT)))
    for room in rooms().values():
        if room.where not in ASKS_STRANGERS:
            yield from (Violation("asks what it is", room.where, what) for what in room.asks)


def thresholds() -> Iterator[Violation]:
    """Yield the thresholds that stand elsewhere than on the pages of tolerances, without a name and a reason."""
    for path in files(*GROUPS["src"], *GROUPS["kernels"]):
        if "tolerances" not in path.parts:
            for line, spelled in bare(path.read_text(), path.suffix):
                yield Violation("bare threshold", f"{path.relative_to(ROOT)}:{line}", spelled)


def renamed() -> Iterator[Violation]:
    """Yield imports of names that are not there, in tests and examples too."""
    yield from (Violation("no such name", where, what) for where, what in missing())


def turns_by_hand() -> Iterator[Violation]:
    """Yield remainders of whole turns that are taken elsewhere than where joints are measured."""
    for path in files(*GROUPS["src"]):
        if path.parent != SOURCE / "kinematics":
            for node in ast.walk(ast.parse(path.read_text())):
                if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mod) and whole_turn(node.right):
                    yield Violation("turn by hand", f"{path.relative_to(ROOT)}:{node.lineno}", ast.unparse(node))


def whole_turn(node: ast.expr) -> bool:
    """Return whether an expression is 2 pi by any of its names."""
    return ast.unparse(node) in {"TURN", "2 * np.pi", "2 * math.pi", "2 * pi", "np.pi * 2", "math.tau", "2.0 * np.pi"}


@cache
def violations() -> dict[str, Violation]:
    """Return everything that breaks a rule, by the line that says so."""
    rules = (upward, unexported, private_names, in_circles, sizes, fossils, thresholds, renamed, turns_by_hand)
    return {str(v): v for rule in rules for v in rule()}


def arrows() -> list[str]:
    """Return a table of how many imports run from wing to wing."""
    count = Counter((room.wing, wing_of(t)) for room in rooms().values() for t in set(targets(room)))
    wings = [w for w in FLOOR if any(w in pair for pair in count)]
    lines = ["imports".ljust(14) + " ".join(w[:7].rjust(7) for w in wings)]
    for a in wings:
        cells = (str(count[a, b] or ".") + ("!" if count[a, b] and FLOOR[b] > FLOOR[a] else "") for b in wings)
        lines.append(a.ljust(14) + " ".join(cell.rjust(7) for cell in cells))
    return lines


def main() -> None:
    """Print the table and what breaks the law."""
    found = violations()
    if "--short" not in sys.argv[1:]:
        table(found)
    print("\n".join(sorted(found)))
    sys.exit(1 if found else 0)


def table(found: dict[str, Violation]) -> None:
    """Print who imports whom, how long files are, and how many rules are broken how often."""
    print("\n".join(arrows()), end="\n\n")
    for group in GROUPS:
        n = lengths(group)
        long = max(n, key=lambda where: n[where], default="")
        print(
            f"{group:8} {len(n):4} files, {sum(n.values()):6} lines, median {median(n.values()):.0f}; {long} {n[long]}"
        )
    print(f"\ncircles: {', '.join(str(len(c)) for c in circles()) or 'none'} (files each)")
    for rule, count in sorted(Counter(v.rule for v in found.values()).items()):
        print(f"{rule:16} {count}")
    print(f"\n{len(found)} violations")


if __name__ == "__main__":
    main()
