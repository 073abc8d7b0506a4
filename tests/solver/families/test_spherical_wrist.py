"""The spherical wrist anywhere in the chain, with any three other joints."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from oracle.arms.chains import wrist_arm
from oracle.joints import difference, random_joints, scaled
from oracle.native import check_sets, lost_near_singular, missed, solver_of
from pieper.description.dh import DH
from pieper.description.fold import chain_of
from pieper.description.said import describe
from pieper.kinematics.forward import fk
from pieper.kinematics.geometry import look
from pieper.solver.families import spherical_wrist

OTHERS = ["".join(t) for t in itertools.product("RP", repeat=3)]


@pytest.mark.parametrize("first", [0, 1, 2, 3])
@pytest.mark.parametrize("others", OTHERS)
def test_the_joint_vector_that_made_the_pose_is_found_for_any_three_other_joints(first, others):
    rng = np.random.default_rng(100 * first + OTHERS.index(others))
    for _ in range(4):
        chain = wrist_arm(rng, first, others, typed=False)
        assert len(missed(solver_of(spherical_wrist, chain), chain, random_joints(chain, rng, 250))) == 0


@pytest.mark.parametrize("first", [0, 1, 2, 3])
def test_it_is_found_for_tables_of_right_angles_and_zero_lengths(first):
    rng = np.random.default_rng(first)
    taken = 0
    while taken < 12:
        chain = wrist_arm(rng, first, "".join(rng.choice(["R", "R", "P"], 3)), typed=True)
        if spherical_wrist.match(chain, look(chain, 1e-9)) is None:
            continue  # these three joints cannot place the wrist
        taken += 1
        assert len(missed(solver_of(spherical_wrist, chain), chain, random_joints(chain, rng, 150))) == 0


@pytest.mark.parametrize("first", [0, 1, 2, 3])
def test_it_is_found_near_singular_postures_as_well_as_the_pose_tells_them(first):
    rng = np.random.default_rng(40 + first)
    found = [lost_near_singular(spherical_wrist, wrist_arm(rng, first, "RRR", typed=False), rng) for _ in range(3)]
    assert sum(lost for lost, _ in found) == 0 and sum(tried for _, tried in found) > 60


@pytest.mark.parametrize(("first", "others"), [(3, "RRR"), (0, "RRP"), (1, "RRR"), (2, "RPR")])
def test_the_set_is_that_of_a_slow_oracle(first, others):
    rng = np.random.default_rng(7 + first)
    chain = wrist_arm(rng, first, others, typed=False)
    check_sets(spherical_wrist, chain, rng, 400)


def test_one_pose_and_a_batch_give_the_same_rows_in_the_same_order():
    rng = np.random.default_rng(3)
    for others in ("RRR", "RPR", "PPP"):
        chain = wrist_arm(rng, 3, others, typed=False)
        solver, T = solver_of(spherical_wrist, chain), fk(chain, random_joints(chain, rng, 61))
        q, valid, _, _ = solver.many(T, 1)
        for i, pose in enumerate(T):
            np.testing.assert_allclose(solver.one(np.ascontiguousarray(pose))[0], q[i][valid[i]], atol=1e-7)


@pytest.mark.parametrize("distance", [1e-9, 1e-8, 1e-6, 1e-4])
def test_a_cylindrical_arm_reaches_its_column_from_both_sides(distance):
    # its slide near zero is a double root of the quartic, whose two solutions are half a turn of the column apart
    rows = [(0, 0, 0.3), (0, -np.pi / 2, 0), (0, 0, 0.2), (0, -np.pi / 2, 0), (0, np.pi / 2, 0), (0, 0, 0.1)]
    description = describe(
        [DH(a=a, alpha=alpha, d=d) for a, alpha, d in rows], convention="standard", joint_types="RPPRRR"
    )
    chain = chain_of(description)
    solver = solver_of(spherical_wrist, chain)
    rng = np.random.default_rng(4)
    for _ in range(40):
        q = random_joints(chain, rng, 1)[0]
        q[2] = distance - 0.2
        T = np.ascontiguousarray(fk(chain, q))
        found = solver.one(T)[0]
        told = max(1e-6, 1e-14 / np.linalg.svd(scaled(chain, q), compute_uv=False)[-1])
        assert len(found) == 4
        assert difference(chain, found, q).min() < told
        poses = np.stack([T, T])
        assert solver.many(poses, 1)[1].sum() == 8


def test_a_pose_out_of_reach_has_no_solution_and_says_so():
    rng = np.random.default_rng(5)
    chain = wrist_arm(rng, 3, "RRR", typed=False)
    T = fk(chain, random_joints(chain, rng, 1))[0]
    T[:3, 3] += 100.0
    q, _, _, flag = solver_of(spherical_wrist, chain).one(np.ascontiguousarray(T))
    assert len(q) == 0 and flag & 4


def test_a_wrist_that_lines_up_gives_one_representative_and_is_flagged():
    rng = np.random.default_rng(9)
    chain = wrist_arm(rng, 3, "RRR", typed=True)
    while spherical_wrist.match(chain, look(chain, 1e-9)) is None:
        chain = wrist_arm(rng, 3, "RRR", typed=True)
    q = random_joints(chain, rng, 1)[0]
    # axes 4 and 6 lie along one line where their product, level + c cos + s sin of the middle angle, is 1
    A, B = chain.links[4][:3, :3], chain.links[5][:3, :3]
    row, column = A[2], B[:, 2]
    c, s = row[:2] @ column[:2], row[1] * column[0] - row[0] * column[1]
    q[4] = np.arctan2(s, c)
    assert row[2] * column[2] + np.hypot(c, s) > 1 - 1e-14
    T = fk(chain, q)
    rows, _, _, flag = solver_of(spherical_wrist, chain).one(np.ascontiguousarray(T))
    assert len(rows) >= 1
    np.testing.assert_allclose(fk(chain, rows), np.broadcast_to(T, (len(rows), 4, 4)), atol=1e-11)
    assert flag & 1
