"""Which door a source goes through, and what is said at the doors that stay closed."""

from __future__ import annotations

import os
import sys
from dataclasses import replace

import numpy as np
import pytest

import pieper
from pieper import InputError
from pieper.description import xacro
from tests.description.urdf_samples import ARM, fixed, robot, slide


@pytest.mark.parametrize("name", ["arm.urdf", "arm.URDF", "arm.xml"])
def test_a_urdf_is_read_whatever_its_ending_is_called(tmp_path, name):
    (tmp_path / name).write_text(robot(*ARM))
    assert pieper.load(tmp_path / name).joint_names == ("a", "b", "c")


def test_base_and_tip_and_what_was_left_out_reach_the_arm(tmp_path):
    path = tmp_path / "arm.urdf"
    path.write_text(robot(*ARM, fixed("h", "l3", "hand"), slide("f1", "hand", "f_l"), slide("f2", "hand", "f_r")))
    arm = pieper.load(path)
    assert arm.n == 3 and len(arm.notes) == 1 and "f1" in arm.notes[0]
    assert pieper.load(path, "l1", "l3").joint_names == ("b", "c")
    assert pieper.load(path, base="l1", tip="f_l").joint_types == "RRP"
    assert pieper.load("denso-vp6242").notes == ()


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("robot.sdf", "SDF is not read. Convert"),
        ("robot.usd", "USD is not read. Export"),
        ("robot.usda", "USD is not read"),
        ("robot.USDZ", "USD is not read"),
        ("robot.world", "Gazebo world"),
        ("robot.step", "CAD file"),
        ("robot.srdf", "base= and tip="),
        ("robot.stl", "mesh has no joints"),
    ],
)
def test_formats_that_are_not_read_are_refused_by_name_with_what_to_do(tmp_path, name, message):
    (tmp_path / name).write_text("anything")
    with pytest.raises(InputError, match=message):
        pieper.load(tmp_path / name)


def test_an_xml_of_another_kind_is_refused_by_its_first_element(tmp_path):
    (tmp_path / "a.xml").write_text("<sdf version='1.6'/>")
    with pytest.raises(InputError, match="SDF is not read"):
        pieper.load(tmp_path / "a.xml")
    (tmp_path / "b.xml").write_text("<svg/>")
    with pytest.raises(InputError, match="first element is <svg>.*<robot>.*<mujoco>"):
        pieper.load(tmp_path / "b.xml")


def test_an_arm_loaded_at_a_named_place_keeps_the_places_where_they_are(tmp_path):
    frames = {"table": pieper.pose(0.5, 0, -0.1, rpy=(0, 0, 1.5)), "shelf": pieper.pose(0, 0.7, 0.3, rpy=(0.2, 0, 0))}
    said = replace(pieper.load("denso-vp6242").description, frames=frames)
    pieper.Arm(said).save(tmp_path / "one.toml")
    q = np.array([0.1, 0.2, 0.3, 0.4, 0.5, 0.6])
    pieper.load(tmp_path / "one.toml", base="table").save(tmp_path / "two.toml")
    for name in frames:
        first, then = (pieper.load(tmp_path / file, base=name) for file in ("one.toml", "two.toml"))
        assert np.abs(first.fk(q) - then.fk(q)).max() < 1e-12
    assert np.array_equal(pieper.load(tmp_path / "two.toml").description.frames["table"], np.eye(4))


@pytest.mark.parametrize("ending", ["toml", "urdf", "xml", "xacro", "sdf"])
@pytest.mark.parametrize("content", [b"a" * 10_000_000, b"<a>" * 3_000_000, b"\x00\xff" * 5_000_000])
def test_ten_megabytes_of_anything_get_a_clear_answer(tmp_path, ending, content):
    path = tmp_path / f"big.{ending}"
    path.write_bytes(content)
    with pytest.raises(InputError, match=f"big.{ending}"):
        pieper.load(path)


def test_a_file_with_too_many_joints_is_refused(tmp_path):
    joints = "".join(
        f'<joint name="j{i}" type="revolute"><parent link="l{i}"/><child link="l{i + 1}"/></joint>' for i in range(6000)
    )
    (tmp_path / "long.urdf").write_text(f"<robot name='r'>{joints}</robot>")
    with pytest.raises(InputError, match="6,000 joints; at most 5,000"):
        pieper.load(tmp_path / "long.urdf")


@pytest.mark.parametrize("source", [None, 3, ["a.urdf"]])
def test_what_is_no_name_and_no_path_is_refused(source):
    with pytest.raises(InputError, match="name of an arm or the path of a file"):
        pieper.load(source)


def test_named_tools_and_frames_of_a_robot_file_are_tips_and_bases(tmp_path):
    path = tmp_path / "arm.toml"
    pieper.load("denso-vp6242").save(path)
    path.write_text(path.read_text() + "\n[tools.pen]\nxyz_mm = [0, 0, 120]\n\n[frames.table]\nxyz_mm = [500, 0, 0]\n")
    plain, q = pieper.load(path), np.array([0.1, 0.2, 0.3, 0.4, 0.5, 0.6])
    pen = pieper.load(path, base="table", tip="pen")
    assert np.abs(pieper.pose(0.5) @ pen.fk(q) - plain.fk(q) @ pieper.pose(0, 0, 0.12)).max() < 1e-15
    assert np.abs(plain.with_tool("pen").fk(q) - plain.fk(q) @ pieper.pose(0, 0, 0.12)).max() < 1e-15
    with pytest.raises(InputError, match="no tool 'brush' for the tip: it has pen"):
        pieper.load(path, tip="brush")
    with pytest.raises(InputError, match="no frame 'table' for the base: it has none"):
        pieper.load("denso-vp6242", base="table")
    with pytest.raises(InputError, match="no tool 'brush': it has pen"):
        plain.with_tool("brush")
    plain.save(path)
    assert "[tools.pen]" in path.read_text()


XACRO = """\
<robot name="x" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="reach" default="{default}"/>
  <xacro:macro name="joint" params="n axis">
    <joint name="j${{n}}" type="revolute"><parent link="l${{n - 1}}"/><child link="l${{n}}"/>
      <origin xyz="$(arg reach) 0 0" rpy="${{pi/2}} 0 0"/><axis xyz="${{axis}}"/><limit lower="-2" upper="2"/></joint>
  </xacro:macro>
  <xacro:joint n="1" axis="0 0 1"/><xacro:joint n="2" axis="0 0 1"/>
</robot>
"""


@pytest.mark.parametrize("name", ["arm.xacro", "arm.urdf.xacro", "arm.urdf"])
def test_macros_are_expanded(tmp_path, name):
    pytest.importorskip("xacrodoc")
    (tmp_path / name).write_text(XACRO.format(default="0.3"))
    arm = pieper.load(tmp_path / name)
    assert arm.joint_names == ("j1", "j2") and np.abs(arm.fk([0, 0])[:3, 3] - [0.6, 0, 0]).max() < 1e-15
    longer = pieper.load(tmp_path / name, xacro_args={"reach": "0.5"})
    assert np.abs(longer.fk([0, 0])[:3, 3] - [1.0, 0, 0]).max() < 1e-15


def test_a_xacro_that_needs_an_argument_or_a_package_says_so(tmp_path):
    pytest.importorskip("xacrodoc")
    needy = XACRO.format(default="0.3").replace('<xacro:arg name="reach" default="0.3"/>', "")
    (tmp_path / "needy.xacro").write_text(needy)
    with pytest.raises(InputError, match="reach.*xacro_args"):
        pieper.load(tmp_path / "needy.xacro")
    # a name of this run's own: other runs' packages may lie in the folders above
    name = f"nowhere_{os.getpid()}"
    (tmp_path / "away.xacro").write_text(
        '<robot name="x" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        f'<xacro:include filename="$(find {name})/a.xacro"/></robot>'
    )
    with pytest.raises(InputError, match=f"needs the package '{name}', which is not in the folders around it. Lay it"):
        pieper.load(tmp_path / "away.xacro")
    (tmp_path / "pkg").mkdir()
    (tmp_path / "pkg" / "package.xml").write_text(f"<package><name>{name}</name></package>")
    with pytest.raises(InputError, match="needs '.*a.xacro', which is not there. Lay it there"):
        pieper.load(tmp_path / "away.xacro")
    (tmp_path / "pkg" / "a.xacro").write_text(XACRO.format(default="0.3"))
    assert pieper.load(tmp_path / "away.xacro").n == 2
    # a folder of its own, in whose neighbours no other run's files lie
    inner = tmp_path / "robot" / "urdf"
    inner.mkdir(parents=True)
    (inner / "macros.xacro").write_text('<robot name="x" xmlns:xacro="http://www.ros.org/wiki/xacro"/>')
    with pytest.raises(InputError, match="may only define macros. Load the file that uses them.$"):
        pieper.load(inner / "macros.xacro")
    (inner / "arm.urdf.xacro").write_text(
        XACRO.format(default="0.3").replace("<xacro:arg", '<xacro:include filename="macros.xacro"/><xacro:arg')
    )
    with pytest.raises(InputError, match="Load the file that uses them: arm.urdf.xacro.$") as raised:
        pieper.load(inner / "macros.xacro")
    assert pieper.load(inner / raised.value.allowed[0]).n == 2


def test_packages_are_looked_for_in_so_many_folders_and_not_in_other_homes(tmp_path, monkeypatch):
    robot = tmp_path / "home" / "anna" / "ws" / "src" / "robot_description"
    for package in (robot, robot.parent / "other", robot.parent / "deep" / "er" / "down"):
        package.mkdir(parents=True)
        (package / "package.xml").write_text(f"<package><name> {package.name} </name></package>")
    (tmp_path / "home" / "berta" / "secret").mkdir(parents=True)
    (tmp_path / "home" / "berta" / "secret" / "package.xml").write_text("<package><name>secret</name></package>")
    file = robot / "urdf" / "a.xacro"
    monkeypatch.setattr("pathlib.Path.home", lambda: tmp_path / "home" / "anna")
    assert set(xacro.packages_around(file)) == {"robot_description", "other", "down"}
    assert xacro.packages_around(tmp_path / "home" / "anna" / "a.xacro").keys() == {"robot_description", "other"}
    looked: list[object] = []
    monkeypatch.setattr(xacro, "MOST_FOLDERS", 30)
    for i in range(60):
        (robot.parent / f"more_{i}").mkdir()
    scandir = os.scandir
    monkeypatch.setattr(os, "scandir", lambda folder: looked.append(folder) or scandir(folder))
    xacro.packages_around(file)
    assert len(looked) <= 30 + xacro.LEVELS_UP


def test_an_argument_used_before_its_line_has_its_default_and_what_fails_names_the_arguments(tmp_path):
    pytest.importorskip("xacrodoc")
    text = XACRO.format(default="0.3").replace('name="x"', 'name="$(arg called)"')
    declared = '<xacro:arg name="called" default="anna"/>'
    (tmp_path / "early.xacro").write_text(text.replace("<xacro:macro", declared + "<xacro:macro"))
    assert pieper.load(tmp_path / "early.xacro").name == "anna"
    assert pieper.load(tmp_path / "early.xacro", xacro_args={"called": "otto"}).name == "otto"
    (tmp_path / "wrong.xacro").write_text(text.replace("<xacro:macro", declared + '<link name="${PI}"/><xacro:macro'))
    with pytest.raises(
        InputError, match="'PI' is not defined.* Its arguments are reach, called; xacro_args= sets them."
    ):
        pieper.load(tmp_path / "wrong.xacro")


def test_without_its_package_a_xacro_says_what_to_install(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "xacrodoc", None)
    (tmp_path / "arm.xacro").write_text(XACRO.format(default="0.3"))
    with pytest.raises(InputError, match="pip install 'pieper.xacro.'"):
        pieper.load(tmp_path / "arm.xacro")


MJCF = """\
<mujoco model="m"><compiler angle="degree"/><asset><mesh name="x" file="nowhere.stl"/></asset>
<default><default class="side"><joint axis="0 1 0" range="-90 90"/></default></default>
<worldbody><body name="b0" pos="0 0 .1"><geom type="mesh" mesh="x"/>
<joint name="j0" axis="0 0 1" limited="true" range="-170 170"/>
<body name="b1" pos=".3 0 0" euler="90 0 0"><joint class="side" name="j1" pos="0 0 .05"/><geom type="mesh" mesh="x"/>
<site name="tcp" pos="0 0 .1"/>{more}</body></body></worldbody>{rest}</mujoco>
"""
FINGERS = """<body name="f1"><joint name="fa" type="slide" axis="0 1 0" range="0 .04"/><geom size=".01"/></body>
<body name="f2"><joint name="fb" type="slide" axis="0 -1 0" range="0 .04"/><geom size=".01"/></body>"""


def test_a_model_of_mujoco_is_read_without_its_meshes(tmp_path):
    mujoco = pytest.importorskip("mujoco")
    path = tmp_path / "arm.xml"
    path.write_text(MJCF.format(more=FINGERS, rest=""))
    arm = pieper.load(path)
    assert arm.joint_names == ("j0", "j1") and "fa" in arm.notes[0] and arm.description.source.endswith("to tcp")
    assert np.allclose(np.degrees(arm.limits), [[-170, 170], [-90, 90]])
    shapes = MJCF.format(more="", rest="").replace('type="mesh" mesh="x"', 'size=".01"')
    model = mujoco.MjModel.from_xml_string(shapes.replace('<mesh name="x" file="nowhere.stl"/>', ""))
    data = mujoco.MjData(model)
    for q in np.random.default_rng(0).uniform(-1, 1, (10, 2)):
        data.qpos[:] = q
        mujoco.mj_kinematics(model, data)
        assert np.abs(arm.fk(q)[:3, 3] - data.site("tcp").xpos).max() < 1e-14
        assert np.abs(arm.fk(q)[:3, :3].ravel() - data.site("tcp").xmat).max() < 1e-14


def test_a_ball_joint_inside_a_model_is_refused_by_name(tmp_path):
    pytest.importorskip("mujoco")
    path = tmp_path / "arm.xml"
    path.write_text(
        MJCF.format(more='<body name="b2"><joint name="ball" type="ball"/><geom size=".1"/></body>', rest="")
    )
    with pytest.raises(InputError, match="joint 'ball' is of type 'ball'"):
        pieper.load(path, tip="b2")


def test_a_model_that_mujoco_cannot_read_says_why(tmp_path):
    pytest.importorskip("mujoco")
    (tmp_path / "bad.xml").write_text("<mujoco><worldbody><body><joint type='bent'/></body></worldbody></mujoco>")
    with pytest.raises(InputError, match="MuJoCo cannot read this model"):
        pieper.load(tmp_path / "bad.xml")


def test_without_its_package_a_model_says_what_to_install(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "mujoco", None)
    (tmp_path / "arm.xml").write_text(MJCF.format(more="", rest=""))
    with pytest.raises(InputError, match="pip install 'pieper.mujoco.'"):
        pieper.load(tmp_path / "arm.xml")


def test_an_inertia_matrix_does_not_stand_in_the_way(tmp_path):
    pytest.importorskip("mujoco")
    path = tmp_path / "arm.xml"
    inertia = '<inertial pos="0 0 0" mass="1" fullinertia="1 1 1 0.1 0 0"/><joint name="j0"'
    path.write_text(MJCF.format(more="", rest="").replace('<joint name="j0"', inertia))
    assert pieper.load(path).n == 2


def test_a_robot_that_floats_begins_at_its_own_body_and_things_about_are_no_arms(tmp_path):
    pytest.importorskip("mujoco")
    path = tmp_path / "scene.xml"
    block = '<body name="block"><freejoint/><geom size=".1"/></body>'
    path.write_text(MJCF.format(more="", rest="").replace("<worldbody>", f"<worldbody>{block}"))
    assert pieper.load(path).joint_names == ("j0", "j1")
    floating = '<body name="hull"><freejoint name="free"/><geom size=".1"/>'
    text = MJCF.format(more="", rest="").replace("<worldbody>", f"<worldbody>{floating}")
    path.write_text(text.replace("</worldbody>", "</body></worldbody>"))
    for arm in (pieper.load(path), pieper.load(path, tip="tcp")):
        assert arm.joint_names == ("j0", "j1") and "floats (joint 'free'); its own body 'hull'" in arm.notes[0]
