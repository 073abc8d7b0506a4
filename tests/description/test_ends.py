"""Where an arm begins and ends: choices are listed, grippers end it before them, and nothing is taken in silence."""

from __future__ import annotations

import numpy as np
import pytest

from pieper.description import urdf
from pieper.errors import InputError
from tests.description.urdf_samples import ARM, fixed, joint, robot, slide


def test_two_frames_on_the_same_joints_are_listed_whatever_their_order_in_the_file():
    camera = fixed("cf", "l3", "camera_link", "0 0.05 0.02", "3.14159265359 0 0")
    end = fixed("ef", "l3", "end_effector_link", "0.1 0 0")
    for ends in ((camera, end), (end, camera)):
        with pytest.raises(InputError, match="several frames end the same joints") as caught:
            urdf.loads(robot(*ARM, *ends))
        assert {choice["tip"] for choice in caught.value.choices} == {"camera_link", "end_effector_link"}
        assert all(choice["joints"] == ["a", "b", "c"] for choice in caught.value.choices)
    assert urdf.loads(robot(*ARM, camera, end), tip="camera_link").source.endswith("to camera_link")


def test_a_dummy_link_for_collisions_is_listed_too():
    with pytest.raises(InputError, match="'hand' or 'l3_sc'"):
        urdf.loads(robot(*ARM, fixed("h", "l3", "hand", "0 0 0.1"), fixed("s", "l3", "l3_sc", "0.01 0 0")))


def test_frames_in_one_place_are_no_choice():
    arm = urdf.loads(robot(*ARM, fixed("x", "l3", "one"), fixed("y", "l3", "other")))
    assert arm.n == 3 and arm.remarks == ()


def test_tool0_is_taken_for_its_name_and_the_others_are_said():
    arm = urdf.loads(robot(*ARM, fixed("f", "l3", "tool0", "0 0 0.1"), fixed("k", "l3", "camera")))
    assert arm.source.endswith("to tool0")
    assert arm.remarks == ("'tool0' was taken for the tool by its name; the file also ends in camera.",)


def test_two_arms_are_asked_for_with_the_joints_of_each():
    left = [joint(f"left_{i}", "base" if i == 0 else f"left_l{i - 1}", f"left_l{i}") for i in range(3)]
    right = [joint(f"right_{i}", "base" if i == 0 else f"right_l{i - 1}", f"right_l{i}") for i in range(2)]
    with pytest.raises(InputError, match="several chains") as caught:
        urdf.loads(robot(*left, *right))
    assert [choice["joints"] for choice in caught.value.choices] == [
        ["left_0", "left_1", "left_2"],
        ["right_0", "right_1"],
    ]
    assert urdf.loads(robot(*left, *right), tip="right_l1").joint_names == ("right_0", "right_1")


def test_from_hand_to_hand_is_a_chain_through_both_arms():
    left, right = joint("left", "base", "lh", "0 0.2 0"), joint("right", "base", "rh", "0 -0.2 0", axis="0 1 0")
    both = urdf.loads(robot(left, right, fixed("e", "lh", "lt", "0.3 0 0")), base="lt", tip="rh")
    assert both.joint_names == ("left", "right")
    one = urdf.loads(robot(left, fixed("e", "lh", "lt", "0.3 0 0")), tip="lt")
    other = urdf.loads(robot(right), tip="rh")
    q = np.array([0.4, -0.7])
    wanted = np.linalg.inv(_fk(one, q[:1])) @ _fk(other, q[1:])
    assert np.abs(_fk(both, q) - wanted).max() < 1e-14


def _fk(arm, q):
    from pieper import Arm

    return Arm(arm).fk(q)


@pytest.mark.parametrize(
    "ends",
    [
        (slide("f1", "l3", "left_finger"), slide("f2", "l3", "right_finger")),
        (slide("f1", "l3", "p1"), slide("f2", "l3", "p2", extra='<mimic joint="f1"/>')),
        (slide("f1", "l3", "p1"), slide("f2", "l3", "p2")),
        (slide("f1", "l3", "p1"),),
        (joint("jaw_joint", "l3", "moving"), fixed("fj", "l3", "fixed_jaw")),
        (joint("gripper", "l3", "x"),),
        (joint("k", "l3", "left_inner_knuckle"), joint("m", "l3", "y", extra='<mimic joint="k"/>')),
        (joint("p", "l3", "finger_1_proximal"), joint("d", "finger_1_proximal", "finger_1_distal")),
        (fixed("h", "l3", "hand"), slide("f1", "hand", "leftfinger"), slide("f2", "hand", "rightfinger")),
    ],
)
def test_fingers_and_jaws_end_the_arm_before_them_and_it_is_said(ends):
    arm = urdf.loads(robot(*ARM, *ends))
    assert arm.joint_names == ("a", "b", "c")
    assert "gripper was left out" in arm.remarks[0] and "tip=" in arm.remarks[0]
    assert arm.source.endswith(("to l3", "to hand"))


def test_a_finger_is_a_joint_of_the_arm_when_the_tip_says_so():
    ends = (slide("f1", "l3", "left_finger"), slide("f2", "l3", "right_finger"))
    assert urdf.loads(robot(*ARM, *ends), tip="left_finger").joint_types == "RRRP"


@pytest.mark.parametrize("name", ["gripper_roll", "gripperYaw", "wrist_gripper_joint"])
def test_a_wrist_that_turns_the_gripper_is_a_joint_of_the_arm(name):
    fingers = (slide("f1", "gripper", "left_finger"), slide("f2", "gripper", "right_finger"))
    arm = urdf.loads(robot(*ARM, joint(name, "l3", "gripper"), *fingers))
    assert arm.joint_names == ("a", "b", "c", name)


def test_a_joint_that_turns_a_link_named_gripper_with_fingers_on_it_is_a_wrist():
    fingers = (slide("f1", "gripper", "left_finger"), slide("f2", "gripper", "right_finger"))
    assert urdf.loads(robot(*ARM, joint("j6", "l3", "gripper"), *fingers)).n == 4


def test_the_quill_of_a_scara_and_the_axes_of_a_gantry_are_no_fingers():
    scara = robot(
        joint("a", "base", "l1"), joint("b", "l1", "l2", "0.3 0 0"), slide("z", "l2", "l3", 0.0, 0.2, "0 0 1")
    )
    assert urdf.loads(scara).joint_types == "RRP"
    gantry = robot(slide("x", "base", "l1", 0, 0.05), slide("y", "l1", "l2", 0, 0.05), slide("z", "l2", "l3", 0, 0.05))
    assert urdf.loads(gantry).joint_types == "PPP"


def test_wheels_are_left_out_and_said():
    wheels = [joint(f"wheel_{i}", "base", f"wheel_link_{i}", kind="continuous", extra="") for i in range(4)]
    arm = urdf.loads(robot(*wheels, *ARM))
    assert arm.n == 3 and "Wheels were left out" in arm.remarks[0]


def test_what_moves_beside_the_arm_is_said_to_be_beside_it():
    cylinder = joint("cylinder", "l1", "piston", extra='<limit lower="-1" upper="1"/><mimic joint="b"/>')
    arm = urdf.loads(robot(*ARM, cylinder))
    assert arm.n == 3 and arm.remarks == ("Beside the arm and not part of it: joint 'cylinder'.",)


def test_a_hand_alone_is_asked_for_a_tip():
    fingers = (slide("f1", "palm", "left_finger"), slide("f2", "palm", "right_finger"))
    with pytest.raises(InputError, match="looks like one of a gripper.*left_finger, right_finger"):
        urdf.loads(robot(*fingers))


def test_a_frame_beside_the_chain_may_be_base_or_tip():
    side = fixed("s", "base", "controller", "0 0 0", "0 0 3.14159265358979")
    text = robot(side, *ARM)
    forward = urdf.loads(text, base="controller")
    assert forward.joint_names == ("a", "b", "c")
    backward = urdf.loads(text, base="l3", tip="controller")
    assert backward.joint_names == ("c", "b", "a")
    q = np.array([0.3, -0.5, 0.7])
    assert np.abs(_fk(forward, q) @ _fk(backward, q[::-1]) - np.eye(4)).max() < 1e-14
    plain = urdf.loads(text)
    assert np.abs(_fk(forward, q) - np.diag([-1, -1, 1, 1]) @ _fk(plain, q)).max() < 1e-14


@pytest.mark.parametrize("kind", ["planar", "ball"])
def test_a_joint_of_another_kind_inside_the_chain_is_named_with_a_cure(kind):
    with pytest.raises(InputError, match=f"joint 'free' is of type '{kind}'.*base='root'"):
        urdf.loads(robot(joint("free", "world", "root", kind=kind), joint("a", "root", "b"), joint("c", "b", "d")))
    text = robot(joint("free", "world", "root", kind=kind), joint("a", "root", "b"), joint("c", "b", "d"))
    assert urdf.loads(text, base="root").n == 2


def test_a_robot_that_floats_as_a_whole_begins_after_that_and_a_floating_joint_further_on_is_named():
    free = joint("free", "world", "root", kind="floating")
    arm = urdf.loads(robot(free, joint("a", "root", "b"), joint("c", "b", "d")))
    assert arm.n == 2 and "The robot floats (joint 'free'); its own body 'root' is the base." in arm.remarks
    with pytest.raises(InputError, match="joint 'free' is of type 'floating'"):
        urdf.loads(robot(joint("a", "root", "b"), joint("free", "b", "e", kind="floating"), joint("c", "e", "d")))


def test_two_roots_are_asked_for_by_their_bases():
    with pytest.raises(InputError, match="2 separate robots.*base='x' .joints a.*base='p' .joints b"):
        urdf.loads(robot(joint("a", "x", "y"), joint("b", "p", "q")))
    assert urdf.loads(robot(joint("a", "x", "y"), joint("b", "p", "q")), base="p").joint_names == ("b",)
    with pytest.raises(InputError, match="nor do both hang from a third link"):
        urdf.loads(robot(joint("a", "x", "y"), joint("b", "p", "q")), base="x", tip="q")


def test_names_with_blanks_and_letters_of_any_language_are_names():
    arm = urdf.loads(robot(joint("Achse eins", "Fuß", "Arm links"), joint("第二轴", "Arm links", "末端 工具")))
    assert arm.joint_names == ("Achse eins", "第二轴")
    assert urdf.loads(
        robot(joint("Achse eins", "Fuß", "Arm links"), joint("第二轴", "Arm links", "末端 工具")), tip="Arm links"
    ).joint_names == ("Achse eins",)


def test_limits_of_zero_and_zero_are_asked_about_and_may_be_taken_as_none():
    text = robot(joint("a", "x", "y", extra='<limit lower="0" upper="0"/>'), joint("b", "y", "z"))
    with pytest.raises(InputError, match="'a' is revolute and cannot move.*missing_limits='unlimited'"):
        urdf.loads(text)
    arm = urdf.loads(text, missing_limits="unlimited")
    assert np.isinf(arm.limits[0]).all() and arm.limits[1].tolist() == [-2, 2]
    assert arm.remarks == ("No range is given for a: taken as unlimited.",)
    with pytest.raises(InputError, match="'refuse' or 'unlimited'"):
        urdf.loads(text, missing_limits="ignore")


def test_limits_that_exporters_write_for_none_are_none():
    arm = urdf.loads(robot(joint("a", "x", "y", extra='<limit lower="-1e16" upper="1e16"/>')))
    assert np.isinf(arm.limits).all() and "taken as none: a" in arm.remarks[0]
