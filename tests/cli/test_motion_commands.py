"""`pieper time`, `program` and `animate`: what they print, what they write, what they refuse."""

import json

import numpy as np
import pytest

import pieper

LINE = ["denso-vp6242", "--from", "350 0 400", "--to", "300 80 420", "--start", "line-start"]
LIMITS = ["--speed", "180", "--acceleration", "600"]


def test_time_says_how_long_and_what_binds(run, tmp_path):
    figure, csv = tmp_path / "t.png", tmp_path / "t.csv"
    status, out, _ = run("time", *LINE, *LIMITS, "--figure", figure, "--csv", csv)
    assert status == 0 and "acceleration of joint_" in out and "largest value over its limit is" in out
    assert figure.exists()
    read = pieper.read_motion(csv, pieper.load("denso-vp6242"))
    _, out, _ = run("time", *LINE, *LIMITS, "--json")
    data = json.loads(out)
    assert data["margin"] <= 1 and data["duration_s"] == pytest.approx(read.duration, abs=1e-8)
    assert np.abs(read.q - np.array(data["q"])).max() < 1e-9


def test_limits_are_in_the_units_typed(run):
    words = ["--json", "--tool-speed"]
    _, degrees, _ = run("time", *LINE, *LIMITS, *words, "100")
    limits = ["--speed", "pi", "--acceleration", "10*pi/3"]
    ends = ["--from", "0.35 0 0.4", "--to", "0.3 0.08 0.42", "--start", "line-start"]
    _, radians, _ = run("time", LINE[0], *ends, *limits, *words, "0.1", "--angle", "rad", "--length", "m")
    assert json.loads(degrees)["duration_s"] == pytest.approx(json.loads(radians)["duration_s"], rel=1e-9)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (LINE, "say --speed and --acceleration"),
        ([*LINE, "--speed", "1 2", "--acceleration", "3"], "takes one number or 6"),
        ([*LINE, *LIMITS, "--constant", "0.1 0.2"], "s0, s1 and a speed"),
        ([LINE[0], *LIMITS], "needs --from and --to"),
        ([*LINE, *LIMITS[:2]], "say --acceleration too"),
        ([*LINE, *LIMITS[:2], "--acceleration", "-3"], "--acceleration must be more than zero, got -3"),
        ([*LINE, "--speed", "9 9 0 9 9 9", "--acceleration", "9"], "--speed of joint_3 must be more than zero, got 0;"),
        ([*LINE, *LIMITS, "--tool-speed", "0"], "--tool-speed must be more than zero, got 0; leave it out for none"),
        ([*LINE, *LIMITS, "--constant", "0.2 0.8 -5"], "must be more than zero, got -5 mm/s"),
        ([*LINE, *LIMITS, "--constant", "0.8 0.2 5"], "s = 0.8 to 0.2"),
        (
            [*LINE, *LIMITS, "--constant", "0 0.8 5000"],
            "keep 5000 mm/s from s = 0 to 0.8: the run-up to s = 0 allows 0",
        ),
    ],
)
def test_time_refuses(run, words, said):
    status, _, err = run("time", *words)
    assert status == 2 and said in err


def test_the_speed_that_would_do_is_told_as_it_is_typed_and_does(run):
    status, _, err = run("time", *LINE, *LIMITS, "--constant", "0.2 0.8 5000")
    assert status == 2 and "cannot keep 5000 mm/s" in err and " m/s" not in err
    most = float(err.split(" mm/s, the highest")[0].split()[-1])
    assert run("time", *LINE, *LIMITS, "--constant", f"0.2 0.8 {most * 0.9999}")[0] == 0
    assert run("time", *LINE, *LIMITS, "--constant", f"0.2 0.8 {most * 1.01}")[0] == 2


@pytest.mark.parametrize("words", [("program", "denso-vp6242", "no.toml"), ("program", "denso-vp6242", "no.src")])
def test_a_file_that_is_not_there_is_named_once(run, words):
    status, _, err = run(*words)
    assert status == 2 and err.count("no.") == 1 and "No such file" in err and "Errno" not in err


def test_a_line_that_stops_is_no_motion(run):
    status, out, _ = run("time", *LINE[:3], "--to", "900 0 400", *LINE[5:], *LIMITS)
    assert status == 1 and "Stop at s" in out


def test_a_program_is_told_written_and_animated(run, tmp_path):
    arm = pieper.load("denso-vp6242")
    start = arm.ik(pieper.pose(0.35, 0, 0.4)).nearest(np.zeros(6))
    program = pieper.Program(arm, pieper.Limits(speed=3.0, acceleration=9.0), start=start)
    program.move_l(pieper.pose(0.3, 0.08, 0.42), blend=0.01).move_l(pieper.pose(0.35, 0, 0.4)).gripper(1.0).wait(0.1)
    file = pieper.save_program(program, tmp_path / "p.toml")
    page, pac = tmp_path / "p.html", tmp_path / "weld.pcs"
    status, out, _ = run("program", arm.name, file, "--write", pac, "--animate", page)
    assert status == 0 and "2 moves of denso-vp6242" in out and "gripper" in out and page.exists()
    home = " ".join(str(v) for v in np.degrees(start))
    status, out, _ = run("program", arm.name, pac, "--start", home, *LIMITS, "--write", tmp_path / "again.csv")
    assert status == 0 and "2 moves" in out and "gripper" in out and "blend 10 mm" in out
    gif = tmp_path / "m.gif"
    assert run("animate", arm.name, tmp_path / "again.csv", gif, "--rate", "4", "--size", "320 240")[0] == 0
    assert gif.stat().st_size > 1000
    for words, said in (
        (("program", arm.name, pac), "holds no limits"),
        (("program", arm.name, file, *LIMITS), "holds its own limits"),
        (("program", arm.name, tmp_path / "no.toml"), "cannot read"),
        (("animate", arm.name, file, tmp_path / "m.avi"), "ends in .avi"),
        (("animate", arm.name, file, gif, "--size", "640"), "takes two numbers"),
    ):
        status, _, err = run(*words)
        assert status == 2 and said in err


PROGRAM = """arm = "denso-vp6242"
start = [0, 51.492738, -150.638208, 0, 99.14547, 0]
[limits]
speed = 180
acceleration = 600
tool_speed = 250
[[step]]
move_l = [350, 80, 400, 0, 0, 0]
speed = 100
blend = 10
[[step]]
wait = 0.3
[[step]]
move_j = [0, 51.492738, -150.638208, 0, 99.14547, 0]
"""


@pytest.mark.parametrize(
    ("was", "given", "said"),
    [
        ("blend = 10", "blend = -10", "step 1: blend must be a finite number of at least 0, a radius, mm, got -10"),
        ("speed = 100", "speed = 0", "step 1: speed must be a finite number above 0, mm/s, got 0"),
        ("speed = 180", "speed = [9, 9, 0, 9, 9, 9]", "speed of joint_3 must be more than zero, deg/s"),
        ("speed = 180", "", "[limits] has no speed: say one number for all joints or one a joint, deg/s"),
        ("acceleration = 600", "jerk = 600", "[limits] has no acceleration"),
        ("tool_speed = 250", "tool_speed = -1", "tool_speed must be a finite number above 0, mm/s"),
        ("start = [0,", "start = [400,", "joint_1 is at 400 deg, allowed is -160 to 160 deg"),
        ("move_j = [0,", "move_j = [200,", "step 3: target of move 2 is outside the limits: joint_1 is at 200 deg"),
    ],
)
def test_what_a_program_file_says_is_refused_in_its_own_units(run, tmp_path, was, given, said):
    file = tmp_path / "bad.toml"
    file.write_text(PROGRAM.replace(was, given, 1))
    status, _, err = run("program", "denso-vp6242", file)
    assert status == 2 and "bad.toml" in err and said in " ".join(err.split())


def test_a_motion_in_time_that_rests_is_read_back_as_moves(run, tmp_path):
    file, points = tmp_path / "p.toml", tmp_path / "p.csv"
    file.write_text(PROGRAM)
    assert run("program", "denso-vp6242", file, "--write", points)[0] == 0
    home = "0 51.492738 -150.638208 0 99.14547 0"
    status, out, _ = run("program", "denso-vp6242", points, "--start", home, *LIMITS)
    assert status == 0 and "the points are read, not their times" in " ".join(out.split())


def test_what_a_controllers_file_lacks_is_said_with_its_cure(run, tmp_path):
    file, script = tmp_path / "p.toml", tmp_path / "weld.pcs"
    file.write_text(PROGRAM)
    assert run("program", "denso-vp6242", file, "--write", script)[0] == 0
    # an arm whose zero has the wrist straight: no line leaves it
    arm, rapid = pieper.load("abb-irb2400"), tmp_path / "weld.mod"
    start = np.radians([-47, -25, 20, 9, -46, -7])
    line = pieper.Program(arm, pieper.Limits(speed=2.0, acceleration=6.0), start=start)
    line.move_l(arm.fk(start) @ pieper.pose(0, 0.05, 0.02)).write(rapid)
    status, _, err = run("program", arm.name, rapid, *LIMITS)
    assert status == 2 and "is --start zero right?" in " ".join(err.split())
    status, _, err = run("animate", "denso-vp6242", script, tmp_path / "m.html")
    assert status == 2 and "pieper program denso-vp6242" in " ".join(err.split()) and "--animate" in err
    status, _, err = run("program", "denso-vp6242", file, "--write", tmp_path / "a-b.pcs")
    assert status == 2 and "name the file so." in " ".join(err.split()) and "name=" not in err


def test_clear_reads_a_table_of_joints_by_their_names_or_in_order(run, tmp_path):
    table = tmp_path / "p.csv"
    rows = "0,0,-150,0,0,0\n10,0,-150,0,0,0\n"
    said = []
    for head in ("joint_1,joint_2,joint_3,joint_4,joint_5,joint_6", "q1,q2,q3,q4,q5,q6", ""):
        table.write_text(f"{head}\n{rows}" if head else rows)
        status, out, _ = run("clear", "denso-vp6242", "--path", table)
        assert status in (0, 1)
        said.append(out)
    assert said[0] == said[1] == said[2]
    table.write_text("joint_1,joint_2,joint_3,joint_4,joint_5,joint_6\n0,x,0,0,0,0\n")
    status, _, err = run("clear", "denso-vp6242", "--path", table)
    assert status == 2 and "line 2" in err and "'x' is not a number" in err
