"""Arms said by axes, by OPW parameters and by a UR's calibration."""

from __future__ import annotations

import json

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import pieper
from pieper import InputError
from pieper.description import robotfile, urdf
from tests.description.urdf_samples import joint, robot


def exponential(axis, point, q, kind):
    T = np.eye(4)
    if kind == "P":
        T[:3, 3] = np.array(axis) * q
        return T
    T[:3, :3] = Rotation.from_rotvec(np.array(axis) * q).as_matrix()
    T[:3, 3] = point - T[:3, :3] @ point
    return T


def test_axes_and_points_give_the_product_of_exponentials():
    rng = np.random.default_rng(0)
    for _ in range(50):
        n = int(rng.integers(1, 8))
        axes = rng.normal(size=(n, 3))
        axes /= np.linalg.norm(axes, axis=1, keepdims=True)
        points, kinds = rng.normal(size=(n, 3)), "".join(rng.choice(list("RRRP"), n))
        home = pieper.pose(*rng.normal(size=3), rpy=rng.uniform(-1, 1, 3))
        arm = pieper.Arm.from_axes(axes, points, home, joint_types=kinds, limits=[(-3, 3)] * n)
        q, T = rng.uniform(-3, 3, n), np.eye(4)
        for axis, point, value, kind in zip(axes, points, q, kinds, strict=True):
            T = T @ exponential(axis, point, value, kind)
        assert np.abs(arm.fk(q) - T @ home).max() < 1e-13
        assert arm.limits.tolist() == [[-3, 3]] * n


@pytest.mark.parametrize(
    ("axes", "points", "message"),
    [
        ([[0, 0, 0]], [[0, 0, 0]], "joint 1 has no direction"),
        ([[0, 0, 2]], [[0, 0, 0]], "length 2; axes are unit vectors"),
        ([[0, 0, 1]], [[0, 0, 0], [1, 0, 0]], "as many"),
        ([], [], "n, 3"),
        ([[0, 0, np.nan]], [[0, 0, 0]], "finite"),
        ("axes", [[0, 0, 0]], "n, 3"),
    ],
)
def test_axes_that_are_none_are_refused(axes, points, message):
    with pytest.raises(InputError, match=message):
        pieper.Arm.from_axes(axes, points, np.eye(4))


def test_a_home_that_is_no_pose_is_refused():
    with pytest.raises(InputError, match="home"):
        pieper.Arm.from_axes([[0, 0, 1]], [[0, 0, 0]], np.eye(3))


AXES_FILE = """\
name = "two axes"
convention = "axes"

[[joints]]
name = "turn"
type = "revolute"
axis = [0, 0, 1]
point_mm = [100, 0, 0]
limits_deg = [-90, 90]

[[joints]]
name = "slide"
type = "prismatic"
axis = ["sqrt(2)/2", 0, "sqrt(2)/2"]
limits_mm = [0, 200]

[home]
xyz_mm = [400, 0, 250]
rpy_deg = [180, 0, 0]

[tools.pen]
xyz_mm = [0, 0, 50]
"""


def test_a_robot_file_may_say_axes():
    arm = pieper.Arm(robotfile.loads(AXES_FILE))
    half = np.sqrt(2) / 2
    home = pieper.pose(400, 0, 250, rpy=(180, 0, 0), degrees=True, mm=True)
    wanted = exponential([0, 0, 1], np.array([0.1, 0, 0]), 0.3, "R") @ exponential([half, 0, half], 0, 0.1, "P") @ home
    assert np.abs(arm.fk([0.3, 0.1]) - wanted).max() < 1e-15
    pen = arm.with_tool("pen")
    assert np.abs(pen.fk([0.3, 0.1]) - wanted @ pieper.pose(0, 0, 0.05)).max() < 1e-15


@pytest.mark.parametrize(
    ("was", "now", "message"),
    [
        ("axis = [0, 0, 1]\n", "", "joint 1 .'turn'.*'axis' is missing"),
        ("axis = [0, 0, 1]", "axis = [0, 0, 0]", "must be of length 1"),
        ("axis = [0, 0, 1]", "axis = [0, 1]", "list of 3 numbers"),
        ("point_mm = [100, 0, 0]\n", "", "key for point is missing"),
        ("axis = [0, 0, 1]", "a_mm = 3", "unknown"),
        ('convention = "axes"', 'convention = "standard"', "home: belongs to"),
    ],
)
def test_axes_in_a_robot_file_that_are_none_are_refused_where_they_stand(was, now, message):
    with pytest.raises(InputError, match=message):
        robotfile.loads(AXES_FILE.replace(was, now))


def opw_pose(p, q):
    """Return the pose of OPW parameters, by Brandstötter's formulas."""
    theta = np.array(p["signs"]) * q - np.array(p["offsets"])
    psi, k = np.arctan2(p["a2"], p["c3"]), np.hypot(p["a2"], p["c3"])
    x = p["c2"] * np.sin(theta[1]) + k * np.sin(theta[1] + theta[2] + psi) + p["a1"]
    z = p["c2"] * np.cos(theta[1]) + k * np.cos(theta[1] + theta[2] + psi) + p["c1"]
    c, s = np.cos(theta[0]), np.sin(theta[0])
    R = Rotation.from_euler("ZY", [theta[0], theta[1] + theta[2]]) * Rotation.from_euler("ZYZ", theta[3:])
    T = np.eye(4)
    T[:3, :3] = R.as_matrix()
    T[:3, 3] = np.array([x * c - p["b"] * s, x * s + p["b"] * c, z]) + p["c4"] * T[:3, 2]
    return T


def test_opw_parameters_give_the_pose_of_their_formulas():
    lengths = {"a1": 0.1, "a2": -0.135, "b": 0.02, "c1": 0.615, "c2": 0.705, "c3": 0.755, "c4": 0.085}
    said = lengths | {"offsets": [0, 0, -np.pi / 2, 0.1, 0, 0], "signs": [1, 1, -1, -1, 1, -1]}
    arm = pieper.Arm.from_opw(**said)
    for q in np.random.default_rng(3).uniform(-3, 3, (30, 6)):
        assert np.abs(arm.fk(q) - opw_pose(said, q)).max() < 5e-15
    assert arm.plan.family == "spherical_wrist_parallel"
    q = np.array([0.3, 0.2, 0.1, 0.5, 0.7, 0.9])
    assert np.abs(arm.ik(arm.fk(q)).q - q).max(1).min() < 1e-9


def test_opw_parameters_that_are_none_are_refused():
    lengths = {"a1": 0.1, "a2": -0.135, "b": 0, "c1": 0.615, "c2": 0.705, "c3": 0.755, "c4": 0.085}
    with pytest.raises(InputError, match="c2 must be a finite number, a length in m"):
        pieper.Arm.from_opw(**lengths | {"c2": np.nan})
    with pytest.raises(InputError, match="offsets must be six"):
        pieper.Arm.from_opw(**lengths, offsets=[0, 0])
    with pytest.raises(InputError, match="sign must be"):
        pieper.Arm.from_opw(**lengths, signs=[0] * 6)


CALIBRATION = """\
kinematics:
  shoulder:
    x: 0
    y: 0
    z: 0.16241
    roll: -0
    pitch: 0
    yaw: -1.2e-05
  upper_arm: {x: -0.000189, y: 0, z: 0, roll: 1.5700, pitch: 0, yaw: 5.0e-06}
  forearm:
    x: -0.42497
    y: 0
    z: 0
    roll: 3.1412
    pitch: 3.14103
    yaw: 3.1415926
  wrist_1:
    x: -0.39234
    y: -0.00038
    z: 0.13331  # m
    roll: 0.00285
    pitch: -0.00113
    yaw: -2e-06
  wrist_2: {x: 4.2e-05, y: -0.09949, z: 5.0e-05, roll: 1.57028, pitch: 0, yaw: -1.0e-06}
  wrist_3: {x: -1.9e-05, y: 0.09953, z: -1.4e-05, roll: 1.57065, pitch: 3.14159, yaw: 3.14158}
  hash: calib_123
"""


def test_a_calibrated_ur_is_the_product_of_its_six_frames(tmp_path):
    path = tmp_path / "ur.yaml"
    path.write_text(CALIBRATION)
    arm = pieper.ur_calibrated(path)
    import yaml

    frames = yaml.safe_load(CALIBRATION)["kinematics"]
    for q in np.random.default_rng(5).uniform(-3, 3, (10, 6)):
        T = np.eye(4)
        for link, value in zip(list(frames)[:6], q, strict=True):
            f, step = frames[link], np.eye(4)
            step[:3, :3] = Rotation.from_euler("xyz", [f["roll"], f["pitch"], f["yaw"]]).as_matrix()
            step[:3, 3] = f["x"], f["y"], f["z"]
            T = T @ step @ exponential([0, 0, 1], np.zeros(3), value, "R")
        assert np.abs(arm.fk(q) - T).max() < 1e-11
    assert arm.joint_names[2] == "elbow_joint"
    # the common normals of its nearly parallel axes lie hundreds of metres away; the arm is no longer for that
    assert max(abs(row.d) for row in arm.description.rows) > 100 and arm.chain.length < 2
    q = np.array([0.3, -1, 1.2, 0.4, 0.8, 0.1])
    assert np.abs(arm.ik(arm.fk(q)).q - q).max(1).min() < 1e-12
    assert "joints 2, 3 and 4 made parallel" in pieper.Arm(arm.description, snap=1e-2).plan.explain()


@pytest.mark.parametrize(
    ("was", "now", "message"),
    [
        ("    z: 0.16241\n", "", "shoulder: z is missing"),
        ("0.16241", "tall", "line 5: shoulder, z holds 'tall'"),
        ("kinematics", "dynamics", "no key 'kinematics'"),
        ("kinematics", "delta_theta", "ur_calibration"),
        ("  wrist_3", "  wrist_9", "wrist_3: x is missing"),
    ],
)
def test_a_calibration_that_is_none_is_refused_where_it_is_wrong(tmp_path, was, now, message):
    path = tmp_path / "ur.yaml"
    path.write_text(CALIBRATION.replace(was, now))
    with pytest.raises(InputError, match=message):
        pieper.ur_calibrated(path)


def test_a_calibration_in_braces_or_behind_a_mark_is_the_same_and_other_units_are_refused(tmp_path):
    import yaml

    frames = yaml.safe_load(CALIBRATION)
    texts = {
        "mark": "\ufeff" + CALIBRATION,
        "braces": yaml.safe_dump(frames, default_flow_style=True, width=60),
        "json": json.dumps(frames),
    }
    (tmp_path / "own.yaml").write_text(CALIBRATION)
    q = np.random.default_rng(5).uniform(-3, 3, (10, 6))
    wanted = pieper.ur_calibrated(tmp_path / "own.yaml").fk(q)
    for name, text in texts.items():
        path = tmp_path / f"{name}.yaml"
        path.write_text(text, encoding="utf-8")
        assert np.abs(pieper.ur_calibrated(path).fk(q) - wanted).max() < 1e-15, name
    own = {link: f for link, f in frames["kinematics"].items() if isinstance(f, dict)}
    for keys, factor, words in (("x y z", 1000, "millimetres"), ("roll pitch yaw", 180 / np.pi, "degrees")):
        other = {
            link: {key: float(value) * (factor if key in keys.split() else 1) for key, value in f.items()}
            for link, f in own.items()
        }
        (tmp_path / "other.yaml").write_text(yaml.safe_dump({"kinematics": other}))
        with pytest.raises(InputError, match=words):
            pieper.ur_calibrated(tmp_path / "other.yaml")


def test_a_calibration_that_is_not_there_or_no_text_is_refused(tmp_path):
    with pytest.raises(InputError, match="no file"):
        pieper.ur_calibrated(tmp_path / "none.yaml")
    (tmp_path / "bytes.yaml").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(InputError, match="UTF-8"):
        pieper.ur_calibrated(tmp_path / "bytes.yaml")


@pytest.mark.parametrize(
    ("said", "word"),
    [
        ({"rows": [(300, 0, 400, 0), (200, 0, 0, 0)]}, "links between the joints of this arm add up to"),
        ({"tool": pieper.pose(100, 0, 0)}, "tool stands from the last axis by 100"),
        ({"rows": [(0.3, 0, 0.4, 0), (200, 0, 0, 0)]}, "tool stands from the last axis by 200"),
        ({"rows": [(0.3, 90, 0.4, 0), (0.2, 0, 0, 0)]}, "looks like degrees"),
        ({"base": pieper.pose(500, 0, 0)}, "base stands away"),
        ({"offset": [0, -90]}, "degrees"),
        ({"joint_types": "RP", "limits": [None, (0, 400)]}, "slide's limits"),
    ],
)
def test_millimetres_and_degrees_in_a_table_are_warned_of(said, word):
    rows = [pieper.DH(*row) for row in said.pop("rows", [(0.3, 0, 0.4, 0), (0.2, 0, 0, 0)])]
    with pytest.warns(pieper.PieperWarning, match=word):
        pieper.Arm.from_dh(rows, convention="standard", **said)


@pytest.mark.parametrize("snap", [-1, float("nan"), "x", 0.5])
def test_a_snap_that_is_none_is_refused_when_the_arm_is_made(snap):
    with pytest.raises(pieper.InputError, match="snap"):
        pieper.Arm.from_dh([pieper.DH(a=1)], convention="standard", snap=snap)
    with pytest.raises(pieper.InputError, match="snap"):
        pieper.load("three-r", snap=snap)


def test_a_length_that_no_number_holds_is_refused_with_its_row():
    with pytest.raises(pieper.InputError, match="row 1 .*1e\\+300"):
        pieper.Arm.from_dh([pieper.DH(a=1e300)], convention="standard")


@pytest.mark.parametrize("ending", [".json", ".yaml", ".urdff", ".xyz"])
def test_an_ending_that_is_none_of_ours_is_refused_with_one_that_is(ending, tmp_path):
    with pytest.raises(pieper.InputError, match=r"written as \.toml or \.urdf"):
        pieper.load("three-r").save(tmp_path / f"arm{ending}")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("typed", "first"), [("ur5ee", "universal-robots-ur5e"), ("kuka iiwa", "kuka-lbr-iiwa-14-r820")]
)
def test_the_name_that_was_meant_is_offered_first(typed, first):
    with pytest.raises(pieper.InputError, match=f"Did you mean {first}"):
        pieper.load(typed)


def test_links_that_nobody_declared_and_joints_without_a_name_are_told():
    inside = '<parent link="a"/><child link="b"/><axis xyz="0 0 1"/><limit lower="-1" upper="1"/>'
    text = f'<robot name="r"><link name="a"/><joint name="{{}}" type="revolute">{inside}</joint></robot>'
    assert any("b is named by a joint and not declared" in note for note in urdf.loads(text.format("j")).remarks)
    with pytest.raises(pieper.InputError, match="line 1: a joint has no name"):
        urdf.loads(text.format(""))


def test_a_joint_that_mimics_none_of_the_file_is_refused_and_is_no_finger():
    text = robot(
        joint("j1", "b", "l1"), joint("j2", "l1", "l2", axis="0 1 0", extra='<mimic joint="zz" multiplier="1"/>')
    )
    with pytest.raises(pieper.InputError, match="'j2' mimics 'zz', which is not another joint.*take the <mimic> out"):
        urdf.loads(text)
