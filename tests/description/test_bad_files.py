"""Files and numbers that say something impossible are refused in one sentence with a cure, whatever their kind."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from tests.description.urdf_samples import joint, robot

BALL = """<mujoco><worldbody><body name="a"><joint type="ball" name="bj"/><geom size="0.1"/>
<body name="b"><joint type="hinge" axis="0 0 1"/><geom size=".1"/></body></body></worldbody></mujoco>"""
XACRO = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="side"/>
<xacro:arg name="size" default="1"/><link name="$(arg side)"/></robot>"""


def test_two_roots_and_a_ring_are_said(tmp_path):
    file = tmp_path / "a.urdf"
    file.write_text(robot(joint("j1", "a", "b"), joint("j2", "c", "e")))
    with pytest.raises(pieper.InputError, match="2 separate robots.*base='a'.*base='c'"):
        pieper.load(file)
    file.write_text(robot(joint("j1", "a", "b"), joint("j2", "b", "c"), joint("j3", "c", "a")))
    with pytest.raises(pieper.InputError, match="form a ring"):
        pieper.load(file)


def test_names_with_blanks_and_other_letters_are_names(tmp_path):
    file = tmp_path / "a.urdf"
    file.write_text(robot(joint("gelenk \u00f6 1", "Fu\u00df 1", "\u00e4rm")), encoding="utf-8")
    arm = pieper.load(file)
    assert arm.joint_names == ("gelenk \u00f6 1",)
    arm.save(tmp_path / "b.toml")
    assert pieper.load(tmp_path / "b.toml").joint_names == arm.joint_names


def test_a_ball_joint_and_an_argument_without_a_default_are_named_with_a_cure(tmp_path):
    pytest.importorskip("mujoco")
    file = tmp_path / "b.xml"
    file.write_text(BALL)
    with pytest.raises(pieper.InputError, match="'bj' is of type 'ball'.*base="):
        pieper.load(file)


def test_a_xacro_that_needs_an_argument_says_which(tmp_path):
    pytest.importorskip("xacrodoc")
    file = tmp_path / "x.xacro"
    file.write_text(XACRO)
    with pytest.raises(pieper.InputError, match=r"asks for side and has no default.*xacro_args=\{'side': 'value'\}"):
        pieper.load(file)


def test_an_axis_of_no_length_is_said():
    with pytest.raises(pieper.InputError, match="joint 1 has no direction"):
        pieper.Arm.from_axes([[0, 0, 0]], [[0, 0, 0]], np.eye(4))


@pytest.mark.parametrize("ending", ["urdf", "toml", "xml", "xacro"])
@pytest.mark.parametrize("what", [b"a" * 10_500_000, bytes(range(256)) * 40_000])
def test_ten_megabytes_of_anything_are_refused_at_once(tmp_path, ending, what):
    file = tmp_path / f"big.{ending}"
    file.write_bytes(what)
    with pytest.raises(pieper.InputError, match=f"big.{ending}"):
        pieper.load(file)


def test_angles_given_twice_and_quaternions_of_another_length_are_refused_with_the_tolerance():
    with pytest.raises(pieper.InputError, match="rpy and zyz say the orientation twice"):
        pieper.pose(0, 0, 0, rpy=(1, 0, 0), zyz=(0, 0, 0))
    with pytest.raises(pieper.InputError, match="length 1.00499; a length off by up to 1e-3 is made 1"):
        pieper.pose(0, 0, 0, quat_wxyz=(1, 0.1, 0, 0))
    assert np.allclose(pieper.pose(0, 0, 0, quat_wxyz=(1 + 1e-7, 0, 0, 0)), np.eye(4))


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "the file is empty"),
        ("hello", "not valid XML: syntax error.*Correct it there"),
        ("version https://git-lfs.github.com/spec/v1\noid sha256:0", "pointer of Git LFS.*git lfs pull"),
        ("<!DOCTYPE html><html><body>404</body></html>", "a web page.*raw file"),
        ("<html><br></html>", "a web page.*raw file"),
        ("<!DOCTYPE robot><robot/>", "Take it out"),
        ("<mujoco/>", "an MJCF: give it the ending .xml"),
        ("<sdf/>", "an SDF: convert it"),
        ("<COLLADA/>", "a mesh: load the URDF"),
        (robot(joint("j", "a", "b", kind="Revolute")), "of type 'Revolute': write 'revolute'"),
        (robot(joint("j", "a", "b", xyz="0.1,0,0.2")), "apart by blanks, got '0.1,0,0.2'"),
    ],
)
def test_what_is_no_urdf_is_told_with_a_cure(tmp_path, text, words):
    file = tmp_path / "arm.urdf"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(pieper.InputError, match=words):
        pieper.load(file)
