"""URDF chains become DH tables whose forward kinematics is that of the URDF."""

from __future__ import annotations

import math

import numpy as np
import pytest

import pieper
from oracle.products import product
from pieper.description import catalog, robotfile, urdf
from pieper.description.commonnormal import standard_table
from pieper.errors import InputError
from tests.description.urdf_samples import ARM, LIMITS, joint, robot


def pose_of(xyz, rpy):
    """Return the pose of a URDF origin, by elementary matrices."""
    T = np.eye(4)
    for i, j, angle in ((0, 1, rpy[2]), (2, 0, rpy[1]), (1, 2, rpy[0])):
        M = np.eye(4)
        M[i, i] = M[j, j] = math.cos(angle)
        M[i, j], M[j, i] = -math.sin(angle), math.sin(angle)
        T = T @ M
    T[:3, 3] = xyz
    return T


def motion(axis, q, kind):
    """Return the pose that a URDF joint adds, by the exponential series."""
    axis = np.array(axis) / np.linalg.norm(axis)
    M = np.eye(4)
    if kind == "prismatic":
        M[:3, 3] = axis * q
        return M
    K = np.cross(np.eye(3), axis)
    term = total = np.eye(3)
    for k in range(1, 40):
        term = term @ K * q / k
        total = total + term
    M[:3, :3] = total
    return M


#: A six-joint arm as makers draw it: no rotations, axes named, tool0 turned.
FANUC_LIKE = [
    ((0, 0, 0.45), (0, 0, 0), (0, 0, 1)),
    ((0.15, 0, 0), (0, 0, 0), (0, 1, 0)),
    ((0, 0, 0.79), (0, 0, 0), (0, -1, 0)),
    ((0, 0, 0.25), (0, 0, 0), (-1, 0, 0)),
    ((0.835, 0, 0), (0, 0, 0), (0, -1, 0)),
    ((0.1, 0, 0), (0, 0, 0), (-1, 0, 0)),
]


def chain_text(chain, kinds=None):
    kinds = kinds or ["revolute"] * len(chain)
    spell = lambda numbers: " ".join(repr(float(v)) for v in numbers)  # noqa: E731
    return robot(
        *(
            joint(f"j{i + 1}", f"l{i}", f"l{i + 1}", spell(xyz), spell(rpy), spell(axis), kind)
            for i, ((xyz, rpy, axis), kind) in enumerate(zip(chain, kinds, strict=True))
        )
    )


def chain_pose(chain, q, kinds=None):
    kinds = kinds or ["revolute"] * len(chain)
    T = np.eye(4)
    for (xyz, rpy, axis), value, kind in zip(chain, q, kinds, strict=True):
        T = T @ pose_of(xyz, rpy) @ motion(axis, value, kind)
    return T


def test_an_industrial_arm_keeps_its_forward_kinematics_to_rounding():
    rng = np.random.default_rng(1)
    arm = urdf.loads(chain_text(FANUC_LIKE))
    for q in rng.uniform(-2, 2, (20, 6)):
        assert np.abs(product(arm, q) - chain_pose(FANUC_LIKE, q)).max() < 5e-15


def test_random_chains_with_slides_and_slanted_axes_keep_their_forward_kinematics():
    rng = np.random.default_rng(2)
    for _ in range(100):
        n = int(rng.integers(1, 8))
        kinds = [str(k) for k in rng.choice(["revolute", "continuous", "prismatic"], n)]
        turns = [0, math.pi / 2, -math.pi / 2, math.pi, 0.3, -1.1]
        chain = [
            (rng.choice([0, 0, 0.4, -0.25], 3), rng.choice(turns, 3), rng.choice([0.0, 1.0, -0.5], 3) + [0, 0, 0.25])
            for _ in range(n)
        ]
        arm = urdf.loads(chain_text(chain, kinds))
        q = rng.uniform(-2, 2, n)
        assert np.abs(product(arm, q) - chain_pose(chain, q, kinds)).max() < 2e-14


def test_a_dh_table_drawn_as_a_urdf_comes_back_as_the_same_table():
    for name in ("denso-vp6242", "universal-robots-ur5e", "motoman-ea1400n", "fanuc-crx-10ia"):
        arm = catalog.load(name)
        axes, points, T = [], [], np.eye(4)
        for row in arm.rows:
            axes.append(T[:3, 2].copy())
            points.append(T[:3, 3].copy())
            T = T @ pose_of((0, 0, row.d), (0, 0, row.theta)) @ pose_of((row.a, 0, 0), (row.alpha, 0, 0))
        table = standard_table(np.array(axes), np.array(points), T)
        assert table.rows == arm.rows
        assert np.array_equal(table.base, np.eye(4)) and np.array_equal(table.tool, np.eye(4))


def test_quarter_turns_typed_with_few_digits_are_read_as_exact_and_reported():
    tool = joint("t", "l6", "tool0", rpy="3.1416 -1.5708 0", kind="fixed")
    short = chain_text(FANUC_LIKE).replace("</robot>", tool + "</robot>")
    arm = urdf.loads(short)
    exact = chain_pose(FANUC_LIKE, np.zeros(6)) @ pose_of((0, 0, 0), (math.pi, -math.pi / 2, 0))
    assert np.abs(product(arm, np.zeros(6)) - exact).max() < 5e-15
    assert "2 angles" in arm.notes and "7.3e-06 rad" in arm.notes


def test_every_digit_counts_when_asked_for():
    text = robot(joint("a", "x", "y"), joint("b", "y", "z", xyz="0.3 0 0", rpy="1.5708 0 0"))
    arm = urdf.loads(text, exact_angles=False)
    assert arm.rows[0].alpha == pytest.approx(1.5708, abs=1e-15) and arm.notes == ""


def test_an_angle_that_is_no_multiple_stays_what_it_is():
    text = robot(joint("a", "x", "y"), joint("b", "y", "z", xyz="0.3 0 0", rpy="1.57 0 0"))
    assert urdf.loads(text).rows[0].alpha == pytest.approx(1.57, abs=1e-15)


def test_limits_names_and_kinds_are_taken_over():
    text = robot(
        joint("turn", "a", "b", extra='<limit lower="-1.5" upper="2.5"/>'),
        joint("spin", "b", "c", kind="continuous", extra=""),
        joint("slide", "c", "d", kind="prismatic", extra='<limit upper="0.3"/>'),
    )
    arm = urdf.loads(text)
    assert arm.joint_names == ("turn", "spin", "slide") and arm.joint_types == "RRP"
    assert arm.limits.tolist() == [[-1.5, 2.5], [-math.inf, math.inf], [0.0, 0.3]]


def test_base_and_tip_can_be_chosen():
    text = chain_text(FANUC_LIKE)
    arm = urdf.loads(text, base="l1", tip="l4")
    assert arm.joint_names == ("j2", "j3", "j4")
    q = [0.3, -0.4, 0.5]
    assert np.abs(product(arm, q) - chain_pose(FANUC_LIKE[1:4], q)).max() < 5e-15


def test_tool0_is_the_tip_where_there_is_one():
    text = chain_text(FANUC_LIKE).replace(
        "</robot>",
        joint("f", "l6", "tool0", xyz="0 0 0.1", kind="fixed") + joint("c", "l6", "camera", kind="fixed") + "</robot>",
    )
    assert "to tool0" in urdf.loads(text).source


def test_two_equal_branches_have_to_be_told_apart():
    text = robot(joint("a", "x", "left"), joint("b", "x", "right"))
    with pytest.raises(InputError, match="several chains.*left, right"):
        urdf.loads(text)
    assert urdf.loads(text, tip="right").joint_names == ("b",)


def test_a_urdf_arm_can_be_saved_as_a_robot_file(tmp_path):
    arm = urdf.loads(chain_text(FANUC_LIKE))
    path = robotfile.write(arm, tmp_path / "arm.toml")
    q = np.linspace(-1, 1, 6)
    assert np.array_equal(product(robotfile.read(path), q), product(arm, q))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("<!DOCTYPE robot [<!ENTITY a 'b'>]><robot name='x'/>", "document type"),
        ("<!DOCTYPE robot SYSTEM 'file:///etc/passwd'><robot name='x'/>", "document type"),
        ("not xml", "not valid XML"),
        ("<robot name='x'>", "not valid XML"),
        ("<html></html>", "begins with <robot>"),
        ("<robot name='x'/>", "no joint"),
        ('<robot name="x"><joint name="${p}a" type="fixed"/></robot>', "xacro"),
        (robot(joint("a", "x", "y", kind="fixed", extra="")), "no moving joint"),
        (robot(joint("a", "x", "y", kind="floating")), "floating"),
        (robot(joint("a", "x", "y", extra=LIMITS + '<mimic joint="b"/>')), "mimics 'b'"),
        (robot(joint("a", "x", "y"), joint("a", "y", "z")), "there twice"),
        (robot(joint("a", "x", "z"), joint("b", "y", "z")), "hangs from two joints"),
        (robot(joint("a", "x", "y"), joint("b", "y", "x")), "ring"),
        (robot(joint("a", "x", "y", axis="0 0 0")), "no direction"),
        (robot(joint("a", "x", "y", axis="0 0 nan")), "not a finite number"),
        (robot(joint("a", "x", "y", xyz="0 0")), "three numbers"),
        (robot(joint("a", "x", "y", extra='<limit lower="2" upper="1"/>')), "swapped"),
        (robot(joint("a", "x", "y", extra="")), "needs limits"),
    ],
)
def test_what_is_no_serial_arm_is_refused_with_its_reason(text, message):
    tip = "y" if "joint name" in text and "<child" in text and "ring" not in message else None
    with pytest.raises(InputError, match=message):
        urdf.loads(text, tip=tip if message not in ("hangs from two joints",) else None)


def test_a_bomb_of_entities_is_refused_before_it_grows():
    layers = "".join(f'<!ENTITY e{i + 1} "{f"&e{i};" * 10}">' for i in range(12))
    with pytest.raises(InputError, match="document type"):
        urdf.loads(f'<!DOCTYPE r [<!ENTITY e0 "x">{layers}]><robot name="&e12;"/>')


def test_unknown_links_are_answered_with_the_known_ones():
    with pytest.raises(InputError, match="no link 'hand'.*l0"):
        urdf.loads(chain_text(FANUC_LIKE), tip="hand")


def test_a_missing_file_is_said_to_be_missing(tmp_path):
    with pytest.raises(InputError, match="no file"):
        urdf.read(tmp_path / "none.urdf")


def test_of_two_origins_of_a_joint_the_first_counts_and_that_is_said(tmp_path):
    twice = ARM[0].replace("<axis", '<origin xyz="0 0 9" rpy="0 0 1"/><axis').replace("</joint>", f"{LIMITS}</joint>")
    file, plain = tmp_path / "twice.urdf", tmp_path / "plain.urdf"
    file.write_text(robot(twice, *ARM[1:]))
    plain.write_text(robot(*ARM))
    arm, q = pieper.load(file), [0.3, 0.2, -0.4]
    assert np.array_equal(arm.fk(q), pieper.load(plain).fk(q))
    assert "Joint 'a' has more than one <origin>: the first counts, as in ROS." in arm.notes
    assert not pieper.load(plain).notes
