"""Joint terms inverted: from values of the chain to every joint vector inside the limits that has them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from pieper.calibration.model import AxesModel
from pieper.errors import PlanError
from pieper.kinematics.arrays import Array, Indices
from pieper.kinematics.joints import TURN, JointSpace, inside
from pieper.solver.plan.plan import Plan
from pieper.solver.redundant.choice import Redundancy, nothing_chosen

PI = np.pi
#: By how much (rad, m) joint terms change a value at most: farther outside its limits a chain's value is not tried.
SLACK_OF_TERMS = 0.5
#: Steps of Newton's method for a joint's number behind its harmonics: a contraction by the harmonic's size each.
_INVERSIONS = 12


def joint_values(model: AxesModel, values: Array) -> Array:
    """Return the joint vectors (..., n) at which the chain's joints have these values (..., n), rad or m."""
    gears = np.asarray(np.linalg.inv(model.gears), np.float64)
    q: Array = values @ gears.T
    for _ in range(_INVERSIONS):
        q += (values - model.values(q)) @ gears.T
    return np.asarray(q, np.float64)


def inside_limits(model: AxesModel, limits: Array, values: Array) -> tuple[Indices, Array]:
    """Return every joint vector (k, n) inside limits (n, 2) that has values (m, n) of the chain, and whose they are.

    Each value is tried with the whole turns that the limits leave room for. A joint without limits is in (-pi, pi].
    """
    turning = ~model.prismatic
    bounded = turning & np.isfinite(limits).all(1)
    # where the chain's values come to lie: what a joint's drive carries along moves others out of their own limits
    ends = np.where(bounded[:, None] | ~turning[:, None], limits, [-PI, PI])
    with np.errstate(invalid="ignore"):
        parts = np.where(model.gears == 0, 0, model.gears) * ends.T[:, None]
    parts[:, model.gears == 0] = 0
    span = np.stack([parts.min(0).sum(1), parts.max(0).sum(1)], 1) + [-SLACK_OF_TERMS, SLACK_OF_TERMS]
    most = np.ceil((np.abs(span).max(1, initial=0.0, where=np.isfinite(span)) + 1) / TURN)
    of, tried = np.arange(len(values)), np.array(values, np.float64)
    for j in range(model.n):
        # one joint after the other: what cannot come inside by any turn is dropped before the next
        turns = TURN * np.arange(-most[j], most[j] + 1) if turning[j] else np.zeros(1)
        there = tried[:, j, None] + turns
        row, turn = np.nonzero((there > span[j, 0]) & (there < span[j, 1]))
        of, tried = of[row], tried[row]
        tried[:, j] = there[row, turn]
    q = joint_values(model, tried)
    endless = turning & ~bounded
    ok = (inside(q, limits) & (~endless | ((q > -PI) & (q <= PI)))).all(1)
    return of[ok], q[ok]


def nearest_of(which: Indices, q: Array, near: Array, space: JointSpace, weights: Array) -> tuple[Indices, Array]:
    """Return of rows q (m, n) of poses (m,), in order of these, the one of each pose nearest to its row of near."""
    away = space.straight(q, near[which], weights)
    order = np.lexsort((away, which))
    first = order[np.unique(which[order], return_index=True)[1]]
    return which[first], q[first]


def of_the_chain(plan: Plan, model: AxesModel, redundancy: Redundancy) -> Redundancy:
    """Return what is to be held by the chain's values, where it was said by the joints' numbers.

    Raises:
        PlanError: The axis of a joint that is to be held is moved by others too.
    """
    if nothing_chosen(redundancy):
        return None
    if not isinstance(redundancy, Mapping):
        names = plan.redundancy
        if not names:
            return redundancy
        columns = np.asarray(redundancy)
        if len(names) == 1:
            redundancy = {names[0]: columns.ravel() if columns.ndim else columns}
        elif columns.shape[-1:] == (len(names),):
            redundancy = {name: columns[..., k] for k, name in enumerate(names)}
        else:
            return redundancy
    joints = plan.full_names[: model.n]
    held: dict[str, Any] = {}
    for name, value in redundancy.items():
        held[name] = value
        if name in joints:
            held[name] = _value_alone(model, joints, name, value)
    return held


def _value_alone(model: AxesModel, joints: tuple[str, ...], name: str, value: Any) -> Any:
    """Return the chain's value of a joint at a number (...) of it; what is no number is left for the solver to say."""
    at = joints.index(name)
    others = [joints[k] for k in np.flatnonzero(model.gears[at]) if k != at]
    if others:
        raise PlanError(
            f"{name} cannot be held: its axis also moves with {', '.join(others)}. Hold a value of the chain: "
            f"fit.geometry.ik(T, redundancy={{{name!r}: value}}), and fit.joint_values of its rows.",
            moved_by=others,
        )
    try:
        number = np.asarray(value, np.float64)
    except (TypeError, ValueError):
        return value
    q = np.zeros((*number.shape, model.n))
    q[..., at] = number
    return model.values(q)[..., at]
