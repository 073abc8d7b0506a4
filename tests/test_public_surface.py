"""What `import pieper` offers: every name exists and loads late, and the rooms that people use keep to those names."""

from __future__ import annotations

import ast
import subprocess
import sys
from pathlib import Path

import pytest

import pieper

SOURCE = Path(pieper.__file__).parent
ROOMS = ("cli", "workbench")
#: Every threshold stands there with its reason, those of these rooms too; it offers numbers and nothing that works.
THRESHOLDS = {"pieper.tolerances"}


def imports(path: Path):
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.module:
            yield node.module
        elif isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)


@pytest.mark.parametrize(
    "path",
    [p for room in ROOMS for p in sorted((SOURCE / room).glob("*.py"))],
    ids=lambda p: f"{p.parent.name}/{p.name}",
)
def test_command_line_and_workbench_use_public_names_only(path):
    others = {m for m in imports(path) if m.startswith("pieper.") and m.split(".")[1] not in ROOMS}
    assert others <= THRESHOLDS


def test_the_late_names_are_those_that_a_type_checker_is_told():
    tree = ast.parse((SOURCE / "__init__.py").read_text(encoding="utf-8"))
    told = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING":
            for line in node.body:
                if isinstance(line, ast.AnnAssign):  # a module that is called: it is itself, and anything
                    told[ast.unparse(line.target)] = f"pieper.{ast.unparse(line.target)}"
                    continue
                assert isinstance(line, ast.ImportFrom)
                for alias in line.names:
                    module = f"{line.module}.{alias.name}" if alias.name in pieper._MODULES else line.module
                    told[alias.name] = module
    assert told == pieper._LATER


def test_every_name_exists_and_is_listed_once():
    assert len(set(pieper.__all__)) == len(pieper.__all__)
    assert all(getattr(pieper, name) is not None for name in pieper.__all__)
    assert set(pieper._LATER) <= set(pieper.__all__) <= set(dir(pieper))
    with pytest.raises(AttributeError, match="no attribute 'plto'"):
        pieper.plto  # noqa: B018


def test_late_names_are_late():
    code = (
        "import sys, pieper; print([m for m in sys.modules if m.startswith(('pieper.judge', 'pieper.presentation'))])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_type_checkers_are_told_that_the_package_is_typed_and_what_its_native_modules_hold():
    home = Path(str(pieper.__file__)).parent
    assert (home / "py.typed").exists()
    assert {f"{path.name.split('.')[0]}.pyi" for path in home.glob("_*.so")} <= {p.name for p in home.glob("*.pyi")}
