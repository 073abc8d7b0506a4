"""Short arms with a joint to spare at round postures: held there, the six joints they are filled up to are singular."""

from __future__ import annotations

import numpy as np
import pytest

from pieper import DH, Arm, Status

QUARTER = np.pi / 2
ROWS = [
    (0, QUARTER, 0.4, 0),
    (0.5, -QUARTER, 0, QUARTER),
    (0.3, 0, 0.2, 0),
    (-0.2, QUARTER, 0, -0.26064),
    (0, -QUARTER, 0.51246, QUARTER),
]
#: The last axis turned by half a turn, about which the first filling is special.
POSTURE = np.array([0.1, -0.3, 0.0, 2.63145346, np.pi])


def made(limits=None) -> Arm:
    return Arm.from_dh([DH(*row) for row in ROWS], convention="standard", joint_types="PPRRR", limits=limits)


@pytest.mark.parametrize("joint", [0, 1, 2, 3])
def test_each_joint_may_be_held_where_it_stands(joint):
    arm = made()
    sols = arm.ik(arm.fk(POSTURE), redundancy={arm.joint_names[joint]: POSTURE[joint]})
    assert arm.chain.joints.apart(sols.all_q, POSTURE).min() < 1e-6


@pytest.mark.parametrize("width", [0.02, 0.1, 0.4])
@pytest.mark.parametrize("at_stop", [None, 2, 3])
def test_what_the_limits_leave_is_told_however_narrow_they_are(width, at_stop):
    limits = np.stack([POSTURE - width, POSTURE + 0.7 * width], 1)
    if at_stop is not None:
        limits[at_stop, 0] = POSTURE[at_stop]
    arm = made([tuple(pair) for pair in limits])
    sols = arm.ik(arm.fk(POSTURE))
    assert sols.status == Status.REDUNDANT
    assert np.abs(sols.nearest(POSTURE) - POSTURE).max() < 1e-9
    intervals = [(motion, a, b) for motion in sols.self_motions for a, b in motion.inside]
    assert intervals
    for motion, a, b in intervals:
        for u in np.linspace(a, b, 9):
            q = motion.at(float(u))
            assert np.all((q > limits[:, 0] - 1e-9) & (q < limits[:, 1] + 1e-9))
    # every sample of the whole curve that is inside lies in an interval
    for motion in sols.self_motions:
        for u in np.linspace(0, 1, 400):
            q = motion.at(float(u))
            if np.all((q > limits[:, 0] + 1e-6) & (q < limits[:, 1] - 1e-6)):
                assert any(a - 1e-9 <= u <= b + 1e-9 for a, b in motion.inside)
