"""Each of the four users' scripts runs, and a type checker in its strict mode has nothing to say."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import pieper

HERE = Path(__file__).parent
SCRIPTS = ("student", "lab_engineer", "researcher", "integrator")


@pytest.mark.parametrize("name", SCRIPTS)
def test_the_script_of_a_user_runs(name, tmp_path):
    source = str(Path(pieper.__file__).parents[1])
    environment = os.environ | {"PYTHONPATH": source, "PYTHONWARNINGS": "error"}
    done = subprocess.run(
        [sys.executable, str(HERE / f"{name}.py"), str(tmp_path)],
        capture_output=True,
        text=True,
        env=environment,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("pyright") is None, reason="pyright is not installed")
def test_pyright_in_strict_mode_has_nothing_to_say():
    done = subprocess.run(
        ["pyright", "--outputjson", "-p", str(HERE / "pyrightconfig.json")], capture_output=True, text=True, check=False
    )
    told = json.loads(done.stdout)
    assert told["summary"]["filesAnalyzed"] >= len(SCRIPTS)
    assert not [d["message"] for d in told["generalDiagnostics"] if Path(d["file"]).stem in SCRIPTS]


def test_a_motion_is_columns_with_their_units():
    arm = pieper.load("stanford-arm")
    program = pieper.Program(
        arm, pieper.Limits(speed=[1.0] * 6, acceleration=[4.0] * 6), start=[0.1, 0.2, 0.5, 0.1, 0.2, 0.3]
    )
    program.move_j([0.2, 0.1, 0.4, 0.3, 0.2, 0.1])
    motion = program.motion()
    columns = motion.columns(degrees=True, mm=True)
    names = list(columns)
    assert names[0] == "t_s" and f"{arm.joint_names[2]}_mm" in names and f"{arm.joint_names[0]}_deg" in names
    assert f"dq_{arm.joint_names[0]}_deg_per_s" in names and f"ddq_{arm.joint_names[2]}_mm_per_s2" in names
    assert all(len(column) == len(motion.t) for column in columns.values())
    assert columns[f"{arm.joint_names[2]}_mm"][-1] == pytest.approx(400.0)
