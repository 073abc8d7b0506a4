"""The page's example runs as it stands, and the command reads tables."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest

import pieper
from tests.calibration.command import main
from tests.calibration.planted import NOISE, noisy, planted, postures

PAGE = Path(__file__).parents[2] / "docs" / "calibration.md"


def test_the_example_of_the_page_runs(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for block in re.findall(r"```python\n(.*?)```", PAGE.read_text(), re.S):
        exec(compile(block, str(PAGE), "exec"), {})
    assert pieper.load("my-ur5e.toml").n == 6


def table(place: Path, head: list[str], rows: np.ndarray) -> str:
    place.write_text("\n".join([",".join(head), *(",".join(repr(float(x)) for x in row) for row in rows)]) + "\n")
    return str(place)


def test_a_table_without_orientations_is_not_calibrated_as_poses(tmp_path, capsys):
    arm, q, Y = planted_denso()
    head = [f"{name}_deg" for name in arm.joint_names] + ["x_mm", "y_mm", "z_mm", "comment"]
    rows = np.column_stack([np.degrees(q), 1e3 * Y[:, :3, 3], np.zeros(len(q))])
    file = table(tmp_path / "places.csv", head, rows)
    assert main(["calibrate", "denso-vp6242", file]) == 2
    assert "no orientation: say --kind position" in capsys.readouterr().err
    assert main(["calibrate", "denso-vp6242", file, "--kind", "position"]) == 0
    said = capsys.readouterr()
    assert "not used of" in said.err and said.err.rstrip().endswith("comment.") and "mrad" not in said.out
    heights = [*head[:6], "height_mm"]
    file = table(tmp_path / "heights.csv", heights, rows[:, :7])
    assert main(["calibrate", "denso-vp6242", file]) == 2
    assert "say --kind plane" in capsys.readouterr().err


def planted_denso(seed=3):
    arm, rng = pieper.load("denso-vp6242"), np.random.default_rng(seed)
    q = postures(arm, rng, 60)
    return arm, q, noisy(planted(arm, rng).fk(q), rng)


def test_a_table_of_poses_becomes_a_robot_file(tmp_path, capsys):
    arm, q, Y = planted_denso()
    said = np.array([pieper.read_pose(T, "rpy", degrees=True, mm=True) for T in Y])
    head = [f"{name}_deg" for name in arm.joint_names] + ["x_mm", "y_mm", "z_mm", "roll_deg", "pitch_deg", "yaw_deg"]
    data = table(tmp_path / "data.csv", head, np.hstack([np.degrees(q), said]))
    out = tmp_path / "arm.toml"
    assert main(["calibrate", "denso-vp6242", data, "--out", str(out), "--sigma", "0.05 0.0057"]) == 0
    assert "held-out poses the error is" in capsys.readouterr().out.replace("\n", " ")
    expected = arm.calibrate(q, Y, sigma=(NOISE[0], np.radians(0.0057)))
    assert np.abs(pieper.load(out).fk(q) - expected.arm.fk(q)).max() < 1e-9
    assert main(["calibrate", "denso-vp6242", data, "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["held_out"]["metres"] < 3e-4


@pytest.mark.parametrize("kind", ["position", "distance", "plane"])
def test_other_kinds_have_columns_of_their_own(tmp_path, capsys, kind):
    _, q, Y = planted_denso()
    p = Y[:, :3, 3]
    columns = {
        "position": (["x_mm", "y_mm", "z_mm"], p * 1e3),
        "distance": (["distance_mm"], np.linalg.norm(p - [0.6, 0.5, 0.2], axis=1)[:, None] * 1e3),
        "plane": (["height_mm"], p[:, 2:] * 1e3),
    }
    head, rows = columns[kind]
    data = table(tmp_path / "d.csv", [f"q{i}_deg" for i in range(1, 7)] + head, np.hstack([np.degrees(q), rows]))
    assert main(["calibrate", "denso-vp6242", data, "--kind", kind, "--loss", "huber"]) == 0
    assert "cannot see" in capsys.readouterr().out


def test_a_missing_column_is_named(tmp_path, capsys):
    _, q, _ = planted_denso()
    data = table(tmp_path / "d.csv", [f"q{i}_deg" for i in range(1, 6)], np.degrees(q[:, :5]))
    assert main(["calibrate", "denso-vp6242", data]) == 2
    assert "no column for joint_6" in capsys.readouterr().err.replace("\n", " ")
    assert main(["calibrate", "denso-vp6242", str(tmp_path / "none.csv")]) == 2
