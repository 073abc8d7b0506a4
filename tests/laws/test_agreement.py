"""Laws of agreement: one pose and many, a special family and the general solver, the Jacobian and its definition."""

from __future__ import annotations

import numpy as np
import pytest

from oracle.arms.kinds import KINDS, offset_wrist, random_pose, spherical_wrist_parallel, three_parallel
from oracle.joints import random_joints, same_set
from pieper.kinematics.geometry import look
from pieper.solver.families import choose, general
from pieper.solver.native import SixJointSolver
from tests.laws.of_kinds import of_kinds


@of_kinds(KINDS, examples=6)
def test_one_pose_and_many_poses_agree_to_the_last_solution(arm, rng):
    T = np.concatenate([arm.fk(random_joints(arm, rng, 20)), np.stack([random_pose(rng) for _ in range(10)])])
    many = arm.ik_many(T, threads=2)
    for i, pose in enumerate(T):
        one = arm.ik(pose)
        assert len(one.all_q) == many.count[i]
        np.testing.assert_allclose(one.all_q, many.q[i][many.valid[i]], atol=1e-9)
        assert one.status == many.status[i]


@of_kinds([spherical_wrist_parallel, three_parallel, offset_wrist], examples=5)
def test_a_special_family_and_the_general_solver_agree(arm, rng):
    _, spec = choose(arm.chain, look(arm.chain, 1e-9), (general.FAMILY,))
    slow = SixJointSolver(arm.chain, spec, arm.limits)
    for pose in arm.fk(random_joints(arm, rng, 20)):
        rows, _, _, flag = slow.one(np.ascontiguousarray(pose))
        assert flag & 2 or same_set(arm.ik(pose).all_q, rows, arm.chain.prismatic, 1e-5)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("shape", [(), (1,), (3, 2)])
def test_forward_kinematics_takes_any_batch_shape(kind, shape):
    rng = np.random.default_rng(5)
    arm = kind(rng)
    q = random_joints(arm, rng, int(np.prod(shape, dtype=int))).reshape(*shape, arm.n)
    T, F, J = arm.fk(q), arm.frames(q), arm.jacobian(q)
    assert T.shape == (*shape, 4, 4) and F.shape == (*shape, arm.n + 2, 4, 4) and J.shape == (*shape, 6, arm.n)
    np.testing.assert_allclose(F[..., -1, :, :], T, atol=1e-13)
    np.testing.assert_allclose(F[..., 0, :, :], np.broadcast_to(arm.base, (*shape, 4, 4)), atol=0)
    for index in np.ndindex(shape):
        np.testing.assert_allclose(arm.fk(q[index]), T[index], atol=1e-14)


@pytest.mark.parametrize("kind", KINDS)
def test_the_jacobian_is_the_complex_step_derivative_of_an_independent_product(kind):
    rng = np.random.default_rng(6)
    arm = kind(rng)
    for q in random_joints(arm, rng, 5):
        J = arm.jacobian(q)
        R = product(arm, q.astype(complex)).real[:3, :3]
        for j in range(arm.n):
            moved = q.astype(complex)
            moved[j] += 1e-30j
            D = product(arm, moved).imag / 1e-30
            np.testing.assert_allclose(J[:3, j], D[:3, 3], atol=1e-12)
            W = D[:3, :3] @ R.T
            np.testing.assert_allclose(J[3:, j], [W[2, 1], W[0, 2], W[1, 0]], atol=1e-12)


def product(arm, q):
    """Return the pose of q as a plain product of standard DH matrices, in whatever number q is made of."""
    T = arm.base.astype(complex)
    d = arm.description
    for i, row in enumerate(d.rows):
        sliding = arm.joint_types[i] == "P"
        value = d.sign[i] * q[i] + d.offset[i]
        theta, length = (row.theta, row.d + value) if sliding else (row.theta + value, row.d)
        c, s, ca, sa = np.cos(theta), np.sin(theta), np.cos(row.alpha), np.sin(row.alpha)
        T = T @ np.array(
            [[c, -s * ca, s * sa, row.a * c], [s, c * ca, -c * sa, row.a * s], [0, sa, ca, length], [0, 0, 0, 1]]
        )
    return T @ arm.tool
