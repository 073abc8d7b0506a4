"""Three neighbouring joints of a plane, wherever they stand in the chain."""

from __future__ import annotations

import numpy as np
import pytest

from oracle.arms.chains import plane_arm
from oracle.joints import random_joints
from oracle.native import backwards_alike, check_sets, lost_near_singular, missed, solver_of
from pieper import DH, Arm
from pieper.kinematics.forward import fk
from pieper.kinematics.geometry import look
from pieper.solver.families import three_parallel

H = np.pi / 2


@pytest.mark.parametrize("first", [0, 1, 2, 3])
@pytest.mark.parametrize("typed", [False, True])
def test_the_joint_vector_that_made_the_pose_is_found_for_three_parallel_axes(first, typed):
    rng = np.random.default_rng(10 * first + typed)
    taken = 0
    while taken < 6:
        chain = plane_arm(rng, first, "RRRRRR", typed)
        if three_parallel.match(chain, look(chain, 1e-9)) is None:
            continue  # an arm of right angles that cannot reach every direction
        taken += 1
        assert len(missed(solver_of(three_parallel, chain), chain, random_joints(chain, rng, 250))) == 0


@pytest.mark.parametrize("first", [0, 1, 2, 3])
def test_slides_in_the_plane_and_beside_it_are_taken_too(first):
    rng = np.random.default_rng(50 + first)
    taken = 0
    while taken < 25:
        types = "".join(rng.choice(["R", "R", "P"], 6))
        if types[first : first + 3] == "PPP":
            continue
        chain = plane_arm(rng, first, types, typed=False)
        if three_parallel.match(chain, look(chain, 1e-9)) is None:
            continue
        taken += 1
        assert len(missed(solver_of(three_parallel, chain), chain, random_joints(chain, rng, 60))) == 0


@pytest.mark.parametrize("first", [0, 1, 2, 3])
def test_it_is_found_near_singular_postures_as_well_as_the_pose_tells_them(first):
    rng = np.random.default_rng(70 + first)
    found = [lost_near_singular(three_parallel, plane_arm(rng, first, "RRRRRR", typed=False), rng) for _ in range(3)]
    assert sum(lost for lost, _ in found) == 0 and sum(tried for _, tried in found) > 60


@pytest.mark.parametrize("first", [0, 1])
def test_the_set_is_that_of_a_slow_oracle(first):
    rng = np.random.default_rng(7 + first)
    chain = plane_arm(rng, first, "RRRRRR", typed=False)
    check_sets(three_parallel, chain, rng, 500)


def test_a_reversed_chain_has_the_reversed_solutions():
    rng = np.random.default_rng(2)
    chain = plane_arm(rng, 1, "RRRRRR", typed=False)
    back = chain.reversed()
    backwards_alike(three_parallel, chain, back, rng, 20)


def test_one_pose_and_a_batch_give_the_same_rows_in_the_same_order():
    rng = np.random.default_rng(3)
    chain = plane_arm(rng, 1, "RRRRRR", typed=False)
    solver, T = solver_of(three_parallel, chain), fk(chain, random_joints(chain, rng, 61))
    q, valid, _, _ = solver.many(T, 1)
    for i, pose in enumerate(T):
        np.testing.assert_allclose(solver.one(np.ascontiguousarray(pose))[0], q[i][valid[i]], atol=1e-7)


def test_generic_poses_are_not_sent_to_the_careful_look():
    rng = np.random.default_rng(31)
    for first in range(4):
        chain = plane_arm(rng, first, "RRRRRR", typed=False)
        _, _, _, flag = solver_of(three_parallel, chain).many(fk(chain, random_joints(chain, rng, 20000)), 1)
        assert (flag & 1).sum() == 0


@pytest.mark.parametrize("bent", [-1, 1])
def test_a_slide_beside_the_plane_that_comes_to_lie_along_it_is_free(bent):
    """Joint 6 slides, and where joint 5 stands square to the plane of joints 2 to 4 these make up for it."""
    rows = [
        DH(a=-0.576, alpha=-H, theta=H),
        DH(a=-0.142, alpha=-H, d=-0.581, theta=H),
        DH(alpha=H, d=-0.093),
        DH(alpha=-H, theta=np.pi),
        DH(alpha=np.pi / 3),
        DH(a=0.198, alpha=-H, d=0.777, theta=-H),
    ]
    arm = Arm.from_dh(rows, convention="modified", joint_types="RRPRRP")
    assert arm.plan.family == "three_parallel"
    rng = np.random.default_rng(5)
    for _ in range(4):
        q = np.where(arm.chain.prismatic, rng.uniform(-0.6, 0.6, 6), rng.uniform(-3, 3, 6))
        q[4] = bent * H
        found = arm.ik(arm.fk(q))
        assert any(motion.contains(q) for motion in found.self_motions), (found.status, q)
        assert np.abs(arm.fk(found.all_q) - arm.fk(q)).max() < 1e-12


def test_a_free_slide_goes_to_where_short_links_of_the_plane_can_reach():
    """Links of 0.18 and 0.12 m reach a narrow part of the slide's way, on either side of where it comes nearest."""
    rows = [
        DH(a=-0.18, alpha=-H, theta=H),
        DH(a=-0.058, alpha=-H, d=-0.13, theta=H),
        DH(a=0.181),
        DH(a=0.119, theta=np.pi),
        DH(alpha=np.pi / 3),
        DH(a=0.182, alpha=-H, d=0.353, theta=-H),
    ]
    arm = Arm.from_dh(rows, convention="modified", joint_types="RRRRRP")
    assert arm.plan.family == "three_parallel"
    rng = np.random.default_rng(3)
    for far in (-1.2645395811774875, *rng.uniform(-2, 2, 9)):
        q = np.append(rng.uniform(-3, 3, 4), [-H, far])
        found = arm.ik(arm.fk(q))
        assert any(motion.contains(q) for motion in found.self_motions), (found.status, q)


@pytest.mark.parametrize(
    ("a1", "a2", "d2", "a3", "a4", "a6", "d6", "q"),
    [
        (0.599, 0.302, 0.432, 0.356, 0.0344, 0.0495, 0.261, (0.952, 0.828, 0.908, 1.584, -H, -0.453)),
        (0.266, 0.446, 0.169, 0.563, 0.0756, 0.454, 0.0838, (0.707, -0.188, 2.518, 2.746, -H, 0.871)),
    ],
)
def test_a_free_slide_brings_the_planes_own_slide_to_where_a_short_link_can_reach(a1, a2, d2, a3, a4, a6, d6, q):
    """Joint 2 slides too: its line must pass the circle of a4, which none of sixteen values of joint 6 let it."""
    rows = [
        DH(a=-a1, alpha=-H, theta=H),
        DH(a=-a2, alpha=-H, d=-d2, theta=H),
        DH(a=a3, alpha=H),
        DH(a=a4, theta=np.pi),
        DH(alpha=np.pi / 3),
        DH(a=a6, alpha=-H, d=d6, theta=-H),
    ]
    arm = Arm.from_dh(rows, convention="modified", joint_types="RPRRRP")
    assert arm.plan.family == "three_parallel"
    found = arm.ik(arm.fk(q))
    assert any(motion.contains(np.array(q)) for motion in found.self_motions), found.status
