"""`pieper clear`: what it says is so, and its exit status follows."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest

import pieper
from pieper.cli import main

ROOT = Path(__file__).parents[2]


def run(capsys, *words):
    with pytest.raises(SystemExit) as left:
        main(list(words))
    return left.value.code, capsys.readouterr()


def test_a_clear_path_and_one_that_hits(tmp_path, capsys):
    pieper.Scene([pieper.Box([0.3, 0.0, 0.2], [0.1, 0.4, 0.4], name="crate")]).save(tmp_path / "cell.toml")
    there = ("clear", "denso-vp6242", "--from", "90 90 -180 0 0 0", "--to", "0 90 -180 0 0 0")
    code, said = run(capsys, *there)
    assert code == 0 and said.out.startswith("Clear:") and "guessed" in said.out
    code, said = run(capsys, *there, "--scene", str(tmp_path / "cell.toml"), "--margin", "5")
    assert code == 1 and "crate" in said.out
    code, said = run(capsys, *there, "--scene", str(tmp_path / "cell.toml"), "--margin", "5", "--json")
    data = json.loads(said.out)
    arm = pieper.load("denso-vp6242")
    scene = pieper.Scene.load(tmp_path / "cell.toml")
    assert data["verdict"] == "HIT" and float(arm.distance(data["q"], scene)) < 0.005
    path = np.radians([[90, 90, -180, 0, 0, 0], [0, 90, -180, 0, 0, 0]])
    assert data["nearest_m"] == float(np.min(arm.distance(path, scene)))


def test_a_file_of_joints_is_a_path(tmp_path, capsys):
    (tmp_path / "q.csv").write_text("0,90,-180,0,0,0\n10,90,-180,0,0,0\n")
    code, said = run(capsys, "clear", "denso-vp6242", "--path", str(tmp_path / "q.csv"))
    assert code == 0 and "Of its 2 points" in said.out
    (tmp_path / "q.csv").write_text("0,90,-180,0,0\n")
    code, said = run(capsys, "clear", "denso-vp6242", "--path", str(tmp_path / "q.csv"))
    assert code == 2 and "line 1" in said.err
    code, said = run(capsys, "clear", "denso-vp6242")
    assert code == 2 and "--from" in said.err


def test_what_cannot_be_gone_to_and_what_the_bodies_are_is_said(capsys):
    code, said = run(capsys, "clear", "denso-vp6242", "--from", "home", "--to", "600 90 -180 0 0 0")
    assert code == 0 and "joint_1 is at 600 deg at point 2, outside its limits of -160 to 160 deg" in said.out
    code, said = run(capsys, "clear", "denso-vp6242", "--bodies")
    assert code == 0 and "These may touch" in said.out
    code, said = run(capsys, "clear", "denso-vp6242", "--from", "home", "--margin", "-5")
    assert code == 2 and "at least 0 mm, got -5" in said.err


def test_the_page_runs_as_it_stands(capsys):
    text = (ROOT / "docs" / "collision.md").read_text()
    names: dict[str, object] = {}
    for block in re.findall(r"```python\n(.*?)```", text, re.S):
        exec(compile(block, "docs/collision.md", "exec"), names)
    assert "Clear" in capsys.readouterr().out
    command = re.search(r"`pieper (clear ARM[^`]*)`", text)[1]
    assert command.startswith("clear ARM --scene")
