"""Second and third axes parallel, fourth and fifth meeting: one trigonometric polynomial in the last joint's angle."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle.arms.chains import offset_arm
from oracle.joints import difference, random_joints
from oracle.native import backwards_alike, missed, newton_solutions, solver_of
from pieper.kinematics.chain import Chain
from pieper.kinematics.forward import fk
from pieper.kinematics.geometry import look
from pieper.kinematics.pose import translation
from pieper.solver.families import general, offset_wrist
from pieper.solver.native import SixJointSolver

REAL = ("motoman-ea1400n", "fanuc-crx-10ia", "motoman-hc10", "kinova-jaco-j2n6", "kinova-mico")


def general_solver(chain: Chain) -> SixJointSolver:
    return SixJointSolver(chain, general.prepare(chain), np.tile([-np.inf, np.inf], (6, 1)))


@pytest.mark.parametrize("name", REAL)
def test_real_arms_of_the_family_lose_nothing_and_have_even_counts(name):
    arm = pieper.load(name)
    assert arm.plan.family == "offset_wrist" and arm.plan.max_solutions == 16
    rng = np.random.default_rng(4)
    Q = random_joints(arm.plan.chain, rng, 2000)
    assert len(missed(arm.plan.solver, arm.plan.chain, Q)) == 0
    _, valid, _, _ = arm.plan.solver.many(fk(arm.plan.chain, Q), 1)
    assert np.all(valid.sum(1) % 2 == 0)


@pytest.mark.parametrize("name", REAL)
def test_all_but_few_poses_are_solved_without_the_general_solver_behind(name, monkeypatch):
    monkeypatch.setattr(offset_wrist, "general_model", lambda chain: None)
    chain = pieper.load(name).plan.chain
    alone = solver_of(offset_wrist, chain)
    T = fk(chain, random_joints(chain, np.random.default_rng(10), 1000))
    _, valid, _, flag = alone.many(T, 1)
    assert np.count_nonzero(flag) < 30
    assert (valid[flag == 0].any(1)).all()


@pytest.mark.parametrize("alike", [False, True])
def test_random_arms_of_the_family_lose_nothing(alike):
    rng = np.random.default_rng(20 + alike)
    for _ in range(8):
        chain = offset_arm(rng, alike)
        assert len(missed(solver_of(offset_wrist, chain), chain, random_joints(chain, rng, 400))) == 0


@pytest.mark.parametrize("alike", [False, True])
def test_it_gives_the_sets_of_the_general_solver(alike):
    rng = np.random.default_rng(30 + alike)
    for _ in range(4):
        chain = offset_arm(rng, alike)
        T = fk(chain, random_joints(chain, rng, 150))
        q, valid, _, flag = solver_of(offset_wrist, chain).many(T, 1)
        other, other_valid, _, other_flag = general_solver(chain).many(T, 1)
        for i in np.flatnonzero((flag == 0) & (other_flag == 0)):
            ours, theirs = q[i][valid[i]], other[i][other_valid[i]]
            assert len(ours) == len(theirs)
            assert all(difference(chain, theirs, row).min() < 1e-6 for row in ours)


@pytest.mark.parametrize("alike", [False, True])
def test_the_set_is_that_of_a_slow_oracle(alike):
    rng = np.random.default_rng(40 + alike)
    chain = offset_arm(rng, alike)
    solver = solver_of(offset_wrist, chain)
    for T in fk(chain, random_joints(chain, rng, 3)):
        ours, oracle = solver.one(np.ascontiguousarray(T))[0], newton_solutions(rng, chain, T, 1500)
        assert len(ours) == len(oracle)
        assert all(difference(chain, oracle, row).min() < 1e-6 for row in ours)


def test_a_wrist_at_the_base_is_solved_from_tool_to_base():
    rng = np.random.default_rng(5)
    chain = offset_arm(rng, False)
    back = chain.reversed()
    found = offset_wrist.match(back, look(back, 1e-9))
    assert found is not None and found.backward
    backwards_alike(offset_wrist, chain, back, rng, 40)


def test_solutions_close_to_rounding_or_are_solved_with_care():
    arm = pieper.load("motoman-ea1400n")
    T = arm.fk(np.random.default_rng(6).uniform(-np.pi, np.pi, (3000, 6)))
    q, valid, _, flag = arm.plan.solver.many(T, 1)
    error = arm.plan.residual(q[valid], np.repeat(T, valid.sum(1), axis=0)).max(0)
    assert error[0] < 1e-12 * arm.plan.chain.length and error[1] < 1e-12


def test_arms_whose_sides_are_nearly_alike_go_to_the_general_solver():
    # every root would be nearly double: shoulder offsets between rounding and two thousandths of the arm
    for offset, taken in ((0.0, True), (1e-12, False), (1e-6, False), (1e-4, False), (0.05, True)):
        rows = [
            pieper.DH(a=offset, alpha=-np.pi / 2, d=0),
            pieper.DH(a=0.54, alpha=0, d=0),
            pieper.DH(a=0, alpha=-np.pi / 2, d=0),
            pieper.DH(a=0, alpha=np.pi / 2, d=0.54),
            pieper.DH(a=0, alpha=-np.pi / 2, d=-0.15),
            pieper.DH(a=0, alpha=0, d=0.16),
        ]
        arm = pieper.Arm.from_dh(rows, convention="standard")
        assert (arm.plan.family == "offset_wrist") == taken, offset
        q = np.random.default_rng(7).uniform(-np.pi, np.pi, (300, 6))
        assert len(missed(arm.plan.solver, arm.plan.chain, q)) == 0


def test_axes_that_miss_by_more_than_rounding_are_not_taken():
    chain = offset_arm(np.random.default_rng(8), False)
    for link in (3, 4):
        links = np.array(chain.links)
        links[link] = links[link] @ translation(x=1e-6, y=2e-6)
        other = Chain.of(links, chain.prismatic.copy())
        found = offset_wrist.match(other, look(other, 1e-9))
        assert (found is None) == (link == 4)  # link 3 is the forearm: any will do


def test_one_pose_and_a_batch_give_the_same_rows_in_the_same_order():
    chain = offset_arm(np.random.default_rng(9), False)
    solver, T = solver_of(offset_wrist, chain), fk(chain, random_joints(chain, np.random.default_rng(3), 61))
    q, valid, _, _ = solver.many(T, 1)
    for i, pose in enumerate(T):
        np.testing.assert_allclose(solver.one(np.ascontiguousarray(pose))[0], q[i][valid[i]], atol=1e-9)


def test_a_pose_out_of_reach_has_no_solution_and_no_flag_of_doubt():
    arm = pieper.load("motoman-ea1400n")
    T = arm.fk([0.3, -0.2, 0.5, 1.0, 0.7, 0.2])  # where nothing is aligned
    T[:3, 3] += [3.0, 0.0, 0.0]
    q, _, _, flag = arm.plan.solver.one(T)
    assert len(q) == 0 and flag == 4
