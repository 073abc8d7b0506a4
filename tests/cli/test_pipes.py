"""Pipes: tables that can be read once, rows that go into one, readers that stop, outputs that are full or closed."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import pieper
from tests.calibration.planted import planted, postures

pytestmark = pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="pipes and devices of POSIX")
TABLE = "x,y,z\n350,0,400\n"


def told(line: str, folder: Path) -> subprocess.CompletedProcess[str]:
    """Return what a line of bash came to, in which `pieper` is this one."""
    source = os.pathsep.join([str(Path(pieper.__file__).parents[1]), os.environ.get("PYTHONPATH", "")])
    (folder / "poses.csv").write_text(TABLE)
    line = f'set -o pipefail; pieper() {{ "{sys.executable}" -m pieper "$@"; }}; {line}'
    words, environment = ["bash", "-c", line], os.environ | {"PYTHONPATH": source}
    return subprocess.run(words, cwd=folder, env=environment, capture_output=True, text=True, timeout=120)


@pytest.mark.parametrize(
    "line",
    [
        "pieper ik denso-vp6242 @<(cat poses.csv)",
        "cat poses.csv | pieper ik denso-vp6242 @/dev/stdin",
        "mkfifo named; (cat poses.csv > named &); pieper ik denso-vp6242 @named",
        "(head -1 poses.csv; sleep 1; tail -1 poses.csv) | pieper ik denso-vp6242 @/dev/stdin",
        "pieper ik denso-vp6242 @poses.csv --csv >(cat)",
        "pieper ik denso-vp6242 @poses.csv --csv /dev/stdout | cat",
    ],
)
def test_a_pipe_gives_and_takes_what_a_file_does(line, tmp_path):
    as_file = told("pieper ik denso-vp6242 @poses.csv", tmp_path)
    got = told(line, tmp_path)
    assert got.returncode == 0 and as_file.stdout.startswith("pose,solution")
    assert got.stdout == as_file.stdout


def test_joints_come_through_a_pipe_too(tmp_path):
    got = told("pieper fk denso-vp6242 @<(echo 0 51 -150 0 99 0) --json", tmp_path)
    assert got.returncode == 0 and got.stdout == told("pieper fk denso-vp6242 0 51 -150 0 99 0 --json", tmp_path).stdout


def test_a_calibration_is_read_through_a_pipe_and_from_the_standard_input(tmp_path):
    arm, rng = pieper.load("denso-vp6242"), np.random.default_rng(3)
    q = postures(arm, rng, 60)
    rows = np.column_stack([np.degrees(q), 1e3 * planted(arm, rng).fk(q)[:, :3, 3]])
    head = ",".join([*(f"q{i}_deg" for i in range(1, 7)), "x_mm", "y_mm", "z_mm"])
    np.savetxt(tmp_path / "data.csv", rows, delimiter=",", header=head, comments="")
    said = [
        told(f"{line} --kind position", tmp_path)
        for line in (
            "pieper calibrate denso-vp6242 data.csv",
            "pieper calibrate denso-vp6242 <(cat data.csv)",
            "cat data.csv | pieper calibrate denso-vp6242 -",
        )
    ]
    assert [one.returncode for one in said] == [0, 0, 0] and len({one.stdout for one in said}) == 1


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no /dev/full")
@pytest.mark.parametrize("words", ["ik denso-vp6242 350 0 400", "ik denso-vp6242 @poses.csv", "show ur5e", "robots"])
def test_a_full_output_is_one_sentence(words, tmp_path):
    got = told(f"pieper {words} > /dev/full", tmp_path)
    assert got.returncode == 2 and "Traceback" not in got.stderr
    assert "cannot write: No space left on device. Free room there" in " ".join(got.stderr.split())


@pytest.mark.parametrize("line", ["ik denso-vp6242 350 0 400 >&-", "robots | head -1", "show ur5e | head -1"])
def test_a_closed_output_and_a_reader_that_stops_are_no_failure(line, tmp_path):
    got = told(f"pieper {line}", tmp_path)
    assert got.returncode == 0 and not got.stderr
