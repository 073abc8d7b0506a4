"""`pieper route`: verdict and status, files, JSON, and what cannot be asked."""

import json

import numpy as np

ENDS = ("--from", "900 -300 900 0 180 0", "--to", "900 300 900 0 180 0", "--points", "20")


def test_a_route_is_printed_and_written(run, tmp_path):
    csv, figure = tmp_path / "route.csv", tmp_path / "route.png"
    status, out, _ = run("route", "abb-irb2400", *ENDS, "--free", "--csv", csv, "--plot", figure)
    assert status == 0 and "Found: 20 points" in out and "turn, deg" in out
    assert figure.stat().st_size > 10_000
    head = csv.read_text().splitlines()[0].split(",")
    rows = np.loadtxt(csv, delimiter=",", skiprows=1)
    assert rows.shape == (20, len(head)) and "turn_deg" in head


def test_json_says_the_verdict_and_what_closes_the_way(run):
    status, out, _ = run("route", "abb-irb2400", *ENDS, "--free", "--json")
    found = json.loads(out)
    assert status == 0 and found["verdict"] == "FOUND" and len(found["q"]) == 20
    far = ("--from", "2500 -300 900 0 180 0", "--to", "2500 300 900 0 180 0", "--points", "5")
    status, out, _ = run("route", "abb-irb2400", *far, "--free", "--json")
    refused = json.loads(out)
    assert status == 1 and refused["verdict"] == "IMPOSSIBLE" and "out of reach" in refused["blocked"]["why"]


def test_poses_are_read_from_a_table(run, tmp_path):
    table = tmp_path / "seam.csv"
    table.write_text("x,y,z,roll,pitch,yaw\n" + "\n".join(f"900,{y},900,0,180,0" for y in range(-100, 101, 20)))
    status, out, _ = run("route", "abb-irb2400", "--poses", table, "--turn", "-30 30")
    assert status == 0 and "Found: 11 points" in out


def test_what_cannot_be_asked_is_said(run):
    assert run("route", "abb-irb2400", "--free")[0] == 2
    assert "--free or --turn" in run("route", "abb-irb2400", *ENDS, "--free", "--turn", "-1 1")[2]
    assert "lower end first" in run("route", "abb-irb2400", *ENDS, "--turn", "30 -30")[2]


def test_what_is_refused_is_told_as_it_was_typed(run):
    for words, told in (
        (("--free", "--cone", "95"), "less than 90 deg, got 95 deg"),
        (("--turn", "30 -30"), 'got "30 -30" deg; did you mean "-30 30"'),
        (("--turn", "30 500"), "goes over 470 deg"),
        (("--free", "--cone", "2", "--angle", "rad"), "less than 1.5708 rad, got 2 rad"),
        (("--start", "900 0 0 0 0 0"), "joint_1 at 900 deg, outside its limits of -180 to 180 deg"),
        (("--plot", "x.png"), "say --free"),
    ):
        status, _, err = run("route", "abb-irb2400", *(ENDS if "rad" not in words else ENDS[:0]), *words)
        assert status == 2 and told in err
