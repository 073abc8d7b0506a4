"""A characteristic polynomial leads to every posture, those that share the angle it is in told apart."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

import pieper

D = pieper.DH
#: Axes 2, 3, 4 meet and 4, 5, 6 are parallel: every angle of joint 2 is two postures', joints 1 and 3 with it.
SHARED = [D(0.1, 0.3, 0.02), D(0, pi / 2), D(0, -pi / 2), D(0.3, 0, 0.1), D(0.25), D(0.02, 1, 0.1)]


def test_postures_that_share_the_angle_are_told_apart():
    ik = pieper.Arm.from_dh(SHARED, convention="standard").symbolic.ik()
    said = ik.check(4)
    assert said.found == said.solutions and said.extra == 0 and said.solutions >= 16


def test_its_page_lists_the_postures_of_the_pose_it_shows():
    arm = pieper.Arm.from_dh(SHARED, convention="standard")
    text = arm.symbolic.ik().text()
    q = np.radians([float(x) for x in text.split("For the pose of the joint vector (")[1].split(")")[0].split(",")])
    rows = text.split("confirmed there:")[1].split("(The harmonics")[0].strip().splitlines()
    listed = np.radians([[float(x) for x in row.split("(")[1].split(")")[0].split(",")] for row in rows])
    assert len(listed) == len(arm.ik(arm.fk(q)).all_q) == 4
    assert arm.fk(listed)[:, :3] == pytest.approx(np.repeat(arm.fk(q)[None, :3], 4, 0), abs=1e-5)
    assert "Of its 16 roots 4 belong to real postures" in text
