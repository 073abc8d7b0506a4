"""An arm changed into another arm: what it was stays what it was."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from pieper import DH, InputError

ARMS = ("denso-vp6242", "universal-robots-ur5e", "franka-panda", "stanford-arm", "adept-cobra-600", "kuka-kr16-2")


def joints(arm, count=20):
    return np.random.default_rng(4).uniform(-2, 2, (count, arm.n))


@pytest.mark.parametrize("name", ARMS)
def test_a_tool_and_a_base_stand_where_they_are_said_to(name):
    arm, T = pieper.load(name), pieper.pose(0.1, 0.2, 0.3, rpy=(0.1, 0.2, 0.3))
    q = joints(arm)
    flange = arm.fk(q) @ np.linalg.inv(arm.tool)
    assert np.abs(arm.with_tool(T).fk(q) - flange @ T).max() < 1e-13
    assert np.abs(arm.with_base(T).fk(q) - T @ np.linalg.inv(arm.base) @ arm.fk(q)).max() < 1e-13
    assert np.array_equal(arm.with_tool(T).tool, T) and arm.with_tool(T).limits is arm.limits


@pytest.mark.parametrize("name", ARMS)
def test_the_other_convention_is_the_same_arm_and_comes_back_unchanged(name):
    arm = pieper.load(name)
    other = "modified" if arm.description.convention == "standard" else "standard"
    turned = arm.to(other)
    assert turned.description.convention == other
    assert np.abs(turned.fk(joints(arm)) - arm.fk(joints(arm))).max() < 1e-13
    back = turned.to(arm.description.convention)
    assert np.abs(back.fk(joints(arm)) - arm.fk(joints(arm))).max() < 1e-13
    assert arm.to(arm.description.convention).description is arm.description


@pytest.mark.parametrize("name", ARMS)
def test_a_reversed_arm_gives_the_inverse_pose_of_the_reversed_joints(name):
    arm = pieper.load(name)
    turned = arm.reversed()
    assert np.abs(turned.fk(joints(arm)[:, ::-1]) @ arm.fk(joints(arm)) - np.eye(4)).max() < 1e-12
    assert turned.joint_names == arm.joint_names[::-1] and np.array_equal(turned.limits, arm.limits[::-1])
    assert np.abs(turned.reversed().fk(joints(arm)) - arm.fk(joints(arm))).max() < 1e-13


@pytest.mark.parametrize("name", ARMS)
def test_a_locked_joint_is_the_joint_held_there(name):
    arm = pieper.load(name)
    for k in range(arm.n):
        value = float(np.clip(0.3, *arm.limits[k]))
        held = arm.with_joints_locked({arm.joint_names[k]: value})
        q = joints(arm)
        q[:, k] = value
        assert np.abs(held.fk(np.delete(q, k, 1)) - arm.fk(q)).max() < 1e-12
        assert held.joint_names == arm.joint_names[:k] + arm.joint_names[k + 1 :]
        assert np.array_equal(held.limits, np.delete(arm.limits, k, 0))


def test_several_joints_are_locked_at_once_and_it_is_noted():
    arm = pieper.load("franka-panda")
    held = arm.with_joints_locked({arm.joint_names[4]: 0.5, arm.joint_names[2]: -0.25})
    q = joints(arm)
    q[:, 4], q[:, 2] = 0.5, -0.25
    assert np.abs(held.fk(q[:, [0, 1, 3, 5, 6]]) - arm.fk(q)).max() < 1e-12
    assert held.notes == (f"{arm.joint_names[2]} is held at -0.25 rad.", f"{arm.joint_names[4]} is held at 0.5 rad.")


def test_coupled_joints_are_changed_too():
    C = [[1, 0, 0, 0], [0, 1, 0, 0], [0, -1, 1, 0], [0, 0, 0.5, 1]]
    rows = [DH(alpha=np.pi / 2, d=0.4), DH(a=0.5), DH(a=0.1, alpha=np.pi / 2), DH(d=0.2, a=0.1)]
    arm = pieper.Arm.from_dh(rows, convention="standard", coupling=C, sign=[1, -1, 1, -1], offset=[0.1, 0.2, 0.3, 0.4])
    q = joints(arm)
    assert np.abs(arm.to("modified").fk(q) - arm.fk(q)).max() < 1e-14
    assert np.abs(arm.reversed().fk(q[:, ::-1]) @ arm.fk(q) - np.eye(4)).max() < 1e-14
    q[:, 1] = 0.7
    held = arm.with_joints_locked({"joint_2": 0.7})
    assert np.abs(held.fk(q[:, [0, 2, 3]]) - arm.fk(q)).max() < 1e-14
    with pytest.raises(InputError, match="joint_3 cannot be held: .* moves with joint_2"):
        arm.with_joints_locked({"joint_3": 0.0})


def test_limits_are_changed_by_name():
    arm = pieper.load("denso-vp6242").with_limits({"joint_2": (-1, 0.5), "joint_6": None, "joint_1": (None, 2)})
    assert arm.limits[1].tolist() == [-1, 0.5] and np.isinf(arm.limits[5]).all()
    assert arm.limits[0].tolist() == [-np.inf, 2] and np.array_equal(
        arm.limits[2:5], pieper.load("denso-vp6242").limits[2:5]
    )


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda arm: arm.with_limits({"elbow": (0, 1)}), "no joint 'elbow'; its joints are joint_1"),
        (lambda arm: arm.with_limits({"joint_1": (1, 0)}), "swapped"),
        (lambda arm: arm.with_limits([(0, 1)] * 6), "dict from joint names"),
        (lambda arm: arm.with_joints_locked({"joint_9": 0}), "no joint 'joint_9'"),
        (lambda arm: arm.with_joints_locked({"joint_1": np.nan}), "joint_1 is held at must be a finite number"),
        (lambda arm: arm.with_joints_locked(dict.fromkeys(arm.joint_names, 0)), "every joint would be held"),
        (lambda arm: arm.to("hayati"), "'standard' or 'modified'"),
        (lambda arm: arm.with_tool(np.eye(3)), "tool must have shape"),
        (lambda arm: arm.with_base(np.zeros((4, 4))), "base"),
        (lambda arm: arm.with_tool("pen"), "no tool 'pen': it has none by name"),
    ],
)
def test_what_cannot_be_changed_is_refused(change, message):
    with pytest.raises(InputError, match=message):
        change(pieper.load("denso-vp6242"))


def test_postures_follow_the_joints():
    arm = pieper.load("universal-robots-ur5e")
    assert np.array_equal(arm.reversed().postures["upright"], arm.postures["upright"][::-1])
    assert "zero" in arm.postures and arm.with_joints_locked({arm.joint_names[0]: 1.0}).postures.keys() == {"zero"}


def test_a_joint_is_not_held_outside_its_limits():
    arm = pieper.load("denso-vp6242").with_limits({"joint_3": (-4.36, -1.92)})
    with pytest.raises(pieper.InputError, match=r"joint_3 cannot be held at 0 rad.*limits -4.36 to -1.92 rad") as told:
        arm.with_joints_locked({"joint_3": 0})
    assert told.value.data["joint"] == "joint_3" and told.value.data["allowed"] == (-4.36, -1.92)
    with pytest.raises(pieper.InputError, match=r"If -120 degrees was meant, write -2.0944"):
        arm.with_joints_locked({"joint_3": -120})
    assert arm.with_joints_locked({"joint_3": -4.36}).n == 5
    slide = pieper.Arm.from_dh([DH(), DH(a=0.1)], convention="standard", joint_types="PR", limits=[(0, 0.4), None])
    with pytest.raises(pieper.InputError, match=r"If 200 mm was meant, write 0.2"):
        slide.with_joints_locked({"joint_1": 200})
    with pytest.warns(pieper.PieperWarning, match="looks like degrees"):
        slide.with_joints_locked({"joint_2": 99})
