"""Arms for which every way of elimination vanishes: what arms beside them lead to is all there is, and certain."""

from __future__ import annotations

import numpy as np
import pytest

from pieper import DH, Arm, Status

QUARTER = np.pi / 2
#: Tables (a, alpha, d, theta) of five joints; the tool's roll is the sixth. Each lost or doubted poses.
TABLES = {
    "three axes that meet one after the other": [
        (0, -QUARTER, 0.4, -1.0693),
        (0, QUARTER, 0, 2.9955),
        (0.3, -QUARTER, 0, 0),
        (0, QUARTER, 0, 0),
        (0, 1.9643, 0.6673, 0),
    ],
    "parallel, then meeting": [
        (0.589, QUARTER, 0.4, 0),
        (0.5, QUARTER, 0.518, -1.578),
        (0.745, -2.031, 0, 0),
        (0.288, np.pi, 0.2, QUARTER),
        (0, QUARTER, 0, 0),
    ],
    "parallel, all across": [
        (0.3, QUARTER, 0.2, 0),
        (0.5, QUARTER, -0.1, 1.786),
        (0.3, QUARTER, 0.2, -2.38),
        (0.3, 0, 0, 0),
        (0, -QUARTER, -0.1, 0),
    ],
}


def made(name: str) -> Arm:
    return Arm.from_dh([DH(*row) for row in TABLES[name]], convention="standard", joint_types="RPRRR")


@pytest.mark.parametrize("name", TABLES)
def test_every_pose_is_solved_for_certain_and_the_posture_that_made_it_is_found(name):
    arm, rng = made(name), np.random.default_rng(8)
    assert arm.plan.spec.info["certified"] is False
    q = rng.uniform(-1, 1, (40, 5)) * [3, 1, 3, 3, 3]
    T = arm.fk(q)
    many = arm.ik_many(T)
    assert np.all(many.status == Status.SOLVED)
    for i in range(len(q)):
        rows = many.q[i][many.valid[i]]
        assert len(rows) % 2 == 0 and arm.chain.joints.apart(rows, q[i]).min() < 1e-8
        assert arm.plan.residual(rows, T[i]).max() < 1e-12
    for i in range(3):
        assert np.array_equal(arm.ik(T[i]).all_q, many.q[i][many.valid[i]])


@pytest.mark.parametrize("name", TABLES)
def test_a_pose_out_of_reach_is_said_to_be(name):
    arm = made(name)
    T = arm.fk(np.zeros(5))
    T[:3, 3] += [0, 0, 40]
    assert arm.ik(T).status == Status.OUT_OF_REACH
    assert arm.ik_many(T[None]).status[0] == Status.OUT_OF_REACH
