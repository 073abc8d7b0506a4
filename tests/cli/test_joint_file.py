"""`pieper fk ARM @joints.csv`: a table of joint vectors becomes a table of poses, which `pieper ik` reads back."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pieper
from pieper.cli import main, number_table

ARM = pieper.load("epson-ls3-401s")


def run(*words: str) -> int:
    with pytest.raises(SystemExit) as left:
        main(list(words))
    return int(left.value.code or 0)


def poses(file: Path) -> tuple[np.ndarray, np.ndarray]:
    rows = np.loadtxt(file, delimiter=",", skiprows=1, ndmin=2)
    T = np.tile(np.eye(4), (len(rows), 1, 1))
    T[:, :3, 3], T[:, :3, :3] = rows[:, 1:4] / 1000, rows[:, 4:13].reshape(-1, 3, 3)
    return T, rows[:, 13]


@pytest.mark.parametrize(
    "heads", ["joint_1_deg,joint_2_deg,joint_3_mm,joint_4_deg", "q1,q2,q3,q4", "j4,q4,q3_m,q2_rad,q1", ""]
)
def test_a_table_is_what_the_arm_says_row_by_row(tmp_path, capsys, monkeypatch, heads):
    monkeypatch.setattr(number_table, "BLOCK", 3)
    q = np.random.default_rng(0).uniform([-40, -140, -150, -300], [220, 140, 0, 300], (8, 4))
    q[3, 0] = 300.0
    said = q
    if heads.startswith("j4"):
        said = np.column_stack([np.zeros(8), q[:, 3], q[:, 2] / 1000, np.radians(q[:, 1]), q[:, 0]])
    lines = [",".join(map(repr, row)) for row in said.tolist()]
    (tmp_path / "q.csv").write_text("\n".join([heads, *lines]) + "\n")
    assert run("fk", "epson-ls3-401s", f"@{tmp_path / 'q.csv'}", "--csv", str(tmp_path / "T.csv")) == 0
    T, inside = poses(tmp_path / "T.csv")
    SI = q * [np.pi / 180, np.pi / 180, 1e-3, np.pi / 180]
    assert np.abs(T - ARM.fk(SI)).max() < 1e-12
    assert inside.tolist() == [1, 1, 1, 0, 1, 1, 1, 1]
    told = capsys.readouterr().err
    assert "8 joint vectors, 1 of them outside the limits; written" in told
    assert ("not used" in told) == heads.startswith("j4")


def test_what_fk_wrote_ik_reads_and_what_ik_wrote_fk_reads(tmp_path, capsys):
    arm = pieper.load("denso-vp6242")
    q = np.degrees(np.random.default_rng(1).uniform(*arm.limits.T, (5, 6)))
    (tmp_path / "q.csv").write_text("\n".join(",".join(map(repr, row)) for row in q.tolist()))
    assert run("fk", "denso-vp6242", f"@{tmp_path / 'q.csv'}", "--csv", str(tmp_path / "T.csv")) == 0
    assert run("ik", "denso-vp6242", f"@{tmp_path / 'T.csv'}", "--csv", str(tmp_path / "all.csv")) == 0
    assert run("fk", "denso-vp6242", f"@{tmp_path / 'all.csv'}", "--csv", str(tmp_path / "again.csv")) == 0
    which = np.loadtxt(tmp_path / "all.csv", delimiter=",", skiprows=1, usecols=0).astype(int) - 1
    assert set(which) == set(range(5))
    assert np.abs(poses(tmp_path / "again.csv")[0] - poses(tmp_path / "T.csv")[0][which]).max() < 1e-11
    capsys.readouterr()


@pytest.mark.parametrize(
    ("text", "words", "message"),
    [
        ("q1,q2,q4\n1,2,3\n", (), "no column q3; it has q1, q2, q4"),
        ("1,2,3\n", (), "has 4 joints (deg, deg, mm, deg), got 3 numbers a row"),
        ("q1,q2,q3,q4\n", (), "no joint vector beneath them"),
        ("", (), "holds no joint vector"),
        ("q1,q2,q3_deg,q4\n1,2,3,4\n", (), "the column q3 cannot be in deg; it may be in m or mm"),
        ("q1,q1,q2,q3,q4\n1,1,2,3,4\n", (), "the column q1 stands there twice"),
        ("1,2,3,4\n1,x,3,4\n", (), "line 2"),
        ("1,2,3,4\n", ("--frames",), "leave --frames out"),
        ("1,2,3,4\n", ("--json",), "leave --json out"),
    ],
)
def test_a_table_that_is_none_is_refused_with_its_line_or_column(tmp_path, capsys, text, words, message):
    (tmp_path / "q.csv").write_text(text)
    assert run("fk", "epson-ls3-401s", f"@{tmp_path / 'q.csv'}", "--csv", str(tmp_path / "T.csv"), *words) == 2
    said = " ".join(capsys.readouterr().err.split())
    assert message.replace("m or mm", "") in said.replace("mm or m", "m or mm").replace("m or mm", "")
    assert not (tmp_path / "T.csv").exists()


def test_csv_without_a_table_says_what_to_write(capsys):
    assert run("fk", "epson-ls3-401s", "0", "0", "0", "0", "--csv", "T.csv") == 2
    assert "pieper fk ARM @joints.csv --csv FILE" in capsys.readouterr().err
