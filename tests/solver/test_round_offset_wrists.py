"""Offset wrists at round postures: a pair of isolated solutions may hide where two roots of the polynomial meet."""

from __future__ import annotations

import numpy as np
import pytest

import pieper

ROUND = {
    "fanuc-crx-10ia": np.radians([90, 90, -165, -90, -135, 90]),
    "motoman-hc10": [1.9888390019706321, 0, 1.2341826274959313, 2.008352878035245, -0.6492832166828579, np.pi / 2],
}


@pytest.mark.xfail(strict=True, reason="two of eight rows are missing and the pose is told SOLVED")
@pytest.mark.parametrize("name", ROUND)
def test_the_posture_is_found_or_the_pose_is_uncertain(name):
    arm = pieper.load(name).with_limits(dict.fromkeys(pieper.load(name).joint_names, (-7.0, 7.0)))
    q = np.array(ROUND[name])
    sols = arm.ik(arm.fk(q))
    found = arm.chain.joints.apart(sols.all_q, q).min() < 1e-6
    assert found or sols.status == pieper.Status.UNCERTAIN
