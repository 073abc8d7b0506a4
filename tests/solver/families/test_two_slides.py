"""Two slides among six joints, in any order: one trigonometric polynomial of degree 4."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

import pieper
from oracle.arms.chains import sliding_arm
from oracle.joints import around, difference, random_joints
from oracle.native import missed, newton_solutions, solver_of
from pieper.kinematics.chain import Chain
from pieper.kinematics.forward import fk
from pieper.kinematics.geometry import look
from pieper.solver.families import general, two_slides
from pieper.solver.native import SixJointSolver

ORDERS = ["".join("P" if j in pair else "R" for j in range(6)) for pair in itertools.combinations(range(6), 2)]


@pytest.mark.parametrize("order", ORDERS)
@pytest.mark.parametrize("typed", [False, True])
def test_the_joint_vector_that_made_the_pose_is_found_and_counts_are_even(order, typed):
    rng = np.random.default_rng(ORDERS.index(order) + 100 * typed)
    taken = 0
    while taken < 3:
        chain = sliding_arm(rng, order, typed)
        if two_slides.match(chain, look(chain, 1e-9)) is None:
            assert typed  # an arm of right angles that cannot reach every direction
            continue
        taken += 1
        solver, Q = solver_of(two_slides, chain), random_joints(chain, rng, 200)
        assert len(missed(solver, chain, Q)) == 0
        _, valid, _, flag = solver.many(fk(chain, Q), 1)
        assert np.all(valid[flag == 0].sum(1) % 2 == 0) and valid.shape[1] == 8


@pytest.mark.parametrize("order", ["PPRRRR", "RPRRPR", "RRRRPP", "RRPPRR"])
def test_it_gives_the_sets_of_the_general_solver(order):
    rng = np.random.default_rng(ORDERS.index(order))
    chain = sliding_arm(rng, order, typed=False)
    T = fk(chain, random_joints(chain, rng, 150))
    q, valid, _, flag = solver_of(two_slides, chain).many(T, 1)
    slow = SixJointSolver(chain, general.prepare(chain), np.tile([-np.inf, np.inf], (6, 1)))
    other, other_valid, _, other_flag = slow.many(T, 1)
    both = np.flatnonzero((flag == 0) & (other_flag == 0))
    assert len(both) > 100
    for i in both:
        ours, theirs = q[i][valid[i]], other[i][other_valid[i]]
        assert len(ours) == len(theirs)
        assert all(difference(chain, theirs, row).min() < 1e-6 for row in ours)


@pytest.mark.parametrize("order", ["PRRRPR", "RRPRRP"])
def test_the_set_is_that_of_a_slow_oracle(order):
    rng = np.random.default_rng(ORDERS.index(order))
    chain = sliding_arm(rng, order, typed=False)
    solver = solver_of(two_slides, chain)
    for T in fk(chain, random_joints(chain, rng, 3)):
        ours, oracle = solver.one(np.ascontiguousarray(T))[0], newton_solutions(rng, chain, T, 1500)
        assert all(difference(chain, ours, row).min() < 1e-6 for row in oracle)
        far = [row for row in ours if difference(chain, oracle, row).min() >= 1e-6]
        # the oracle's starts do not reach slides a long way out
        assert all(np.abs(row[chain.prismatic]).max() > 2 * chain.length for row in far)


def test_drawn_arms_that_leave_the_general_elimination_no_certain_way_are_certain():
    # slides along or across revolute axes, right angles: found by a search over random arms
    tables = {
        "PRRRRP": [
            (0.322, -np.pi / 2, 0, np.pi),
            (-0.436, -np.pi / 2, -0.402, 0),
            (-0.067, np.pi, 0, 0),
            (-0.753, -np.pi / 2, 0, np.pi),
            (0, -np.pi / 6, 0, np.pi / 2),
            (0, -np.pi / 4, 0, 0),
        ],
        "PPRRRR": [
            (0, np.pi / 2, 0, 0),
            (-0.481, 0, 0, np.pi / 2),
            (-0.709, np.pi / 2, 0, np.pi / 2),
            (-0.128, 0, 0.166, 0),
            (0, -np.pi / 2, 0.796, np.pi),
            (0, -np.pi / 2, 0, 0),
        ],
    }
    for order, rows in tables.items():
        table = [pieper.DH(a=a, alpha=alpha, d=d, theta=theta) for a, alpha, d, theta in rows]
        arm = pieper.Arm.from_dh(table, convention="standard", joint_types=order)
        assert arm.plan.family == "two_slides" and arm.plan.max_solutions == 8
        Q = random_joints(arm.plan.chain, np.random.default_rng(1), 500)
        assert len(missed(arm.plan.solver, arm.plan.chain, Q)) == 0
        many = arm.ik_many(arm.fk(Q), threads=1)
        assert np.mean(many.status == pieper.Status.SOLVED) > 0.98


def test_lengths_over_six_decades_are_no_trouble():
    rng = np.random.default_rng(6)
    for order in ("PRRRRP", "RRRRPP", "RPRRPR"):
        chain = sliding_arm(rng, order, typed=False)
        links = np.array(chain.links)
        links[1:6, :3, 3] *= 10.0 ** rng.uniform(-3, 3, (5, 1))
        stretched = Chain.of(links, chain.prismatic.copy())
        Q = random_joints(stretched, rng, 300)
        solver = solver_of(two_slides, stretched)
        q, valid, _, _ = solver.many(fk(stretched, Q), 1)
        gap = q - Q[:, None]
        gap = np.where(stretched.prismatic, gap / stretched.length, around(gap))
        assert ((np.abs(gap).max(-1) < 1e-6) & valid).any(1).all()


def test_one_pose_and_a_batch_give_the_same_rows_in_the_same_order():
    chain = sliding_arm(np.random.default_rng(9), "RPRRPR", typed=False)
    solver, T = solver_of(two_slides, chain), fk(chain, random_joints(chain, np.random.default_rng(3), 61))
    q, valid, _, _ = solver.many(T, 1)
    for i, pose in enumerate(T):
        np.testing.assert_allclose(solver.one(np.ascontiguousarray(pose))[0], q[i][valid[i]], atol=1e-9)
