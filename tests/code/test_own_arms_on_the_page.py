"""Robot files on the page without a server: each by a name of its own, and never beside kernels of another version."""

from __future__ import annotations

import json
import re

import pytest

import pieper
from static_page.build import add, build

ROBOT = "denso-vp6242"


@pytest.fixture
def own(tmp_path):
    file = tmp_path / "mine.toml"
    pieper.load(ROBOT).with_tool(pieper.pose(0, 0, 0.1)).save(file)
    return file


def listed(folder):
    return json.loads(re.search(r"^const NAMES = (.*);$", (folder / "page.js").read_text(), re.M)[1])


def test_an_arm_that_is_called_as_another_gets_the_name_of_its_file(tmp_path, own):
    named_alike = pieper.load(own).name
    assert build(tmp_path / "site", [named_alike], code=b"none", own=[str(own)]) == 2
    assert listed(tmp_path / "site") == [["mine", "arm_mine", True], [named_alike, "arm_denso_vp6242", False]]
    script = (tmp_path / "site" / "arms" / "arm_mine.js").read_text()
    assert '"name": "mine"' in script
    assert '"solver": {' in script


def test_a_robot_file_is_put_into_a_folder_that_stands(tmp_path, own):
    folder = tmp_path / "site"
    build(folder, ["universal-robots-ur5e"], code=b"none")
    assert add(folder, [str(own)]) == 1
    name = pieper.load(own).name
    assert [arm[0] for arm in listed(folder)] == [name, "universal-robots-ur5e"]
    # again: changed, not doubled
    assert add(folder, [str(own)]) == 1
    assert [arm[0] for arm in listed(folder)] == [name, "universal-robots-ur5e"]
    kernels = folder / "kernel.js"
    kernels.write_text(re.sub(r'"made": "[^"]*"', '"made": "another"', kernels.read_text()))
    with pytest.raises(pieper.InputError, match="another version"):
        add(folder, [str(own)])


def test_what_is_no_robot_file_is_told_before_anything_is_compiled(tmp_path):
    with pytest.raises(pieper.InputError, match="no file"):
        build(tmp_path / "site", [ROBOT], own=["universal-robots-ur5e"])
    with pytest.raises(pieper.InputError, match="build it first"):
        add(tmp_path, [str(tmp_path / "a.toml")])
