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
