"""Writing over an existing robot file: comments stay, the file is whole or untouched."""

from __future__ import annotations

import dataclasses
import math
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import pieper
from pieper.description import catalog, robotfile, wholefile
from pieper.errors import InputError
from tests.description.robotfile_samples import EXAMPLES, TWO_JOINTS, same


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "two.toml"
    path.write_text(TWO_JOINTS)
    return path


def with_row(arm, index, **changes):
    rows = list(arm.rows)
    rows[index] = dataclasses.replace(rows[index], **changes)
    return dataclasses.replace(arm, rows=tuple(rows))


def test_writing_back_what_was_read_changes_no_character(file):
    robotfile.write(robotfile.read(file), file)
    assert file.read_text() == TWO_JOINTS


@pytest.mark.parametrize("name", catalog.names())
def test_a_catalogue_file_written_back_changes_no_character(name, tmp_path):
    text = Path(catalog.path_of(name)).read_text()
    path = tmp_path / "arm.toml"
    path.write_text(text)
    robotfile.write(catalog.load(name), path)
    assert path.read_text() == text


def test_a_changed_number_keeps_its_key_its_unit_and_its_comment(file):
    arm = with_row(robotfile.read(file), 0, a=0.25)
    robotfile.write(arm, file)
    assert file.read_text() == TWO_JOINTS.replace("a_mm = 10  ", "a_mm = 250  ")


def test_a_number_that_its_unit_cannot_say_exactly_takes_the_other_unit_and_keeps_its_comment(file):
    angle = 0.12345678912345
    arm = with_row(robotfile.read(file), 1, alpha=angle)
    robotfile.write(arm, file)
    text = file.read_text()
    assert f"alpha_rad = {angle}" in text and "alpha_deg = 30" not in text
    assert "# a quarter turn" in text and "# an arm" in text
    assert same(robotfile.read(file), arm)


def test_expressions_stay_where_their_value_stays(file):
    robotfile.write(dataclasses.replace(robotfile.read(file), name="other"), file)
    assert 'alpha_rad = "pi/2"      # a quarter turn' in file.read_text()
    assert 'name = "other"            # its name' in file.read_text()


def test_new_and_vanished_parts_are_written_and_comments_elsewhere_stay(file):
    arm = robotfile.read(file)
    tool = np.eye(4)
    tool[2, 3] = 0.1
    arm = dataclasses.replace(
        arm, tool=tool, limits=np.full((2, 2), [-math.inf, math.inf]), postures={"home": np.zeros(2)}
    )
    robotfile.write(arm, file)
    text = file.read_text()
    assert "limits" not in text and "[tool]" in text and "# the link" in text
    assert same(robotfile.read(file), arm)


def test_another_number_of_joints_is_written_too(file):
    arm = catalog.load("denso-vp6242")
    robotfile.write(arm, file)
    assert same(robotfile.read(file), arm)


def test_the_annotated_example_keeps_every_comment_when_a_length_changes(tmp_path):
    source = (EXAMPLES / "my-arm.toml").read_text()
    path = tmp_path / "my-arm.toml"
    path.write_text(source)
    robotfile.write(with_row(robotfile.read(path), 0, d=0.41), path)
    before, after = source.splitlines(), path.read_text().splitlines()
    assert [line for line in before if line not in after] == ["d_mm = 400"]
    assert [line for line in after if line not in before] == ["d_mm = 410"]


def test_a_file_that_is_no_robot_file_is_left_alone(tmp_path):
    path = tmp_path / "shopping.toml"
    path.write_text('milk = "2 l"\n')
    with pytest.raises(InputError, match="not a robot file"):
        robotfile.write(catalog.load("three-r"), path)
    assert path.read_text() == 'milk = "2 l"\n'


def test_an_empty_file_is_filled(tmp_path):
    path = tmp_path / "new.toml"
    path.touch()
    robotfile.write(catalog.load("three-r"), path)
    assert robotfile.read(path).name == "three-r"


@pytest.mark.parametrize("place", ["missing/arm.toml", "plain/arm.toml"])
def test_a_folder_that_cannot_be_written_is_said_so(tmp_path, place):
    (tmp_path / "plain").write_text("a file, not a folder")
    with pytest.raises(InputError, match="cannot write.*folder"):
        robotfile.write(catalog.load("three-r"), tmp_path / place)


def test_writing_onto_a_folder_is_refused(tmp_path):
    with pytest.raises(InputError, match="folder"):
        robotfile.write(catalog.load("three-r"), tmp_path)


@pytest.mark.parametrize("interruption", [KeyboardInterrupt, OSError])
def test_an_interrupted_write_leaves_the_old_file_and_nothing_else(file, monkeypatch, interruption):
    def stop(*_):
        raise interruption

    monkeypatch.setattr(os, "replace", stop)
    arm = dataclasses.replace(robotfile.read(file), name="other")
    with pytest.raises((KeyboardInterrupt, InputError)):
        robotfile.write(arm, file)
    assert file.read_text() == TWO_JOINTS
    assert [entry.name for entry in file.parent.iterdir()] == [file.name]


def test_the_permissions_of_a_rewritten_file_stay(file):
    file.chmod(0o640)
    wholefile.replace_file(file, TWO_JOINTS)
    assert file.stat().st_mode & 0o777 == 0o640


def test_a_link_to_a_file_stays_a_link(file, tmp_path):
    link = tmp_path / "link.toml"
    link.symlink_to(file)
    robotfile.write(dataclasses.replace(robotfile.read(file), name="other"), link)
    assert link.is_symlink() and robotfile.read(file).name == "other"


def test_without_tomlkit_a_new_file_is_written_and_an_old_one_is_left_with_a_hint(file, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "tomlkit", None)
    arm = dataclasses.replace(robotfile.read(file), name="other")
    robotfile.write(arm, tmp_path / "new.toml")
    assert robotfile.read(tmp_path / "new.toml").name == "other"
    with pytest.raises(InputError, match="pip install tomlkit"):
        robotfile.write(arm, file)
    assert file.read_text() == TWO_JOINTS


def test_reading_loads_no_package_but_numpy():
    code = "import sys; from pieper.description import robotfile; sys.exit('tomlkit' in sys.modules)"
    source = Path(robotfile.__file__).parents[2]
    assert subprocess.run([sys.executable, "-c", code], cwd=source, check=False).returncode == 0


def test_a_tool_or_base_said_by_its_position_becomes_one_that_is_turned_and_back(tmp_path):
    arm = pieper.Arm.from_dh([pieper.DH(0.1), pieper.DH(0.2)], convention="standard")
    moved, turned = pieper.pose(0, 0, 0.1), pieper.pose(0, 0, 0.1, rpy=(0.1, 0.2, 0.3))
    file = tmp_path / "z.toml"
    for tool, base in ((moved, moved), (turned, moved), (turned, turned), (moved, turned), (np.eye(4), moved)):
        wanted = arm.with_tool(tool).with_base(base)
        wanted.save(file)
        again = pieper.load(file)
        assert np.array_equal(again.tool, wanted.tool) and np.array_equal(again.base, wanted.base)
