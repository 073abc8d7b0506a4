"""Sixteen complex paths from a generic arm end in all solutions of an arm: the solver's sets are the real ones."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle import equations, machine
from oracle.arms.known import free
from oracle.homotopy import all_solutions, apart, forward, kept, newton
from oracle.joints import random_joints
from pieper import DH, Arm


def test_the_kept_starts_are_sixteen_different_solutions():
    for one in kept():
        goal = np.repeat(forward(one.p[None], one.q[None])[0], 16, 0)
        step, left = newton(np.tile(one.p, (16, 1)), goal, one.roots)
        assert np.abs(step).max() < 1e-9 and left.max() < 1e-10
        assert (apart(one.roots[:, None], one.roots[None]) + 9 * np.eye(16)).min() > 1e-3


@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_all_sixteen_paths_arrive_for_a_general_arm(convention):
    rng = np.random.default_rng(8)
    rows = [DH(*rng.uniform(0.1, 0.6, 3), rng.uniform(-3, 3)) for _ in range(6)]
    arm = Arm.from_dh(rows, convention=convention, sign=rng.choice([-1, 1], 6), offset=rng.uniform(-3, 3, 6))
    m, q = machine(arm), random_joints(arm, rng, 2)
    x, arrived, doubtful = all_solutions(arm, m, q, kept())
    assert arrived.all() and not doubtful.any()
    for i in range(2):
        real = x[i][np.abs(x[i].imag).max(1) < 1e-7].real
        assert (apart(real, q[i]) < 1e-8).any()
        assert np.abs(equations(m, m.inner(real), m.pose(arm.fk(q[i])))[0]).max() < 1e-10
        rows = arm.ik(arm.fk(q[i])).all_q
        assert len(rows) == len(real) and (apart(rows[:, None], real[None]).min(0) < 1e-6).all()


@pytest.mark.parametrize(
    ("name", "most"), [("motoman-ea1400n", 16), ("fanuc-crx-10ia", 16), ("universal-robots-ur5e", 8)]
)
def test_the_real_ends_are_the_solutions(name, most):
    arm = free(name)
    m, q = machine(arm), random_joints(arm, np.random.default_rng(31), 3)
    x, arrived, _ = all_solutions(arm, m, q, kept())
    assert (arrived.sum(1) == most).all()
    for i in range(3):
        real = x[i][arrived[i] & (np.abs(x[i].imag).max(1) < 1e-7)].real
        rows = arm.ik(arm.fk(q[i])).all_q
        assert len(rows) == len(real) and (apart(rows[:, None], real[None]).min(0) < 1e-6).all()


def test_an_arm_with_a_slide_is_refused():
    arm = pieper.load("stanford-arm")
    with pytest.raises(ValueError, match="revolute"):
        all_solutions(arm, machine(arm), np.zeros((1, 6)), kept())
