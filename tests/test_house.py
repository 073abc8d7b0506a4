"""The law of the house: imports run one way and in no circle, rooms stay small, nothing heavy loads with the package.

`tests/tools/house.py` reads the tree and says what each rule means.
"""

from __future__ import annotations

import ast
import re
import subprocess
import sys
import tomllib

import pytest

import pieper
from tests.tools import house

RULES = (
    "no such wing",
    "upward",
    "may import less",
    "not public",
    "private",
    "circle",
    "too long",
    "no purpose",
    "median",
    "fossil name",
    "asks what it is",
    "bare threshold",
    "no such name",
    "turn by hand",
)


@pytest.mark.parametrize("rule", RULES)
def test_the_law_of_the_house_holds(rule):
    broken = sorted(name for name, v in house.violations().items() if v.rule == rule)
    assert not broken, "\n".join(["broken:", *broken])


def test_every_rule_is_looked_at():
    assert {v.rule for v in house.violations().values()} <= set(RULES)


def test_imports_are_read_wherever_they_stand(tmp_path):
    text = """
import pieper.errors
from typing import TYPE_CHECKING
from ..motion import track
if TYPE_CHECKING:
    from pieper.arm import Arm
def f(name):
    from pieper.solver.words.labels import _hidden
    import_module("pieper.judge.claims")
    import_module(f"pieper.solver.families.{name}")
    return pieper.description, other._secret, hasattr(f, "title")
"""
    room = house.Room("pieper.cli.somewhere", house.SOURCE / "cli" / "somewhere.py", ast.parse(text))
    house.read(room)
    seen = set(house.targets(room))
    assert {"pieper.errors", "pieper.motion.track", "pieper.arm", "pieper.solver.words.labels"} <= seen
    assert {"pieper.judge.claims", "pieper.solver.families.general", "pieper.description"} <= seen
    assert "pieper.solver" in seen, "a package is run on the way to its modules"
    assert room.strange == ["pieper.solver.words.labels._hidden", "other._secret"]
    assert room.asks == ["title"]


def test_a_turn_taken_by_hand_is_found(tmp_path, monkeypatch):
    (tmp_path / "some.py").write_text("a = (x + np.pi) % (2 * np.pi) - np.pi\nb = x % TURN\nc = k % 2\nd = '%s' % pi\n")
    monkeypatch.setattr(house, "ROOT", tmp_path)
    monkeypatch.setattr(house, "files", lambda *patterns: [tmp_path / "some.py"])
    assert {v.what for v in house.turns_by_hand()} == {"(x + np.pi) % (2 * np.pi)", "x % TURN"}


def test_fixed_decimals_have_no_negative_zero():
    # a format with "z" writes what rounds to zero as 0.0, not as -0.0
    bare = []
    for path in house.SOURCE.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.FormattedValue) and node.format_spec is not None:
                spec = ast.unparse(node.format_spec)[2:-1]
                if re.search(r"\.(\d+|\{.*\})f$", spec) and "z" not in spec:
                    bare.append(f"{path.name}:{node.lineno} {spec}")
    assert not bare, "\n".join(bare)


def test_a_circle_is_found(monkeypatch):
    arrows = {"a": {"b"}, "b": {"c"}, "c": {"a"}, "d": {"a"}, "e": set()}
    monkeypatch.setattr(house, "graph", lambda: arrows)
    assert house.circles() == [{"a", "b", "c"}]


def test_nothing_heavy_loads_with_the_package():
    heavy = "sympy matplotlib dask starlette uvicorn click rich tomlkit scipy".split()
    code = f"import sys, pieper; print([m for m in {heavy!r} if m in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_every_public_name_exists():
    assert all(hasattr(pieper, name) for name in pieper.__all__)


def test_the_version_is_said_once():
    project = tomllib.loads((house.ROOT / "pyproject.toml").read_text())
    assert "version" in project["project"]["dynamic"]
    said = re.search(r'__version__ = "([^"]+)"', (house.SOURCE / "__init__.py").read_text())
    assert said and pieper.__version__ == said[1]


def test_every_file_a_pose_walks_through_is_there():
    told = re.findall(
        r"`([\w/.]+\.(?:py|hpp|cpp)|[\w/]+/)`", (house.ROOT / "docs" / "a_pose_walks_through.md").read_text()
    )
    solver = house.SOURCE / "solver"
    homes = (house.SOURCE, house.ROOT, solver, solver / "redundant", solver / "singular", solver / "words")
    assert len(told) > 40
    assert not [name for name in told if not any((home / name).exists() for home in homes)]
