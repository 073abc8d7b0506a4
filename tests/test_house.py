"""Rules of the house: imports run one way, rooms stay small, nothing heavy loads with the package."""

from __future__ import annotations

import ast
import subprocess
import sys
from pathlib import Path

import pytest

import pieper

SOURCE = Path(__file__).resolve().parents[1] / "src" / "pieper"
#: A wing may import from itself and from wings before it.
ORDER = [
    "errors",
    "tolerances",
    "_kernel",
    "description",
    "kinematics",
    "inverse",
    "motion",
    "symbolic",
    "presentation",
]
FILES = sorted(p for p in SOURCE.rglob("*.py") if "node_modules" not in p.parts)
PUBLIC_ONLY = ("cli", "workbench")
#: Where a wing reads one that comes later, on purpose: `describe` checks poses with the pose module.
ALLOWED = {("description", "kinematics")}


def wing(path: Path) -> str:
    return path.relative_to(SOURCE).parts[0].removesuffix(".py")


def top_level_imports(path: Path):
    for node in ast.parse(path.read_text()).body:
        if isinstance(node, ast.ImportFrom) and node.module and node.module.startswith("pieper"):
            yield node.module.split(".")[1] if "." in node.module else node.names[0].name
        elif isinstance(node, ast.Import):
            for name in node.names:
                if name.name.startswith("pieper."):
                    yield name.name.split(".")[1]


@pytest.mark.parametrize("path", FILES, ids=lambda p: str(p.relative_to(SOURCE)))
def test_imports_run_one_way(path):
    mine = wing(path)
    if mine not in ORDER:
        return
    for other in top_level_imports(path):
        if other not in ORDER or (mine, other) in ALLOWED:
            continue
        assert ORDER.index(other) <= ORDER.index(mine), f"{mine} must not import {other}"


@pytest.mark.parametrize("path", FILES, ids=lambda p: str(p.relative_to(SOURCE)))
def test_a_room_says_its_purpose_and_can_be_read_in_one_sitting(path):
    text = path.read_text()
    assert ast.get_docstring(ast.parse(text)), "the first line says what the room is for"
    assert len(text.splitlines()) <= 450
    assert path.stem not in {"utils", "helpers", "common", "core", "manager"}


def test_nothing_heavy_loads_with_the_package():
    heavy = "sympy matplotlib dask starlette uvicorn typer rich tomlkit scipy".split()
    code = f"import sys, pieper; print([m for m in {heavy!r} if m in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_every_public_name_exists():
    assert all(hasattr(pieper, name) for name in pieper.__all__)
