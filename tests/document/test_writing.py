"""Everything that writes a file: no path, a folder, an unknown ending, a place that cannot be written; links, pipes."""

from __future__ import annotations

import os
import stat
import threading

import numpy as np
import pytest

import pieper


@pytest.fixture(scope="module")
def writers():
    """Return name -> (a function that writes to a path, an ending that is right)."""
    arm = pieper.load("denso-vp6242")
    T = pieper.pose(0.35, 0, 0.4)
    sols = arm.ik(T)
    q = sols.q[0]
    limits = pieper.Limits(speed=1.0, acceleration=2.0)
    track = arm.follow(pieper.line(T, pieper.pose(0.35, 0.05, 0.4), n=4), start=q)
    program = pieper.Program(arm, limits, start=q)
    program.move_j(q + 0.1)
    drawn = np.random.default_rng(0).uniform(-1, 1, (30, 6))
    motion = pieper.time_law(track, limits)
    figure = pieper.plot.solutions_figure(arm, sols)
    return {
        "arm": (arm.save, ".toml"),
        "solutions": (sols.save, ".csv"),
        "batch": (arm.ik_many([T, T]).save, ".npz"),
        "track": (track.save, ".csv"),
        "motion": (motion.save, ".npz"),
        "moving picture": (motion.animate, ".html"),
        "program of ours": (lambda path: pieper.save_program(program, path), ".toml"),
        "program": (program.write, ".pcs"),
        "map": (arm.reach_map([(0.2, 0.3), (0, 0.1), (0.2, 0.3)], 0.05, orientations=(8, 2)).save, ".npz"),
        "scene": (pieper.Scene([pieper.Box(pieper.pose(1, 0, 0), (0.1, 0.1, 0.1))]).save, ".toml"),
        "fit": (arm.calibrate(drawn, arm.fk(drawn)).save, ".toml"),
        "figure": (lambda path: pieper.plot.save_figure(figure, path), ".svg"),
        "code": (lambda path: arm.code("python", path), ".py"),
        "report": (lambda path: pieper.write_report(arm, path), ".html"),
    }


NAMES = (
    "arm",
    "solutions",
    "batch",
    "track",
    "motion",
    "moving picture",
    "program of ours",
    "program",
    "map",
    "scene",
    "fit",
    "figure",
    "code",
    "report",
)


@pytest.mark.parametrize("name", NAMES)
def test_what_is_no_place_for_a_file_is_refused_in_words(writers, name, tmp_path):
    write, ending = writers[name]
    for given in (None, 3, "", "a\0b", object(), ["x" + ending]):
        with pytest.raises(pieper.InputError, match="must be the path of a file, got"):
            write(given)
    folder = tmp_path / f"folder{ending}"
    folder.mkdir()
    with pytest.raises(pieper.InputError, match="is a folder"):
        write(folder)
    (tmp_path / "file").write_text("mine")
    for place in (tmp_path / "no" / f"x{ending}", tmp_path / "file" / f"x{ending}", f"/proc/x{ending}"):
        with pytest.raises(pieper.InputError, match="cannot write|does not exist|cannot be"):
            write(place)
    assert sorted(p.name for p in tmp_path.iterdir()) == ["file", folder.name]
    assert not list(folder.iterdir()) and (tmp_path / "file").read_text() == "mine"


@pytest.mark.parametrize("name", [name for name in NAMES if name != "code"])
def test_an_ending_that_says_something_else_is_refused(writers, name, tmp_path):
    write, ending = writers[name]
    with pytest.raises(pieper.InputError, match=r"\.\w+"):
        write(tmp_path / "x.unknown")
    assert not list(tmp_path.iterdir())
    write(tmp_path / f"x{ending}")
    assert [p.name for p in tmp_path.iterdir()] == [f"x{ending}"]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="links, pipes and rights of POSIX")
def test_links_pipes_devices_and_rights_stay_what_they_are(writers, tmp_path):
    for name in ("solutions", "arm"):
        write, ending = writers[name]
        real, link = tmp_path / f"real{ending}", tmp_path / f"link{ending}"
        write(real)
        text = real.read_bytes()
        os.chmod(real, 0o640)
        link.symlink_to(real)
        write(link)
        assert link.is_symlink() and real.read_bytes() == text
        assert stat.S_IMODE(real.stat().st_mode) == 0o640
    write, ending = writers["solutions"]
    pipe = tmp_path / "pipe.csv"
    os.mkfifo(pipe)
    got: list[bytes] = []
    reader = threading.Thread(target=lambda: got.append(pipe.read_bytes()))
    reader.start()
    write(pipe)
    reader.join(120)
    assert got == [(tmp_path / "real.csv").read_bytes()]
    with pieper.whole_file(os.devnull) as out:
        out.write(b"nothing")
    assert stat.S_ISCHR(os.stat(os.devnull).st_mode)
