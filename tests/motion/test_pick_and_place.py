"""The example of a program runs as it stands and says what it did."""

import runpy
from pathlib import Path

EXAMPLE = Path(__file__).resolve().parents[2] / "examples" / "06_pick_and_place.py"


def test_the_example_runs(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    runpy.run_path(str(EXAMPLE))
    said = capsys.readouterr().out
    assert "7 moves of dfrobot-rob0036" in said and "gripper 1" in said
    assert (tmp_path / "pick_and_place.csv").exists()
