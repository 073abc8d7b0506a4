"""A path that begins with "~" is one in the user's own folder, at every door where a file goes in or out."""

from __future__ import annotations

import numpy as np
import pytest

import pieper

LIMITS = pieper.Limits(1.0, 1.0)


@pytest.fixture(autouse=True)
def home(tmp_path, monkeypatch):
    """A home folder of the test's own, and another folder to work in."""
    (tmp_path / "home").mkdir()
    (tmp_path / "here").mkdir()
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    monkeypatch.chdir(tmp_path / "here")
    return tmp_path / "home"


def test_what_is_written_there_is_read_from_there(home):
    arm = pieper.load("denso-vp6242")
    start = np.mean(arm.limits, axis=1)
    q = start + 0.2
    for name in ("a.toml", "a.urdf"):
        arm.save(f"~/{name}")
        assert np.allclose(pieper.load(f"~/{name}").fk(q), arm.fk(q))
    program = pieper.Program(arm, LIMITS, start=start).move_j(q)
    pieper.save_program(program, "~/p.toml")
    assert np.allclose(pieper.load_program(arm, "~/p.toml").moves[-1].q, q)
    program.write("~/p.csv")
    assert np.allclose(pieper.read_program("~/p.csv")[-1].q, q, atol=1e-6)
    arm.code("c", "~/a.c")
    pieper.Scene([pieper.Box([1.0, 0.0, 0.5], [0.1, 0.1, 0.1])]).save("~/s.toml")
    assert len(pieper.Scene.load("~/s.toml")) == 1
    assert {f.name for f in home.iterdir()} >= {"a.toml", "a.urdf", "p.toml", "p.csv", "a.c", "s.toml"}
    assert not list(home.parent.joinpath("here").iterdir())


def test_a_folder_of_nobody_is_named():
    with pytest.raises(pieper.InputError, match="no user 'nobody-here'"):
        pieper.load("~nobody-here/a.toml")
