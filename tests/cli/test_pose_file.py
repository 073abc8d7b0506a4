"""Files of poses on the command line: columns in any order and unit, messages that name the line, constant memory."""

from __future__ import annotations

import csv
import json

import numpy as np
import pytest

import pieper
from pieper.cli import main, number_table
from pieper.cli.pose_file import PoseFile, is_table
from pieper.cli.units import Units

ARM = pieper.load("denso-vp6242")


@pytest.fixture
def written(tmp_path):
    def write(text: str, name: str = "poses.csv"):
        (tmp_path / name).write_text(text, encoding="utf-8")
        return tmp_path / name

    return write


def poses_of(file) -> np.ndarray:
    return np.concatenate(list(PoseFile(str(file), Units()).blocks()))


def test_solutions_are_those_of_the_library_with_the_unit_in_every_name(run, written, tmp_path):
    T = ARM.fk(np.random.default_rng(1).uniform(-2, 2, (30, 6)))
    lines = [",".join(repr(v * (1e3 if i % 4 == 3 else 1)) for i, v in enumerate(p[:3].ravel().tolist())) for p in T]
    status, _, err = run("ik", ARM.name, f"@{written(chr(10).join(lines))}", "--all", "--csv", tmp_path / "out.csv")
    assert "30 poses" in err
    many = ARM.ik_many(T)
    assert status == int(not many.in_limits.any(1).all())
    with (tmp_path / "out.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert [row for row in rows[0] if row.startswith("joint_3")] == ["joint_3_deg"]
    assert len(rows) == int(many.valid.sum())
    got = np.radians([[float(row[f"joint_{j}_deg"]) for j in range(1, 7)] for row in rows])
    assert np.allclose(got, many.q[many.valid], atol=1e-13)
    assert [int(row["pose"]) for row in rows] == (np.nonzero(many.valid)[0] + 1).tolist()


def test_columns_are_taken_by_name_in_any_order_and_unit(written):
    expected = pieper.pose(0.35, 0.01, 0.4, rpy=(0.1, np.pi / 2 - 1, 0.3))
    a, b, c = 0.3, np.pi / 2 - 1, 0.1
    for text in (
        f"yaw_rad,id,z_m,x_mm,y_mm,roll_deg,pitch\n0.3,7,0.4,350,10,{float(np.degrees(0.1))!r},{float(np.degrees(b))!r}\n",
        f'"x [mm]";"y, mm";z_mm;A_rad;B_rad;C_rad\n350;10;400;{a!r};{b!r};{c!r}\n',
        "x y z r11 r12 r13 r21 r22 r23 r31 r32 r33\n350 10 400 "
        + " ".join(repr(v) for v in expected[:3, :3].ravel().tolist()),
    ):
        assert np.allclose(poses_of(written(text)), [expected], atol=1e-12)


def test_a_file_of_positions_for_a_scara_is_of_positions_and_says_so(run, written):
    file = written("x_mm,y_mm,z_mm\n480,310,337\n435,341,287\n")
    status, out, err = run("ik", "adept-cobra-600", f"@{file}")
    assert status == 0
    assert "taken as positions" in err and out.count("\n") >= 3


def test_poses_without_a_solution_keep_their_place_with_their_status(run, written):
    file = written("350,0,400\n900,0,400\n350,0,400\n")
    status, out, _ = run("ik", ARM.name, f"@{file}", "--near", "home")
    rows = out.splitlines()
    assert status == 1
    assert [row.split(",")[0] for row in rows[1:]] == ["1", "2", "3"]
    assert rows[2].startswith("2,0,OUT_OF_REACH,,")
    _, out, _ = run("ik", ARM.name, f"@{file}", "--json")
    data = [json.loads(line) for line in out.splitlines()]
    assert [d["status"] for d in data] == ["SOLVED", "OUT_OF_REACH", "SOLVED"]
    assert np.allclose(ARM.fk(data[0]["q"][0])[:3, 3], [0.35, 0, 0.4])


def test_a_matrix_in_a_csv_is_still_one_pose(run, written):
    status, out, _ = run("ik", ARM.name, f"@{written('0 0 1 350' + chr(10) + '0 1 0 0' + chr(10) + '-1 0 0 400')}")
    assert status == 0 and "position 350.000, 0.000, 400.000 mm" in out


@pytest.mark.parametrize(
    ("text", "nouns"),
    [
        ("", ["no pose"]),
        ("x_mm,y_mm,z_mm\n", ["no pose"]),
        ("x_mm,y_mm\n1,2\n", ["column z"]),
        ("x_mm,x_m,y,z\n1,1,2,3\n", ["column x", "twice"]),
        ("x_deg,y,z\n1,2,3\n", ["column x", "deg", "mm or m"]),
        ("x,y,z,qw,qx\n1,2,3,1,0\n", ["qw", "qy, qz"]),
        ("x,y,z,qw,qx,qy,qz\n350,0,400,1,0,0,0\n350,0,400,2,0,0,0\n", ["line 3", "length"]),
        ("350;0;400\n350;zero;400\n", ["line 2", "zero"]),
        ("350,0,400\n350,0\n", ["line 2", "2 cells"]),
        ("350,0,400\n350,nan,0\n", ["line 2", "finite"]),
        ("350,0,400,1\n", ["4 numbers"]),
        ("1,0,0,350,0,2,0,0,0,0,1,400\n", ["line 1", "rotation"]),
    ],
)
def test_what_is_wrong_with_a_file_is_said_with_its_line(run, written, tmp_path, text, nouns):
    status, out, err = run("ik", ARM.name, f"@{written(text)}", "--csv", tmp_path / "out.csv")
    assert status == 2 and "Traceback" not in err and out == ""
    for noun in nouns:
        assert noun in err
    assert not (tmp_path / "out.csv").exists()


def test_a_file_is_read_block_by_block(written, monkeypatch):
    monkeypatch.setattr(number_table, "BLOCK", 7)
    file = written("x_mm,y_mm,z_mm\n" + "350,0,400\n" * 20)
    told = []
    sizes = [len(block) for block in PoseFile(str(file), Units()).blocks(told.append)]
    assert sizes == [7, 7, 6]
    assert sum(told) == file.stat().st_size


@pytest.mark.parametrize(
    "text", ["z [m];y [m];x [m]\n0,4;0;0,35\n", "z_m\ty_m\tx_m\n0,4\t0\t0,35\n", "x;y;z\n350;0;400\n"]
)
def test_tables_of_spreadsheets_with_semicolons_and_decimal_commas_are_read(tmp_path, text):
    (tmp_path / "p.csv").write_text(text)
    poses = np.concatenate(list(PoseFile(str(tmp_path / "p.csv"), Units("mm", "deg")).blocks()))
    assert np.allclose(poses[:, :3, 3], [[0.35, 0.0, 0.4]])


@pytest.mark.parametrize(
    ("lines", "table"),
    [
        ("400 100 300 180 0 0\n300 200 300 180 0 0\n", True),
        ("300 100 300\n300 200 300\n300 0 300\n300 0 310\n", True),
        ("x_mm,y_mm,z_mm\n300,100,300\n", True),
        ("300 100 300\n", False),
        ("300 100 300\n0 90 0\n", False),
        ("300\n100\n300\n", False),
        ("1 0 0 300\n0 1 0 100\n0 0 1 300\n", False),
        ("# a pose\n1 0 0 300\n0 1 0 100\n0 0 1 300\n0 0 0 1\n", False),
    ],
)
def test_the_lines_of_a_file_of_any_name_say_whether_they_are_poses(tmp_path, lines, table):
    (tmp_path / "p.txt").write_text(lines)
    assert is_table(f"@{tmp_path / 'p.txt'}") == table
    assert is_table("300") is False


def test_the_answer_is_not_written_over_the_poses(tmp_path, capsys):
    (tmp_path / "a.csv").write_text("350,0,400\n")
    with pytest.raises(SystemExit) as left:
        main(["ik", "denso-vp6242", f"@{tmp_path / 'a.csv'}", "--csv", str(tmp_path / "." / "a.csv")])
    assert left.value.code == 2 and "write over the table it reads" in capsys.readouterr().err
    assert (tmp_path / "a.csv").read_text() == "350,0,400\n"
