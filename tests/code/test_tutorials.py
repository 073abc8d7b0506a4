"""The tutorials of maps, placement, calibration and export run and end with their pictures."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.mark.parametrize(
    ("name", "picture", "said"),
    [
        ("07_reach_map", "margin.png", "a tool 100 mm long gains"),
        ("08_base_placement", "placement.png", "of the grasps are reached from"),
        ("09_calibration", "calibration.png", "calibrated 8 solutions"),
        ("10_solver_to_take_away", "solutions.png", "8 solutions of one pose"),
    ],
)
def test_a_tutorial_runs_and_ends_with_a_picture(name, picture, said, tmp_path):
    # the working folder is the test's, so what the import path names must not depend on it
    path = os.pathsep.join(os.path.abspath(p) for p in sys.path if p)
    ran = subprocess.run(
        [sys.executable, EXAMPLES / f"{name}.py"],
        cwd=tmp_path,
        env=os.environ | {"PYTHONPATH": path},
        capture_output=True,
        text=True,
        check=False,
    )
    assert ran.returncode == 0, ran.stderr
    assert said in ran.stdout
    assert (tmp_path / picture).read_bytes()[:4] == b"\x89PNG"
