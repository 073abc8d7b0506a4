"""Data of which all was made small: radians that were taken for degrees beside metres taken for millimetres."""

from __future__ import annotations

import numpy as np
import pytest

import pieper


@pytest.mark.parametrize("notation", ["rpy", "abc", "zyz", "rotvec"])
@pytest.mark.parametrize("name", ["universal-robots-ur5e", "denso-vp6242", "franka-panda", "epson-g6-651s"])
def test_a_table_in_metres_and_radians_that_was_read_in_millimetres_and_degrees_is_named(name, notation):
    arm, rng = pieper.load(name), np.random.default_rng(3)
    q = rng.uniform(*np.clip(arm.limits, -2.5, 2.5).T, (60, arm.n))
    T = arm.with_tool(arm.tool @ pieper.pose(0.002, 0, 0.003)).fk(q)
    numbers = [pieper.read_pose(t, notation) for t in T]
    read = np.array([pieper.pose(*np.divide(row[:3], 1e3), **{notation: np.radians(row[3:])}) for row in numbers])
    joints = q * np.where(arm.chain.prismatic, 1e-3, np.pi / 180)
    with pytest.raises(
        pieper.InputError, match="those of the measured poses are in radians that were taken"
    ) as refused:
        arm.calibrate(joints, read)
    assert refused.value.left < 1e-9 and "in metres that were taken for millimetres" in str(refused.value)
    assert "left-handed" not in str(refused.value)
    with pytest.raises(pieper.InputError, match="the angles of the measured poses are in radians"):
        arm.calibrate(q, np.array([pieper.pose(*row[:3], **{notation: np.radians(row[3:])}) for row in numbers]))


@pytest.mark.parametrize("kind", ["distance", "plane"])
@pytest.mark.parametrize("name", ["universal-robots-ur5e", "denso-vp6242", "franka-panda", "fanuc-crx-10ia"])
def test_single_numbers_beside_joints_that_hardly_move_are_compared_with_the_arms_own_places(name, kind):
    arm, rng = pieper.load(name), np.random.default_rng(3)
    q = rng.uniform(*np.clip(arm.limits, -2.5, 2.5).T, (60, arm.n))
    p = arm.with_tool(arm.tool @ pieper.pose(0.002, 0, 0.003)).fk(q)[:, :3, 3]
    numbers = np.linalg.norm(p - [0.9, 0.1, 0.2], axis=1) if kind == "distance" else p @ [0.6, 0, 0.8] + 0.1
    words = "the joint angles are in radians .* what was measured is in metres that were taken for millimetres"
    with pytest.raises(pieper.InputError, match=words):
        arm.calibrate(np.radians(q), numbers / 1000, kind=kind)


@pytest.mark.parametrize("name", ["universal-robots-ur5e", "denso-vp6242", "fanuc-crx-10ia"])
def test_heights_that_belong_to_no_joints_are_refused_however_small_they_are(name):
    arm, rng = pieper.load(name), np.random.default_rng(3)
    for size in (0.003, 0.01, 0.1):
        with pytest.raises(pieper.InputError, match="do not belong together"):
            arm.calibrate(rng.uniform(-0.04, 0.04, (60, arm.n)), size * rng.normal(size=60), kind="plane")
