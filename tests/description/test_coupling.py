"""Coupled joints: what a controller calls a joint against the angle of the chain."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle.products import product
from pieper import DH, InputError
from pieper.description import robotfile, urdf
from pieper.description.coupling import chain_values, joint_values
from pieper.description.said import describe
from tests.description.urdf_samples import joint, robot

ROWS = [DH(alpha=np.pi / 2, d=0.4), DH(a=0.5), DH(a=0.1, alpha=np.pi / 2)]
#: The forearm of a parallelogram keeps its angle to the ground while joint 2 moves.
PARALLELOGRAM = [[1, 0, 0], [0, 1, 0], [0, -1, 1]]


def coupled(**said):
    return pieper.Arm.from_dh(ROWS, convention="standard", coupling=PARALLELOGRAM, **said)


def test_the_chain_moves_by_the_coupling_before_sign_and_offset():
    q = np.array([0.3, -0.5, 0.7])
    said = {"sign": [1, -1, -1], "offset": [0.1, 0.2, 0.3]}
    plain = pieper.Arm.from_dh(ROWS, convention="standard", **said)
    values = np.array([0.3, -0.5, 0.7 + 0.5])
    assert np.array_equal(coupled(**said).fk(q), plain.fk(values))
    assert np.array_equal(coupled(**said).frames([q, q]), plain.frames([values, values]))


def test_the_jacobian_is_the_derivative_by_the_joints_numbers():
    arm, q, h = coupled(), np.array([0.3, -0.5, 0.7]), 1e-6
    J = arm.jacobian(q)
    for i in range(3):
        step = np.zeros(3)
        step[i] = h
        change = (arm.fk(q + step)[:3, 3] - arm.fk(q - step)[:3, 3]) / (2 * h)
        assert np.abs(J[:3, i] - change).max() < 1e-9


def test_values_and_joints_lead_back_to_each_other():
    C = np.array(PARALLELOGRAM, float)
    q = np.random.default_rng(0).uniform(-3, 3, (4, 5, 3))
    assert np.abs(joint_values(chain_values(q, C), C) - q).max() < 1e-14
    assert chain_values(q, None) is q and joint_values(q, None) is q


def test_the_identity_is_no_coupling():
    arm = describe(ROWS, convention="standard", coupling=np.eye(3))
    assert arm.coupling is None and np.array_equal(pieper.Arm(arm).coupling, np.eye(3))


@pytest.mark.parametrize(
    ("coupling", "message"),
    [
        ([[1, 0], [0, 1]], "3 rows of 3"),
        ([[1, 0, 0], [0, 1, 0], [0, np.nan, 1]], "finite"),
        ("parallelogram", "3 rows of 3"),
        ([[1, 0], [0, 1], [0, 0]], None),
        ([[1, 0], [0, 0], [0, 0]], "joint_2 moves nothing"),
        ([[1, 1], [2, 2], [0, 0]], "singular: .*joint_1, .*joint_2 together"),
        ([[1, 0, 0], [0, 1, 1], [0, 1, 1]], "singular: .*joint_2, .*joint_3 together.*Change a row"),
        ([[1, 0, 0], [0, 0, 0], [0, 0, 1]], "joint_2 moves nothing"),
    ],
)
def test_a_coupling_that_is_none_is_refused(coupling, message):
    if message is None:  # an axis that never moves is a linkage's too
        assert describe(ROWS, convention="standard", coupling=coupling).n == 2
        return
    with pytest.raises(InputError, match=message):
        describe(ROWS, convention="standard", coupling=coupling)


def test_a_robot_file_keeps_the_coupling(tmp_path):
    arm = coupled(name="para")
    arm.save(tmp_path / "para.toml")
    back = pieper.load(tmp_path / "para.toml")
    assert np.array_equal(back.coupling, PARALLELOGRAM)
    text = (tmp_path / "para.toml").read_text()
    with pytest.raises(InputError, match="coupling: must be 3 rows"):
        robotfile.loads(text.replace("    [0, -1, 1],\n", ""))
    with pytest.raises(InputError, match="singular"):
        robotfile.loads(text.replace("[0, -1, 1]", "[0, 1, 0]"))


def test_a_urdf_says_the_coupling_by_joints_that_mimic(tmp_path):
    arm = coupled(name="para", limits=[(-2, 2)] * 3)
    arm.save(tmp_path / "para.urdf")
    back = pieper.load(tmp_path / "para.urdf")
    assert np.array_equal(back.coupling, PARALLELOGRAM) and np.array_equal(back.limits, arm.limits)
    q = np.random.default_rng(1).uniform(-2, 2, (20, 3))
    assert np.abs(back.fk(q) - arm.fk(q)).max() < 1e-12


MIMIC = '<mimic joint="j2" multiplier="-1" offset="0.25"/>'
PALLETIZER = (
    joint("j1", "b", "l1", "0 0 0.1"),
    joint("j2", "l1", "l2", "0 0 0.05", axis="0 1 0"),
    joint("j2m", "l2", "fake", "0 0 0.135", axis="0 1 0", extra=MIMIC),
    joint("j3", "fake", "l3", axis="0 1 0"),
    joint("j4", "l3", "l4", "0.147 0 0"),
)


def test_a_mimic_joint_on_the_axis_of_its_neighbour_is_a_coupling_and_said():
    arm = pieper.Arm(urdf.loads(robot(*PALLETIZER)))
    assert arm.joint_names == ("j1", "j2", "j3", "j4")
    assert arm.coupling.tolist() == [[1, 0, 0, 0], [0, 1, 0, 0], [0, -1, 1, 0], [0, 0, 0, 1]]
    assert "Joint 'j2m' mimics 'j2' on the axis of 'j3'" in arm.notes[0]
    freed = [
        text.replace('<mimic joint="j2" multiplier="-1" offset="0.25"/>', "<limit lower='-3' upper='3'/>")
        for text in PALLETIZER
    ]
    five = urdf.loads(robot(*freed))
    q = np.array([0.2, 0.6, -0.4, 0.9])
    assert np.abs(arm.fk(q) - product(five, [0.2, 0.6, 0.25 - 0.6, -0.4, 0.9])).max() < 1e-14


def test_a_mimic_joint_on_an_axis_of_its_own_is_moved_by_a_linkage_and_said():
    wrist = joint("level", "l3", "l4", "0.147 0 0", axis="0 1 0", extra='<mimic joint="j2" multiplier="-1"/>')
    text = robot(*PALLETIZER[:2], joint("j3", "l2", "l3", "0 0 0.2", axis="0 1 0"), wrist, joint("j4", "l4", "l5"))
    arm = pieper.Arm(urdf.loads(text))
    assert arm.joint_names == ("j1", "j2", "j3", "j4") and arm.description.axis_names[3] == "level"
    assert arm.coupling.tolist() == [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0], [0, 0, 0, 1]]
    assert any("'level' mimics 'j2' about an axis of its own: a linkage moves it" in note for note in arm.notes)
    q = np.array([0.2, 0.6, -0.4, 0.9])
    assert np.abs(arm.fk(q) - arm.uncoupled().fk([0.2, 0.6, -0.4, -0.6, 0.9])).max() < 1e-14
    assert urdf.loads(text, tip="l3").n == 3


def test_a_joint_that_mimics_none_of_this_arm_is_refused_by_name():
    text = robot(joint("a", "x", "y"), joint("b", "y", "z", extra='<mimic joint="c"/>'), joint("c", "y", "w"))
    with pytest.raises(InputError, match="'b' mimics 'c' and 'c' is not between"):
        urdf.loads(text, tip="z")


def test_a_leader_keeps_to_the_range_of_the_joints_that_follow_it():
    rng = np.random.default_rng(4)
    for _ in range(60):
        own, other = np.sort(rng.uniform(-3, 3, (2, 2)), axis=1)
        by, offset = rng.choice([-2.0, -0.7, 0.5, 1.0, 3.0]), rng.choice([0.0, 0.4])
        mimic = f'<mimic joint="b" multiplier="{by}" offset="{offset}"/>'
        follow = f'<limit lower="{float(other[0])}" upper="{float(other[1])}"/>{mimic}'
        lead = f'<limit lower="{float(own[0])}" upper="{float(own[1])}"/>'
        where, axis = ("0 0 0", "0 1 0") if rng.integers(2) else ("0.2 0 0.1", "0 1 0")
        text = robot(
            joint("a", "base", "l1"),
            joint("b", "l1", "l2", "0.3 0 0", axis="0 1 0", extra=lead),
            joint("c", "l2", "l3", where, axis=axis, extra=follow),
            joint("d", "l3", "l4", "0.3 0 0", axis="1 0 0"),
        )
        arm = urdf.loads(text)
        low, high = arm.limits[1]
        q = np.linspace(own[0], own[1], 501)
        inside = (by * q + offset >= other[0]) & (by * q + offset <= other[1])
        if inside.any():
            assert np.array_equal(inside, (q >= low) & (q <= high)), text
        told = [note for note in arm.remarks if "would leave its own" in note or "were left out" in note]
        assert bool(told) == (not inside.all())
        if inside.sum() == 0:
            assert np.allclose((low, high), own) or high - low < (own[1] - own[0]) / 500
            assert "were left out" in told[0] or low < high
