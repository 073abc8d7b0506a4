"""Inverse kinematics that JAX differentiates: `pieper.jax.ik(arm)`."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from pieper.code.differentiable import DifferentiableRows, Lends, Solvable, checked_plan, framework, pose_gradient, rows
from pieper.errors import InputError
from pieper.kinematics.pose import checked_pose


def ik(arm: Solvable) -> Callable[[Any], Any]:
    """Return a function from poses (..., 4, 4) to (q (..., slots, 6), inside (..., slots)), differentiable in reverse.

    It may be compiled (jax.jit) and differentiated (jax.grad, jax.vjp) and mapped (jax.vmap); the native solver runs on
    the processor. Rows are zeros where `inside` is false. Derivatives follow from the implicit function theorem; see
    docs/code.md for what happens at singular poses.

    Raises:
        PlanError: The arm has not six joints.
        ModuleNotFoundError: JAX is not installed.
    """
    jax: Any = framework("jax", "JAX")
    jnp: Any = framework("jax.numpy", "JAX")
    if not jax.config.read("jax_enable_x64"):
        # single precision loses rows
        jax.config.update("jax_enable_x64", True)
    plan = checked_plan(arm)
    slots = plan.max_solutions

    def native(T: Any) -> DifferentiableRows:
        return rows(plan, np.asarray(T, np.float64))

    def native_gradient(T: Any, q: Any, inside: Any, g: Any) -> Any:
        return pose_gradient(
            plan.chain, np.asarray(T), np.asarray(q), np.asarray(inside, bool), np.asarray(g, np.float64)
        )

    @jax.custom_vjp
    def solve(T: Any) -> Any:
        lead = T.shape[:-2]
        shapes = (jax.ShapeDtypeStruct((*lead, slots, 6), jnp.float64), jax.ShapeDtypeStruct((*lead, slots), jnp.bool_))
        return jax.pure_callback(lambda x: tuple(native(x)), shapes, T, vmap_method="broadcast_all")

    def forward(T: Any) -> Any:
        q, inside = solve(T)
        return (q, inside), (T, q, inside)

    def backward(kept: Any, cotangent: Any) -> Any:
        T, q, inside = kept
        shape = jax.ShapeDtypeStruct(T.shape, jnp.float64)
        return (jax.pure_callback(native_gradient, shape, T, q, inside, cotangent[0], vmap_method="broadcast_all"),)

    solve.defvjp(forward, backward)

    def checked(T: Any) -> Any:
        known = isinstance(T, jax.Array | np.ndarray) or not isinstance(T, Lends)
        T = jnp.asarray(T if known else jnp.from_dlpack(T), jnp.float64)
        if not isinstance(T, jax.core.Tracer):
            # said here as an InputError; from within what is compiled JAX says it in an error of its own
            checked_pose(np.asarray(T), "T", batch=True)
        elif T.shape[-2:] != (4, 4):
            raise InputError(f"T must have shape (..., 4, 4), got {T.shape}.", given=T.shape)
        return solve(T)

    return checked
