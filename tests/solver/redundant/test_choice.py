"""Held joints: any that moves along the self-motions can be chosen, and what cannot be is refused with a reason."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle.joints import turns_apart
from pieper import DH, Arm, InputError, Status

ARMS = ["franka-panda", "kuka-lbr-iiwa-14-r820", "rethink-sawyer"]


@pytest.mark.parametrize("name", ARMS)
def test_any_joint_can_be_held_and_the_posture_is_found_again(name):
    arm = pieper.load(name)
    rng = np.random.default_rng(4)
    q = rng.uniform(*np.clip(arm.limits, -2.5, 2.5).T, (20, 7))
    T = arm.fk(q)
    for joint, called in enumerate(arm.joint_names):
        try:
            many = arm.ik_many(T, threads=1, redundancy={called: q[:, joint]})
        except InputError as refused:
            assert "pose alone decides" in str(refused) and joint == 3 and "iiwa" in name
            continue
        gap = turns_apart(many.q, q[:, None]).max(-1)
        assert (np.where(many.valid, gap, 9.0).min(1) < 1e-6).all()
        held = np.abs((many.q[..., joint] - q[:, None, joint])[many.valid])
        assert held.max() < 1e-9
        one = arm.ik(T[0], redundancy={called: q[0, joint]})
        np.testing.assert_allclose(one.all_q, many.q[0][many.valid[0]], atol=1e-9)
        assert one.status == Status.REDUNDANT


def test_two_joints_of_eight_can_be_held_and_one_alone_too():
    rng = np.random.default_rng(5)
    rows = [DH(rng.uniform(-0.5, 0.5), rng.uniform(-3, 3), rng.uniform(-0.5, 0.5)) for _ in range(8)]
    arm = Arm.from_dh(rows, convention="standard", limits=[(-2.0, 2.0)] * 8)
    q = rng.uniform(-1.5, 1.5, 8)
    names = arm.joint_names
    both = arm.ik(arm.fk(q), redundancy={names[1]: q[1], names[6]: q[6]})
    assert np.abs(both.all_q - q).max(1).min() < 1e-6
    one = arm.ik(arm.fk(q), redundancy={names[4]: q[4]})
    assert all(abs(row[4] - q[4]) < 1e-9 for row in one.all_q)


def test_what_cannot_be_held_is_refused_by_name():
    arm = pieper.load("franka-panda")
    T = arm.fk(np.array([0.1, 0.4, 0.2, -1.6, 0.1, 1.3, 0.4]))
    first, last = arm.joint_names[0], arm.joint_names[-1]
    with pytest.raises(InputError, match="outside its limits"):
        arm.ik(T, redundancy={first: 3.1})
    with pytest.raises(InputError, match="no joint of"):
        arm.ik(T, redundancy={"joint_99": 0.0})
    with pytest.raises(InputError, match="1 coordinate to spare"):
        arm.ik(T, redundancy={first: 0.0, last: 0.0})
    with pytest.raises(InputError, match="not both"):
        arm.ik(T, redundancy={first: 0.0, "arm angle": 0.0})
    with pytest.raises(InputError, match="finite"):
        arm.ik(T, redundancy={first: float("nan")})
    with pytest.raises(InputError, match="one number, or one a pose"):
        arm.ik_many(T[None], redundancy={first: [0.0, 1.0]})


def test_a_tool_roll_or_a_joint_can_be_held_of_an_arm_that_need_not_turn_its_tool():
    arm = pieper.load("denso-vp6242")
    q = np.array([0.3, 0.5, 1.1, 0.4, 0.7, 0.2])
    T = arm.fk(q)
    sols = arm.ik(T, task="position+axis", redundancy={"tool roll": 0.0})
    assert np.abs(sols.all_q - q).max(1).min() < 1e-6
    # along joint 6 the tool's roll and that joint are one: the rest is decided by the pose, and says so
    with pytest.raises(InputError, match="tool roll, joint_6 instead"):
        arm.ik(T, task="position+axis", redundancy={"joint_4": q[3]})
    arm = arm.with_tool(pieper.pose(0.05, 0.0, 0.1, rpy=(0.0, 0.6, 0.0)))
    T = arm.fk(q)
    sols = arm.ik(T, task="position+axis", redundancy={"joint_4": q[3]})
    assert np.abs(sols.all_q[:, 3] - q[3]).max() < 1e-9
    assert np.abs(sols.all_q - q).max(1).min() < 1e-6


def test_no_value_at_all_is_no_choice():
    arm = pieper.load("franka-panda")
    T = arm.fk([0, 0.1, 0, -1.5, 0, 1.6, 0.7])
    assert np.array_equal(arm.ik(T, redundancy={}).q, arm.ik(T).q) and len(arm.ik(T).q)
    assert arm.ik_many(T[None], redundancy={}).status[0] == Status.REDUNDANT


@pytest.mark.parametrize("held", [1, 5])
def test_where_two_axes_are_one_at_the_chosen_value_rows_hold_the_pose_and_the_value(held):
    # of an iiwa axes 1 and 3 are one line at joint 2 = 0, and 5 and 7 at joint 6 = 0: what is left has a freedom
    arm, q = pieper.load("kuka-lbr-iiwa-14-r820"), np.array([0.3, 0.7, -0.4, -1.2, 0.5, 0.9, -0.2])
    q[held] = 0.0
    T, chosen = arm.fk(q), {arm.joint_names[held]: 0.0}
    one, many = arm.ik(T, redundancy=chosen), arm.ik_many(T[None], redundancy=chosen)
    rows = many.found.q[0][many.found.valid[0]]
    assert len(one.all_q) == len(rows) >= 4
    for found in (one.all_q, rows):
        assert np.abs(arm.fk(found) - T).max() < 1e-12 and np.abs(found[:, held]).max() < 1e-9
    # the posture's own mirror images are among them: joint 4 as it is, and the sum about the line that is one
    a, b = held - 1, held + 1
    sums = turns_apart(one.all_q[:, a] + one.all_q[:, b], q[a] + q[b])
    assert (turns_apart(one.all_q[:, 3], q[3]) + sums).min() < 1e-8
