"""Long tables that are stopped: no half file, a sentence that says how far, and the same bytes when it goes on."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import pieper
from pieper.cli import kept_rows, number_table

ARM = pieper.load("denso-vp6242")
BLOCK = 4


@pytest.fixture
def poses(tmp_path, monkeypatch):
    """Return a table of eighteen poses with a comment and an empty line, two of them out of reach."""
    monkeypatch.setattr(number_table, "BLOCK", BLOCK)
    T = ARM.fk(np.random.default_rng(4).uniform(-1.5, 1.5, (18, 6)))
    T[[5, 9], :3, 3] += 2
    lines = [",".join(repr(v * (1e3 if i % 4 == 3 else 1)) for i, v in enumerate(p[:3].ravel().tolist())) for p in T]
    file = tmp_path / "poses.csv"
    file.write_text("\n".join([*lines[:7], "# half of them", "", *lines[7:], "", ""]))
    return file


@pytest.fixture
def joints(tmp_path, monkeypatch):
    """Return a table of eighteen joint vectors with names."""
    monkeypatch.setattr(number_table, "BLOCK", BLOCK)
    q = np.degrees(np.random.default_rng(4).uniform(-3, 3, (18, 6)))
    file = tmp_path / "joints.csv"
    file.write_text("\n".join(["q1,q2,q3,q4,q5,q6", *(",".join(map(repr, row)) for row in q.tolist())]))
    return file


def stop_at(monkeypatch, verb: str, call: int, stop: type[BaseException] = KeyboardInterrupt):
    """Let an arm's verb be stopped at its call-th call."""
    real, calls = getattr(pieper.Arm, verb), []

    def stopping(self, *args, **kwargs):
        calls.append(1)
        if len(calls) == call:
            raise stop
        return real(self, *args, **kwargs)

    monkeypatch.setattr(pieper.Arm, verb, stopping)


@pytest.mark.parametrize(
    ("verb", "options"),
    [
        ("ik_many", ()),
        ("ik_many", ("--all",)),
        ("ik_many", ("--near", "home")),
        ("ik_many", ("--length", "m")),
        ("fk", ()),
        ("fk", ("--length", "m")),
    ],
)
def test_a_run_stopped_anywhere_goes_on_to_the_same_bytes(run, poses, joints, tmp_path, verb, options):
    table = poses if verb == "ik_many" else joints
    words = ("ik" if verb == "ik_many" else "fk", ARM.name, f"@{table}", "--csv")
    whole, out = tmp_path / "whole.csv", tmp_path / "out.csv"
    status, _, summary = run(*words, whole, *options)
    for call in range(1, 6):
        with pytest.MonkeyPatch.context() as patch:
            stop_at(patch, verb, call)
            stopped, _, said = run(*words, out, *options)
        assert stopped == 130
        assert not out.exists()
        if call == 1:
            assert "nothing was written" in said
            assert not (tmp_path / "out.csv.part").exists()
        else:
            assert f"stopped after {(call - 1) * BLOCK} " in said and f"{out}.part keeps" in said
        again, _, told = run(*words, out, *options)
        assert again == status
        assert ("goes on after" in told) == (call > 1)
        assert told.splitlines()[-1] == summary.splitlines()[-1].replace("whole.csv", "out.csv")
        assert out.read_bytes() == whole.read_bytes()
        assert sorted(p.name for p in tmp_path.glob("*out*")) == ["out.csv"]
        out.unlink()


def test_lines_of_a_block_that_was_not_finished_are_written_again(run, poses, tmp_path, monkeypatch):
    run("ik", ARM.name, f"@{poses}", "--csv", tmp_path / "whole.csv")
    real, calls = kept_rows.KeptRows.keep, []

    def keep(self, place, **more):
        calls.append(1)
        if len(calls) == 3:  # the block is written, and not yet remembered
            raise KeyboardInterrupt
        real(self, place, **more)

    monkeypatch.setattr(kept_rows.KeptRows, "keep", keep)
    _, _, said = run("ik", ARM.name, f"@{poses}", "--csv", tmp_path / "out.csv")
    assert "stopped after 8 poses" in said
    run("ik", ARM.name, f"@{poses}", "--csv", tmp_path / "out.csv")
    assert (tmp_path / "out.csv").read_bytes() == (tmp_path / "whole.csv").read_bytes()


def test_a_run_that_is_asked_otherwise_does_not_go_on(run, poses, joints, tmp_path, monkeypatch):
    out = tmp_path / "out.csv"
    words = ("ik", ARM.name, f"@{poses}", "--csv", out)
    with monkeypatch.context() as patch:
        stop_at(patch, "ik_many", 3)
        run(*words)
    for other, what in (
        ((*words, "--all"), "--all"),
        ((*words, "--near", "home"), "--near"),
        ((*words, "--angle", "rad"), "unit"),
        ((*words, "--task", "position"), "--task"),
        (("ik", "ur5e", f"@{poses}", "--csv", out), "arm"),
        (("fk", ARM.name, f"@{joints}", "--csv", out), "command"),
    ):
        status, _, said = run(*other)
        said = " ".join(said.split())
        assert status == 2
        assert f"another {what}" in said and "remove it to begin anew" in said, said
        assert not out.exists()
    # an arm of the same name with another limit is another arm
    changed = tmp_path / "changed.toml"
    ARM.with_limits({"joint_1": (-1.0, 1.0)}).save(changed)
    status, _, said = run("ik", changed, f"@{poses}", "--csv", out)
    assert status == 2 and "another arm" in " ".join(said.split())
    status, _, said = run(*words)
    assert out.exists() and "goes on after 8 poses" in said


def test_a_table_that_was_changed_above_is_refused_and_below_is_read(run, poses, tmp_path, monkeypatch):
    out, lines = tmp_path / "out.csv", poses.read_text().splitlines()
    with monkeypatch.context() as patch:
        stop_at(patch, "ik_many", 3)
        run("ik", ARM.name, f"@{poses}", "--csv", out)
    for other in (["0" + lines[0], *lines[1:]], lines[1:], lines[:3], [lines[0] + " ", *lines[1:]]):
        poses.write_text("\n".join(other))
        status, _, said = run("ik", ARM.name, f"@{poses}", "--csv", out)
        assert status == 2
        assert "is not what the stopped run read" in " ".join(said.split())
        assert not out.exists()
    lines[-2] = lines[2]
    poses.write_text("\n".join(lines))
    run("ik", ARM.name, f"@{poses}", "--csv", out)
    run("ik", ARM.name, f"@{poses}", "--csv", tmp_path / "whole.csv")
    assert out.read_bytes() == (tmp_path / "whole.csv").read_bytes()


def test_a_line_that_cannot_be_read_keeps_what_was_done_before_it(run, poses, tmp_path):
    out, lines = tmp_path / "out.csv", poses.read_text().splitlines()
    poses.write_text("\n".join([*lines[:12], "1,2,three", *lines[12:]]))
    status, _, said = run("ik", ARM.name, f"@{poses}", "--csv", out)
    assert status == 2 and not out.exists()
    assert "line 13" in said and "Stopped after 8 poses" in " ".join(said.split())
    poses.write_text("\n".join(lines))
    _, _, said = run("ik", ARM.name, f"@{poses}", "--csv", out)
    run("ik", ARM.name, f"@{poses}", "--csv", tmp_path / "whole.csv")
    assert "goes on after 8 poses" in said
    assert out.read_bytes() == (tmp_path / "whole.csv").read_bytes()


def test_what_is_not_ours_is_left_alone(run, poses, tmp_path):
    mine = tmp_path / "out.csv.part"
    mine.mkdir()
    (mine / "notes.txt").write_text("mine")
    status, _, said = run("ik", ARM.name, f"@{poses}", "--csv", tmp_path / "out.csv")
    assert status == 2 and "something else" in " ".join(said.split())
    assert (mine / "notes.txt").read_text() == "mine"
    (tmp_path / "other.csv.part").write_text("mine too")
    status, _, said = run("ik", ARM.name, f"@{poses}", "--csv", tmp_path / "other.csv")
    assert status == 2 and "something else" in " ".join(said.split())
    assert (tmp_path / "other.csv.part").read_text() == "mine too"


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="signals and locks of POSIX")
@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM", "SIGHUP", "SIGKILL"])
def test_a_process_is_stopped_by_any_signal_and_goes_on(tmp_path, name):
    T = ARM.fk(np.random.default_rng(4).uniform(-1.5, 1.5, (5000, 6)))
    lines = [",".join(repr(v * (1e3 if i % 4 == 3 else 1)) for i, v in enumerate(p[:3].ravel().tolist())) for p in T]
    text = "".join(line + "\n" for line in lines).encode()
    half = len("\n".join(lines[:4321]).encode())

    def begin(out: str) -> subprocess.Popen[bytes]:
        words = [sys.executable, "-m", "pieper", "ik", ARM.name, "@-", "--csv", out]
        pipe = subprocess.PIPE
        source = os.pathsep.join([str(Path(pieper.__file__).parents[1]), os.environ.get("PYTHONPATH", "")])
        environment = os.environ | {"PYTHONPATH": source}

        def heard() -> None:
            signal.signal(signal.SIGHUP, signal.SIG_DFL)  # these tests may run where it is not

        return subprocess.Popen(
            words, cwd=tmp_path, stdin=pipe, stderr=pipe, stdout=pipe, env=environment, preexec_fn=heard
        )

    first, reached = begin("out.csv"), tmp_path / "out.csv.part" / "reached.json"
    assert first.stdin is not None
    first.stdin.write(text[:half])
    first.stdin.flush()
    until = time.monotonic() + 60
    while time.monotonic() < until and not (
        reached.exists() and json.loads(reached.read_text())["counts"]["done"] == 4000
    ):
        time.sleep(0.05)
    second = begin("out.csv")
    _, said = second.communicate(text)
    assert second.returncode == 2 and b"another run is writing out.csv" in said
    number = getattr(signal, name)
    first.send_signal(number)
    _, said = first.communicate()
    assert not (tmp_path / "out.csv").exists()
    if name == "SIGKILL":
        assert first.returncode == -number
    else:
        assert first.returncode == 128 + number
        assert b"stopped after 4,000 poses, whose rows out.csv.part keeps. The same command goes on there." in said
    again, whole = begin("out.csv"), begin("whole.csv")
    _, said = again.communicate(text)
    whole.communicate(text)
    assert b"goes on after 4,000 poses" in said
    assert (tmp_path / "out.csv").read_bytes() == (tmp_path / "whole.csv").read_bytes()
    assert sorted(p.name for p in tmp_path.iterdir()) == ["out.csv", "whole.csv"]
