"""What the differentiable doors share: native rows, and the rule that turns a row's cotangent into the pose's.

A row q solves fk(q) = T. Moving the pose by a twist x (metres of the tool's point; radians about it, base frame) moves
the row by J(q)^-1 x (implicit function theorem): no elimination and no branch is differentiated. The gradient of a loss
with respect to the pose's twelve numbers is not unique, since a pose has six freedoms; returned is the one along the
manifold: for every motion of the pose its inner product with dT is the loss's derivative.

At a singular pose the derivative does not exist. Singular values of the Jacobian (lengths in units of the arm) below
`DAMPED_INVERSE` are inverted damped, s / (s^2 + DAMPED_INVERSE^2): directions in which the row is free to move fast get
a finite gradient, directions the arm cannot move in get none. Rows that do not exist have no gradient.
"""

from __future__ import annotations

import os
from importlib import import_module
from typing import Any, NamedTuple, Protocol, runtime_checkable

import numpy as np

from pieper.errors import PlanError
from pieper.kinematics.arrays import Array, Bools
from pieper.kinematics.chain import Chain
from pieper.kinematics.pose import checked_pose
from pieper.solver.plan.plan import Plan
from pieper.tolerances import DAMPED_INVERSE


class Solvable(Protocol):
    """What is needed of an arm."""

    chain: Chain

    @property
    def plan(self) -> Plan:
        """How it is solved."""
        ...


@runtime_checkable
class Lends(Protocol):
    """An array of somebody else, which speaks DLPack."""

    def __dlpack__(self, **asked: Any) -> Any:
        """Hand out the numbers."""
        ...


class DifferentiableRows(NamedTuple):
    """Rows of poses (..., 4, 4).

    Args:
        q: (..., slots, n), rad or m, zeros where there is none.
        inside: (..., slots) which there are, inside the limits.
    """

    q: Array
    inside: Bools


def framework(name: str, called: str) -> Any:
    """Return a framework that is an extra.

    Raises:
        ModuleNotFoundError: It is not installed; the message says how it comes.
    """
    try:
        return import_module(name)
    except ModuleNotFoundError as error:
        if error.name != name.split(".")[0]:
            raise
        said = f"pieper.{error.name} needs {called}: pip install 'pieper[{error.name}]'"
        raise ModuleNotFoundError(said, name=error.name) from None


def checked_plan(arm: Solvable) -> Plan:
    """Return the plan of an arm whose rows are differentiable.

    Raises:
        PlanError: The arm has spare, missing or coupled joints: its rows are no functions of the pose alone.
    """
    plan = arm.plan
    if plan.n != 6 or plan.task != "pose" or plan.uncoupled is not None:
        cure = " Lock the joint to spare first: arm.with_joints_locked." if plan.redundancy else ""
        raise PlanError(
            f"{plan.name}: derivatives are given for six joints and full poses; this arm has {plan.n} joints and task "
            f"{plan.task!r}{', coupled' if plan.uncoupled is not None else ''}.{cure}"
        )
    return plan


def rows(plan: Plan, T: Array) -> DifferentiableRows:
    """Return the native rows of poses (..., 4, 4), limits applied.

    Raises:
        InputError: A pose is none.
    """
    poses = checked_pose(T, "T", batch=True)
    flat, lead = np.ascontiguousarray(poses.reshape(-1, 4, 4)), poses.shape[:-2]
    if not len(flat):
        slots = plan.max_solutions
        return DifferentiableRows(np.zeros((*lead, slots, 6)), np.zeros((*lead, slots), np.bool_))
    if plan.direct:
        q, _, inside, _ = plan.solver.many(flat, os.cpu_count() or 1)
    else:
        from pieper.solver.verbs import ik_many

        batch = ik_many(plan, flat, None)
        q, inside = batch.q, batch.in_limits
    q = np.where(inside[..., None], q, 0.0)
    return DifferentiableRows(q.reshape(*lead, -1, 6), np.asarray(inside.reshape(*lead, -1), np.bool_))


def pose_gradient(chain: Chain, T: Array, q: Array, inside: Bools, g: Array) -> Array:
    """Return the gradient (..., 4, 4) with respect to poses T from g (..., slots, 6) with respect to rows q."""
    units = chain.joints.unit
    length = chain.length
    J = chain.native.jacobian(np.ascontiguousarray(q))
    # lengths in units of the arm, so that one threshold serves turns and slides
    scaled = J * units
    scaled[..., :3, :] /= length
    U, s, Vt = np.linalg.svd(scaled)
    damped = np.where(s < DAMPED_INVERSE, s / (s * s + DAMPED_INVERSE**2), 1.0 / np.maximum(s, DAMPED_INVERSE))
    given = np.where(inside[..., None], g, 0.0) * units
    # the row vector g J^-1: twists that each unit of the loss wants
    along = np.einsum("...ij,...j->...i", Vt, given) * damped
    twist = np.einsum("...ij,...j->...i", U, along).sum(-2)
    twist[..., :3] /= length
    w, R = twist[..., 3:], T[..., :3, :3]
    out = np.zeros(T.shape)
    cross = np.zeros((*w.shape[:-1], 3, 3))
    cross[..., 0, 1], cross[..., 0, 2], cross[..., 1, 2] = -w[..., 2], w[..., 1], -w[..., 0]
    cross -= np.swapaxes(cross, -1, -2)
    out[..., :3, :3] = 0.5 * cross @ R
    out[..., :3, 3] = twist[..., :3]
    return out
