"""How many solutions are met: poses of many postures solved, limits not applied, and the fullest one counted."""

from __future__ import annotations

import numpy as np

from pieper.kinematics.arrays import Array, Indices
from pieper.kinematics.chain import Chain
from pieper.kinematics.geometry import axes_at
from pieper.solver.arm_rows import arm_rows
from pieper.solver.plan.plan import Plan
from pieper.solver.plan.six_joints import sample_joints

#: Postures whose poses are solved, and how many of them between two looks.
POSTURES, AT_ONCE = 2000, 100
#: Steps (parts of the joints' ranges) from the fullest postures, how many of these are gone on from, and to how many.
STEPS, KEPT, TRIED = (0.3, 0.1, 0.1, 0.03, 0.1, 0.03, 0.01, 0.1, 0.03, 0.01), 20, 400


def most_met(plan: Plan, postures: int = POSTURES) -> int:
    """Return the most solutions that a pose of some postures has, limits not applied.

    Args:
        plan: How the arm is solved.
        postures: How many at most, until the bound is met; spread evenly over all joints, the same every time, spare
            joints at their usual values.
    """
    whole = plan
    if plan.uncoupled is not None:
        if not plan.chain.linked:
            return most_met(plan.uncoupled, postures)
        plan = plan.uncoupled  # the axes are solved, at poses that the linkage holds
    q = sample_joints(whole.chain, postures)
    for joint, value in zip(plan.reduction.locked, plan.defaults, strict=True):
        if joint < plan.n:
            q[:, joint] = value
    most = 0
    for first in range(0, postures, AT_ONCE):
        most = max(most, int(_counts(whole, plan, q[first : first + AT_ONCE]).max(initial=0)))
        if most >= plan.count.most:
            return most
    return most if whole is not plan else max(most, _fuller(plan, q, most))


def _counts(whole: Plan, plan: Plan, q: Array) -> Indices:
    """Return how many solutions the poses of postures q (k, n) have, (k,)."""
    rows = arm_rows(plan, whole.chain.native.fk(q), np.tile(plan.defaults, (len(q), 1)), 1)
    if whole is not plan:
        from pieper.solver.linked import rows_of

        rows = rows_of(whole, rows)
    return rows.valid.sum(1)


def _fuller(plan: Plan, q: Array, most: int) -> int:
    """Return the most solutions of poses that are special, or near the fullest of postures q (k, n)."""
    held = [joint for joint in plan.reduction.locked if joint < plan.n]
    pool = q[: 2 * AT_ONCE]
    counts = _counts(plan, plan, pool)
    for tried in [*_along(plan.chain, q[:AT_ONCE], held), *range(len(STEPS))]:
        if isinstance(tried, int):
            best = pool[np.argsort(-counts, kind="stable")[:KEPT]]
            step = STEPS[tried] * sample_joints(plan.chain, TRIED, seed=2 + tried)
            step[:, held] = 0.0
            tried = best[np.arange(TRIED) % len(best)] + step
        found = _counts(plan, plan, tried)
        pool, counts = np.concatenate([pool, tried]), np.concatenate([counts, found])
        most = max(most, int(found.max(initial=0)))
        if most >= plan.count.most:
            break
    return most


def _along(chain: Chain, q: Array, held: list[int]) -> list[Array]:
    """Return postures with one joint turned so that the last turning axis lies along the first one that is not held.

    A palletizer's hand is level then: of an arm of few joints such poses have more solutions than others.
    """
    turning = [joint for joint in range(chain.n) if not chain.prismatic[joint] and joint not in held]
    thirds = np.array([0.0, 2.0, 4.0]) * np.pi / 3
    out: list[Array] = []
    for joint in turning[1:-1]:
        at = np.repeat(q[None], 3, 0)
        at[:, :, joint] = thirds[:, None]
        axes = axes_at(chain, at)[0]
        lined = np.sum(axes[..., turning[0], :] * axes[..., turning[-1], :], -1)
        turned = q.copy()
        turned[:, joint] = np.arctan2(np.sin(thirds) @ lined, np.cos(thirds) @ lined)
        out.append(turned)
    return out
