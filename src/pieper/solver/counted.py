"""How many solutions are met: poses of many postures solved, limits not applied, and the fullest one counted."""

from __future__ import annotations

import numpy as np

from pieper.solver.arm_rows import arm_rows
from pieper.solver.plan.plan import Plan
from pieper.solver.plan.six_joints import sample_joints

#: Postures whose poses are solved, and how many of them between two looks.
POSTURES, AT_ONCE = 2000, 100


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
        some = q[first : first + AT_ONCE]
        values = np.tile(plan.defaults, (len(some), 1))
        rows = arm_rows(plan, whole.chain.native.fk(some), values, 1)
        if whole is not plan:
            from pieper.solver.linked import rows_of

            rows = rows_of(whole, rows)
        most = max(most, int(rows.valid.sum(1).max(initial=0)))
        if most >= plan.count.most:
            break
    return most
