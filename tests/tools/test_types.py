"""Which files pyright looks at again: those whose own text changed, or the types of something that they import."""

from __future__ import annotations

import ast

import pytest

from tests.tools import types

FILES = {
    "src/pieper/__init__.py": "",
    "src/pieper/low.py": "WIDTH = 1e-9\n\n\ndef twice(x: float) -> float:\n    y = 2 * x\n    return y\n",
    "src/pieper/middle.py": "from pieper.low import twice\n\n\ndef four(x: float) -> float:\n    return twice(x)\n",
    "src/pieper/high.py": "from pieper import middle\n\nVALUE = middle.four(1.0)\n",
    "src/pieper/beside.py": "import math\n",
    "pyproject.toml": "[tool.pyright]\n",
}


@pytest.fixture
def tree(tmp_path, monkeypatch):
    """A small tree of its own, and what of it pyright is asked to look at."""
    for name, text in FILES.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    monkeypatch.setattr(types, "ROOT", tmp_path)
    monkeypatch.setattr(types, "KEPT", tmp_path / "out" / "types.json")
    return tmp_path


def looked_at(said="0 errors, "):
    """Return the names of the files that pyright is called with."""
    for function in (types.settings, types.reached, types.imported, types.files_of, types.outside):
        function.cache_clear()
    asked = []

    def run(*command):
        if "--version" not in command:
            asked.extend(command[command.index("--pythonpath") + 2 :])
        return 0, said

    types.complaints(run)
    return {name.rpartition("/")[2] for name in asked} - {"__init__.py"}


def test_all_files_are_looked_at_first_and_none_afterwards(tree):
    assert looked_at() == {"low.py", "middle.py", "high.py", "beside.py"}
    assert looked_at() == set()


@pytest.mark.parametrize(
    ("old", "new", "again"),
    [
        ("y = 2 * x", "y = x + x", {"low.py"}),
        ("WIDTH = 1e-9", "WIDTH = 1e-8", {"low.py"}),
        ("-> float:", "-> int:", {"low.py", "middle.py", "high.py"}),
        ("WIDTH = 1e-9", "WIDTH = 'wide'", {"low.py", "middle.py", "high.py"}),
    ],
)
def test_a_change_reaches_those_whose_types_depend_on_it(tree, old, new, again):
    looked_at()
    low = tree / "src" / "pieper" / "low.py"
    low.write_text(low.read_text().replace(old, new))
    assert looked_at() == again


def test_a_file_with_a_complaint_is_looked_at_until_it_is_mended(tree):
    complaint = f"{tree}/src/pieper/low.py:5:9 - error: no\n1 error, "
    looked_at(complaint)
    assert looked_at(complaint) == {"low.py"}


def test_new_settings_of_pyright_count_for_all_files(tree):
    looked_at()
    (tree / "pyproject.toml").write_text("[tool.pyright]\ntypeCheckingMode = 'strict'\n")
    assert len(looked_at()) == 4


def test_a_body_that_sets_an_attribute_is_part_of_the_types():
    text = """class A:
    def __init__(self) -> None:
        self.x = 1
        self.y = 2

    def f(self) -> int:
        z = 1
        return z
"""
    assert list(types.hidden(ast.parse(text))) == [(7, 8)]
