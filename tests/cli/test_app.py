"""The command line: exit statuses, units, JSON, readable errors."""

import json
import math
import subprocess
import sys

import numpy as np
import pytest

import pieper
from pieper.cli import main
from pieper.cli.stopping import Stopped

ARM = pieper.load("denso-vp6242")


def test_robots_lists_the_catalogue(run):
    status, out, _ = run("robots", "--json")
    assert status == 0
    assert {arm["name"] for arm in json.loads(out)} == set(pieper.catalog())


def test_show_prints_the_table_with_units(run):
    status, out, _ = run("show", "denso-vp6242")
    assert status == 0
    for text in ("a, mm", "alpha, deg", "210.000", "-75.000", "spherical wrist", "Source"):
        assert text in out


def test_fk_reads_degrees_and_prints_millimetres(run):
    status, out, _ = run("fk", "denso-vp6242", 0, 51.492738, -150.638208, 0, 99.145470, 0)
    assert status == 0
    assert "350.000, 0.000, 400.000 mm" in out


def test_fk_takes_negative_numbers_radians_expressions_and_postures(run):
    _, out, _ = run("fk", "denso-vp6242", "-pi/2", -1, "-3", 0, 0.5, 0, "--angle", "rad", "--json")
    expected = ARM.fk([-math.pi / 2, -1, -3, 0, 0.5, 0])
    assert np.allclose(json.loads(out)["T"], expected, atol=1e-15)
    _, out, _ = run("fk", "denso-vp6242", "home", "--json")
    assert np.allclose(json.loads(out)["T"], ARM.fk(ARM.description.postures["home"]))


def test_ik_takes_a_spare_joint_by_value_or_by_name_and_an_arm_angle_in_degrees(run):
    arm = pieper.load("kuka-lbr-iiwa-14-r820")
    T = arm.fk(np.full(7, 0.4))
    pose = [float(v) * (1000 if i % 4 == 3 else 1) for i, v in enumerate(T[:3].ravel())]
    _, out, _ = run("ik", arm.name, *pose, "--redundancy", "20", "--all", "--json")
    by_value = [row["q"] for row in json.loads(out)["solutions"]]
    assert np.allclose(by_value, arm.ik(T, redundancy=np.radians(20)).all_q, atol=1e-9)
    _, out, _ = run("ik", arm.name, *pose, "--redundancy", "joint_1=20", "--all", "--json")
    assert np.allclose([row["q"] for row in json.loads(out)["solutions"]], by_value, atol=1e-12)
    _, out, _ = run("ik", arm.name, *pose, "--redundancy", "arm angle=20", "--all", "--json")
    rows = np.array([row["q"] for row in json.loads(out)["solutions"]])
    assert len(rows) == 8 and np.allclose(arm.arm_angle(rows)[0], np.radians(20), atol=1e-9)
    status, _, said = run("ik", arm.name, *pose, "--redundancy", "elbow=20")
    assert status == 2 and "arm angle" in said


def test_ik_prints_every_solution_with_label_limit_and_residual(run):
    status, out, _ = run("ik", "denso-vp6242", 350, 0, 400, "--all")
    assert status == 0
    for text in ("51.493", "-150.638", "front, elbow up", "joint_3 outside", "mm", "deg"):
        assert text in out


def test_ik_as_json_is_in_radians_and_closes_under_fk(run):
    _, out, _ = run("ik", "denso-vp6242", 350, 0, 400, "--all", "--json")
    data = json.loads(out)
    assert len(data["solutions"]) == 8
    for solution in data["solutions"]:
        assert np.allclose(ARM.fk(solution["q"])[:3, 3], [0.35, 0, 0.4], atol=1e-12)


@pytest.mark.parametrize(
    "words",
    [
        ["350,0,400,0,90,0"],
        ["350 0 400", "0", "90", "0"],
        ["0.35", "0", "0.4", "0", "pi/2", "0", "--length", "m", "--angle", "rad"],
        ["350", "0", "400", "90", "90", "90", "--order", "zyx"],
        ["350", "0", "400", "90", "90", "90", "--order", "abc"],
        ["350", "0", "400", "sqrt(2)/2", "0", "sqrt(2)/2", "0", "--order", "quaternion_wxyz"],
        ["0 0 1 350  0 1 0 0  -1 0 0 400"],
        ["0 0 1 350  0 1 0 0  -1 0 0 400  0 0 0 1"],
    ],
)
def test_a_pose_may_be_written_in_many_ways(run, words):
    status, out, _ = run("ik", "denso-vp6242", *words, "--json")
    expected = np.array([[0, 0, 1, 0.35], [0, 1, 0, 0], [-1, 0, 0, 0.4], [0, 0, 0, 1]])
    assert status == 0
    assert np.allclose(json.loads(out)["T"], expected, atol=1e-12)


def test_numbers_may_come_from_a_file(run, tmp_path):
    file = tmp_path / "pose.txt"
    file.write_text("350, 0, 400  # mm\n0 90 0\n")
    _, out, _ = run("ik", "denso-vp6242", f"@{file}", "--json")
    assert np.allclose(np.array(json.loads(out)["T"])[:3, 2], [1, 0, 0], atol=1e-12)


def test_a_pose_out_of_reach_is_status_one_with_the_distance(run):
    status, out, _ = run("ik", "denso-vp6242", 900, 0, 400)
    assert status == 1
    assert "OUT_OF_REACH" in out
    # position first: sqrt(900^2 + 275^2) mm from the shoulder, of which links laid end to end reach 503 mm
    assert "438.1 mm" in out


def test_path_reaches_the_end_and_writes_its_csv(run, tmp_path):
    file = tmp_path / "line.csv"
    status, out, _ = run(
        "path", "denso-vp6242", "--from", "350 0 400", "--to", "200 100 500", "--start", "line-start", "--csv", file
    )
    assert status == 0
    assert "50 of 50 points reached" in out
    rows = file.read_text().splitlines()
    assert len(rows) == 51
    assert rows[0].startswith("point,s,joint_1_deg") and ",x_mm,y_mm,z_mm,r11," in rows[0]
    q = [float(v) for v in rows[1].split(",")[2:8]]
    assert q == pytest.approx([0, 51.492738, -150.638208, 0, 99.14547, 0], abs=1e-6)
    status, _, _ = run("ik", "denso-vp6242", f"@{file}", "--csv", tmp_path / "back.csv")
    assert status == 0


def test_a_path_that_stops_is_status_one_and_says_where(run):
    status, out, _ = run("path", "denso-vp6242", "--from", "350 0 400", "--to", "700 0 400", "--start", "line-start")
    assert status == 1
    assert "out of reach" in out
    assert "s = 0." in out


@pytest.mark.parametrize(
    ("words", "nouns"),
    [
        (["ik", "nowhere-robot", "1", "2", "3"], ["nowhere-robot", "catalogue"]),
        (["ik", "denso-vp6242", "1", "2"], ["pose", "2 numbers"]),
        (["ik", "denso-vp6242", "1", "two", "3"], ["two", "not a number"]),
        (["ik", "denso-vp6242", "nan", "0", "3"], ["nan", "finite"]),
        (["ik", "denso-vp6242", "350 0 400 1 1 1", "--order", "xyz"], ["xyz", "rpy"]),
        (["ik", "denso-vp6242", "1 0 0 350 0 2 0 0 0 0 1 400"], ["rotation"]),
        (["ik", "denso-vp6242", "@/no/such/file"], ["/no/such/file"]),
        (["fk", "denso-vp6242", "1", "2", "3"], ["6 joints", "3 numbers"]),
        (["fk", "denso-vp6242", "nowhere"], ["posture", "home"]),
        (["path", "denso-vp6242", "--from", "350 0 400"], ["--to"]),
        (["path", "denso-vp6242", "--from", "350 0 400", "--to", "1 2 3", "-n", "1"], ["at least 2"]),
        (["report", "denso-vp6242", "--from", "350 0 400"], ["--to"]),
        (["check", "/no/such/claims.toml"], ["/no/such/claims.toml"]),
        (["show"], ["ARM"]),
        (["fly"], ["fly"]),
        (["shwo", "denso-vp6242"], ["shwo", "Did you mean show?"]),
        (["ik", "ur5e", "400", "100", "300", "--rotvec", "3", "0", "0"], ["no option --rotvec", "--order rotvec"]),
        (["ik", "ur5e", "400", "100", "300", "--tsk=position"], ["no option --tsk", "Did you mean --task?"]),
        (["fk", "ur5e", "zero", "--frobnicate"], ["no option --frobnicate", "--frames"]),
        (["show", "fanuc"], ["fanuc-cr-7ia", "say which"]),
        (["ik", "denso-vp6242", "1 2 3", "--angle", "turns"], ["turns"]),
    ],
)
def test_misuse_is_status_two_and_one_readable_sentence(run, words, nouns):
    status, out, err = run(*words)
    assert status == 2
    assert out == ""
    assert err.startswith("pieper: ")
    assert "Traceback" not in err
    for noun in nouns:
        assert noun in err


def test_a_unique_part_of_a_name_is_enough(run):
    for part, name in (("panda", "franka-panda"), ("ur5e", "universal-robots-ur5e"), ("UR5", "universal-robots-ur5")):
        _, out, _ = run("show", part, "--json")
        assert json.loads(out)["name"] == name


def test_x_y_z_of_an_arm_that_cannot_hold_r_i_is_a_position_and_says_so(run):
    status, out, _ = run("ik", "adept-cobra-600", 480, 310, 337)
    assert status == 0
    assert "taken as a position" in out and "roll, pitch, yaw" not in out
    _, out, _ = run("ik", "adept-cobra-600", 480, 310, 337, "--json")
    data = json.loads(out)
    assert data["task"] == "position" and "R = I" in data["note"]
    arm = pieper.load("adept-cobra-600")
    assert np.allclose([arm.fk(s["q"])[:3, 3] for s in data["solutions"]], [0.48, 0.31, 0.337], atol=1e-9)
    status, out, _ = run("ik", "adept-cobra-600", 480, 310, 337, 0, 0, 0)
    assert status == 1 and "taken as a position" not in out
    line = ["--from", "480 310 337", "--to", "470 310 337", "-n", 4, "--start", "17 34 50 0"]
    status, out, _ = run("path", arm.name, *line)
    assert status == 0 and "taken as positions" in out
    _, out, _ = run("ik", "denso-vp6242", 350, 0, 400)
    assert "taken as a position" not in out


def test_the_nearest_row_is_marked_and_named_with_its_turns(run):
    _, out, _ = run("ik", "universal-robots-ur5e", 400, 200, 300, 180, 0, 0, "--near", "0 -90 90 -90 -90 0")
    marked = [line for line in out.splitlines() if line.split()[1:2] == ["*"]]
    assert len(marked) == 1
    row = marked[0].split()[0]
    assert f"nearest to 0 -90 90 -90 -90 0: solution {row}, at " in out
    _, data, _ = run("ik", "universal-robots-ur5e", 400, 200, 300, 180, 0, 0, "--near", "0 -90 90 -90 -90 0", "--json")
    nearest, rows = json.loads(data)["nearest"], json.loads(data)["solutions"]
    turns = (np.array(rows[int(row) - 1]["q"]) - nearest) / (2 * np.pi)
    assert np.allclose(turns, np.round(turns), atol=1e-9)


def test_ik_writes_the_solutions_of_one_pose_as_csv(run, tmp_path):
    run("ik", "denso-vp6242", 350, 0, 400, "--all", "--csv", tmp_path / "rows.csv")
    lines = (tmp_path / "rows.csv").read_text().splitlines()
    assert len(lines) == 9
    assert lines[0].split(",")[3] == "joint_1_deg" and lines[0].endswith("in_limits,residual_mm,residual_deg")
    assert "-0.0" not in [cell for line in lines[1:] for cell in line.split(",")[3:9]]


def test_metres_given_as_millimetres_and_degrees_as_radians_are_remarked_upon(run):
    _, _, err = run("ik", "denso-vp6242", 0.35, 0, 0.4)
    assert "metres" in err
    _, _, err = run("fk", "denso-vp6242", 0, 51, -150, 0, 99, 0, "--angle", "rad")
    assert "degrees" in err


def test_figures_go_into_a_folder_and_an_unwritable_one_is_said(run, tmp_path):
    words = ["path", "denso-vp6242", "--from", "350 0 400", "--to", "340 0 400", "-n", 3, "--start", "line-start"]
    status, _, _ = run(*words, "--figures", tmp_path / "figures")
    assert status == 0
    assert {p.suffix for p in (tmp_path / "figures").iterdir()} == {".png", ".svg"}
    blocked = tmp_path / "file"
    blocked.write_text("")
    status, _, err = run(*words, "--figures", blocked / "figures")
    assert status == 2
    assert "folder" in err


def test_the_judge_answers_with_its_status(run, tmp_path):
    claims = tmp_path / "claims.toml"
    pytest.importorskip("sympy")
    from pieper.cli.denso_equations import claims as printed

    claims.write_text(printed())
    status, out, _ = run("check", claims, "--brief")
    assert status == 1
    assert "Px" in out


@pytest.mark.parametrize("command", ["robots", "show", "fk", "ik", "path", "report", "check", "workbench", "tour"])
def test_every_command_has_help(run, command):
    status, out, _ = run(command, "--help")
    assert status == 0
    assert f"pieper {command}" in out


def test_nothing_heavy_is_loaded_for_a_solution():
    code = (
        "import sys; from pieper.cli import main\n"
        "try: main(['ik', 'denso-vp6242', '350', '0', '400'])\n"
        "except SystemExit: pass\n"
        "heavy = {'matplotlib', 'sympy', 'scipy', 'starlette', 'uvicorn', 'mpmath'} & set(sys.modules)\n"
        "sys.exit(', '.join(sorted(heavy)) or 0)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def test_rows_outside_the_limits_alone_are_no_solution_self_motions_or_not(run):
    status, out, _ = run("ik", "adept-cobra", "400", "100", "300")
    assert "OUTSIDE_LIMITS" in out and "self-motions" in out
    assert status == 1


@pytest.mark.parametrize(
    ("said", "typed"),
    [
        (
            "Begin after it with base='c', or end before it with tip='left tool'.",
            "--base c, or end before it with --tip",
        ),
        ("load it with missing_limits='unlimited'", "--missing-limits unlimited"),
        ("say which by tip=: tip='a' (joints x)", "by --tip: --tip a (joints x)"),
    ],
)
def test_sentences_of_the_library_name_options_as_they_are_typed(said, typed):
    from pieper.cli.failure import as_typed

    assert typed in as_typed(said)
    assert "='" not in as_typed(said)


def test_a_far_pose_typed_in_millimetres_is_not_asked_whether_it_was_in_millimetres(run):
    _, _, said = run("ik", "denso-vp6242", 350000, 0, 400)
    said = " ".join(said.split())
    assert "350 m away" in said and "--length" in said and "pieper.pose" not in said and "millimetres" not in said


@pytest.mark.parametrize("stop", [KeyboardInterrupt, Stopped])
def test_the_way_to_leave_the_workbench_is_no_interruption(run, monkeypatch, stop):
    def serve(**_):
        raise stop

    monkeypatch.setattr("pieper.workbench.serve", serve)
    status, _, said = run("workbench", "--no-browser")
    assert (status, said) == (0, "")


def test_the_tour_breaks_its_sentences_to_the_terminal(monkeypatch, tmp_path, capsys):
    monkeypatch.setattr("pieper.cli.output.terminal_width", lambda: 30)

    def study(out, say):
        say("  tool up (+z), R = I: 50 of 50 points have a solution")
        return out / "index.html", True

    monkeypatch.setattr("pieper.cli.denso_study.run", study)
    with pytest.raises(SystemExit):
        main(["tour", "-o", str(tmp_path)])
    said = capsys.readouterr().out
    assert "  tool up (+z), R = I: 50 of\n  50 points have a solution\n" in said
    assert str(tmp_path / "index.html") in said
