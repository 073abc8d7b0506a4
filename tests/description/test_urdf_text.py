"""Every arm as a URDF: read back, it is the same arm."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from pieper import DH, InputError


@pytest.mark.parametrize("name", pieper.catalog())
def test_an_arm_written_as_urdf_reads_back_the_same(name, tmp_path):
    arm = pieper.load(name)
    arm.save(tmp_path / "arm.urdf")
    back = pieper.load(tmp_path / "arm.urdf")
    q = np.random.default_rng(0).uniform(-1, 1, (30, arm.n))
    assert np.abs(back.fk(q) - arm.fk(q)).max() < 1e-12
    assert back.joint_names == arm.joint_names and back.joint_types == arm.joint_types
    assert np.array_equal(back.limits, arm.limits)


@pytest.mark.parametrize("pitch", [90, -90, 90 - 1e-9, -90 + 1e-7, 89.9999])
def test_a_pitch_of_a_quarter_turn_loses_no_digit(pitch, tmp_path):
    arm = pieper.Arm.from_dh(
        [DH(a=0.3, alpha=0.4), DH(a=0.2)],
        convention="standard",
        tool=pieper.pose(0.1, 0.2, 0.3, rpy=(30, pitch, 40), degrees=True),
        base=pieper.pose(0.1, 0.2, 0.3, rpy=(-30, pitch, 140), degrees=True),
    )
    arm.save(tmp_path / "arm.urdf")
    q = np.random.default_rng(0).uniform(-3, 3, (20, 2))
    assert np.abs(pieper.load(tmp_path / "arm.urdf").fk(q) - arm.fk(q)).max() < 1e-14


def test_names_that_xml_minds_are_written_and_read(tmp_path):
    arm = pieper.Arm.from_dh(
        [DH(a=1), DH(a=1)], convention="standard", joint_names=['a "<&> b', "tool_fixed"], name="Größe <1>"
    )
    arm.save(tmp_path / "arm.urdf")
    back = pieper.load(tmp_path / "arm.urdf")
    assert back.joint_names == arm.joint_names and back.name == arm.name


def test_another_format_is_refused_with_the_way_there(tmp_path):
    with pytest.raises(InputError, match="MuJoCo reads a .urdf"):
        pieper.load("three-r").save(tmp_path / "arm.xml")


def test_mujoco_reads_what_is_written(tmp_path):
    mujoco = pytest.importorskip("mujoco")
    arm = pieper.load("denso-vp6242")
    arm.save(tmp_path / "arm.urdf")
    spec = mujoco.MjSpec.from_file(str(tmp_path / "arm.urdf"))
    assert [joint.name for joint in spec.joints] == list(arm.joint_names)


def test_a_short_slide_or_a_name_like_a_fingers_at_the_end_comes_back_from_a_file_of_ours(tmp_path):
    rows = [pieper.DH(a=0.25), pieper.DH(a=0.2), pieper.DH(d=0.1)]
    arm = pieper.Arm.from_dh(
        rows,
        convention="standard",
        joint_types="RRP",
        limits=[(-2, 2), (-2, 2), (0, 0.05)],
        joint_names=["wheel", "jaw", "finger"],
    )
    arm.save(tmp_path / "quill.urdf")
    back = pieper.load(tmp_path / "quill.urdf")
    assert back.joint_names == arm.joint_names and back.notes == ()
    assert pieper.load(tmp_path / "quill.urdf", tip="link_2").n == 2


def test_angles_that_look_rounded_come_back_to_the_last_digits_of_what_pieper_wrote(tmp_path):
    rng = np.random.default_rng(7)
    for digits in (4, 5, 6, 9, 10, 12):
        near = np.round(np.radians(15 * rng.integers(-12, 13, (4, 2))), digits)
        rows = [pieper.DH(0.3, float(alpha), 0.1, float(theta)) for alpha, theta in near]
        arm = pieper.Arm.from_dh(
            rows, convention="standard", tool=pieper.pose(0.1, 0, 0.2, rpy=tuple(near[0]) + (0.5,))
        )
        arm.save(tmp_path / "a.urdf")
        again = pieper.load(tmp_path / "a.urdf", missing_limits="unlimited")
        q = rng.uniform(-3, 3, (5, 4))
        assert np.abs(again.fk(q) - arm.fk(q)).max() < 1e-12
        assert again.notes == ()
