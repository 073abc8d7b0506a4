"""Short arms of which the axes say how many solutions there are: as many, merged ones counted, are all there is."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from pieper import DH, Arm, Status

QUARTER = np.pi / 2
#: Two slides between parallel turns; at round postures the circle touches the line.
ROWS = [(0.5, QUARTER, -0.1, 0), (0.3, -QUARTER, 0, 0), (0, 0, 0, 0), (0.609, -QUARTER, 0.5844, 0)]


@pytest.mark.parametrize(("first", "last"), list(itertools.product([0, QUARTER, np.pi], [-QUARTER, 0, QUARTER])))
def test_a_fold_of_as_many_branches_as_there_can_be_is_certain(first, last):
    arm = Arm.from_dh([DH(*row) for row in ROWS], convention="standard", joint_types="RPPR")
    assert arm.plan.count.most == 2
    q = np.array([first, 0, -0.63576868, last])
    T = arm.fk(q)
    sols, many = arm.ik(T), arm.ik_many(T[None])
    assert sols.status == Status.SOLVED and many.status[0] == Status.SOLVED
    assert arm.chain.joints.apart(sols.all_q, q).min() < 1e-6
    assert sols.multiplicity.sum() == 2
