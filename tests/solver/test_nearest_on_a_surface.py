"""Of a pose that a whole surface of postures takes, one of them is the nearest to itself."""

from __future__ import annotations

import numpy as np
import pytest

import pieper

STRETCHED = {
    "kuka-kr6-r900-2": ([-np.pi / 2, -np.pi / 2, 0, 0, 0, 0], [0, 0, 0, -0.1, 0, 0.1]),
    "from a table": ([0.3, np.pi / 2, np.pi / 2, 0.4, 0, 0.5], [0.7, 0, 0, -0.4, 0, -0.3]),
}


def arm_of(name):
    if name != "from a table":
        return pieper.load(name)
    rows = [
        pieper.DH(d=0.4, alpha=np.pi / 2),
        pieper.DH(a=0.4),
        pieper.DH(alpha=np.pi / 2),
        pieper.DH(d=0.4, alpha=-np.pi / 2),
        pieper.DH(alpha=np.pi / 2),
        pieper.DH(d=0.1),
    ]
    return pieper.Arm.from_dh(rows, convention="standard", limits=[(-3.1, 3.1)] * 6)


@pytest.mark.parametrize("name", STRETCHED)
@pytest.mark.parametrize("far", [0.0, 0.5, 1.0])
def test_a_posture_that_takes_the_pose_is_the_nearest_to_itself(name, far):
    arm = arm_of(name)
    q, way = map(np.array, STRETCHED[name])
    T, here = arm.fk(q), q + far * way
    assert np.abs(arm.fk(here) - T).max() < 1e-14
    assert np.abs(arm.ik(T).nearest(here) - here).max() < 1e-9
