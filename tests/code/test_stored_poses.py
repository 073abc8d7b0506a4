"""What an exported file tests itself with: twenty poses that the arm's limits allow, wherever they lie, or no file."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from pieper.code.export import export


@pytest.mark.parametrize("value", [np.pi, -np.pi, 2 * np.pi, 3 * np.pi, 1.0, np.nextafter(0.3, 1)])
@pytest.mark.parametrize("name", ["universal-robots-ur5e", "denso-vp6242", "franka-panda"])
def test_a_joint_held_where_no_few_digits_are_has_poses_to_be_tested_with(name, value):
    arm = pieper.load(name)
    arm = arm.with_limits({arm.joint_names[0]: (value, value)})
    made = export(arm, "x")
    assert len(made.T) == len(made.q) == len(made.counts) == 20 and min(made.counts) > 0
    inside = (made.q >= arm.limits[:, 0] - 1e-9) & (made.q <= arm.limits[:, 1] + 1e-9)
    assert inside.all() and np.abs(arm.fk(made.q) - made.T).max() < 1e-5


@pytest.mark.parametrize("joint", [2, 4])
def test_an_arm_all_of_whose_postures_are_singular_is_not_written(joint):
    arm = pieper.load("universal-robots-ur5e")
    arm = arm.with_limits({arm.joint_names[joint]: (0, 0)})
    with pytest.raises(pieper.PlanError, match="clear of singular ones"):
        export(arm, "x")
