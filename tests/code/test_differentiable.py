"""Gradients of inverse kinematics agree with differences, in JAX and PyTorch, and are finite at singular poses."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from pieper.code.differentiable import checked_plan, pose_gradient, rows
from tests.code.test_export import poses

ARMS = ("denso-vp6242", "universal-robots-ur5e", "stanford-arm", "fanuc-crx-10ia", "abb-irb140")


def moved(T, x):
    """Move poses by a twist (metres of the tool's point; radians about it)."""
    motion = pieper.pose(0, 0, 0, rotvec=x[3:])
    out = T.copy()
    out[..., :3, :3] = motion[:3, :3] @ T[..., :3, :3]
    out[..., :3, 3] += x[:3]
    return out


def regular(arm, count=40, seed=1):
    q, T = poses(arm, 400, seed)
    small = np.linalg.svd(arm.jacobian(q), compute_uv=False)[:, -1]
    plan = checked_plan(arm)
    # the same number of rows a little to each side: no limit is crossed
    keep = small > 0.05
    for x in 2e-4 * np.vstack([np.eye(6), -np.eye(6)]):
        keep &= rows(plan, moved(T, x)).inside.sum(1) == rows(plan, T).inside.sum(1)
    for k in range(rows(plan, T).q.shape[1]):
        found = rows(plan, T)
        s = np.linalg.svd(arm.jacobian(found.q[:, k]), compute_uv=False)[:, -1]
        keep &= ~found.inside[:, k] | (s > 0.05)
    return T[keep][:count]


def loss(q, inside):
    # smooth in q, blind to whole turns and to the order of rows
    return np.where(inside[..., None], np.cos(q) + 0.3 * np.sin(2 * q), 0.0).sum()


def slope(q, inside):
    return np.where(inside[..., None], -np.sin(q) + 0.6 * np.cos(2 * q), 0.0)


def difference(function, T, x, h=2e-4):
    """Return the derivative along a twist, by Richardson's rule from four neighbours."""
    at = lambda k: function(moved(T, k * h * x))  # noqa: E731
    return (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * h)


@pytest.mark.parametrize("name", ARMS)
def test_the_rule_agrees_with_differences(name):
    arm = pieper.load(name)
    plan, T, rng = checked_plan(arm), regular(arm), np.random.default_rng(2)
    found = rows(plan, T)
    gradient = pose_gradient(arm.chain, T, found.q, found.inside, slope(*found))
    for i in range(len(T)):
        x = rng.normal(size=6) * np.r_[np.full(3, 0.05), np.full(3, 0.2)]
        numeric = difference(lambda P: loss(*rows(plan, P)), T[i : i + 1], x, 5e-4)
        dT = np.zeros((4, 4))
        w = np.array([[0, -x[5], x[4]], [x[5], 0, -x[3]], [-x[4], x[3], 0]])
        dT[:3, :3], dT[:3, 3] = w @ T[i, :3, :3], x[:3]
        exact = (gradient[i] * dT).sum()
        assert abs(exact - numeric) < 1e-8 * max(1.0, abs(exact))
    assert len(T) >= 10


@pytest.mark.parametrize("name", ARMS)
def test_gradients_at_singular_poses_are_finite(name):
    arm = pieper.load(name)
    q = np.random.default_rng(3).uniform(-1, 1, (50, 6))
    q[:, 4] = 0.0
    T = arm.fk(q)
    found = rows(checked_plan(arm), T)
    gradient = pose_gradient(arm.chain, T, found.q, found.inside, slope(*found))
    assert np.isfinite(gradient).all()


def test_arms_with_spare_joints_are_refused():
    with pytest.raises(pieper.PlanError, match="six joints"):
        checked_plan(pieper.load("franka-panda"))


def test_the_doors_load_nothing_before_they_are_used():
    assert pieper.jax.ik.__module__ == "pieper.jax" and pieper.torch.ik.__module__ == "pieper.torch"


def test_jax_differentiates_compiles_and_maps():
    jax = pytest.importorskip("jax")
    import jax.numpy as jnp

    arm = pieper.load("denso-vp6242")
    solve, T = pieper.jax.ik(arm), regular(arm, 8)
    q, inside = solve(T)
    assert np.array_equal(np.asarray(q), rows(arm.plan, T).q)

    def total(P):
        q, inside = solve(P)
        return jnp.where(inside[..., None], jnp.cos(q) + 0.3 * jnp.sin(2 * q), 0.0).sum()

    expected = pose_gradient(arm.chain, T, np.asarray(q), np.asarray(inside), slope(np.asarray(q), np.asarray(inside)))
    for gradient in (jax.grad(total)(T), jax.jit(jax.grad(total))(T), jax.vmap(jax.grad(total))(T)):
        assert np.abs(np.asarray(gradient) - expected).max() < 1e-12


def test_torch_differentiates():
    torch = pytest.importorskip("torch")
    arm = pieper.load("denso-vp6242")
    T = regular(arm, 8)
    P = torch.tensor(T, requires_grad=True)
    q, inside = pieper.torch.ik(arm)(P)
    torch.where(inside[..., None], torch.cos(q) + 0.3 * torch.sin(2 * q), torch.zeros_like(q)).sum().backward()
    found = rows(arm.plan, T)
    assert np.abs(P.grad.numpy() - pose_gradient(arm.chain, T, found.q, found.inside, slope(*found))).max() < 1e-12
    again, _ = pieper.torch.ik(arm)(T)  # anything that speaks DLPack
    assert np.array_equal(again.numpy(), found.q)


def test_no_poses_have_no_rows():
    plan = pieper.load("denso-vp6242").plan
    found = rows(plan, np.zeros((2, 0, 4, 4)))
    assert found.q.shape == (2, 0, plan.max_solutions, 6) and found.inside.shape == (2, 0, plan.max_solutions)


def test_a_spare_joint_is_refused_with_its_cure():
    with pytest.raises(pieper.PlanError, match="with_joints_locked"):
        checked_plan(pieper.load("franka-panda"))


def test_torch_keeps_fractions_of_poses_in_whole_numbers():
    torch = pytest.importorskip("torch")
    arm = pieper.load("denso-vp6242")
    # the base stands where every entry of a reached pose is a whole number
    T = np.array([[0, 0, 1, 0], [0, -1, 0, 0], [1, 0, 0, 0], [0, 0, 0, 1]])
    arm = arm.with_base(pieper.pose(-0.25, 0, -0.35))
    q, inside = pieper.torch.ik(arm)(torch.tensor(T))
    assert q.dtype == torch.float64 and inside.any()
    assert np.abs(arm.fk(q[inside].numpy()) - T).max() < 1e-9
    assert pieper.torch.ik(arm)(torch.tensor(T, dtype=torch.float32))[0].dtype == torch.float32
    assert np.array_equal(pieper.torch.ik(arm)(T.tolist())[0], q)


def test_torch_is_mapped_and_differentiated_by_its_functions():
    torch = pytest.importorskip("torch")
    arm = pieper.load("denso-vp6242")
    solve, T = pieper.torch.ik(arm), torch.tensor(regular(arm, 6))
    q, inside = solve(T)
    assert torch.equal(torch.vmap(lambda P: solve(P)[0])(T), q)
    assert torch.equal(torch.vmap(lambda P: solve(P)[1], in_dims=2)(T.permute(1, 2, 0)), inside)

    def total(P):
        q, inside = solve(P)
        return torch.where(inside[..., None], torch.cos(q) + 0.3 * torch.sin(2 * q), 0.0).sum()

    expected = pose_gradient(arm.chain, T.numpy(), q.numpy(), inside.numpy(), slope(q.numpy(), inside.numpy()))
    for gradient in (torch.func.grad(total)(T), torch.vmap(torch.func.grad(total))(T)):
        assert np.abs(gradient.numpy() - expected).max() < 1e-12
    assert torch.func.jacrev(lambda P: solve(P)[0])(T[0]).shape == (*q.shape[1:], 4, 4)


def test_torch_does_not_take_the_second_derivative_for_zero():
    torch = pytest.importorskip("torch")
    arm = pieper.load("denso-vp6242")
    P = torch.tensor(regular(arm, 2), requires_grad=True)
    q, _ = pieper.torch.ik(arm)(P)
    (gradient,) = torch.autograd.grad(torch.sin(q).sum() + (P**3).sum(), P, create_graph=True)
    with pytest.raises(NotImplementedError, match="first derivatives"):
        gradient.sum().backward()


def test_jax_refuses_in_pieper_s_words_what_is_no_pose():
    jax = pytest.importorskip("jax")
    arm = pieper.load("denso-vp6242")
    solve, T = pieper.jax.ik(arm), arm.fk(np.full(6, 0.3))
    with pytest.raises(pieper.InputError, match="left-handed"):
        solve(T * np.array([1.0, 1.0, -1.0, 1.0]))
    with pytest.raises(pieper.InputError, match="shape"):
        jax.jit(solve)(T[:3])
    assert solve(np.zeros((0, 4, 4)))[0].shape == (0, arm.plan.max_solutions, 6)

    class Lent:
        """An array of somebody else, that speaks DLPack alone."""

        def __dlpack__(self, **asked):
            return T.__dlpack__(**asked)

        def __dlpack_device__(self):
            return T.__dlpack_device__()

    assert np.array_equal(solve(Lent())[0], solve(T)[0])
